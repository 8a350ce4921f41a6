#include "pmts/app/field/range_presenter.hpp"

#include <QSignalSpy>
#include <gmock/gmock.h>

namespace pmts::app {
namespace {

using Field = RangePresenter::Field;

class RangePresenterTest : public testing::Test {
protected:
    Preferences preferences{QString()};
    RangeKeeper range{25.0};
    RangePresenter presenter{range, preferences};
    QSignalSpy rejected{&presenter, &RangePresenter::rejected};
};

TEST_F(RangePresenterTest, TypedRangesAreUsedAtOnceAndKept) {
    presenter.setTexts(QStringLiteral("40"), QStringLiteral("3 m"), QStringLiteral("0.3 km"));
    EXPECT_TRUE(rejected.isEmpty());
    EXPECT_DOUBLE_EQ(range.assumed(), 40.0);
    EXPECT_DOUBLE_EQ(preferences.settings().assumed_range_m, 40.0);
    EXPECT_DOUBLE_EQ(preferences.settings().image_tools.parallax_near_m, 3.0);
    EXPECT_DOUBLE_EQ(preferences.settings().image_tools.parallax_far_m, 300.0);
}

TEST_F(RangePresenterTest, BareNumbersHaveTheSurveyorsUnit) {
    UnitFormat feet;
    feet.length_unit = LengthUnit::kFoot;
    preferences.setUnits(feet);
    presenter.setTexts(QStringLiteral("100"), QStringLiteral("10"), QStringLiteral("500"));
    EXPECT_NEAR(range.assumed(), 30.48, 1e-9);
}

TEST_F(RangePresenterTest, RefusalNamesTheFieldAndTheLimitsAndChangesNothing) {
    presenter.setTexts(QStringLiteral("0.1"), QStringLiteral("2"), QStringLiteral("200"));
    ASSERT_EQ(rejected.size(), 1);
    EXPECT_EQ(rejected[0][0].value<Field>(), Field::kAssumed);
    EXPECT_TRUE(rejected[0][1].value<core::Error>().sentence().contains(QStringLiteral("0.500 m to 5000.000 m")));
    EXPECT_DOUBLE_EQ(range.assumed(), 25.0);
}

TEST_F(RangePresenterTest, FarEndNearerThanTheNearEndIsRefused) {
    presenter.setTexts(QStringLiteral("25"), QStringLiteral("50"), QStringLiteral("40"));
    ASSERT_EQ(rejected.size(), 1);
    EXPECT_EQ(rejected[0][0].value<Field>(), Field::kFar);
}

TEST_F(RangePresenterTest, ForgettingTheShotBringsTheAssumedRangeBack) {
    range.addShot({.ha = core::Angle::fromGon(10), .va = core::Angle::fromGon(100)}, 12.0);
    EXPECT_TRUE(presenter.hasShot());
    EXPECT_EQ(presenter.inUseText(), QStringLiteral("12.000 m (last shot)"));
    presenter.forgetShot();
    EXPECT_EQ(presenter.inUseText(), QStringLiteral("25.000 m (assumed)"));
}

TEST_F(RangePresenterTest, SlidersAreLogarithmicAndTheirEndsHaveNoLimit) {
    EXPECT_EQ(presenter.farText(), QStringLiteral("no end"));
    presenter.setDepthSteps(40, 80);
    EXPECT_NEAR(*preferences.settings().image_tools.depth.near_m, 10.0, 1e-9);
    EXPECT_NEAR(*preferences.settings().image_tools.depth.far_m, 100.0, 1e-9);
    EXPECT_EQ(presenter.nearText(), QStringLiteral("from 10 m"));
    EXPECT_EQ(presenter.farText(), QStringLiteral("to 100 m"));
    EXPECT_EQ(presenter.nearStep(), 40);
    presenter.setDepthSteps(0, RangePresenter::kDepthSteps);
    EXPECT_EQ(preferences.settings().image_tools.depth, DepthFilter{});
}

}  // namespace
}  // namespace pmts::app
