#pragma once

#include "pmts/video/video_source.hpp"

#include <QStringList>

namespace pmts::video {

/// V4L2 cameras first; those of Qt Multimedia whose description no other entry carries follow, each once.
[[nodiscard]] std::vector<SourceAddress> mergedCameras(std::vector<SourceAddress> v4l2,
                                                       const QStringList& qt_descriptions);

}  // namespace pmts::video
