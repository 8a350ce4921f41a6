#include "pmts/app/field/image_routines.hpp"

#include "app/field_fixture.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

using test::FailedWith;

class ImageRoutinesTest : public FieldTest {
protected:
    void showPicture() {
        camera->show(clock.now(), cv::Mat(720, 1280, CV_8UC3, cv::Scalar::all(90)));
        pass(150ms);
        camera->show(clock.now(), cv::Mat(720, 1280, CV_8UC3, cv::Scalar::all(90)));
        pass(150ms);
    }

    ImageMarks marks;
    ImageRoutines routines{live, marks, preferences};
};

TEST_F(ImageRoutinesTest, PdataTellsWhatAClickWouldAimAt) {
    connectInstrument();
    showPicture();
    const auto told = routines.pdata(900.25, 300.5);
    targeting.aimAtLivePixel({900.25, 300.5});
    ASSERT_TRUE(told.has_value());
    EXPECT_EQ(*told, targeting.target()->pointing);
}

TEST_F(ImageRoutinesTest, OutsideThePictureOrWithoutReadingsThereIsNoDirection) {
    camera->show(clock.now(), cv::Mat(720, 1280, CV_8UC3, cv::Scalar::all(90)));
    core::deliverQueuedEvents();
    EXPECT_THAT(routines.pdata(100, 100), FailedWith(core::ErrorKind::kNotConnected));
    connectInstrument();
    showPicture();
    EXPECT_THAT(routines.pdata(1300, 100), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(routines.pdata(100, 100, Picture::kStill), FailedWith(core::ErrorKind::kUndefined));
}

TEST_F(ImageRoutinesTest, ZoomBoxTakesCornersInAnyOrderAndIsCutToThePicture) {
    showPicture();
    QSignalSpy asked(&routines, &ImageRoutines::zoomBoxAsked);
    EXPECT_EQ(routines.zoomBox(300, 200, 100, 50).value(), QRectF(100, 50, 200, 150));
    EXPECT_EQ(routines.zoomBox(1200, 600, 1500, 800).value(), QRectF(1200, 600, 79.5, 119.5));
    EXPECT_EQ(asked.size(), 2);
    EXPECT_THAT(routines.zoomBox(10, 10, 12, 40), FailedWith(core::ErrorKind::kBadInput));
    EXPECT_EQ(asked.size(), 2);
}

TEST_F(ImageRoutinesTest, PdrawMarksADirectionThatIsFoundInAnotherPicture) {
    connectInstrument();
    showPicture();
    const auto id = routines.pdraw(900, 300, QStringLiteral("gutter"));
    ASSERT_TRUE(id.has_value());
    const ImageMark mark = *marks.find(*id);
    EXPECT_EQ(mark.label, QStringLiteral("gutter"));
    live.setExtraPlaces({{.kind = OverlayKind::kMark,
                          .p_station = geometry::stationFromPolar({mark.pointing, mark.slope_distance_m}),
                          .label = mark.label, .code = {}, .row_id = mark.id}});
    ASSERT_EQ(live.scene().overlay.size(), 1U);
    EXPECT_NEAR(live.scene().overlay[0].px.x(), 900, 1e-3);
    const geometry::Pointing turned{live.scene().pointing->ha + Angle::fromGon(2), live.scene().pointing->va};
    EXPECT_LT(live.overlayFor(turned)[0].px.x(), 890) << "the telescope turned right: the mark moves left";
}

TEST_F(ImageRoutinesTest, MarksAreNumberedRenamedMovedAndDeleted) {
    connectInstrument();
    showPicture();
    const qint64 first = routines.pdraw(600, 300, {}).value();
    const qint64 second = routines.pdraw(700, 300, {}).value();
    EXPECT_EQ(marks.find(second)->label, QStringLiteral("M2"));
    marks.rename(second, QStringLiteral(" edge "));
    const auto before = marks.find(second)->pointing;
    ASSERT_TRUE(routines.moveMark(second, 800, 300).has_value());
    EXPECT_EQ(marks.find(second)->label, QStringLiteral("edge"));
    EXPECT_NE(marks.find(second)->pointing, before);
    marks.remove(first);
    EXPECT_EQ(marks.find(first), nullptr);
    EXPECT_EQ(marks.marks().size(), 1U);
}

TEST_F(ImageRoutinesTest, MarkOfAStillKnowsItsPhotoAndPixel) {
    connectInstrument();
    openJob();
    showPicture();
    live.capture();
    showPicture();
    ASSERT_TRUE(until([this] { return live.still() && live.still()->photo_row_id != 0; }));
    const qint64 id = routines.pdraw(640.5, 333.25, {}, Picture::kStill).value();
    EXPECT_EQ(marks.find(id)->photo_row_id, live.still()->photo_row_id);
    EXPECT_EQ(marks.find(id)->photo_px, QPointF(640.5, 333.25));
}

}  // namespace
}  // namespace pmts::app
