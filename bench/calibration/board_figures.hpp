#pragma once

namespace pmts::bench {

/// A lens from rendered views of a chessboard and a ChArUco board, against the lens they were drawn with and against OpenCV.
void boardFigures();

}  // namespace pmts::bench
