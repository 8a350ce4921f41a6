#include "pmts/targeting/patch_matcher.hpp"

#include "support/matchers.hpp"
#include "targeting/pictures.hpp"

namespace pmts::targeting {
namespace {

using core::ErrorKind;
using Eigen::Vector2d;
using test::FailedWith;
using test::seenBy;
using test::TurnedPicture;

const cv::Size kSize(640, 480);

/// The rig model expects the shift, `off_px` wrong, and no turn.
Expectation shiftedBy(const Vector2d& shift_px, const Vector2d& off_px = Vector2d::Zero()) {
    return {
        .seen = [=](const Vector2d& old_px) { return std::optional<Vector2d>(old_px + shift_px + off_px); }};
}

/// Largest miss over clicks all over the old picture, when the new one is this.
double largestMiss_px(const TurnedPicture& warp, double contrast, double brightness, double blur_px,
                      double noise) {
    const cv::Mat scene = test::naturalTexture(kSize, 3);
    const cv::Mat before = seenBy(scene, 1.0, 0.0, 0.0, noise, 1);
    const cv::Mat after = seenBy(warp.of(scene), contrast, brightness, blur_px, noise, 2);
    const PatchMatcher matcher;
    double largest = 0;
    for (const Vector2d& click :
         {Vector2d(320, 240), Vector2d(200.3, 150.8), Vector2d(440.5, 300.5), Vector2d(250.7, 330.2)}) {
        TurnedPicture about = warp;
        const auto patch = matcher.take(before, click);
        const auto match = patch.and_then([&](const Patch& p) {
            return matcher.find(p, after, shiftedBy(about.at(click) - click, {9, -7}));
        });
        if (!match) {
            ADD_FAILURE() << match.error().sentence().toStdString() << click.transpose();
            return 1e9;
        }
        largest = std::max(largest, (match->px - about.at(click)).norm());
    }
    return largest;
}

TEST(PatchMatcherTest, FindsTheClickUnderNoiseWithinATenthOfAPixel) {
    EXPECT_LE(largestMiss_px({.shift_px = {31.37, -12.61}}, 1.0, 0.0, 0.0, 4.0), 0.1);
}

TEST(PatchMatcherTest, FindsTheClickUnderBlurAndExposureDrift) {
    EXPECT_LE(largestMiss_px({.shift_px = {-20.25, 8.75}}, 1.3, -20.0, 1.5, 2.0), 0.1);
    EXPECT_LE(largestMiss_px({.shift_px = {-20.25, 8.75}}, 0.7, 10.0, 1.0, 2.0), 0.1);
}

TEST(PatchMatcherTest, FindsTheClickAtHalfTheContrast) {
    EXPECT_LE(largestMiss_px({.shift_px = {14.5, 3.3}}, 0.5, 60.0, 0.0, 2.0), 0.1);
}

TEST(PatchMatcherTest, FindsTheClickInAPictureTurnedByTwoDegrees) {
    EXPECT_LE(largestMiss_px({.turn_deg = 2.0, .shift_px = {5.4, -3.1}}, 1.0, 0.0, 0.0, 2.0), 0.1);
    EXPECT_LE(largestMiss_px({.turn_deg = -2.0, .shift_px = {5.4, -3.1}}, 1.0, 0.0, 0.0, 2.0), 0.1);
}

TEST(PatchMatcherTest, FindsTheClickUnderEverythingAtOnce) {
    EXPECT_LE(largestMiss_px({.turn_deg = 1.5, .shift_px = {11.8, 6.6}}, 0.5, 40.0, 1.0, 2.5), 0.1);
}

TEST(PatchMatcherTest, ClickNearTheEdgeOfThePictureIsFoundFromTheHalfThatIsThere) {
    const cv::Mat scene = test::naturalTexture(kSize, 4);
    const TurnedPicture warp{.shift_px = {200.4, 150.6}};
    const PatchMatcher matcher;
    const auto patch = matcher.take(scene, {12, 14});
    ASSERT_TRUE(patch.has_value()) << patch.error().sentence().toStdString();
    const auto match = matcher.find(*patch, warp.of(scene), shiftedBy({200, 150}));
    ASSERT_TRUE(match.has_value()) << match.error().sentence().toStdString();
    EXPECT_LE((match->px - Vector2d(212.4, 164.6)).norm(), 0.1);
}

TEST(PatchMatcherTest, SigmaIsAsLargeAsTheMissesAre) {
    const cv::Mat scene = test::naturalTexture(kSize, 5);
    const TurnedPicture warp{.shift_px = {7.31, 4.77}};
    const PatchMatcher matcher;
    double normalized2 = 0;
    constexpr int kRepeats = 40;
    for (unsigned i = 0; i < kRepeats; ++i) {
        const Vector2d click(120 + 10 * i, 100 + 6 * i);
        const auto patch = matcher.take(seenBy(scene, 1, 0, 0, 5.0, 10 + i), click);
        const auto match =
            matcher.find(*patch, seenBy(warp.of(scene), 1, 0, 0, 5.0, 100 + i), shiftedBy({7, 5}));
        ASSERT_TRUE(match.has_value()) << match.error().sentence().toStdString();
        normalized2 +=
            ((match->px - click - warp.shift_px) / match->sigma_px).squaredNorm() / (2.0 * kRepeats);
    }
    // Promises are kept: the misses are not larger than said, and no worse than three times smaller.
    EXPECT_LT(normalized2, 1.3);
    EXPECT_GT(normalized2, 0.1);
}

TEST(PatchMatcherTest, CoveredTargetIsLostWithASentence) {
    const PatchMatcher matcher;
    const auto patch = matcher.take(test::naturalTexture(kSize, 6), {300, 200});
    const auto match = matcher.find(*patch, test::naturalTexture(kSize, 60), shiftedBy({0, 0}));
    ASSERT_THAT(match, FailedWith(ErrorKind::kNotReached));
    EXPECT_TRUE(match.error().detail.startsWith("lost") || match.error().detail.startsWith("ambiguous"));
    EXPECT_FALSE(match.error().happened.isEmpty());
    EXPECT_FALSE(match.error().remedy.isEmpty());
}

TEST(PatchMatcherTest, WhiteOrBlackPictureIsLost) {
    const PatchMatcher matcher;
    const auto patch = matcher.take(test::naturalTexture(kSize, 6), {300, 200});
    for (const double grey : {0.0, 255.0}) {
        const auto match =
            matcher.find(*patch, cv::Mat(kSize, CV_8UC3, cv::Scalar::all(grey)), shiftedBy({0, 0}));
        ASSERT_THAT(match, FailedWith(ErrorKind::kNotReached));
        EXPECT_TRUE(match.error().detail.startsWith("lost"));
    }
}

TEST(PatchMatcherTest, ClickOnARepeatingFacadeIsRefusedAtOnce) {
    const cv::Mat facade = seenBy(test::facadeOfWindows(kSize, 60), 1, 0, 0, 2.0, 1);
    const auto patch = PatchMatcher().take(facade, {255, 255});
    ASSERT_THAT(patch, FailedWith(ErrorKind::kNotReached));
    EXPECT_TRUE(patch.error().detail.startsWith("ambiguous"));
}

TEST(PatchMatcherTest, WindowOfAFacadeIsToldApartByWhatStandsBesideIt) {
    // The same windows, with one poster within reach of the patch's surroundings.
    cv::Mat facade = test::facadeOfWindows(kSize, 60);
    test::naturalTexture({70, 90}, 8).copyTo(facade(cv::Rect(280, 200, 70, 90)));
    const TurnedPicture warp{.shift_px = {33.3, 21.4}};
    const PatchMatcher matcher;
    const auto patch = matcher.take(seenBy(facade, 1, 0, 0, 2.0, 1), {255, 255});
    ASSERT_TRUE(patch.has_value()) << patch.error().sentence().toStdString();
    // Predicted nearly a whole window wrong.
    const auto match =
        matcher.find(*patch, seenBy(warp.of(facade), 1, 0, 0, 2.0, 2), shiftedBy({33, 21}, {50, 0}));
    ASSERT_TRUE(match.has_value()) << match.error().sentence().toStdString();
    EXPECT_LE((match->px - Vector2d(288.3, 276.4)).norm(), 0.1);
}

TEST(PatchMatcherTest, SecondCopyInTheNewPictureMakesTheMatchAmbiguous) {
    const cv::Mat before = test::naturalTexture(kSize, 9);
    cv::Mat after = before.clone();
    before(cv::Rect(100, 120, 200, 200)).copyTo(after(cv::Rect(300, 120, 200, 200)));
    const PatchMatcher matcher;
    const auto patch = matcher.take(before, {200, 220});
    Expectation wide = shiftedBy({100, 0});
    wide.search_radius_px = 130;
    const auto match = matcher.find(*patch, after, wide);
    ASSERT_THAT(match, FailedWith(ErrorKind::kNotReached));
    EXPECT_TRUE(match.error().detail.startsWith("ambiguous"));
}

TEST(PatchMatcherTest, TargetPredictedOutsideThePictureIsSaidSo) {
    const cv::Mat picture = test::naturalTexture(kSize, 10);
    const PatchMatcher matcher;
    const auto patch = matcher.take(picture, {300, 200});
    const auto match = matcher.find(*patch, picture, shiftedBy({-400, 0}));
    ASSERT_THAT(match, FailedWith(ErrorKind::kNotReached));
    EXPECT_TRUE(match.error().detail.startsWith("outside"));
    const Expectation nothing{.seen = [](const Vector2d&) { return std::optional<Vector2d>(); }};
    EXPECT_TRUE(matcher.find(*patch, picture, nothing).error().detail.startsWith("outside"));
}

TEST(PatchMatcherTest, SkyAndPlainWallCannotBeFoundAgain) {
    const cv::Mat sky = seenBy(cv::Mat(kSize, CV_8UC3, cv::Scalar(220, 190, 160)), 1, 0, 0, 3.0, 1);
    EXPECT_THAT(PatchMatcher().take(sky, {300, 200}), FailedWith(ErrorKind::kUndefined));
}

TEST(PatchMatcherTest, StraightEdgeWithoutACornerCannotBeFoundAgain) {
    cv::Mat wall(kSize, CV_8UC3, cv::Scalar::all(200));
    wall.colRange(0, 300).setTo(cv::Scalar::all(60));
    EXPECT_THAT(PatchMatcher().take(seenBy(wall, 1, 0, 0, 2.0, 1), {300, 240}),
                FailedWith(ErrorKind::kUndefined));
}

TEST(PatchMatcherTest, ClickAtTheVeryEdgeIsRefused) {
    const cv::Mat picture = test::naturalTexture(kSize, 11);
    for (const Vector2d& click :
         {Vector2d(2, 200), Vector2d(638, 200), Vector2d(300, -5), Vector2d(300, 600)}) {
        EXPECT_THAT(PatchMatcher().take(picture, click), FailedWith(ErrorKind::kLimit));
    }
}

TEST(PatchMatcherTest, EdgeInDepthIsNeverAveraged) {
    // The right half of the clicked patch moves 3 px against the left one, as near and far things do. The
    // click is on the right one: that surface is found, or the edge is told; half way is wrong.
    const PatchMatcher matcher;
    for (unsigned seed = 12; seed < 18; ++seed) {
        const cv::Mat scene = test::naturalTexture(kSize, seed);
        cv::Mat after = scene.clone();
        TurnedPicture{.shift_px = {0, 3}}.of(scene).colRange(298, 640).copyTo(after.colRange(298, 640));
        const auto patch = matcher.take(scene, {300, 240});
        const auto match = matcher.find(*patch, after, shiftedBy({0, 0}));
        if (match) {
            EXPECT_LE((match->px - Vector2d(300, 243)).norm(), 0.3) << match->px.transpose();
        } else {
            EXPECT_EQ(match.error().kind, ErrorKind::kNotReached);
        }
    }
}

}  // namespace
}  // namespace pmts::targeting
