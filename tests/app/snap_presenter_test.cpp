#include "pmts/app/field/snap_presenter.hpp"

#include "app/field_fixture.hpp"

#include <QSignalSpy>
#include <opencv2/imgproc.hpp>

namespace pmts::app {
namespace {

/// A dark window with its upper left corner between pixels: at (399.5, 299.5).
cv::Mat windowPicture() {
    cv::Mat picture(720, 1280, CV_8UC3, cv::Scalar::all(190));
    cv::rectangle(picture, cv::Rect(400, 300, 200, 150), cv::Scalar::all(50), cv::FILLED);
    return picture;
}

constexpr QPointF kCorner(399.5, 299.5);
constexpr QPointF kBeside(405, 294);
constexpr QPointF kNowhere(700, 600);
constexpr double kReach_px = 15.0;

double distance(const QPointF& a, const QPointF& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

class SnapPresenterTest : public FieldTest {
protected:
    void showWindow(const cv::Mat& picture = windowPicture()) {
        camera->show(clock.now(), picture);
        core::deliverQueuedEvents();
    }
    std::optional<QPointF> click(const QPointF& px) {
        std::optional<QPointF> taken;
        snap.choose(Picture::kLive, live.scene().frame, px, kReach_px, [&taken](QPointF at) { taken = at; });
        return taken;
    }

    SnapPresenter snap{live, preferences, Threading::kCallersThread};
};

TEST_F(SnapPresenterTest, CornerIsShownBeforeTheClickAndTheClickTakesIt) {
    showWindow();
    snap.setOn(true);
    snap.look(Picture::kLive, live.scene().frame, kBeside, kReach_px);
    ASSERT_TRUE(snap.spotIn(Picture::kLive).has_value());
    EXPECT_EQ(snap.spotIn(Picture::kLive)->kind, SnapKind::kCorner);
    EXPECT_LE(distance(snap.spotIn(Picture::kLive)->px, kCorner), 0.3);
    EXPECT_EQ(click(kBeside), snap.spotIn(Picture::kLive)->px);
}

TEST_F(SnapPresenterTest, ClickThatWasNeverHoveredLandsOnTheCornerToo) {
    showWindow();
    snap.setOn(true);
    const auto taken = click(kBeside);  // a finger
    ASSERT_TRUE(taken.has_value());
    EXPECT_LE(distance(*taken, kCorner), 0.3);
}

TEST_F(SnapPresenterTest, TargetIsTheCornersDirectionNotTheCursors) {
    connectInstrument();
    showFrames();
    showWindow();
    snap.setOn(true);
    snap.choose(Picture::kLive, live.scene().frame, kBeside, kReach_px,
                [this](QPointF px) { targeting.aimAtLivePixel(px); });
    const auto corner = live.model().pointingForPixel({kCorner.x(), kCorner.y()}, *live.scene().pointing, 25.0);
    ASSERT_TRUE(corner && targeting.target());
    EXPECT_THAT(targeting.target()->pointing.ha, test::IsNearAngle(corner->ha, Angle::fromMgon(15)));  // 0.3 px
    EXPECT_THAT(targeting.target()->pointing.va, test::IsNearAngle(corner->va, Angle::fromMgon(15)));
}

TEST_F(SnapPresenterTest, ClickStaysWhereItWasMadeWhenOffOrWhenNothingIsNear) {
    showWindow();
    EXPECT_EQ(click(kBeside), kBeside);
    snap.setOn(true);
    EXPECT_EQ(click(kNowhere), kNowhere);
}

TEST_F(SnapPresenterTest, FollowsTheCornerInNewerFramesWhileTheCursorRests) {
    showWindow();
    snap.setOn(true);
    snap.look(Picture::kLive, live.scene().frame, kBeside, kReach_px);
    cv::Mat moved;
    cv::warpAffine(windowPicture(), moved, cv::Mat(cv::Matx23d(1, 0, 4, 0, 1, 3)), {1280, 720}, cv::INTER_NEAREST,
                   cv::BORDER_REPLICATE);
    showWindow(moved);
    ASSERT_TRUE(snap.spotIn(Picture::kLive).has_value());
    EXPECT_LE(distance(snap.spotIn(Picture::kLive)->px, kCorner + QPointF(4, 3)), 0.3);
}

TEST_F(SnapPresenterTest, CursorInOnePictureShowsNothingInTheOther) {
    showWindow();
    snap.setOn(true);
    snap.look(Picture::kLive, live.scene().frame, kBeside, kReach_px);
    EXPECT_FALSE(snap.spotIn(Picture::kStill).has_value());
    snap.lookAway();
    EXPECT_FALSE(snap.spotIn(Picture::kLive).has_value());
}

TEST_F(SnapPresenterTest, IsRememberedInTheSettings) {
    snap.setOn(true);
    EXPECT_TRUE(preferences.settings().image_tools.snap);
    snap.setOn(false);
    EXPECT_FALSE(preferences.settings().image_tools.snap);
}

TEST_F(SnapPresenterTest, OnItsOwnThreadOnlyTheNewestOfManyPlacesIsLookedAt) {
    showWindow();
    SnapPresenter busy(live, preferences);
    busy.setOn(true);
    QSignalSpy changed(&busy, &SnapPresenter::spotChanged);
    for (int i = 0; i < 200; ++i) {
        busy.look(Picture::kLive, live.scene().frame, kBeside + QPointF(i % 2, 0), kReach_px);
    }
    std::optional<QPointF> taken;
    busy.choose(Picture::kLive, live.scene().frame, {402, 297}, kReach_px, [&taken](QPointF px) { taken = px; });
    for (int told = 0; told < 10 && !taken; ++told) {
        ASSERT_TRUE(changed.wait());
    }
    ASSERT_TRUE(taken.has_value());
    EXPECT_LE(distance(*taken, kCorner), 0.3);
    EXPECT_LE(changed.count(), 3);
}

}  // namespace
}  // namespace pmts::app
