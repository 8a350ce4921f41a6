#pragma once

#include <QObject>

#include <functional>

namespace pmts::sim {

/// Runs `action` on the event loop of this thread when SIGINT, SIGTERM or SIGHUP arrives. `owner` ends it.
void onTermination(QObject* owner, std::function<void()> action);

}  // namespace pmts::sim
