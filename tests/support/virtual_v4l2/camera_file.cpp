#include "camera_file.hpp"

#include <cstdlib>
#include <fstream>
#include <string_view>

namespace pmts::virtual_v4l2 {

std::optional<CameraFile> readCameraFile(const std::string& path) {
    std::ifstream file(path);
    if (!file) {
        return std::nullopt;
    }
    CameraFile camera;
    for (std::string line; std::getline(file, line);) {
        const std::size_t equals = line.find('=');
        const std::string key = line.substr(0, equals);
        const std::string value = equals == std::string::npos ? std::string() : line.substr(equals + 1);
        if (key == "card") {
            camera.card = value;
        } else if (key == "skip") {
            camera.skip = std::atoi(value.c_str());
        } else if (key == "jpeg") {
            camera.jpeg_folder = value;
        } else if (key == "bare") {
            camera.bare = value == "1";
        } else if (key == "busy") {
            camera.busy = value == "1";
        } else if (key == "forbidden") {
            camera.forbidden = value == "1";
        } else if (key == "stall") {
            camera.stall = value == "1";
        } else if (key == "metadata") {
            camera.metadata = value == "1";
        }
    }
    return camera;
}

bool isCameraPath(const char* path) {
    const char* const folder = std::getenv("PMTS_VIRTUAL_CAMERAS");
    if (path == nullptr || folder == nullptr || *folder == '\0') {
        return false;
    }
    const std::string prefix = std::string(folder) + "/video";
    const std::string_view name(path);
    return name.substr(0, prefix.size()) == prefix && name.find('/', prefix.size()) == std::string_view::npos;
}

}  // namespace pmts::virtual_v4l2
