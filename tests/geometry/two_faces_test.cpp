#include "pmts/geometry/two_faces.hpp"

#include "pmts/geometry/polar.hpp"
#include "support/matchers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pmts::geometry {
namespace {

using core::Angle;

/// Circle readings of an instrument with these errors at a true direction (surveying textbooks: HA is off by
/// c / sin VA + k cot VA, VA by i; in face II with the face II zenith angle).
struct Axes {
    Angle collimation, index, tilting;

    [[nodiscard]] Pointing reading(const Pointing& truth) const {
        const double sine = core::sin(truth.va);
        return {core::normalized(truth.ha + collimation / sine + tilting * (core::cos(truth.va) / sine)), truth.va + index};
    }
    [[nodiscard]] FacePair pair(double ha_gon, double va_gon) const {
        const Pointing truth{Angle::fromGon(ha_gon), Angle::fromGon(va_gon)};
        return {reading(truth), reading(otherFace(truth))};
    }
};

constexpr Axes kAxes{Angle::fromMgon(6), Angle::fromMgon(-4), Angle::fromMgon(3)};

TEST(TwoFacesTest, TheMeanIsFreeOfAllThreeErrorsAcrossTheZeroOfTheCircle) {
    for (const double ha : {0.001, 120.0, 399.999}) {
        const auto mean = meanOfFaces(kAxes.pair(ha, 70));
        EXPECT_NEAR(core::normalizedSigned(mean.ha - Angle::fromGon(ha)).cc(), 0.0, 1e-3);
        EXPECT_NEAR(mean.va.gon(), 70.0, 1e-7);
    }
}

TEST(TwoFacesTest, TheDifferencesAreTwiceTheErrorsAtTheHorizon) {
    const auto difference = faceDifference(kAxes.pair(10, 100));
    EXPECT_NEAR(difference.ha.mgon(), 12.0, 1e-6);
    EXPECT_NEAR(difference.va.mgon(), -8.0, 1e-6);
}

TEST(TwoFacesTest, CollimationAndIndexFollowFromTargetsAtTheHorizon) {
    const auto errors = axisErrorsFrom({kAxes.pair(10, 100), kAxes.pair(110, 100)});
    ASSERT_TRUE(errors.has_value());
    EXPECT_NEAR(errors->collimation.value.mgon(), 6.0, 1e-6);
    EXPECT_NEAR(errors->index.value.mgon(), -4.0, 1e-6);
    EXPECT_FALSE(errors->tilting.has_value()) << "level targets say nothing of the tilting axis";
}

TEST(TwoFacesTest, ASteepTargetBesideALevelOneShowsTheTiltingAxisToo) {
    const auto errors = axisErrorsFrom({kAxes.pair(10, 100), kAxes.pair(10, 70), kAxes.pair(200, 125)});
    ASSERT_TRUE(errors.has_value());
    ASSERT_TRUE(errors->tilting.has_value());
    EXPECT_NEAR(errors->collimation.value.mgon(), 6.0, 1e-6);
    EXPECT_NEAR(errors->tilting->value.mgon(), 3.0, 1e-6);
}

TEST(TwoFacesTest, TheStandardDeviationIsThatOfTheMean) {
    // Readings of 0.3 mgon: c from n pairs is off by 0.3 / sqrt(2 n).
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 0.3);
    std::vector<FacePair> pairs;
    for (int i = 0; i < 200; ++i) {
        auto pair = kAxes.pair(50, 100);
        for (Angle* angle : {&pair.face_one.ha, &pair.face_one.va, &pair.face_two.ha, &pair.face_two.va}) {
            *angle += Angle::fromMgon(noise(random));
        }
        pairs.push_back(pair);
    }
    const auto errors = axisErrorsFrom(pairs);
    ASSERT_TRUE(errors && errors->collimation.sigma && errors->index.sigma);
    EXPECT_NEAR(errors->collimation.sigma->mgon(), 0.3 / std::sqrt(400.0), 0.002);
    EXPECT_NEAR(errors->collimation.value.mgon(), 6.0, 0.05);
    EXPECT_NEAR(errors->index.value.mgon(), -4.0, 0.05);
}

TEST(TwoFacesTest, OnePairHasNoStandardDeviationAndNoneNoResult) {
    const auto errors = axisErrorsFrom({kAxes.pair(10, 100)});
    ASSERT_TRUE(errors.has_value());
    EXPECT_FALSE(errors->collimation.sigma.has_value());
    EXPECT_FALSE(errors->index.sigma.has_value());
    EXPECT_EQ(axisErrorsFrom({}).error().kind, core::ErrorKind::kBadInput);
    EXPECT_EQ(axisErrorsFrom({kAxes.pair(10, 3)}).error().kind, core::ErrorKind::kUndefined);
}

}  // namespace
}  // namespace pmts::geometry
