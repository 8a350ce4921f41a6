#include "pmts/core/logging.hpp"

namespace pmts::core {

Q_LOGGING_CATEGORY(logTransport, "pmts.transport")
Q_LOGGING_CATEGORY(logScheduler, "pmts.scheduler")
Q_LOGGING_CATEGORY(logInstrument, "pmts.instrument")
Q_LOGGING_CATEGORY(logVideo, "pmts.video")
Q_LOGGING_CATEGORY(logJob, "pmts.job")
Q_LOGGING_CATEGORY(logSimulator, "pmts.simulator")
Q_LOGGING_CATEGORY(logApp, "pmts.app")

}  // namespace pmts::core
