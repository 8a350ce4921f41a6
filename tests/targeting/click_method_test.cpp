#include "pmts/targeting/click_method.hpp"

#include "pmts/geometry/polar.hpp"
#include "support/matchers.hpp"

namespace pmts::targeting {
namespace {

using core::Angle;
using geometry::Pointing;
using test::FailedWith;
using test::IsNearAngle;

constexpr Method kThesis[] = {Method::kApa, Method::kTpa, Method::kOatpa, Method::kRectifiedOatpa};

camera::Rig straightRig() {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 1500, .cx_px = 639.5, .cy_px = 359.5});
    return rig;
}

Pointing level() { return {Angle::fromGon(20), Angle::fromGon(100)}; }

TEST(ClickMethodTest, AllMethodsAgreeAtTheCentreOfAStraightCamera) {
    const PixelToPointing model(straightRig());
    for (const Method method : {Method::kApa, Method::kTpa, Method::kOatpa, Method::kRectifiedOatpa, Method::kRigorous}) {
        const auto pointing = pointingOfClick({.method = method, .measured_pixel_angle = {}}, model, {639.5, 359.5}, level(), 20);
        ASSERT_TRUE(pointing.has_value()) << methodName(method).toStdString();
        EXPECT_LT(geometry::separation(*pointing, level()), Angle::fromCc(1)) << methodName(method).toStdString();
    }
}

TEST(ClickMethodTest, TpaIsTheArcTangentOfPixelsByF) {
    const PixelToPointing model(straightRig());
    const auto pointing =
        pointingOfClick({.method = Method::kTpa, .measured_pixel_angle = {}}, model, {639.5 + 150, 359.5}, level(), 20);
    ASSERT_TRUE(pointing.has_value());
    // atan(150 / 1500) is 6.3451 gon by any table of tangents.
    EXPECT_THAT(pointing->ha, IsNearAngle(Angle::fromGon(26.3451), Angle::fromGon(0.0002)));
}

TEST(ClickMethodTest, ApaTakesTheMeasuredPixelAngle) {
    const PixelToPointing model(straightRig());
    const AveragePixelAngle measured{Angle::fromGon(0.05), Angle::fromGon(0.04)};
    const auto pointing = pointingOfClick({.method = Method::kApa, .measured_pixel_angle = measured}, model,
                                          {639.5 - 100, 359.5 + 50}, level(), 20);
    ASSERT_TRUE(pointing.has_value());
    EXPECT_THAT(pointing->ha, IsNearAngle(Angle::fromGon(15), Angle::fromCc(1)));
    EXPECT_THAT(pointing->va, IsNearAngle(Angle::fromGon(102), Angle::fromCc(1)));
}

TEST(ClickMethodTest, RectifiedOatpaReadsTheMeasuredTable) {
    camera::Rig rig = straightRig();
    // Wider than any lens bends, so that nothing but the table itself gives this angle; its rows are not on thirties.
    rig.lens = camera::Lens(camera::RadialTableLens{639.5, 359.5, {{0, 0}, {95, 0.09}, {205, 0.2}, {613, 0.65}}});  // ends before the edge
    const auto pointing = pointingOfClick({.method = Method::kRectifiedOatpa, .measured_pixel_angle = {}}, PixelToPointing(rig),
                                          {639.5 + 612.99, 359.5}, level(), 20);
    ASSERT_TRUE(pointing.has_value());
    EXPECT_THAT(pointing->ha, IsNearAngle(Angle::fromGon(20) + Angle::fromRad(0.65), Angle::fromMgon(1)));
}

TEST(ClickMethodTest, AddedAnglesMissARotatedRayInTheCorner) {
    const PixelToPointing model(straightRig());
    const Pointing tilted{Angle::fromGon(20), Angle::fromGon(70)};
    const auto rigorous = pointingOfClick({}, model, {1200, 60}, tilted, 20);
    const auto added = pointingOfClick({.method = Method::kTpa, .measured_pixel_angle = {}}, model, {1200, 60}, tilted, 20);
    ASSERT_TRUE(rigorous && added);
    EXPECT_GT(geometry::separation(*rigorous, *added), Angle::fromGon(0.5));
}

TEST(ClickMethodTest, RigorousKeepsTheFaceAndTheOthersRefuseFaceTwo) {
    const PixelToPointing model(straightRig());
    const Pointing face_two{Angle::fromGon(220), Angle::fromGon(300)};
    const auto rigorous = pointingOfClick({}, model, {700, 300}, face_two, 20);
    ASSERT_TRUE(rigorous.has_value());
    EXPECT_TRUE(geometry::isFaceTwo(*rigorous));
    for (const Method method : kThesis) {
        EXPECT_THAT(pointingOfClick({.method = method, .measured_pixel_angle = {}}, model, {700, 300}, face_two, 20),
                    FailedWith(core::ErrorKind::kUndefined));
    }
}

}  // namespace
}  // namespace pmts::targeting
