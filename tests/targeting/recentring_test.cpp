#include "pmts/targeting/recentring.hpp"

#include "support/matchers.hpp"
#include "targeting/crooked_camera.hpp"

namespace pmts::targeting {
namespace {

using namespace std::chrono_literals;
using core::Angle;
using core::ErrorKind;
using Eigen::Vector2d;
using geometry::Pointing;
using test::FailedWith;

struct RecentringTest : CrookedCameraTest {
    RecentringTest() { stand(wallWith(test::naturalTexture({1600, 1000}, 21))); }

    static std::shared_ptr<const simulator::Scene> wallWith(const cv::Mat& picture) {
        return CrookedCameraTest::wallWith(picture, 16, 10);
    }
    /// f 2 % wrong, pitch and twist 0.3 gon.
    static camera::Rig wrongRig() {
        camera::Rig rig = crookedRig();
        rig.lens = camera::Lens(camera::BrownLens{.f_px = 1530, .cx_px = 652, .cy_px = 349, .k1 = -0.2, .k2 = 0.06});
        rig.mount.pitch += Angle::fromGon(0.3);
        rig.mount.twist += Angle::fromGon(0.3);
        return rig;
    }
    Click clickAt(const Vector2d& px) {
        mark(px);
        return clickOnSpot(px);
    }
    Recentring recentring(const camera::Rig& rig = crookedRig()) {
        return Recentring(*station, frames->source(), findHere(PatchMatcher()), PixelToPointing(rig), clock);
    }
    std::optional<core::Result<Recentred>> run(Recentring& routine, const Click& click,
                                               std::stop_token stop = {}) {
        return test::runToEnd(routine.turnTo(click, stop), clock, 120s);
    }
    /// The clicked spot as the camera truly sees it, against the reticle.
    double trueMiss_px(const camera::Rig& drawn_with = crookedRig()) const {
        const Pointing at = truth->at(clock.now());
        return (truePixel(at) - *PixelToPointing(drawn_with).reticlePixel(at, spot.norm())).norm();
    }
};

TEST_F(RecentringTest, OneClickPutsTheReticleOnTheSpotAndProvesIt) {
    Recentring routine = recentring();
    const Click click = clickAt({300, 200});

    const auto outcome = run(routine, click);

    ASSERT_TRUE(outcome && *outcome) << (*outcome).error().sentence().toStdString();
    const Recentred& proof = **outcome;
    EXPECT_LE(trueMiss_px(), 0.15);
    EXPECT_LE(proof.residual_px.norm(), 0.15);
    EXPECT_LE(proof.moves, 2);
    EXPECT_GT(proof.score, 0.9);
    EXPECT_EQ(proof.before, click.frame);
    EXPECT_NE(proof.after, nullptr);
}

TEST_F(RecentringTest, RigTwoPerCentWrongNeedsNoMoreThanThreeMoves) {
    for (const Vector2d& px : {Vector2d(200, 150), Vector2d(1000, 200), Vector2d(900, 550)}) {
        stand(wallWith(test::naturalTexture({1600, 1000}, 22)));
        Recentring routine = recentring(wrongRig());
        const auto outcome = run(routine, clickAt(px));
        ASSERT_TRUE(outcome && *outcome) << (*outcome).error().sentence().toStdString();
        EXPECT_LE((*outcome)->moves, 3);
        EXPECT_LE(trueMiss_px(wrongRig()), 0.2);
    }
}

TEST_F(RecentringTest, StepsAreReportedInTheirOrder) {
    Recentring routine = recentring();
    std::vector<RecentringStage> stages;
    routine.on_step = [&](const RecentringStep& step) {
        stages.push_back(step.stage);
        EXPECT_EQ(step.matched.has_value(), step.stage == RecentringStage::kMatched);
    };
    ASSERT_TRUE(run(routine, clickAt({500, 300})).has_value());
    ASSERT_GE(stages.size(), 3U);
    EXPECT_EQ(stages[0], RecentringStage::kTurning);
    EXPECT_EQ(stages[1], RecentringStage::kLooking);
    EXPECT_EQ(stages[2], RecentringStage::kMatched);
}

TEST_F(RecentringTest, FramesExposedBeforeTheArrivalAreNotUsed) {
    const Click click = clickAt({300, 200});
    const auto stale = click.frame;
    int stale_given = 0;
    const auto source = [&](core::Duration since,
                            std::stop_token stop) -> core::Task<core::Result<camera::FramePtr>> {
        if (stale_given < 3) {
            ++stale_given;
            co_return core::Result<camera::FramePtr>(stale);
        }
        co_return co_await frames->after(since, stop);
    };
    Recentring routine(*station, source, findHere(PatchMatcher()), PixelToPointing(crookedRig()), clock);
    const auto outcome = run(routine, click);
    ASSERT_TRUE(outcome && *outcome);
    EXPECT_EQ(stale_given, 3);
    EXPECT_LE(trueMiss_px(), 0.15);
}

TEST_F(RecentringTest, CameraThatGivesOnlyOldPicturesEndsTheRoutine) {
    const Click click = clickAt({300, 200});
    const auto source = [frame = click.frame](core::Duration,
                                              std::stop_token) -> core::Task<core::Result<camera::FramePtr>> {
        co_return core::Result<camera::FramePtr>(frame);
    };
    Recentring routine(*station, source, findHere(PatchMatcher()), PixelToPointing(crookedRig()), clock);
    EXPECT_THAT(*run(routine, click), FailedWith(ErrorKind::kCamera));
}

TEST_F(RecentringTest, SwingingPictureIsWaitedForUntilItStands) {
    const Click click = clickAt({600, 420});
    int left = 5;
    frames->change = [&left](cv::Mat& picture) {
        const double swing_px = left > 0 ? 1.3 * left * (left % 2 ? 1 : -1) : 0.0;
        left = std::max(0, left - 1);
        picture = test::TurnedPicture{.shift_px = {0, swing_px}}.of(picture);
    };
    Recentring routine = recentring();
    const auto outcome = run(routine, click);
    ASSERT_TRUE(outcome && *outcome) << (*outcome).error().sentence().toStdString();
    EXPECT_EQ(left, 0);
    EXPECT_LE(trueMiss_px(), 0.15);
}

TEST_F(RecentringTest, PictureThatNeverStandsIsSaidSo) {
    const Click click = clickAt({600, 420});
    frames->change = [n = 0](cv::Mat& picture) mutable {
        picture = test::TurnedPicture{.shift_px = {n++ % 2 ? 2.0 : -2.0, 0}}.of(picture);
    };
    Recentring routine = recentring();
    const auto outcome = run(routine, click);
    ASSERT_THAT(*outcome, FailedWith(ErrorKind::kNotReached));
    EXPECT_EQ((*outcome).error().detail, "restless");
}

TEST_F(RecentringTest, CoveredLensIsLostAndTheInstrumentStays) {
    const Click click = clickAt({300, 200});
    frames->change = [](cv::Mat& picture) { picture.setTo(cv::Scalar::all(12)); };
    Recentring routine = recentring();
    const auto outcome = run(routine, click);
    ASSERT_THAT(*outcome, FailedWith(ErrorKind::kNotReached));
    EXPECT_TRUE((*outcome).error().detail.startsWith("lost"));
    EXPECT_EQ(station->turns, 1);
}

TEST_F(RecentringTest, RepeatingFacadeIsRefusedBeforeAnythingTurns) {
    stand(wallWith(test::facadeOfWindows({1600, 1000}, 100)));
    Recentring routine = recentring();
    const auto outcome = run(routine, clickAt({690, 330}));
    ASSERT_FALSE(outcome->has_value());
    EXPECT_EQ(station->turns, 0);
}

TEST_F(RecentringTest, CancelWhileTurningEndsTheRoutineAsCancelled) {
    Recentring routine = recentring();
    std::stop_source stop;
    routine.on_step = [&](const RecentringStep& step) {
        if (step.stage == RecentringStage::kTurning) {
            stop.request_stop();
        }
    };
    EXPECT_THAT(*run(routine, clickAt({300, 200}), stop.get_token()), FailedWith(ErrorKind::kCancelled));
    EXPECT_EQ(station->turns, 0);
}

TEST_F(RecentringTest, CancelWhileLookingEndsTheRoutineAsCancelled) {
    Recentring routine = recentring();
    std::stop_source stop;
    routine.on_step = [&](const RecentringStep& step) {
        if (step.stage == RecentringStage::kLooking) {
            stop.request_stop();
        }
    };
    EXPECT_THAT(*run(routine, clickAt({300, 200}), stop.get_token()), FailedWith(ErrorKind::kCancelled));
}

TEST_F(RecentringTest, ErrorsOfTheInstrumentArePassedOn) {
    station->refuse_next_turn =
        core::fail(ErrorKind::kLinkLost, QStringLiteral("The cable was pulled.")).value();
    Recentring routine = recentring();
    EXPECT_THAT(*run(routine, clickAt({300, 200})), FailedWith(ErrorKind::kLinkLost));
}

TEST_F(RecentringTest, GuardIsAskedBeforeEveryMove) {
    Recentring routine = recentring();
    routine.may_turn = [](const Pointing&) -> core::Result<void> {
        return core::fail(ErrorKind::kLimit, QStringLiteral("The Sun is there."));
    };
    EXPECT_THAT(*run(routine, clickAt({300, 200})), FailedWith(ErrorKind::kLimit));
    EXPECT_EQ(station->turns, 0);
}

TEST_F(RecentringTest, InstrumentThatCannotHoldItsAimIsNeverCalledSettled) {
    // The servo stops up to 0.05 gon off, ten times the tolerance of the picture.
    station.emplace(clock, truth, test::FakeTotalStation::Habits{.servo_cc = 500, .seed = 3});
    Recentring routine = recentring();
    const auto outcome = run(routine, clickAt({300, 200}));
    ASSERT_TRUE(outcome.has_value());
    if (*outcome) {
        EXPECT_LE(trueMiss_px(), 0.2);  // luck, but then it is true
    } else {
        EXPECT_EQ((*outcome).error().kind, ErrorKind::kNotReached);
    }
}

}  // namespace
}  // namespace pmts::targeting
