#include "pmts/app/lab/parallax_presenter.hpp"

#include "app/lab_fixture.hpp"

namespace pmts::app {
namespace {

using testing::HasSubstr;

/// A camera 30 mm right of and 40 mm above where the profile has it, and a little turned.
class ParallaxPresenterTest : public LabTest {
protected:
    void SetUp() override {
        camera::Rig truth = simulator::simulatedRig();
        truth.mount.offset_m += Eigen::Vector3d(0.030, 0.0, 0.040);
        truth.mount.yaw += Angle::fromGon(0.3);
        truth.mount.pitch -= Angle::fromGon(0.2);
        look(QStringLiteral("laboratory"), truth);
        connectInstrument();
    }
    void sightAndClick(const char* name) {
        ASSERT_TRUE(sight(name));
        parallax.setDistance(mark(name).slope_distance_m);
        parallax.click(seen(name) + QPointF(5, -4));  // snaps
    }

    ParallaxPresenter parallax{live, instrument, range, preferences, messages, Threading::kCallersThread};
};

TEST_F(ParallaxPresenterTest, TwoBoardsGiveTheOffsetsAndAThirdMarkVerifiesThem) {
    EXPECT_THAT(parallax.step().toStdString(), HasSubstr("far board"));
    sightAndClick("2D");
    EXPECT_EQ(parallax.stage(), ParallaxStage::kNear);
    sightAndClick("D");

    ASSERT_TRUE(parallax.fit().has_value()) << qPrintable(parallax.step());
    EXPECT_NEAR(parallax.fit()->mount.offset_m.x(), rig.mount.offset_m.x(), 0.001);
    EXPECT_NEAR(parallax.fit()->mount.offset_m.z(), rig.mount.offset_m.z(), 0.001);
    EXPECT_THAT(parallax.gapText().toStdString(), HasSubstr("22."));  // half of 42 mm, and a little for the 85 mm forward

    parallax.accept();
    EXPECT_EQ(parallax.stage(), ParallaxStage::kVerify);
    EXPECT_NEAR(live.model().rig().mount.offset_m.x(), rig.mount.offset_m.x(), 0.001);
    sightAndClick("T1");
    EXPECT_EQ(parallax.state(), DeviceState::kGood) << qPrintable(parallax.proofText());
    EXPECT_TRUE(parallax.steps().back().done);
}

TEST_F(ParallaxPresenterTest, ClickBeforeTheDistanceIsRefused) {
    ASSERT_TRUE(sight("2D"));
    EXPECT_FALSE(parallax.wantsClick());
    parallax.click(seen("2D"));

    EXPECT_EQ(parallax.stage(), ParallaxStage::kFar);
    EXPECT_THAT(parallax.step().toStdString(), HasSubstr("distance"));
}

TEST_F(ParallaxPresenterTest, BoardsTooCloseToEachOtherAreRefused) {
    ASSERT_TRUE(sight("2D"));
    parallax.setDistance(5.0);
    EXPECT_TRUE(parallax.wantsClick());
    parallax.click(seen("2D"));
    sightAndClick("D");

    EXPECT_FALSE(parallax.canAccept());
    EXPECT_THAT(parallax.step().toStdString(), HasSubstr("twice the distance"));
}

TEST_F(ParallaxPresenterTest, ForwardOffsetAsksForSightingsAside) {
    parallax.setSought({.x = true, .y = true, .z = true});
    sightAndClick("2D");
    sightAndClick("D");
    EXPECT_EQ(parallax.stage(), ParallaxStage::kAside);
    const double ha_gon = mark("D").pointing.ha.gon();
    for (const double aside_gon : {-20.0, 20.0}) {
        ASSERT_TRUE(turnTo(ha_gon + aside_gon, mark("D").pointing.va.gon()));
        showFrames(3);
        parallax.click(seen("D") + QPointF(3, 3));
    }

    ASSERT_TRUE(parallax.fit().has_value()) << qPrintable(parallax.step());
    EXPECT_NEAR(parallax.fit()->mount.offset_m.y(), 0.085, 0.006);
}

TEST_F(ParallaxPresenterTest, NearBoardsDistanceIsJudged) {
    EXPECT_THAT(parallax.boardsAdvice().toStdString(), HasSubstr("1.700 m"));
    parallax.setStage(ParallaxStage::kNear);
    parallax.setDistance(1.2);
    EXPECT_THAT(parallax.boardsAdvice().toStdString(), HasSubstr("too near"));
    parallax.setDistance(30.0);
    EXPECT_THAT(parallax.boardsAdvice().toStdString(), HasSubstr("too far"));
}

}  // namespace
}  // namespace pmts::app
