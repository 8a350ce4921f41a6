#include "pmts/targeting/spot_sweep.hpp"

#include "pmts/geometry/polar.hpp"
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

/// What somebody knows of a camera that was just strapped on: f from its data sheet, everything else zero.
camera::Rig dataSheetRig() {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 1440, .cx_px = 639.5, .cy_px = 359.5});
    return rig;
}

struct SpotSweepTest : CrookedCameraTest {
    SpotSweepTest() {
        stand(wallWith(test::naturalTexture({2800, 1800}, 21), 28, 18));
        mark(kClicked_px);
    }
    std::optional<core::Result<SweepOutcome>> run(const camera::Rig& rig, const std::vector<Pointing>& pointings,
                                                  std::stop_token stop = {}) {
        routine.emplace(*station, frames->source(), findHere(PatchMatcher()), PixelToPointing(rig), clock);
        routine->may_turn = may_turn;
        routine->on_step = [this](const SweepStep& step) { steps.push_back(step); };
        return test::runToEnd(routine->run(clickOnSpot(kClicked_px), pointings, stop), clock, 600s);
    }
    /// Steps of `gon` from where the sweep begins.
    [[nodiscard]] Pointing off(double ha_gon, double va_gon) const {
        return {begin.ha + Angle::fromGon(ha_gon), begin.va + Angle::fromGon(va_gon)};
    }

    const Vector2d kClicked_px{640, 330};
    std::function<core::Result<void>(const Pointing&)> may_turn;
    std::optional<SpotSweep> routine;
    std::vector<SweepStep> steps;
};

TEST_F(SpotSweepTest, FindsTheSpotAcrossTheFrameWithARigFromADataSheet) {
    const auto outcome = run(dataSheetRig(), {off(4, 0), off(11, 0), off(-11, 3), off(-8, -5), off(9, 5.5)});
    ASSERT_TRUE(outcome && *outcome) << (*outcome).error().sentence().toStdString();
    ASSERT_EQ((*outcome)->sightings.size(), 5U);
    for (const SpotSighting& sighting : (*outcome)->sightings) {
        EXPECT_LE((sighting.px - truePixel(sighting.at)).norm(), 0.2) << sighting.index;
    }
    EXPECT_TRUE((*outcome)->missed.empty());
}

TEST_F(SpotSweepTest, SecondFaceShowsTheSpotUpsideDownAndIsFoundToo) {
    const auto outcome = run(crookedRig(), {geometry::otherFace(begin), geometry::otherFace(off(6, 2))});
    ASSERT_TRUE(outcome && *outcome) << (*outcome).error().sentence().toStdString();
    ASSERT_EQ((*outcome)->sightings.size(), 2U);
    for (const SpotSighting& sighting : (*outcome)->sightings) {
        EXPECT_LE((sighting.px - truePixel(sighting.at)).norm(), 0.2);
    }
}

TEST_F(SpotSweepTest, ComesBackToWhereItBegan) {
    ASSERT_TRUE(run(crookedRig(), {off(5, 0), off(-5, 0)}).has_value());
    EXPECT_LE(geometry::separation(station->reading(), begin).gon(), 0.001);
}

TEST_F(SpotSweepTest, BarredAndEmptyPointingsAreMissedWithTheirReason) {
    may_turn = [this](const Pointing& target) -> core::Result<void> {
        if (target.ha - begin.ha > Angle::fromGon(8)) {
            return core::fail(ErrorKind::kLimit, QStringLiteral("The Sun is there."));
        }
        return {};
    };
    const auto outcome = run(crookedRig(), {off(10, 0), off(3, 0), off(-60, 0), off(-3, 0)});
    ASSERT_TRUE(outcome && *outcome);
    EXPECT_EQ((*outcome)->sightings.size(), 2U);
    ASSERT_EQ((*outcome)->missed.size(), 2U);
    EXPECT_EQ((*outcome)->missed[0].reason.happened, QStringLiteral("The Sun is there."));
    EXPECT_EQ((*outcome)->missed[1].index, 2U);
    ASSERT_EQ(steps.size(), 4U);
    EXPECT_EQ(steps.back().done, 4U);
    EXPECT_TRUE(steps[1].sighting.has_value());
}

TEST_F(SpotSweepTest, GivesUpWhenTheSpotStaysLost) {
    frames->change = [this](cv::Mat& picture) {
        if (!steps.empty() || frames->drawn > 0) {
            picture.setTo(cv::Scalar::all(90));
        }
    };
    const auto outcome = run(crookedRig(), std::vector<Pointing>(20, off(3, 0)));
    ASSERT_TRUE(outcome);
    EXPECT_THAT(*outcome, FailedWith(ErrorKind::kNotReached));
    EXPECT_LT(steps.size(), 7U);
    EXPECT_LE(geometry::separation(station->reading(), begin).gon(), 0.001);
}

TEST_F(SpotSweepTest, StopEndsIt) {
    std::stop_source stop;
    may_turn = [&](const Pointing&) -> core::Result<void> {
        if (steps.size() == 2) {
            stop.request_stop();
        }
        return {};
    };
    const auto outcome = run(crookedRig(), std::vector<Pointing>(8, off(3, 0)), stop.get_token());
    ASSERT_TRUE(outcome);
    EXPECT_THAT(*outcome, FailedWith(ErrorKind::kCancelled));
    EXPECT_EQ(steps.size(), 2U);
}

}  // namespace
}  // namespace pmts::targeting
