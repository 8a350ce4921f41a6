#pragma once

#include "pmts/calibration/self_calibration.hpp"
#include "pmts/core/virtual_clock.hpp"
#include "pmts/targeting/spot_sweep.hpp"
#include "support/fake_total_station.hpp"
#include "support/scene_frames.hpp"

#include <memory>
#include <vector>

namespace pmts::bench {

/// Sweeps over walls drawn by the simulated camera, found again by the real matcher: scouting, planning and
/// sweeping as the program does it.
class DrawnSweeps {
public:
    DrawnSweeps(const camera::Rig& truth, unsigned seed);

    /// A spot on each wall (ranges in m), each with so many pointings; less than asked for when one failed.
    [[nodiscard]] std::vector<calibration::SweptSpot> run(const camera::Rig& start,
                                                          const std::vector<double>& ranges_m,
                                                          const std::vector<int>& pointings);
    [[nodiscard]] std::size_t pictures() const { return pictures_; }
    [[nodiscard]] int missed() const { return missed_; }
    [[nodiscard]] double matcherRms_px() const;  ///< over the coordinates

private:
    struct Spot {
        geometry::Pointing at;
        Eigen::Vector3d p_station;
        targeting::Click click;
    };

    [[nodiscard]] std::optional<Spot> clicked(double range_m);
    bool sweep(const Spot& spot, const camera::Rig& rig, const std::vector<geometry::Pointing>& pointings,
               double radius_px, calibration::SweptSpot& swept);

    camera::Rig truth_;
    core::VirtualClock clock_;
    std::shared_ptr<simulator::TruePointing> pointing_ = std::make_shared<simulator::TruePointing>();
    test::FakeTotalStation station_;
    std::unique_ptr<test::SceneFrames> frames_;
    std::vector<targeting::SpotSighting> seen_;  ///< of the spot being swept
    std::size_t pictures_ = 0;
    int missed_ = 0;
    double sum2_px_ = 0;
};

}  // namespace pmts::bench
