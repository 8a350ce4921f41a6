#include "app/field_fixture.hpp"

#include "pmts/app/desk/frame_image.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

class LivePresenterTest : public FieldTest {};

TEST_F(LivePresenterTest, FramesGetTheCircleReadingsOfTheirTime) {
    connectInstrument();
    ASSERT_TRUE(turnTo(12, 97));
    showFrames();
    ASSERT_TRUE(live.scene().pointing.has_value());
    EXPECT_THAT(live.scene().pointing->ha, test::IsNearAngle(Angle::fromGon(12), Angle::fromCc(30)));
    EXPECT_EQ(live.scene().frame->pointing, live.scene().pointing);
    EXPECT_FALSE(live.scene().moving);
}

TEST_F(LivePresenterTest, FrameTakenWhileTurningIsMarkedAsMoving) {
    connectInstrument();
    targeting.aimAtText(QStringLiteral("150"), QStringLiteral("95"));
    targeting.move();
    ASSERT_TRUE(until([this] { return targeting.target()->state == MoveState::kTurning; }));
    camera->show(clock.now());
    EXPECT_TRUE(live.scene().moving);
}

TEST_F(LivePresenterTest, CaptureWaitsUntilAReadingAfterTheFrameConfirmsIt) {
    connectInstrument();
    showFrames();
    camera->show(clock.now());
    QSignalSpy captured(&live, &LivePresenter::stillCaptured);
    live.capture();
    EXPECT_TRUE(captured.empty()) << "nothing has been read since the frame";
    pass(300ms);
    ASSERT_EQ(captured.size(), 1);
    EXPECT_FALSE(live.isCapturing());
    EXPECT_EQ(live.still()->number, 1);
    EXPECT_FALSE(live.still()->ha_text.isEmpty());
}

TEST_F(LivePresenterTest, CaptureDuringATurnGivesTheFirstFrameAtRest) {
    connectInstrument();
    showFrames();
    targeting.aimAtText(QStringLiteral("40"), QStringLiteral("95"));
    targeting.move();
    ASSERT_TRUE(until([this] { return targeting.target()->state == MoveState::kTurning; }));
    QSignalSpy waiting(&live, &LivePresenter::captureWaiting);
    live.capture();
    showFrames(1);
    EXPECT_FALSE(live.still().has_value());
    EXPECT_THAT(waiting.at(0).at(0).toString().toStdString(), testing::HasSubstr("stands still"));
    ASSERT_TRUE(until([this] { return !targeting.isMoving(); }));
    showFrames(4);
    ASSERT_TRUE(live.still().has_value());
    EXPECT_THAT(live.still()->pointing.ha, test::IsNearAngle(Angle::fromGon(40), Angle::fromCc(30)));
}

TEST_F(LivePresenterTest, FrameFromBeforeTheFirstReadingIsReplacedByALaterOne) {
    camera->show(clock.now());
    pass(1ms);
    connectInstrument();
    live.capture();
    showFrames();
    EXPECT_TRUE(live.still().has_value()) << "it waited for readings of the past";
}

TEST_F(LivePresenterTest, CaptureWithoutAnInstrumentSaysWhatItWaitsForAndCanBeCancelled) {
    camera->show(clock.now());
    core::deliverQueuedEvents();
    QSignalSpy waiting(&live, &LivePresenter::captureWaiting);
    live.capture();
    ASSERT_EQ(waiting.size(), 1);
    EXPECT_THAT(waiting.at(0).at(0).toString().toStdString(), testing::HasSubstr("not connected"));
    live.cancelCapture();
    EXPECT_FALSE(live.isCapturing());
    EXPECT_EQ(waiting.last().at(0).toString(), QString());
}

TEST_F(LivePresenterTest, StillIsKeptInTheJobWithItsPose) {
    connectInstrument();
    openJob();
    showFrames();
    live.capture();
    showFrames();
    ASSERT_TRUE(until([this] { return live.still() && live.still()->photo_row_id != 0; }));
    job_desk.close();
    ASSERT_TRUE(until([this] { return !job_desk.isOpen(); }));
    const auto job = job::Job::open(folder.filePath(QStringLiteral("wall.gpkg")));
    ASSERT_TRUE(job.has_value());
    ASSERT_EQ((*job)->photos()->size(), 1U);
    const QImage image = QImage::fromData((*job)->photoImage((*job)->photos()->at(0).row_id).value());
    EXPECT_EQ(image.size(), QSize(128, 72));
}

TEST_F(LivePresenterTest, ReticleIsDrawnForTheRangeAndTellsWhereItComesFrom) {
    connectInstrument();
    showFrames();
    EXPECT_THAT(live.scene().range_text.toStdString(), testing::HasSubstr("25.000 m (assumed)"));
    ASSERT_TRUE(measure());
    EXPECT_THAT(live.scene().range_text.toStdString(), testing::HasSubstr("(measured)"));
    ASSERT_TRUE(turnTo(20, 95));
    showFrames();
    EXPECT_THAT(live.scene().range_text.toStdString(), testing::HasSubstr("(last shot)"));
    EXPECT_TRUE(live.scene().reticle_px.has_value());
}

TEST_F(LivePresenterTest, CameraThatFallsSilentTurnsTheLampAmber) {
    QSignalSpy changed(&live, &LivePresenter::cameraStatusChanged);
    camera->setState(video::SourceState::kSilent);
    EXPECT_EQ(live.cameraStatus().state, DeviceState::kWarning);
    camera->setState(video::SourceState::kLost);
    EXPECT_EQ(live.cameraStatus().state, DeviceState::kFailed);
    camera->setState(video::SourceState::kRunning);
    EXPECT_EQ(live.cameraStatus().state, DeviceState::kGood);
    EXPECT_EQ(changed.size(), 3);
}

TEST_F(LivePresenterTest, ImageOfAFrameKeepsItsPixelsAlive) {
    auto frame = std::make_shared<camera::Frame>();
    frame->image = cv::Mat(4, 6, CV_8UC3, cv::Scalar(10, 20, 30));  // blue, green, red
    QImage image = imageOfFrame(frame);
    frame.reset();
    EXPECT_EQ(image.size(), QSize(6, 4));
    EXPECT_EQ(image.pixel(5, 3), qRgb(30, 20, 10));
    EXPECT_TRUE(imageOfFrame(nullptr).isNull());
}

TEST_F(LivePresenterTest, StatisticsSpeakOfNoPictureBeforeTheFirstFrame) {
    QSignalSpy changed(&live, &LivePresenter::statisticsChanged);
    Q_EMIT camera->stateChanged(video::SourceState::kRunning);
    live.updateStatistics();
    EXPECT_EQ(live.statistics().text, QStringLiteral("no picture yet"));
    showFrames(1);
    live.updateStatistics();
    EXPECT_EQ(live.statistics().text, QStringLiteral("128x72, 0 fps"));
    EXPECT_EQ(changed.size(), 2);
}

}  // namespace
}  // namespace pmts::app
