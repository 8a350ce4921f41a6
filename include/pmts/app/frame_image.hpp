#pragma once

#include "pmts/camera/frame.hpp"

#include <QImage>

namespace pmts::app {

/// The frame's pixels as an image without copying them: the image keeps the frame alive. Null for a null frame.
[[nodiscard]] QImage imageOfFrame(camera::FramePtr frame);

/// PNG or JPEG bytes for the job; `format` as QImageWriter names it.
[[nodiscard]] QByteArray encodedImage(const QImage& image, const char* format);

}  // namespace pmts::app
