#include "pmts/calibration/rig_fit.hpp"

#include "calibration/sightings.hpp"
#include "geometry/poses.hpp"
#include "support/matchers.hpp"

#include <random>

namespace pmts::calibration {
namespace {

using camera::MountKind;
using core::Angle;
using core::ErrorKind;
using test::FailedWith;
using enum RigParameter;

geometry::Pointing pointing(double ha_gon, double va_gon) {
    return {Angle::fromGon(ha_gon), Angle::fromGon(va_gon)};
}

/// The camera everything below is made with.
camera::Rig trueRig(MountKind kind) {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 1150, .cx_px = 652, .cy_px = 349, .k1 = -0.2});
    rig.mount = {.kind = kind,
                 .offset_m = {0.02, 0.12, -0.04},
                 .yaw = Angle{},
                 .pitch = Angle::fromGon(-1.1),
                 .twist = Angle::fromGon(1.5)};
    return rig;
}

camera::Rig nominalRig(MountKind kind) {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 1200, .cx_px = 640, .cy_px = 360});
    rig.mount.kind = kind;
    return rig;
}

const std::vector<RigParameter> kNine{kFocalLength, kCentreX, kCentreY, kTwist, kOffsetX,
                                      kOffsetY,     kOffsetZ, kPitch,   kK1};

/// Targets at 4 to 30 m, seen in photos at three tilts.
std::vector<Sighting> seenBy(const camera::Rig& rig, unsigned seed, double noise_px) {
    test::RandomPoses poses(seed);
    std::mt19937 engine(seed);
    std::normal_distribution<double> noise(0.0, noise_px);
    std::vector<Sighting> sightings;
    while (sightings.size() < 30) {
        const auto at = pointing(100, 90.0 + 10.0 * static_cast<double>(sightings.size() % 3));
        const geometry::PolarPoint target{pointing(poses.uniform(70, 130), poses.uniform(75, 125)),
                                          poses.uniform(4, 30)};
        const auto px = camera::pixelFromStation(rig, at, geometry::stationFromPolar(target));
        if (px && px->x() > 0 && px->x() < 1280 && px->y() > 0 && px->y() < 720) {
            sightings.push_back({*px + Eigen::Vector2d(noise(engine), noise(engine)), at, target});
        }
    }
    return sightings;
}

TEST(RigFitTest, PerfectSightingsGiveTheTrueCameraBack) {
    const camera::Rig truth = trueRig(MountKind::kTelescope);
    const auto fit = fitRig(seenBy(truth, 61, 0.0), nominalRig(MountKind::kTelescope), kNine);
    ASSERT_TRUE(fit.has_value());
    EXPECT_LT(fit->rms_px, 1e-6);
    EXPECT_NEAR(fit->rig.lens.focalLengthPx(), 1150, 1e-4);
    EXPECT_TRUE(fit->rig.lens.principalPoint().isApprox(Eigen::Vector2d(652, 349), 1e-6));
    EXPECT_LT((fit->rig.mount.offset_m - truth.mount.offset_m).norm(), 1e-6);
    EXPECT_NEAR(fit->rig.mount.pitch.gon(), -1.1, 1e-5);
    EXPECT_NEAR(fit->rig.mount.twist.gon(), 1.5, 1e-5);
    EXPECT_NEAR(std::get<camera::BrownLens>(fit->rig.lens.model()).k1, -0.2, 1e-6);
}

TEST(RigFitTest, ParametersThatAreNotFreeKeepTheirValues) {
    camera::Rig start = trueRig(MountKind::kHandle);
    start.mount.offset_m.x() = 0.03;
    start.mount.yaw = Angle::fromGon(0.2);
    const auto fit = fitRig(seenBy(trueRig(MountKind::kHandle), 62, 0.3), start, {kFocalLength, kCentreX});
    ASSERT_TRUE(fit.has_value());
    EXPECT_EQ(fit->rig.mount.offset_m, start.mount.offset_m);
    EXPECT_EQ(fit->rig.mount.yaw, start.mount.yaw);
    EXPECT_EQ(fit->parameters.size(), 2U);
    EXPECT_EQ(fit->redundancy, 58);
}

TEST(RigFitTest, StandardDeviationsAreTheScatterOverManyCalibrations) {
    const double truth_f_px = 1150;
    double sum2_normalized = 0;
    constexpr int kCalibrations = 60;
    for (unsigned seed = 0; seed < kCalibrations; ++seed) {
        const auto fit = fitRig(seenBy(trueRig(MountKind::kTelescope), 100 + seed, 0.3),
                                nominalRig(MountKind::kTelescope), kNine);
        ASSERT_TRUE(fit.has_value());
        const double off = fit->parameters[0].value - truth_f_px;
        sum2_normalized += std::pow(off / fit->parameters[0].standard_deviation.value(), 2) / kCalibrations;
    }
    // Chi-square of 60: within 0.65 to 1.45 in 99 of 100 cases; the seeds are fixed.
    EXPECT_GT(sum2_normalized, 0.65);
    EXPECT_LT(sum2_normalized, 1.45);
}

TEST(RigFitTest, MountIsFoundFromTwoTiltsEvenWithAFreePitch) {
    for (const MountKind kind : {MountKind::kTelescope, MountKind::kHandle}) {
        const auto mounts =
            compareMounts(seenBy(trueRig(kind), 63, 0.5), nominalRig(MountKind::kTelescope), kNine);
        ASSERT_TRUE(mounts.has_value());
        EXPECT_EQ(mounts->likelier, kind);
        EXPECT_TRUE(mounts->decisive());
        EXPECT_LT(mounts->likelierFit().rms_px, 0.6);
        EXPECT_EQ(mounts->likelierFit().rig.mount.kind, kind);
    }
}

/// Targets on a wall straight ahead, 10 m away, in one level photo.
std::vector<Sighting> wallSeenBy(const camera::Rig& rig) {
    std::vector<Sighting> sightings;
    for (double x_m = -4; x_m <= 4; x_m += 2) {
        for (double z_m = -2; z_m <= 2; z_m += 2) {
            const auto at = pointing(0, 100);
            const Eigen::Vector3d p_station(x_m, 10, z_m);
            sightings.push_back({camera::pixelFromStation(rig, at, p_station).value(), at,
                                 geometry::polarFromStation(p_station).value()});
        }
    }
    return sightings;
}

TEST(RigFitTest, FlatWallCannotTellTheFocalLengthFromTheForwardOffset) {
    const auto fit = fitRig(wallSeenBy(nominalRig(MountKind::kHandle)), nominalRig(MountKind::kHandle),
                            {kFocalLength, kOffsetY, kCentreX, kK1});
    ASSERT_TRUE(fit.has_value());
    EXPECT_FALSE(fit->parameters[0].determinable());
    EXPECT_FALSE(fit->parameters[1].determinable());
    EXPECT_TRUE(fit->parameters[2].determinable());
    EXPECT_TRUE(fit->parameters[3].determinable());
}

TEST(RigFitTest, TooFewTargetsAreRefusedWithTheNumberNeeded) {
    auto sightings = test::thesisSightings();
    sightings.resize(4);
    const auto fit = fitRig(sightings, test::thesisStart(), thesisParameters());
    ASSERT_THAT(fit, FailedWith(ErrorKind::kBadInput));
    EXPECT_TRUE(fit.error().remedy.contains('5'));
}

TEST(RigFitTest, TargetBehindTheCameraIsNamed) {
    auto sightings = test::thesisSightings();
    sightings[2].target.pointing.ha += Angle::fromGon(200);
    const auto fit = fitRig(sightings, test::thesisStart(), thesisParameters());
    ASSERT_THAT(fit, FailedWith(ErrorKind::kBadInput));
    EXPECT_TRUE(fit.error().happened.contains('3'));
}

TEST(RigFitTest, DistortionTableIsNotFitted) {
    camera::Rig start = test::thesisStart();
    start.lens =
        camera::Lens(camera::RadialTableLens{.cx_px = 315, .cy_px = 240, .rows = {{0, 0}, {500, 0.6}}});
    EXPECT_THAT(fitRig(test::thesisSightings(), start, thesisParameters()), FailedWith(ErrorKind::kBadInput));
}

TEST(RigFitTest, FitWithNothingToFitIsAMistakeOfTheCaller) {
    EXPECT_THROW((void)fitRig(test::thesisSightings(), test::thesisStart(), {}), std::logic_error);
}

}  // namespace
}  // namespace pmts::calibration
