#include "calibration/sweeps.hpp"
#include "pmts/simulator/simulated_rig.hpp"
#include "support/matchers.hpp"

#include <algorithm>

namespace pmts::calibration {
namespace {

using camera::MountKind;
using core::ErrorKind;
using simulator::CameraLens;
using test::FailedWith;
using enum RigParameter;

/// A camera somebody knocked, and what its data sheet says.
struct Case {
    explicit Case(CameraLens lens = CameraLens::kBrown, MountKind mount = MountKind::kTelescope)
        : truth(simulator::simulatedRig({.lens = lens, .mount = mount, .rig_error = 3})),
          start(test::dataSheetRig(truth)) {}
    [[nodiscard]] SweptSpot far(int pointings = 36, unsigned seed = 1) const {
        return test::scoutedSweepOf(truth, start, test::spotAt(20, 97, 22), {.seed = seed}, pointings);
    }
    [[nodiscard]] SweptSpot near(unsigned seed = 2) const {
        const auto rough = roughRig({far()}, start).value_or(start);
        return test::sweepOf(truth, rough, test::spotAt(60, 101, 5), {.seed = seed}, {.most_pointings = 24});
    }
    camera::Rig truth;
    camera::Rig start;
};

bool holds(const SelfCalibration& result, RigParameter parameter) {
    return std::any_of(result.held.begin(), result.held.end(),
                       [&](const HeldParameter& held) { return held.parameter == parameter; });
}

TEST(SelfCalibrationTest, TwoSpotsAtTwoRangesGiveTheWholeCameraBack) {
    const Case knocked;
    const auto found = selfCalibrate({knocked.far(), knocked.near()}, {.start = knocked.start});
    ASSERT_TRUE(found.has_value()) << found.error().sentence().toStdString();
    EXPECT_LE(found->held_out_px, 0.05);
    EXPECT_NEAR(found->rig.lens.focalLengthPx(), 1400, 0.0005 * 1400);
    EXPECT_LE((found->rig.mount.offset_m - knocked.truth.mount.offset_m).lpNorm<Eigen::Infinity>(), 0.002);
    EXPECT_NEAR(found->rig.mount.twist.gon(), knocked.truth.mount.twist.gon(), 0.003);
    EXPECT_LE(test::frameError_px(knocked.truth, found->rig), 0.05);
    EXPECT_TRUE(found->held.empty());
    EXPECT_TRUE(found->outliers.empty());
    EXPECT_FALSE(found->hasTable()) << "the model is the lens: nothing is left for a table";
}

TEST(SelfCalibrationTest, StandardDeviationsCoverTheTrueErrors) {
    const Case knocked;
    const auto found = selfCalibrate({knocked.far(), knocked.near()}, {.start = knocked.start});
    ASSERT_TRUE(found.has_value());
    const auto error = [&](RigParameter parameter, double truth) {
        for (const ParameterEstimate& estimate : found->parameters) {
            if (estimate.parameter == parameter) {
                return std::abs(estimate.value - truth) / estimate.standard_deviation.value();
            }
        }
        return 0.0;
    };
    EXPECT_LT(error(kFocalLength, 1400), 4);
    EXPECT_LT(error(kCentreX, 643.5), 4);
    EXPECT_LT(error(kYaw, knocked.truth.mount.yaw.rad()), 4);
    EXPECT_LT(error(kPitch, knocked.truth.mount.pitch.rad()), 4);
    EXPECT_EQ(found->correlation.rows(), static_cast<Eigen::Index>(found->parameters.size()));
    EXPECT_NEAR(found->correlation(1, 1), 1.0, 1e-9);
}

TEST(SelfCalibrationTest, OneRangeDoesNotTellOffsetsAndSaysSo) {
    const Case knocked;
    const auto found = selfCalibrate({knocked.far(60)}, {.start = knocked.start});
    ASSERT_TRUE(found.has_value());
    EXPECT_TRUE(holds(*found, kOffsetX) && holds(*found, kOffsetY) && holds(*found, kOffsetZ));
    EXPECT_EQ(found->rig.mount.offset_m, knocked.start.mount.offset_m);
    EXPECT_LE(found->held_out_px, 0.05);
    const QString words = verdict(*found).join(u' ');
    EXPECT_TRUE(words.contains("One range cannot tell the offset to the right from the yaw"))
        << words.toStdString();
    EXPECT_TRUE(words.contains("sweep a second spot")) << words.toStdString();
}

TEST(SelfCalibrationTest, RangesThatWereOnlyAssumedGiveNoOffsets) {
    const Case knocked;
    SweptSpot near = knocked.near();
    near.range_measured = false;
    const auto found = selfCalibrate({knocked.far(), near}, {.start = knocked.start});
    ASSERT_TRUE(found.has_value());
    EXPECT_TRUE(holds(*found, kOffsetZ));
}

TEST(SelfCalibrationTest, PicturesOfAnotherSpotAreRefusedByTheirNumber) {
    const Case knocked;
    SweptSpot far = knocked.far();
    far.pictures[7].px += Eigen::Vector2d(14, -9);
    far.pictures[20].px.x() += 3;
    const auto found = selfCalibrate({far, knocked.near()}, {.start = knocked.start});
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->outliers, (std::vector<std::size_t>{7, 20}));
    EXPECT_LE(found->held_out_px, 0.05);
    EXPECT_LE(test::frameError_px(knocked.truth, found->rig), 0.05);
    EXPECT_TRUE(verdict(*found).join(u' ').contains("8, 21"));
}

TEST(SelfCalibrationTest, TableOfResidualsTakesUpALensTheModelCannotBe) {
    for (const CameraLens lens : {CameraLens::kRational, CameraLens::kFisheye, CameraLens::kThesis}) {
        const Case wide(lens);
        const auto found = selfCalibrate({wide.far(), wide.near()}, {.start = wide.start});
        ASSERT_TRUE(found.has_value()) << found.error().sentence().toStdString();
        EXPECT_LE(test::frameError_px(wide.truth, found->rig), 0.1) << static_cast<int>(lens);
        EXPECT_LE(found->held_out_px, found->held_out_without_table_px);
    }
}

TEST(SelfCalibrationTest, TableIsProvedByPicturesItNeverSaw) {
    const Case wide(CameraLens::kFisheye);
    const auto found = selfCalibrate({wide.far(), wide.near()}, {.start = wide.start});
    ASSERT_TRUE(found && found->hasTable());
    EXPECT_LT(found->held_out_px, 0.7 * found->held_out_without_table_px);
    EXPECT_TRUE(verdict(*found).join(u' ').contains("table of residuals"));
    const auto without =
        selfCalibrate({wide.far(), wide.near()}, {.start = wide.start, .residual_table = false});
    ASSERT_TRUE(without.has_value());
    EXPECT_FALSE(without->hasTable());
}

TEST(SelfCalibrationTest, PlainLensGetsThePlainModel) {
    Case knocked;
    knocked.truth.lens =
        camera::Lens(camera::BrownLens{.f_px = 1400, .cx_px = 641, .cy_px = 358, .k1 = -0.15});
    const auto found = selfCalibrate({knocked.far(), knocked.near()}, {.start = knocked.start});
    ASSERT_TRUE(found.has_value());
    const auto lens = std::get<camera::BrownLens>(found->rig.lens.model());
    EXPECT_EQ(lens.k3, 0.0);
    EXPECT_EQ(lens.p1, 0.0);
    EXPECT_EQ(found->trials.size(), 5U);
}

TEST(SelfCalibrationTest, CameraOnTheHandleNeedsSpotsThatWereSighted) {
    const Case handle(CameraLens::kBrown, MountKind::kHandle);
    const auto row = [&](double va_gon, bool sighted) {
        SweptSpot spot = test::sweepOf(handle.truth, handle.start, test::spotAt(20, va_gon, 12), {.seed = 5},
                                       {.most_pointings = 20});
        spot.direction_sighted = sighted;
        spot.about.pointing.ha = core::Angle::fromGon(sighted ? 20.0 : 20.5);
        return spot;
    };
    const auto one = selfCalibrate({row(99, false)}, {.start = handle.start});
    ASSERT_TRUE(one.has_value());
    EXPECT_TRUE(holds(*one, kYaw));
    EXPECT_TRUE(verdict(*one).join(u' ').contains("cross-hair of the telescope on the spot"));

    const auto three = selfCalibrate({row(90, true), row(99, true), row(108, true)}, {.start = handle.start});
    ASSERT_TRUE(three.has_value());
    EXPECT_FALSE(holds(*three, kYaw));
    EXPECT_LE(three->held_out_px, 0.05);
}

TEST(SelfCalibrationTest, TooFewPicturesAndTablesAsAStartAreRefused) {
    const Case knocked;
    SweptSpot few = knocked.far();
    few.pictures.resize(5);
    EXPECT_THAT(selfCalibrate({few}, {.start = knocked.start}), FailedWith(ErrorKind::kBadInput));
    camera::Rig table = knocked.start;
    table.lens = simulator::thesisLens();
    EXPECT_THAT(selfCalibrate({knocked.far()}, {.start = table}), FailedWith(ErrorKind::kBadInput));
}

TEST(SelfCalibrationTest, CancelEndsIt) {
    const Case knocked;
    double last = -1;
    const auto found = selfCalibrate({knocked.far()}, {.start = knocked.start}, [&](double done) {
        last = done;
        return done < 0.3;
    });
    EXPECT_THAT(found, FailedWith(ErrorKind::kCancelled));
    EXPECT_GE(last, 0.3);
}

}  // namespace
}  // namespace pmts::calibration
