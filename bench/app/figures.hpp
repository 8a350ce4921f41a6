#pragma once

namespace pmts::bench {

/// A click, and Esc, until the first byte is at the other end of a real pty.
void measureWire();
/// Acknowledged records a second, and the longest time the GUI thread's event loop stood still meanwhile.
void measureRecords();
/// What the black box costs with full HD live and polling: processor time over time passed.
void measureBlackBox();

}  // namespace pmts::bench
