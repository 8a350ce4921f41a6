#include "picture_format.hpp"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace pmts::video {
namespace {

/// A header over the driver's memory; OpenCV only reads from it.
cv::Mat view(const RawPicture& raw, int rows, int type) {
    return {rows, raw.width_px, type, const_cast<std::uint8_t*>(raw.data), raw.row_bytes};
}

std::size_t neededBytes(const RawPicture& raw) {
    const auto rows = static_cast<std::size_t>(raw.height_px);
    switch (raw.layout) {
        case PixelLayout::kYuyv:
        case PixelLayout::kBgr:
            return raw.row_bytes * rows;
        case PixelLayout::kNv12:
            return raw.row_bytes * (rows + rows / 2);
        case PixelLayout::kMjpg:
            return 4;
    }
    return 0;
}

}  // namespace

cv::Mat bgrFrom(const RawPicture& raw) {
    if (raw.data == nullptr || raw.size_bytes < neededBytes(raw)) {
        return {};
    }
    cv::Mat bgr;
    switch (raw.layout) {
        case PixelLayout::kYuyv:
            cv::cvtColor(view(raw, raw.height_px, CV_8UC2), bgr, cv::COLOR_YUV2BGR_YUYV);
            break;
        case PixelLayout::kNv12:
            cv::cvtColor(view(raw, raw.height_px * 3 / 2, CV_8UC1), bgr, cv::COLOR_YUV2BGR_NV12);
            break;
        case PixelLayout::kBgr:
            view(raw, raw.height_px, CV_8UC3).copyTo(bgr);
            break;
        case PixelLayout::kMjpg: {
            const cv::Mat bytes(1, static_cast<int>(raw.size_bytes), CV_8UC1,
                                const_cast<std::uint8_t*>(raw.data));
            bgr = cv::imdecode(bytes, cv::IMREAD_COLOR);
            break;
        }
    }
    return bgr;
}

}  // namespace pmts::video
