#include "pmts/app/field/mark_keeper.hpp"

#include "app/field_fixture.hpp"
#include "pmts/app/field/image_routines.hpp"

namespace pmts::app {
namespace {

class MarkKeeperTest : public FieldTest {
protected:
    void SetUp() override {
        connectInstrument();
        openJob();
        showPicture();
        live.capture();
        showPicture();
        ASSERT_TRUE(until([this] { return live.still() && live.still()->photo_row_id != 0; }));
    }
    void showPicture() {
        for (int i = 0; i < 2; ++i) {
            camera->show(clock.now(), cv::Mat(720, 1280, CV_8UC3, cv::Scalar::all(90)));
            pass(150ms);
        }
    }
    void openAgain() {
        pass(1s);
        job_desk.open(jobPath());
        pass(1s);
    }

    ImageMarks marks;
    MarkKeeper keeper{marks, job_desk, live, messages};
    ImageRoutines routines{live, marks, preferences};
};

TEST_F(MarkKeeperTest, MarkOfAStillIsBackWhenTheJobIsOpenedAgain) {
    ASSERT_TRUE(routines.pdraw(640.5, 333.25, QStringLiteral("crack"), Picture::kStill).has_value());
    const geometry::Pointing before = marks.marks()[0].pointing;
    openAgain();
    ASSERT_EQ(marks.marks().size(), 1U);
    EXPECT_EQ(marks.marks()[0].label, QStringLiteral("crack"));
    EXPECT_EQ(marks.marks()[0].photo_px, QPointF(640.5, 333.25));
    EXPECT_THAT(marks.marks()[0].pointing.ha, test::IsNearAngle(before.ha, Angle::fromCc(1)));
}

TEST_F(MarkKeeperTest, RenamedAndMovedMarkIsKeptAsItWasLast) {
    const qint64 id = routines.pdraw(640, 333, {}, Picture::kStill).value();
    marks.rename(id, QStringLiteral("bolt"));  // before the job has answered
    pass(1s);
    ASSERT_TRUE(routines.moveMark(id, 500, 200, Picture::kStill).has_value());
    openAgain();
    ASSERT_EQ(marks.marks().size(), 1U);
    EXPECT_EQ(marks.marks()[0].label, QStringLiteral("bolt"));
    EXPECT_EQ(marks.marks()[0].photo_px, QPointF(500, 200));
}

TEST_F(MarkKeeperTest, DeletedMarkStaysDeleted) {
    const qint64 id = routines.pdraw(640, 333, {}, Picture::kStill).value();
    marks.remove(id);
    openAgain();
    EXPECT_TRUE(marks.marks().empty());
}

TEST_F(MarkKeeperTest, MarkOfTheLivePictureIsKeptWithTheStillThatShowsIt) {
    ASSERT_TRUE(routines.pdraw(700, 400, QStringLiteral("edge")).has_value());
    EXPECT_EQ(marks.marks()[0].photo_row_id, live.still()->photo_row_id);
    openAgain();
    ASSERT_EQ(marks.marks().size(), 1U);
    EXPECT_NEAR(marks.marks()[0].photo_px.x(), 700, 1.0);
}

TEST_F(MarkKeeperTest, JobThatRefusesIsSaidAndTheMarkStays) {
    moveJobAway();
    ASSERT_TRUE(routines.pdraw(640, 333, {}, Picture::kStill).has_value());
    pass(1s);
    EXPECT_FALSE(messages.bars().empty());
    EXPECT_EQ(marks.marks().size(), 1U);
    bringJobBack();
}

}  // namespace
}  // namespace pmts::app
