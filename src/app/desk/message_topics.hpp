#pragma once

#include <QString>

namespace pmts::app {

/// Topics of messages that one file brings up and another one solves.
inline const QString kMoveTopic = QStringLiteral("move");
inline const QString kUsedIdTopic = QStringLiteral("used_id");

}  // namespace pmts::app
