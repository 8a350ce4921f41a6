#pragma once

#include <optional>
#include <string>

namespace pmts::virtual_v4l2 {

/// What the file of a virtual camera says now.
struct CameraFile {
    std::string card = "Virtual camera";
    bool busy = false;
    bool forbidden = false;
    bool stall = false;
    bool metadata = false;
    bool bare = false;  ///< has no controls
    std::string jpeg_folder;
    int skip = 0;
};

/// nullopt when the camera is unplugged: its file is not there.
[[nodiscard]] std::optional<CameraFile> readCameraFile(const std::string& path);

/// True for `videoN` in the folder PMTS_VIRTUAL_CAMERAS names.
[[nodiscard]] bool isCameraPath(const char* path);

}  // namespace pmts::virtual_v4l2
