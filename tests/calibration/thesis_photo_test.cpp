#include "calibration/sightings.hpp"
#include "support/matchers.hpp"

namespace pmts::calibration {
namespace {

using camera::MountKind;
using test::thesisSightings;
using test::thesisStart;
using enum RigParameter;

std::vector<RigParameter> withoutPitch() {
    return {kFocalLength, kCentreX, kCentreY, kTwist, kOffsetY, kOffsetZ, kK1};
}

double value(const RigFit& fit, RigParameter parameter) {
    for (const ParameterEstimate& estimate : fit.parameters) {
        if (estimate.parameter == parameter) {
            return estimate.value;
        }
    }
    throw std::logic_error("not fitted");
}

// Expected figures: an independent fit of the same points (PMTS reference, section 9).

TEST(ThesisPhotoTest, EightParametersExplainTheElevenPointsToTheNoiseOfWholePixels) {
    const auto fit = fitRig(thesisSightings(), thesisStart(), thesisParameters());
    ASSERT_TRUE(fit.has_value());
    EXPECT_LE(fit->rms_px, 0.40);
    EXPECT_NEAR(fit->rms_px, 0.38, 0.01);
    EXPECT_NEAR(fit->largest_px, 0.78, 0.01);
    EXPECT_EQ(fit->redundancy, 14);
    EXPECT_EQ(fit->residuals_px.size(), 11U);
}

TEST(ThesisPhotoTest, FittedCameraIsTheOneOfTheReference) {
    const auto fit = fitRig(thesisSightings(), thesisStart(), thesisParameters());
    ASSERT_TRUE(fit.has_value());
    EXPECT_NEAR(value(*fit, kFocalLength), 762, 1);
    EXPECT_NEAR(value(*fit, kK1), -0.31, 0.01);
    EXPECT_NEAR(value(*fit, kOffsetY), 0.125, 0.005);
    EXPECT_NEAR(value(*fit, kOffsetZ), -0.035, 0.005);
    // The optical axis was level: VA 98.3 gon.
    EXPECT_NEAR(100 - fit->rig.mount.pitch.gon(), 98.3, 0.1);
}

TEST(ThesisPhotoTest, PitchIsKnownWorstBecauseTheCentreRowDoesNearlyTheSame) {
    const auto fit = fitRig(thesisSightings(), thesisStart(), thesisParameters());
    ASSERT_TRUE(fit.has_value());
    for (const ParameterEstimate& estimate : fit->parameters) {
        ASSERT_TRUE(estimate.determinable()) << parameterName(estimate.parameter).toStdString();
    }
    EXPECT_LT(*fit->parameters[0].standard_deviation, 3.0);    // f, px
    EXPECT_GT(*fit->parameters[2].standard_deviation, 5.0);    // cy, px
    EXPECT_GT(*fit->parameters[6].standard_deviation, 0.005);  // pitch, rad: 0.3 gon and more
}

TEST(ThesisPhotoTest, CameraForcedToTiltWithTheTelescopeFitsThreeTimesWorse) {
    const auto mounts = compareMounts(thesisSightings(), thesisStart(), withoutPitch());
    ASSERT_TRUE(mounts.has_value());
    EXPECT_NEAR(mounts->telescope.rms_px, 1.07, 0.03);
    EXPECT_LT(mounts->handle.rms_px, 0.45);
    EXPECT_EQ(mounts->likelier, MountKind::kHandle);
    EXPECT_TRUE(mounts->decisive());
}

TEST(ThesisPhotoTest, FreePitchAtOneTiltMakesTheMountsTheSameModel) {
    const auto mounts = compareMounts(thesisSightings(), thesisStart(), thesisParameters());
    ASSERT_TRUE(mounts.has_value());
    EXPECT_NEAR(mounts->variance_ratio, 1.0, 1e-3);
    EXPECT_FALSE(mounts->decisive());
    // The telescope can only pretend to be level by a camera pitched 7.7 gon up: implausible, but no
    // contradiction.
    EXPECT_NEAR(mounts->telescope.rig.mount.pitch.gon() - mounts->handle.rig.mount.pitch.gon(), 5.98, 0.01);
}

TEST(ThesisPhotoTest, ClicksOnTheWrongObjectStandOutInTheirResiduals) {
    auto sightings = thesisSightings();
    sightings[4].px.x() -= 25;
    const auto fit = fitRig(sightings, thesisStart(), thesisParameters());
    ASSERT_TRUE(fit.has_value());
    EXPECT_GT(fit->rms_px, 1.0);
    EXPECT_NEAR(fit->largest_px, std::abs(fit->residuals_px[4].x()), 3.0);
}

TEST(ThesisPhotoTest, RigThatNeverSawATargetStillMeetsItWithinAFewPixels) {
    const auto sightings = thesisSightings();
    const auto rigs = fitWithoutEach(sightings, thesisStart(), thesisParameters());
    ASSERT_TRUE(rigs.has_value());
    ASSERT_EQ(rigs->size(), sightings.size());
    double sum2_px2 = 0;
    for (std::size_t i = 0; i < sightings.size(); ++i) {
        const auto px = camera::pixelFromStation((*rigs)[i], sightings[i].at,
                                                 geometry::stationFromPolar(sightings[i].target));
        ASSERT_TRUE(px.has_value());
        sum2_px2 += (*px - sightings[i].px).squaredNorm() / (2.0 * static_cast<double>(sightings.size()));
    }
    // 8 unknowns from 20 coordinates: honest errors are larger than the fit's 0.38 px, yet no other world.
    EXPECT_GT(std::sqrt(sum2_px2), 0.38);
    EXPECT_LT(std::sqrt(sum2_px2), 3.0);
}

TEST(ThesisPhotoTest, LeavingOneOutOfTooFewIsRefused) {
    auto sightings = thesisSightings();
    sightings.resize(5);
    EXPECT_THAT(fitWithoutEach(sightings, thesisStart(), thesisParameters()),
                test::FailedWith(core::ErrorKind::kBadInput));
}

}  // namespace
}  // namespace pmts::calibration
