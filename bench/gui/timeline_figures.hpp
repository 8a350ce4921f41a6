#pragma once

/// Painting a full time line, and what a visible one costs while an instrument is polled and pictures come.
void timelineFigures();
