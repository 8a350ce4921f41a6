#include "pmts/camera/lens.hpp"
#include "support/matchers.hpp"

#include <numbers>
#include <random>

namespace pmts::camera {
namespace {

using core::Angle;
using test::FailedWith;

/// Rows of an ideal lens every 30 px, as the thesis observes them.
RadialTableLens idealTable(double f_px, double last_px = 420) {
    RadialTableLens table{.cx_px = 315, .cy_px = 240, .rows = {}};
    for (double radius_px = 0; radius_px <= last_px; radius_px += 30) {
        table.rows.push_back({radius_px, std::atan(radius_px / f_px)});
    }
    return table;
}

double angleOffAxis(const Lens& lens, double radius_px) {
    const Eigen::Vector3d ray =
        lens.cameraFromPixel(lens.principalPoint() + Eigen::Vector2d(radius_px, 0)).value();
    return std::atan2(ray.head<2>().norm(), ray.z());
}

TEST(RadialTableTest, TableOfAnIdealLensSeesWhatTheIdealLensSees) {
    const Lens lens(idealTable(762));
    for (double radius_px = 0; radius_px <= 420; radius_px += 7) {
        // Far below the 0.08 gon of a pixel.
        EXPECT_NEAR(angleOffAxis(lens, radius_px), std::atan(radius_px / 762), Angle::fromGon(0.002).rad())
            << radius_px;
    }
    EXPECT_NEAR(lens.focalLengthPx(), 762, 1.0);
}

TEST(RadialTableTest, PixelWidthAtTheCentreIsThatOfTheThesis) {
    // Fig. 5.15: 0.083719 gon per pixel near the centre, so the first row at 30 px is 30 of them.
    const double first_rad = Angle::fromGon(30 * 0.083719).rad();
    const Lens lens(RadialTableLens{.rows = {{0, 0}, {30, first_rad}, {60, 1.99 * first_rad}}});
    EXPECT_NEAR(Angle::fromRad(1.0 / lens.focalLengthPx()).gon(), 0.083719, 1e-9);
}

TEST(RadialTableTest, PieceBetweenRowsIsTheMonotoneCubicWorkedOutByHand) {
    // Rows (0,0) (1,0.1) (2,0.3): slope 0.1 at the axis, 2/(1/0.1 + 1/0.2) = 0.4/3 at the middle row. Half
    // way up the first piece: 0.05 + (0.1 - 0.4/3) / 8.
    const Lens lens(RadialTableLens{.rows = {{0, 0}, {1, 0.1}, {2, 0.3}}});
    EXPECT_NEAR(angleOffAxis(lens, 0.5), 0.05 - 0.1 / 24, 1e-12);
    EXPECT_NEAR(angleOffAxis(lens, 1.0), 0.1, 1e-12);
    EXPECT_NEAR(angleOffAxis(lens, 2.0), 0.3, 1e-12);
}

TEST(RadialTableTest, InterpolationNeverTurnsBackBetweenUnevenRows) {
    std::mt19937 engine(31);
    std::exponential_distribution<double> step(1.0);
    for (int table = 0; table < 50; ++table) {
        RadialTableLens model{.rows = {{0, 0}}};
        for (int i = 0; i < 10; ++i) {
            const RadialTableLens::Row& last = model.rows.back();
            model.rows.push_back(
                {last.radius_px + 0.1 + 30 * step(engine), last.angle_rad + 1e-4 + 0.04 * step(engine)});
        }
        const Lens lens(model);
        double before = -1;
        for (int i = 0; i <= 200; ++i) {
            const double angle = angleOffAxis(lens, model.rows.back().radius_px * i / 200);
            EXPECT_GT(angle, before);
            before = angle;
        }
    }
}

TEST(RadialTableTest, PixelsGoOutAndComeBack) {
    const Lens lens(idealTable(762));
    for (double v = 0; v < 480; v += 24) {
        for (double u = 0; u < 640; u += 32) {
            const auto ray = lens.cameraFromPixel({u, v});
            ASSERT_TRUE(ray.has_value());
            EXPECT_LT((*lens.pixelFromCamera(*ray) - Eigen::Vector2d(u, v)).norm(), 1e-6);
        }
    }
}

TEST(RadialTableTest, RightAndDownInThePictureAreRightAndDownInTheView) {
    const Lens lens(idealTable(762));
    EXPECT_GT(lens.cameraFromPixel({415, 240})->x(), 0);
    EXPECT_GT(lens.cameraFromPixel({315, 340})->y(), 0);
    EXPECT_TRUE(lens.cameraFromPixel({315, 240})->isApprox(Eigen::Vector3d::UnitZ()));
    EXPECT_TRUE(lens.pixelFromCamera({0, 0, 5})->isApprox(Eigen::Vector2d(315, 240)));
}

TEST(RadialTableTest, NothingIsGuessedPastTheLastRow) {
    const Lens lens(idealTable(762, 300));
    EXPECT_TRUE(lens.cameraFromPixel({615, 240}).has_value());
    EXPECT_THAT(lens.cameraFromPixel({616, 240}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(lens.pixelFromCamera({301, 0, 762}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(lens.pixelFromCamera({0, 0, -1}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(lens.pixelFromCamera({0, 0, 0}), FailedWith(core::ErrorKind::kUndefined));
}

TEST(RadialTableTest, TableThatIsNoFunctionIsRefused) {
    using Rows = std::vector<RadialTableLens::Row>;
    for (const Rows& rows :
         {Rows{}, Rows{{0, 0}}, Rows{{1, 0.1}, {2, 0.2}}, Rows{{0, 0}, {30, 0.1}, {30, 0.2}},
          Rows{{0, 0}, {30, 0.1}, {60, 0.1}}, Rows{{0, 0}, {30, 4.0}}}) {
        EXPECT_THROW(Lens(RadialTableLens{.rows = rows}), std::logic_error);
    }
}

}  // namespace
}  // namespace pmts::camera
