#pragma once

namespace pmts::bench {

/// Full HD Motion-JPEG through the V4L2 worker for this long: rate, latency and its growth, lost frames, cores.
void mjpegLive(double minutes);

}  // namespace pmts::bench
