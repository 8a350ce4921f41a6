#pragma once

#include "pmts/job/photo_file.hpp"

namespace pmts::job {

/// The picture's bytes with EXIF and XMP. kBadInput when they are no JPEG or PNG.
[[nodiscard]] core::Result<QByteArray> withTags(const PhotoFile& file);

}  // namespace pmts::job
