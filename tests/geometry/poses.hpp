#pragma once

#include "pmts/geometry/pointing.hpp"

#include <Eigen/Core>

#include <random>

namespace pmts::test {

/// Seeded pointings over the whole circle, 5 gon clear of the plumb line; half of them in face II when asked.
class RandomPoses {
public:
    explicit RandomPoses(unsigned seed) : engine_(seed) {}

    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    geometry::Pointing faceOne() {
        return {.ha = core::Angle::fromGon(uniform(0, 400)), .va = core::Angle::fromGon(uniform(5, 195))};
    }
    geometry::Pointing eitherFace() {
        const geometry::Pointing face_one = faceOne();
        return uniform(0, 1) < 0.5 ? face_one
                                   : geometry::Pointing{face_one.ha, core::Angle::fromGon(400) - face_one.va};
    }
    Eigen::Vector3d inBox(double half_size_m) {
        return {uniform(-half_size_m, half_size_m), uniform(-half_size_m, half_size_m),
                uniform(-half_size_m, half_size_m)};
    }

private:
    std::mt19937 engine_;
};

}  // namespace pmts::test
