#include "app/drawn_field.hpp"
#include "pmts/app/field/evidence_collector.hpp"
#include "targeting/pictures.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

using test::IsNearAngle;

cv::Mat windows(cv::Size size) {
    cv::Mat picture(size, CV_8UC3, cv::Scalar::all(170));
    for (int y = 10; y + 30 < size.height; y += 60) {
        for (int x = 10; x + 20 < size.width; x += 40) {
            cv::rectangle(picture, {x, y, 20, 30}, cv::Scalar::all(60), cv::FILLED);
        }
    }
    return picture;
}

/// The whole way of a click with a camera that sees a wall 15 m away, 30 pictures a second.
class ImageMoveTest : public DrawnFieldTest {
protected:
    void SetUp() override {
        seeWall(test::naturalTexture({1600, 960}, 4));
        targeting.setRecentring(true);
        beginShowing(33ms);
    }
    void seeWall(const cv::Mat& picture) { DrawnFieldTest::seeWall(picture, 20, 12, live.model().rig()); }
    bool settle() {
        return until([this] { return !targeting.isMoving(); }, 60s);
    }

    /// Records what the telescope points at and reads its evidence back from the job.
    std::optional<job::Evidence> recordedEvidence() {
        EXPECT_TRUE(recordPoint());
        std::optional<job::Evidence> kept;
        bool is_answered = false;
        QObject::connect(&job_desk, &JobDesk::evidenceLoaded,
                         [&](Ticket, qint64, const std::optional<job::Evidence>& evidence) {
                             kept = evidence;
                             is_answered = true;
                         });
        job_desk.loadEvidence(points.points().back().row_id);
        EXPECT_TRUE(until([&] { return is_answered; }));
        return kept;
    }

    EvidenceCollector collector{targeting, live, preferences, clock};
};

TEST_F(ImageMoveTest, OneClickPutsTheReticleOnTheSpotAndShowsTheProof) {
    targeting.moveToLivePixel({900, 250});
    ASSERT_TRUE(settle());
    ASSERT_EQ(targeting.target()->state, MoveState::kArrived) << targeting.target()->sentence.toStdString();
    const auto& proof = targeting.target()->proof;
    ASSERT_TRUE(proof.has_value());
    EXPECT_LE(std::min(proof->residual_px.norm() / 0.1, proof->residual.arcsec() / 20.0), 1.0);
    EXPECT_GT(proof->score, 0.9);
    EXPECT_THAT(targeting.target()->sentence.toStdString(), testing::HasSubstr("On target: "));
    EXPECT_THAT(true_pointing->at(clock.now()).ha, IsNearAngle(targeting.target()->pointing.ha, Angle::fromCc(30)));
}

TEST_F(ImageMoveTest, MoveGoesThroughTurningAndRecentring) {
    QList<MoveState> states;
    QObject::connect(&targeting, &TargetingPresenter::targetChanged, [&] {
        if (targeting.target() && (states.isEmpty() || states.last() != targeting.target()->state)) {
            states.append(targeting.target()->state);
        }
    });
    targeting.moveToLivePixel({700, 300});
    ASSERT_TRUE(settle());
    EXPECT_EQ(states.mid(0, 4), (QList<MoveState>{MoveState::kAimed, MoveState::kQueued, MoveState::kTurning, MoveState::kRecentring}));
    EXPECT_EQ(states.last(), MoveState::kArrived);
}

TEST_F(ImageMoveTest, WrongRangeIsMadeGoodByThePicture) {
    range.setAssumed(40.0);  // the wall is at 15 m: parallax would leave the spot several pixels off
    targeting.moveToLivePixel({400, 500});
    ASSERT_TRUE(settle());
    ASSERT_EQ(targeting.target()->state, MoveState::kArrived) << targeting.target()->sentence.toStdString();
    EXPECT_LE(targeting.target()->proof->residual_px.norm(), 0.3);
    EXPECT_GE(targeting.target()->proof->moves, 1);
}

TEST_F(ImageMoveTest, StillTakenEarlierServesAsWell) {
    live.capture();
    ASSERT_TRUE(until([this] { return live.still().has_value(); }));
    targeting.aimAtText(QStringLiteral("6 gon"), QStringLiteral("101 gon"));
    targeting.move();
    ASSERT_TRUE(settle());
    targeting.moveToStillPixel({640, 300});
    ASSERT_TRUE(settle());
    EXPECT_EQ(targeting.target()->state, MoveState::kArrived) << targeting.target()->sentence.toStdString();
    EXPECT_TRUE(targeting.target()->proof.has_value());
}

TEST_F(ImageMoveTest, ThesisMethodWithRecentringEndsOnTheSameSpot) {
    Settings next = preferences.settings();
    next.aiming.method = targeting::Method::kTpa;
    preferences.set(next);
    targeting.moveToLivePixel({1000, 200});
    ASSERT_TRUE(settle());
    ASSERT_EQ(targeting.target()->state, MoveState::kArrived) << targeting.target()->sentence.toStdString();
    EXPECT_GE(targeting.target()->proof->moves, 2) << "TPA alone is not good enough here";
}

TEST_F(ImageMoveTest, RepeatingWindowsAreRefusedBeforeAnythingMoves) {
    seeWall(windows({1600, 960}));
    ASSERT_TRUE(until([this, frames = 0]() mutable { return ++frames > 5; }));
    const geometry::Pointing before = true_pointing->at(clock.now());
    sent.clear();
    targeting.moveToLivePixel({640, 360});
    ASSERT_TRUE(settle());
    EXPECT_EQ(targeting.target()->state, MoveState::kLost);
    EXPECT_THAT(sent, testing::Not(testing::HasSubstr("WS=")));
    EXPECT_EQ(true_pointing->at(clock.now()), before);
    EXPECT_EQ(messages.bars().back().action, MessageAction::kTurnWithoutPicture);
    targeting.moveWithoutPicture();
    ASSERT_TRUE(settle());
    EXPECT_EQ(targeting.target()->state, MoveState::kArrived);
    EXPECT_FALSE(targeting.target()->proof.has_value());
}

TEST_F(ImageMoveTest, StopWhileThePictureIsSearchedEndsTheMove) {
    targeting.moveToLivePixel({800, 420});
    ASSERT_TRUE(until([this] { return targeting.target()->state == MoveState::kRecentring; }));
    targeting.stop();
    ASSERT_TRUE(settle());
    EXPECT_EQ(targeting.target()->state, MoveState::kLost);
    EXPECT_TRUE(messages.bars().empty());
}

TEST_F(ImageMoveTest, RecordedPointKeepsTheProofOfItsAiming) {
    openJob();
    recording.collect_evidence = [this](const geometry::Pointing& shot) { return collector.collect(shot); };
    targeting.moveToLivePixel({700, 400});
    ASSERT_TRUE(settle());
    const targeting::Recentred proof = targeting.target()->proof.value();
    const auto kept = recordedEvidence();
    ASSERT_TRUE(kept.has_value());
    EXPECT_EQ(kept->method, QStringLiteral("rigorous"));
    EXPECT_TRUE(kept->recentred);
    EXPECT_EQ(kept->moves, proof.moves);
    EXPECT_NEAR(kept->residual_x_px.value(), proof.residual_px.x(), 1e-9);
    EXPECT_NEAR(kept->score.value(), proof.score, 1e-9);
    EXPECT_EQ(kept->slope_distance_source, QStringLiteral("assumed"));
    EXPECT_FALSE(QImage::fromData(kept->before.encoded_image).isNull());
    EXPECT_FALSE(QImage::fromData(kept->after.encoded_image).isNull());
    ASSERT_TRUE(kept->after.spot_px && kept->after.reticle_px);
    const QPointF off = *kept->after.spot_px - *kept->after.reticle_px;
    EXPECT_NEAR(off.x(), proof.residual_px.x(), 1e-9);
}

TEST_F(ImageMoveTest, PointAimedByEyeKeepsItsPictureOnly) {
    openJob();
    recording.collect_evidence = [this](const geometry::Pointing& shot) { return collector.collect(shot); };
    targeting.moveToLivePixel({700, 400});
    ASSERT_TRUE(settle());
    targeting.nudge(Direction::kLeft);  // no longer what was clicked
    ASSERT_TRUE(settle());
    const auto kept = recordedEvidence();
    ASSERT_TRUE(kept.has_value());
    EXPECT_EQ(kept->method, QStringLiteral("eye"));
    EXPECT_FALSE(kept->residual.has_value());
    EXPECT_TRUE(kept->before.encoded_image.isEmpty());
    EXPECT_TRUE(kept->after.reticle_px.has_value());
}

TEST_F(ImageMoveTest, CameraThatFallsSilentIsSaidSo) {
    targeting.moveToLivePixel({800, 420});
    ASSERT_TRUE(until([this] { return targeting.target()->state == MoveState::kTurning; }));
    stopShowing();
    ASSERT_TRUE(settle());
    EXPECT_EQ(targeting.target()->state, MoveState::kLost);
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("camera"));
}

TEST_F(ImageMoveTest, SingleClickTurnsOnlyWhenTheSettingSaysSo) {
    targeting.clickLivePixel({700, 300});
    pass(1s);
    EXPECT_EQ(targeting.target()->state, MoveState::kAimed);
    targeting.setClickTurns(true);
    targeting.clickLivePixel({700, 300});
    ASSERT_TRUE(settle());
    EXPECT_EQ(targeting.target()->state, MoveState::kArrived);
}

TEST_F(ImageMoveTest, EveryMoveOfTheRoutineAsksTheGuard) {
    Settings next = preferences.settings();
    next.aiming.limits.highest = Angle::fromGon(99.5);
    preferences.set(next);
    sent.clear();
    targeting.moveToLivePixel({640, 100});
    ASSERT_TRUE(settle());
    EXPECT_EQ(targeting.target()->state, MoveState::kLost);
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("above the motion limit"));
    EXPECT_THAT(sent, testing::Not(testing::HasSubstr("WS=")));
}

}  // namespace
}  // namespace pmts::app
