#include "pmts/simulator/scene_camera.hpp"

#include "scene_rasteriser.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::simulator {
namespace {

constexpr double kNear_m = 0.05;
constexpr double kSkyFar = 1e-4;  // scales a sky patch's inverse depth behind everything else
constexpr int kEdgeSteps = 12;    // a straight edge is curved by the lens

/// The part of the camera frame that can reach the image: z in front, x/z and y/z within the rays' range.
struct Frustum {
    double left = 0, right = 0, top = 0, bottom = 0;

    static Frustum of(const RayTable& rays) {
        Frustum around;
        const auto range = [](const cv::Mat& values, double& low, double& high) {
            cv::Mat valid = values == values;  // not NaN
            cv::minMaxLoc(values, &low, &high, nullptr, nullptr, valid);
        };
        range(rays.x, around.left, around.right);
        range(rays.y, around.top, around.bottom);
        return around;
    }
    /// Inward planes through the camera centre, and the near plane: inside where n * p >= d.
    [[nodiscard]] std::array<std::pair<Eigen::Vector3d, double>, 5> planes() const {
        return {{{{0, 0, 1}, kNear_m},
                 {{1, 0, -left}, 0},
                 {{-1, 0, right}, 0},
                 {{0, 1, -top}, 0},
                 {{0, -1, bottom}, 0}}};
    }
};

using Polygon = std::vector<Eigen::Vector3d>;

Polygon clipped(const Polygon& polygon, const Eigen::Vector3d& normal, double at_least) {
    Polygon inside;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector3d& here = polygon[i];
        const Eigen::Vector3d& next = polygon[(i + 1) % polygon.size()];
        const double here_by = normal.dot(here) - at_least;
        const double next_by = normal.dot(next) - at_least;
        if (here_by >= 0) {
            inside.push_back(here);
        }
        if ((here_by >= 0) != (next_by >= 0)) {
            inside.push_back(here + (next - here) * (here_by / (here_by - next_by)));
        }
    }
    return inside;
}

/// Pixels the polygon may cover, through the lens; the whole image when the lens cannot say.
cv::Rect boundsOf(const Polygon& polygon, const camera::Lens& lens, const cv::Rect& image) {
    Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector3d edge = polygon[(i + 1) % polygon.size()] - polygon[i];
        for (int step = 0; step < kEdgeSteps; ++step) {
            const auto px =
                lens.pixelFromCamera(polygon[i] + edge * (static_cast<double>(step) / kEdgeSteps));
            if (!px) {
                return image;
            }
            low = low.cwiseMin(*px);
            high = high.cwiseMax(*px);
        }
    }
    constexpr double kMargin_px = 4.0;
    const auto clamp = [](double value, int limit) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(limit)));
    };
    const cv::Point first(clamp(low.x() - kMargin_px, image.width),
                          clamp(low.y() - kMargin_px, image.height));
    const cv::Point last(clamp(high.x() + kMargin_px + 1, image.width),
                         clamp(high.y() + kMargin_px + 1, image.height));
    return {first, last};
}

/// Grey-value noise of a sensor: strips of noise made once, added with another offset to each row.
class SensorNoise {
public:
    SensorNoise(double sigma, unsigned seed, int row_bytes) : rng_(seed + 1ULL), row_bytes_(row_bytes) {
        if (sigma <= 0.0) {
            return;
        }
        cv::Mat noise(1, row_bytes + kExtra, CV_16S);
        rng_.fill(noise, cv::RNG::NORMAL, 0.0, sigma);
        noise.convertTo(brighter_, CV_8U);
        noise.convertTo(darker_, CV_8U, -1.0);
    }
    void apply(cv::Mat& image) {
        if (brighter_.empty()) {
            return;
        }
        for (int row = 0; row < image.rows; ++row) {
            cv::Mat bytes(1, row_bytes_, CV_8U, image.ptr(row));
            const int offset = rng_.uniform(0, kExtra);
            const cv::Range part(offset, offset + row_bytes_);
            cv::add(bytes, brighter_.colRange(part), bytes);
            cv::subtract(bytes, darker_.colRange(part), bytes);
        }
    }

private:
    static constexpr int kExtra = 1 << 16;

    cv::RNG rng_;
    int row_bytes_;
    cv::Mat brighter_;
    cv::Mat darker_;
};

/// Images handed out and given back: a frame nobody looks at any more is drawn over.
class ImagePool {
public:
    cv::Mat take() {
        for (cv::Mat& image : images_) {
            if (image.empty() || CV_XADD(&image.u->refcount, 0) == 1) {
                return image;
            }
        }
        return {};
    }
    void remember(const cv::Mat& image) {
        for (cv::Mat& known : images_) {
            if (known.data == image.data) {
                return;
            }
        }
        images_[next_++ % images_.size()] = image;
    }

private:
    std::array<cv::Mat, 4> images_;
    std::size_t next_ = 0;
};

}  // namespace

class SceneCamera::Impl {
public:
    Impl(std::shared_ptr<const Scene> scene, std::shared_ptr<const TruePointing> pointing, camera::Rig rig,
         CameraFaults faults)
        : scene_(std::move(scene)),
          pointing_(std::move(pointing)),
          rig_(std::move(rig)),
          faults_(faults),
          noise_(faults.noise_sigma, faults.seed, rig_.width_px * 3) {
        const RayTable rays = RayTable::of(rig_);
        frustum_ = Frustum::of(rays);
        rasteriser_ = std::make_unique<SceneRasteriser>(scene_->atlas(), rays);
    }

    camera::Frame draw(core::Duration captured_at) {
        findPatches(camera::cameraPose(rig_.mount, pointing_->at(captured_at)));
        camera::Frame frame;
        frame.image = pool_.take();
        rasteriser_->draw(patches_, frame.image);
        pool_.remember(frame.image);
        expose(frame.image);
        frame.captured_at = captured_at;
        frame.sequence = drawn_++;
        return frame;
    }

    void setFaults(const CameraFaults& faults) {
        if (faults.noise_sigma != faults_.noise_sigma) {
            noise_ = SensorNoise(faults.noise_sigma, faults.seed, rig_.width_px * 3);
        }
        faults_ = faults;
    }

private:
    void findPatches(const camera::CameraPose& pose) {
        patches_.clear();
        const Eigen::Matrix3d camera_from_station = pose.station_from_camera.transpose();
        std::size_t texture = 0;
        for (const Panel& panel : scene_->panels()) {
            addPatch(panel, camera_from_station, pose.centre_station_m, 1.0, texture++);
        }
        for (const Panel& face : scene_->sky()) {
            addPatch(face, camera_from_station, Eigen::Vector3d::Zero(), kSkyFar, texture++);
        }
    }

    void addPatch(const Panel& panel, const Eigen::Matrix3d& camera_from_station,
                  const Eigen::Vector3d& centre_m, double depth_scale, std::size_t texture) {
        const Eigen::Vector3d right = camera_from_station * panel.right_m;
        const Eigen::Vector3d down = camera_from_station * -panel.up_m;
        const Eigen::Vector3d corner = camera_from_station * (panel.origin_m + panel.up_m - centre_m);
        Polygon seen{corner, corner + right, corner + right + down, corner + down};
        for (const auto& [normal, at_least] : frustum_.planes()) {
            seen = clipped(seen, normal, at_least);
        }
        Eigen::Matrix3d ray_from_patch;
        ray_from_patch << right, down, corner;
        if (seen.size() < 3 || std::abs(ray_from_patch.determinant()) < 1e-9 * right.norm() * down.norm()) {
            return;
        }
        const cv::Rect bounds = boundsOf(seen, rig_.lens, {0, 0, rig_.width_px, rig_.height_px});
        if (!bounds.empty()) {
            patches_.push_back({(ray_from_patch.inverse() * depth_scale).cast<float>(), texture, bounds});
        }
    }

    void expose(cv::Mat& image) {
        if (faults_.blur_px > 0.0) {
            cv::GaussianBlur(image, image, {}, faults_.blur_px);
        }
        if (faults_.exposure_gain != 1.0) {
            image.convertTo(image, -1, faults_.exposure_gain);
        }
        noise_.apply(image);
    }

    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const TruePointing> pointing_;
    camera::Rig rig_;
    CameraFaults faults_;
    Frustum frustum_;
    SensorNoise noise_;
    std::unique_ptr<SceneRasteriser> rasteriser_;
    std::vector<ScenePatch> patches_;
    ImagePool pool_;
    std::uint64_t drawn_ = 0;
};

SceneCamera::SceneCamera(std::shared_ptr<const Scene> scene, std::shared_ptr<const TruePointing> pointing,
                         camera::Rig true_rig, CameraFaults faults)
    : impl_(std::make_unique<Impl>(std::move(scene), std::move(pointing), std::move(true_rig), faults)) {}

SceneCamera::~SceneCamera() = default;

void SceneCamera::setFaults(const CameraFaults& faults) { impl_->setFaults(faults); }

camera::Frame SceneCamera::draw(core::Duration captured_at) { return impl_->draw(captured_at); }

}  // namespace pmts::simulator
