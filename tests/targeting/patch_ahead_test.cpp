#include "pmts/targeting/patch_ahead.hpp"

#include "targeting/pictures.hpp"

#include <QThreadPool>
#include <gtest/gtest.h>

namespace pmts::targeting {
namespace {

camera::FramePtr frameOf(const cv::Mat& picture) {
    auto frame = std::make_shared<camera::Frame>();
    frame->image = picture;
    return frame;
}

TEST(PatchAheadTest, PatchIsThereWhenTheMoveComesAndIsTheOneTheRoutineWouldTake) {
    const camera::FramePtr frame = frameOf(test::naturalTexture({640, 480}, 3));
    PatchAhead ahead;
    ahead.begin(frame, {300.5, 200});
    QThreadPool::globalInstance()->waitForDone();
    const auto patch = ahead.taken(frame, {300.5, 200});
    ASSERT_TRUE(patch.has_value());
    const auto own = PatchMatcher().take(frame->image, {300.5, 200});
    EXPECT_EQ(patch->half_side_px, own->half_side_px);
    EXPECT_EQ(patch->look_alike, own->look_alike);
}

TEST(PatchAheadTest, AnotherClickOrPictureGetsNone) {
    const camera::FramePtr frame = frameOf(test::naturalTexture({640, 480}, 3));
    PatchAhead ahead;
    EXPECT_FALSE(ahead.taken(frame, {300, 200}).has_value());
    ahead.begin(frame, {300, 200});
    QThreadPool::globalInstance()->waitForDone();
    EXPECT_FALSE(ahead.taken(frame, {301, 200}).has_value());
    EXPECT_FALSE(ahead.taken(frameOf(frame->image), {300, 200}).has_value());
}

TEST(PatchAheadTest, SpotThatCannotBeKnownAgainIsLeftToTheRoutine) {
    const camera::FramePtr wall = frameOf(cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(120)));
    PatchAhead ahead;
    ahead.begin(wall, {300, 200});
    QThreadPool::globalInstance()->waitForDone();
    EXPECT_FALSE(ahead.taken(wall, {300, 200}).has_value());
}

}  // namespace
}  // namespace pmts::targeting
