#pragma once

namespace pmts::bench {

/// A click, and Esc, until the first byte is at the other end of a real pty.
void measureWire();
/// Acknowledged records a second, and the longest time the GUI thread's event loop stood still meanwhile.
void measureRecords();

}  // namespace pmts::bench
