#pragma once

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <string>

namespace pmts::simulator {

/// A rectangle on a wall, metres, from the wall's lower left corner.
struct Patch_m {
    double left = 0.0;
    double bottom = 0.0;
    double width = 0.0;
    double height = 0.0;

    [[nodiscard]] Patch_m shrunk(double by) const {
        return {left + by, bottom + by, width - 2 * by, height - 2 * by};
    }
    [[nodiscard]] double right() const { return left + width; }
    [[nodiscard]] double top() const { return bottom + height; }
};

/// A wall being painted: an image with metres from its lower left corner. Colours are BGR.
class Canvas {
public:
    Canvas(double width_m, double height_m, double texel_m, const cv::Scalar& ground)
        : texel_m_(texel_m), image_(pixels(height_m), pixels(width_m), CV_8UC3, ground) {}

    [[nodiscard]] cv::Mat& image() { return image_; }
    [[nodiscard]] double texelM() const { return texel_m_; }
    [[nodiscard]] double widthM() const { return image_.cols * texel_m_; }
    [[nodiscard]] double heightM() const { return image_.rows * texel_m_; }

    void fill(const Patch_m& patch, const cv::Scalar& colour) {
        cv::rectangle(image_, at(patch.left, patch.top()), at(patch.right(), patch.bottom), colour,
                      cv::FILLED, cv::LINE_8, kShift);
    }
    void frame(const Patch_m& patch, const cv::Scalar& colour, double thickness_m) {
        const cv::Point2d points[]{{patch.left, patch.bottom},
                                   {patch.right(), patch.bottom},
                                   {patch.right(), patch.top()},
                                   {patch.left, patch.top()}};
        for (int i = 0; i < 4; ++i) {
            line(points[i], points[(i + 1) % 4], colour, thickness_m);
        }
    }
    void line(cv::Point2d from_m, cv::Point2d to_m, const cv::Scalar& colour, double thickness_m) {
        const int thickness_px = std::max(1, cvRound(thickness_m / texel_m_));
        cv::line(image_, at(from_m.x, from_m.y), at(to_m.x, to_m.y), colour, thickness_px, cv::LINE_AA,
                 kShift);
    }
    void arch(cv::Point2d centre_m, double radius_m, const cv::Scalar& colour) {
        const int radius = cvRound(radius_m / texel_m_ * (1 << kShift));
        cv::ellipse(image_, at(centre_m.x, centre_m.y), {radius, radius}, 0, 180, 360, colour, cv::FILLED,
                    cv::LINE_AA, kShift);
    }
    void disc(cv::Point2d centre_m, double radius_m, const cv::Scalar& colour) {
        cv::circle(image_, at(centre_m.x, centre_m.y), cvRound(radius_m / texel_m_ * (1 << kShift)), colour,
                   cv::FILLED, cv::LINE_AA, kShift);
    }
    /// Text centred in the patch, as large as fits.
    void write(const std::string& text, const Patch_m& patch, const cv::Scalar& colour);

private:
    static constexpr int kShift = 4;

    [[nodiscard]] int pixels(double length_m) const { return std::max(4, cvRound(length_m / texel_m_)); }
    /// Fixed-point pixel of a place on the wall; pixel centres are half a texel inside.
    [[nodiscard]] cv::Point at(double right_m, double up_m) const {
        return {cvRound((right_m / texel_m_ - 0.5) * (1 << kShift)),
                cvRound((image_.rows - up_m / texel_m_ - 0.5) * (1 << kShift))};
    }

    double texel_m_;
    cv::Mat image_;
};

}  // namespace pmts::simulator
