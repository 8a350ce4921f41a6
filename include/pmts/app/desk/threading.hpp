#pragma once

#include <QtGlobal>

namespace pmts::app {

/// Where a desk does its work. kCallersThread is for tests: with a virtual clock everything then happens in one order.
enum class Threading { kOwnThread, kCallersThread };

/// The number of a request to a desk: it comes back with its outcome. 0 is never given out.
using Ticket = quint64;

}  // namespace pmts::app
