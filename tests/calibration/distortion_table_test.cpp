#include "pmts/calibration/distortion_table.hpp"

#include "pmts/geometry/frames.hpp"
#include "support/matchers.hpp"

#include <random>

namespace pmts::calibration {
namespace {

using core::Angle;
using core::ErrorKind;
using test::FailedWith;
using testing::HasSubstr;
using Row = camera::RadialTableLens::Row;

camera::Rig trueRig() {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 760, .cx_px = 321, .cy_px = 242, .k1 = -0.31});
    rig.width_px = 640;
    rig.height_px = 480;
    rig.mount = {.kind = camera::MountKind::kTelescope, .offset_m = {0.012, 0.085, 0.052}, .yaw = Angle::fromGon(0.5),
                 .pitch = Angle::fromGon(-0.7), .twist = Angle::fromGon(1.2)};
    return rig;
}

/// What the user has before: offsets and principal point, the rest roughly.
camera::Rig believedRig() {
    camera::Rig rig = trueRig();
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 800, .cx_px = 321, .cy_px = 242});
    rig.mount.yaw = rig.mount.pitch = rig.mount.twist = Angle();
    return rig;
}

/// The pixel of the target from pointings on a grid around it, as a sweep finds them: only those near the planned places.
TableRun runWith(const camera::Rig& truth, double distance_m, const std::vector<RadiusDirection>& directions, double noise_px,
                 unsigned seed = 1) {
    TableRun run{.target = {{Angle::fromGon(20), Angle::fromGon(97)}, distance_m}, .spots = {}};
    const Eigen::Vector3d target = geometry::stationFromPolar(run.target);
    std::mt19937 engine(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    for (const PlannedSpot& planned : plannedSpots(truth, directions, 30, 15)) {
        geometry::Pointing at = run.target.pointing;
        for (int round = 0; round < 50; ++round) {  // turn until it is about there
            const Eigen::Vector2d left = planned.px - camera::pixelFromStation(truth, at, target).value();
            at.ha -= Angle::fromRad(left.x() / 800);
            at.va -= Angle::fromRad(left.y() / 800);
        }
        const Eigen::Vector2d px = camera::pixelFromStation(truth, at, target).value();
        run.spots.push_back({px + noise_px * Eigen::Vector2d(noise(engine), noise(engine)), at});
    }
    return run;
}

/// Difference in pixels between the table and the true lens at a radius to the right.
double offAt(const camera::RadialTableLens& table, const camera::Rig& truth, double radius_px) {
    const double angle = angleAt_rad(table, radius_px).value();
    const Eigen::Vector2d px = truth.lens.pixelFromCamera({std::sin(angle), 0, std::cos(angle)}).value();
    return px.x() - truth.lens.principalPoint().x() - radius_px;
}

TEST(DistortionTableTest, CurveIsTheTrueAngleOffTheAxisThoughTheMountIsNotKnown) {
    const camera::Rig truth = trueRig();
    const auto curves = curvesOfRun(runWith(truth, 5.333, {RadiusDirection::kRight, RadiusDirection::kUpLeft}, 0), believedRig());

    ASSERT_TRUE(curves.has_value()) << testing::PrintToString(curves.error());
    ASSERT_EQ(curves->size(), 2U);
    for (const TableCurve& curve : *curves) {
        for (std::size_t i = 1; i < curve.rows.size(); ++i) {
            const double tangent = std::tan(curve.rows[i].angle_rad);
            const double radius_px = 760 * tangent * (1 - 0.31 * tangent * tangent);  // Brown's formula, by hand
            EXPECT_NEAR(curve.rows[i].radius_px, radius_px, 0.02) << qPrintable(directionName(curve.direction));
        }
    }
}

TEST(DistortionTableTest, ShortRangeDoesNotBendTheCurve) {
    const auto near = curvesOfRun(runWith(trueRig(), 2.5, {RadiusDirection::kRight}, 0), believedRig());
    const auto far = curvesOfRun(runWith(trueRig(), 40, {RadiusDirection::kRight}, 0), believedRig());

    ASSERT_TRUE(near && far);
    for (std::size_t i = 1; i < near->front().rows.size(); ++i) {
        EXPECT_NEAR(near->front().rows[i].angle_rad, far->front().rows[i].angle_rad, 2e-5);  // 0.015 px
    }
}

TEST(DistortionTableTest, TableOfNoisySightingsIsGoodToATenthOfAPixel) {
    const camera::Rig truth = trueRig();
    std::vector<TableCurve> all;
    for (const double distance_m : {5.333, 9.999, 15.003}) {
        const auto curves = curvesOfRun(runWith(truth, distance_m, {RadiusDirection::kRight, RadiusDirection::kLeft}, 0.04,
                                                static_cast<unsigned>(distance_m)), believedRig());
        ASSERT_TRUE(curves.has_value());
        all.insert(all.end(), curves->begin(), curves->end());
    }
    const auto table = tableOfCurves(all, {321, 242}, 30);

    ASSERT_TRUE(table.has_value()) << testing::PrintToString(table.error());
    double squares = 0;
    int count = 0;
    for (double radius_px = 5; radius_px < table->lens.rows.back().radius_px; radius_px += 5, ++count) {
        squares += std::pow(offAt(table->lens, truth, radius_px), 2);
    }
    EXPECT_LT(std::sqrt(squares / count), 0.1);
}

TEST(DistortionTableTest, TargetNeverNearTheCentreIsRefused) {
    TableRun run = runWith(trueRig(), 5, {RadiusDirection::kRight}, 0);
    std::erase_if(run.spots, [](const TableSpot& spot) { return spot.px.x() < 400; });

    EXPECT_THAT(curvesOfRun(run, believedRig()), FailedWith(ErrorKind::kBadInput));
}

TEST(DistortionTableTest, PlannedSpotsStepToTheEdgeAndStartAtTheCross) {
    const auto spots = plannedSpots(trueRig(), {RadiusDirection::kRight, RadiusDirection::kDown}, 30, 15);

    EXPECT_EQ(spots.front().px, Eigen::Vector2d(321, 242));
    EXPECT_EQ(spots[1].px, Eigen::Vector2d(351, 242));
    EXPECT_EQ(spots.size(), 1U + 10U + 7U);  // 321 + 300 = 621 and 242 + 210 = 452 are the last inside
}

// The thesis's figures 5.14 and 5.15: 0.083719 gon per pixel at the centre, 1.48121 gon off the line at pixel 290.
TEST(DistortionTableTest, DeviationAndPixelWidthOfTheThesissLens) {
    const double bend = 1.48121 / std::pow(290.0, 3);
    std::vector<Row> rows;
    for (int radius = 0; radius <= 300; radius += 30) {
        rows.push_back({static_cast<double>(radius), Angle::fromGon(0.083719 * radius - bend * std::pow(radius, 3)).rad()});
    }
    const double width = centralPixelWidth_rad(rows);
    const double angle = angleAt_rad({0, 0, rows}, 290).value();

    EXPECT_NEAR(Angle::fromRad(width).gon(), 0.083719, 1e-6);
    EXPECT_NEAR(Angle::fromRad(idealLineAngle_rad(width, 290) - angle).gon(), 1.48121, 2e-3);
    EXPECT_NEAR(Angle::fromRad(pixelWidths(rows).back().width_rad).gon(), 0.06892, 1e-4);
}

TEST(DistortionTableTest, RowThatFallsBackIsNamed) {
    EXPECT_TRUE(whyNoTable({{0, 0}, {30, 0.04}, {60, 0.08}}).isEmpty());
    EXPECT_THAT(whyNoTable({{0, 0}, {30, 0.04}, {60, 0.04}}).toStdString(), HasSubstr("Row 3"));
    EXPECT_THAT(whyNoTable({{0, 0}, {30, 0.04}, {20, 0.05}}).toStdString(), HasSubstr("radius"));
    EXPECT_THAT(whyNoTable({{1, 0}, {30, 0.04}}).toStdString(), HasSubstr("first row"));
}

TEST(DistortionTableTest, CsvComesBack) {
    const camera::RadialTableLens table{321.25, 241.125, {{0, 0}, {30, 0.039461}, {60, 0.0788123456789}}};

    const auto back = tableFromCsv(tableToCsv(table));

    ASSERT_TRUE(back.has_value()) << testing::PrintToString(back.error());
    EXPECT_EQ(back->cx_px, table.cx_px);
    ASSERT_EQ(back->rows.size(), 3U);
    EXPECT_NEAR(back->rows[2].angle_rad, table.rows[2].angle_rad, 1e-15);
}

TEST(DistortionTableTest, CsvWithAWordForANumberNamesItsLine) {
    const auto table = tableFromCsv("# centre_px,320,240\nradius_px,angle_gon\n0,0\n30,wide\n");

    ASSERT_THAT(table, FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(table.error().happened.toStdString(), HasSubstr("Line 4"));
}

}  // namespace
}  // namespace pmts::calibration
