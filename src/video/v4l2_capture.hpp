#pragma once

#include "pmts/video/video_source.hpp"

#include <vector>

namespace pmts::video {

/// Capture devices among the video nodes of a folder, `/dev` but for tests. Opens each for a moment.
[[nodiscard]] std::vector<SourceAddress> v4l2Cameras(const QString& folder);

}  // namespace pmts::video
