#include "pmts/app/field/plane_range.hpp"

#include "app/field_fixture.hpp"

namespace pmts::app {
namespace {

/// Points on the wall of the fixture, 15 m to the north.
class PlaneRangeTest : public FieldTest {
protected:
    void SetUp() override {
        connectInstrument();
        openJob();
    }
    void recordOnWall(const std::vector<std::pair<double, double>>& pointings_gon) {
        for (const auto& [ha, va] : pointings_gon) {
            ASSERT_TRUE(turnTo(ha, va));
            ASSERT_TRUE(recordPoint());
        }
    }
    [[nodiscard]] QList<qint64> allRows() const {
        QList<qint64> rows;
        for (const survey::Point& point : points.points()) {
            rows.append(point.row_id);
        }
        return rows;
    }

    PlaneRange plane{range, points, station_page, preferences, messages};
};

TEST_F(PlaneRangeTest, ThreePointsOnAWallGiveTheRangeOfTheFourth) {
    recordOnWall({{0, 100}, {20, 98}, {390, 90}});
    plane.use(allRows());
    ASSERT_TRUE(turnTo(375, 95));
    EXPECT_EQ(live.scene().range.source, RangeSource::kPlane);
    EXPECT_THAT(live.scene().range_text.toStdString(), testing::HasSubstr("(plane)"));
    const double truth_m = 15.0 / (std::cos(Angle::fromGon(-25).rad()) * std::sin(Angle::fromGon(95).rad()));
    EXPECT_NEAR(live.scene().range.slope_distance_m, truth_m, 0.03);
}

TEST_F(PlaneRangeTest, ClickTakesItsRangeFromThePlane) {
    recordOnWall({{0, 100}, {20, 98}, {390, 90}});
    plane.use(allRows());
    showFrames();
    targeting.aimAtLivePixel({200, 500});
    ASSERT_TRUE(targeting.target().has_value());
    EXPECT_EQ(targeting.target()->range.source, RangeSource::kPlane);
}

TEST_F(PlaneRangeTest, TwoPointsAreRefusedWithASentence) {
    recordOnWall({{0, 100}, {20, 98}});
    plane.use(allRows());
    EXPECT_FALSE(range.plane().has_value());
    EXPECT_FALSE(messages.bars().empty());
}

TEST_F(PlaneRangeTest, PlaneIsGivenUpWhenItsPointsAreStruckOut) {
    recordOnWall({{0, 100}, {20, 98}, {390, 90}});
    plane.use(allRows());
    ASSERT_TRUE(range.plane().has_value());
    points.strikeOut({allRows().front()});
    ASSERT_TRUE(until([this] { return !range.plane(); }));
    EXPECT_NE(live.scene().range.source, RangeSource::kPlane);
}

}  // namespace
}  // namespace pmts::app
