#pragma once

#include "pmts/camera/frame.hpp"

#include <QImage>

namespace pmts::app {

/// The frame's pixels as an image without copying them: the image keeps the frame alive. Null for a null frame.
[[nodiscard]] QImage imageOfFrame(camera::FramePtr frame);

/// A frame with a copy of the image's pixels; null for a null image.
[[nodiscard]] camera::FramePtr frameOfImage(const QImage& image);

/// PNG or JPEG bytes for the job; `format` as QImageWriter names it.
[[nodiscard]] QByteArray encodedImage(const QImage& image, const char* format);

}  // namespace pmts::app
