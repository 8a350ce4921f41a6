#include "pmts/targeting/thesis_methods.hpp"

#include "pmts/targeting/pixel_to_pointing.hpp"
#include "support/matchers.hpp"
#include "targeting/icsm_table.hpp"

namespace pmts::targeting {
namespace {

using core::Angle;
using core::ErrorKind;
using geometry::Pointing;
using test::FailedWith;
using test::icsmPhoto;
using test::icsmTable;
using test::IsNearAngle;

const Angle kTableResidue = Angle::fromGon(0.010);  // the thesis's 22/7 and its rounding to 0.01 gon

/// Larger of the two circles' errors.
Angle missed(const Pointing& computed, const Pointing& observed) {
    return std::max(core::abs(core::normalizedSigned(computed.ha - observed.ha)),
                    core::abs(computed.va - observed.va));
}

TEST(ThesisMethodsTest, ApaReproducesThePrintedTableAboutColumn316) {
    ThesisCamera camera;
    camera.centre_px.x() = 316;
    for (const auto& row : icsmTable()) {
        EXPECT_LT(missed(apa(camera, icsmPhoto(), row.px), row.apa).gon(), 0.001) << row.px.transpose();
    }
}

TEST(ThesisMethodsTest, TpaReproducesThePrintedTable) {
    for (const auto& row : icsmTable()) {
        EXPECT_LE(missed(tpa({}, icsmPhoto(), row.px), row.tpa), kTableResidue) << row.px.transpose();
    }
}

TEST(ThesisMethodsTest, OatpaReproducesThePrintedTableByAddingTheOffset) {
    for (const auto& row : icsmTable()) {
        const auto pointing = oatpa({}, icsmPhoto(), row.px, row.observed.slope_distance_m);
        ASSERT_TRUE(pointing.has_value());
        EXPECT_LE(missed(*pointing, row.oatpa), kTableResidue) << row.px.transpose();
    }
}

TEST(ThesisMethodsTest, ErrorsOnTheElevenPointsAreThoseTheHeaderStates) {
    Angle worst_tpa, worst_oatpa;
    for (const auto& row : icsmTable()) {
        const Pointing& observed = row.observed.pointing;
        worst_tpa = std::max(worst_tpa, missed(tpa({}, icsmPhoto(), row.px), observed));
        worst_oatpa = std::max(
            worst_oatpa, missed(*oatpa({}, icsmPhoto(), row.px, row.observed.slope_distance_m), observed));
    }
    EXPECT_NEAR(worst_tpa.gon(), 1.76, 0.02);
    EXPECT_NEAR(worst_oatpa.gon(), 1.71, 0.02);
}

TEST(ThesisMethodsTest, AveragePixelAngleComesFromTheExtremeObjects) {
    const auto table = icsmTable();
    const auto sighted = [&table](int number) {
        return SightedPixel{table[number - 1].px, table[number - 1].observed.pointing};
    };
    // Objects 11 and 5 are the outermost columns (73 and 624), 4 and 1 the outermost rows (172 and 371).
    const auto angle = averagePixelAngle(sighted(11), sighted(5), sighted(4), sighted(1));
    ASSERT_TRUE(angle.has_value());
    EXPECT_NEAR(angle->horizontal.gon(), (225.0055 - 179.1463) / 551, 1e-9);
    EXPECT_NEAR(angle->vertical.gon(), (116.7947 - 100.3806) / 199, 1e-9);
    EXPECT_THAT(averagePixelAngle(sighted(1), sighted(1), sighted(4), sighted(1)),
                FailedWith(ErrorKind::kUndefined));
}

TEST(ThesisMethodsTest, AveragePixelAngleSpansTheZeroOfTheCircle) {
    const SightedPixel left{{100, 240}, {Angle::fromGon(395), Angle::fromGon(100)}};
    const SightedPixel right{{200, 240}, {Angle::fromGon(5), Angle::fromGon(100)}};
    const SightedPixel upper{{150, 100}, {Angle::fromGon(0), Angle::fromGon(95)}};
    const SightedPixel lower{{150, 300}, {Angle::fromGon(0), Angle::fromGon(105)}};
    const auto angle = averagePixelAngle(left, right, upper, lower);
    ASSERT_TRUE(angle.has_value());
    EXPECT_NEAR(angle->horizontal.gon(), 0.1, 1e-12);
    EXPECT_NEAR(angle->vertical.gon(), 0.05, 1e-12);
}

TEST(ThesisMethodsTest, ParallaxOfTheOffsetHasTheSizeTheReferenceStates) {
    // 0.085 m across the line of sight is 0.95 gon at 5.7 m (PMTS reference, section 9): sin h = 1 is the
    // limit.
    const Eigen::Vector2d far_right(1e9, 240);
    const auto near = oatpa({}, icsmPhoto(), far_right, 5.7);
    ASSERT_TRUE(near.has_value());
    EXPECT_NEAR((near->ha - tpa({}, icsmPhoto(), far_right).ha).gon(), 0.95, 0.002);
}

TEST(ThesisMethodsTest, OatpaNeedsATargetOutsideTheCamera) {
    EXPECT_THAT(oatpa({}, icsmPhoto(), {100, 100}, 0.09), FailedWith(ErrorKind::kUndefined));
    EXPECT_THAT(oatpa({}, icsmPhoto(), {100, 100}, -5.0), FailedWith(ErrorKind::kUndefined));
    EXPECT_THAT(oatpa({}, icsmPhoto(), {100, 100}, std::nan("")), FailedWith(ErrorKind::kUndefined));
}

camera::RadialTableLens tableOf(const camera::BrownLens& lens) {
    camera::RadialTableLens table{.cx_px = 315, .cy_px = 240, .rows = {{0, 0}}};
    for (double radius_px = 30; radius_px <= 420; radius_px += 30) {
        const Eigen::Vector3d ray = camera::Lens(lens).cameraFromPixel({radius_px, 0}).value();
        table.rows.push_back({radius_px, std::atan2(ray.x(), ray.z())});
    }
    return table;
}

TEST(ThesisMethodsTest, RectifiedOatpaWithAnIdealTableIsOatpa) {
    const auto ideal = tableOf({.f_px = 784});
    for (const auto& row : icsmTable()) {
        const double sd_m = row.observed.slope_distance_m;
        const auto rectified = rectifiedOatpa({}, ideal, icsmPhoto(), row.px, sd_m);
        ASSERT_TRUE(rectified.has_value());
        EXPECT_LT(missed(*rectified, *oatpa({}, icsmPhoto(), row.px, sd_m)).gon(), 0.003);
    }
}

TEST(ThesisMethodsTest, DistortionTableOfTheFittedLensTakesMostOfTheError) {
    // f and k1 as fitted to the same points (PMTS reference, section 9). What is left is the lens's own
    // centre, 90 rows above the photo's, which a table about the photo's centre cannot know.
    const auto barrel = tableOf({.f_px = 762, .k1 = -0.31});
    double sum2_oatpa = 0, sum2_rectified = 0;
    for (const auto& row : icsmTable()) {
        const double sd_m = row.observed.slope_distance_m;
        const Pointing& observed = row.observed.pointing;
        sum2_oatpa += std::pow(missed(*oatpa({}, icsmPhoto(), row.px, sd_m), observed).gon(), 2);
        sum2_rectified +=
            std::pow(missed(*rectifiedOatpa({}, barrel, icsmPhoto(), row.px, sd_m), observed).gon(), 2);
    }
    EXPECT_LT(sum2_rectified, 0.25 * sum2_oatpa);
}

TEST(ThesisMethodsTest, RectifiedOatpaEndsWithItsTable) {
    EXPECT_THAT(rectifiedOatpa({}, tableOf({.f_px = 784}), icsmPhoto(), {900, 240}, 10),
                FailedWith(ErrorKind::kUndefined));
}

TEST(ThesisMethodsTest, AddingAnglesMissesInTheCornersEvenWithAPerfectCamera) {
    // Why the rigorous model rotates the ray: same f, no offset, no distortion, camera tilted with the
    // telescope.
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 784, .cx_px = 315, .cy_px = 240});
    const Eigen::Vector2d corner(0, 479);
    const auto rigorous = PixelToPointing(rig).pointingForPixel(corner, icsmPhoto(), 20);
    ASSERT_TRUE(rigorous.has_value());
    EXPECT_GT(missed(tpa({}, icsmPhoto(), corner), *rigorous).gon(), 0.5);
    EXPECT_THAT(tpa({}, icsmPhoto(), {315, 240}).ha, IsNearAngle(icsmPhoto().ha, Angle::fromCc(0.1)));
}

}  // namespace
}  // namespace pmts::targeting
