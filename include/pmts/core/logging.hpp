#pragma once

#include <QLoggingCategory>

namespace pmts::core {

/// One category a room, `pmts.<room>`: the log window filters by them.
Q_DECLARE_LOGGING_CATEGORY(logTransport)
Q_DECLARE_LOGGING_CATEGORY(logScheduler)
Q_DECLARE_LOGGING_CATEGORY(logInstrument)
Q_DECLARE_LOGGING_CATEGORY(logVideo)
Q_DECLARE_LOGGING_CATEGORY(logJob)
Q_DECLARE_LOGGING_CATEGORY(logSimulator)
Q_DECLARE_LOGGING_CATEGORY(logApp)

}  // namespace pmts::core
