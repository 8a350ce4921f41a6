#include "pmts/app/field/image_routines.hpp"

#include "pmts/geometry/polar.hpp"
#include "pmts/targeting/click_method.hpp"

namespace pmts::app {

namespace {

QRectF pictureOf(const camera::Frame& frame) { return {-0.5, -0.5, double(frame.image.cols), double(frame.image.rows)}; }

}  // namespace

ImageRoutines::ImageRoutines(LivePresenter& live, ImageMarks& marks, const Preferences& preferences, QObject* parent)
    : QObject(parent), live_(live), marks_(marks), preferences_(preferences) {}

core::Result<ImageRoutines::Shown> ImageRoutines::shownIn(Picture picture) const {
    if (picture == Picture::kStill) {
        if (const auto& still = live_.still()) {
            return Shown{.frame = still->frame, .pointing = still->pointing};
        }
        return core::fail(core::ErrorKind::kUndefined, tr("There is no still yet."), tr("Capture one (C)."));
    }
    const LiveScene& scene = live_.scene();
    if (!scene.frame) {
        return core::fail(core::ErrorKind::kUndefined, tr("There is no live picture."), tr("Connect a camera."));
    }
    if (!scene.pointing) {
        return core::fail(core::ErrorKind::kNotConnected, tr("There are no circle readings for this picture."),
                          tr("Connect the instrument, then try again."));
    }
    return Shown{.frame = scene.frame, .pointing = *scene.pointing};
}

core::Result<QRectF> ImageRoutines::zoomBox(double x1, double y1, double x2, double y2, Picture picture) {
    const camera::FramePtr frame =
        picture == Picture::kLive ? live_.scene().frame : (live_.still() ? live_.still()->frame : nullptr);
    if (!frame) {
        return core::fail(core::ErrorKind::kUndefined, tr("There is no picture to enlarge."),
                          tr("Connect a camera, or capture a still (C)."));
    }
    const QRectF box = QRectF(QPointF(x1, y1), QPointF(x2, y2)).normalized() & pictureOf(*frame);
    if (box.width() < kLeastBox_px || box.height() < kLeastBox_px) {
        return core::fail(core::ErrorKind::kBadInput, tr("The zoom box is too small."),
                          tr("Drag from one corner of the part to its opposite corner."));
    }
    Q_EMIT zoomBoxAsked(picture, box);
    return box;
}

core::Result<ImageRoutines::Shown> ImageRoutines::shownAt(double x, double y, Picture picture) const {
    auto shown = shownIn(picture);
    if (shown && !pictureOf(*shown->frame).contains(x, y)) {
        return core::fail(core::ErrorKind::kUndefined, tr("Pixel %1, %2 is outside the picture.").arg(x).arg(y),
                          tr("The picture has %1 x %2 pixels.").arg(shown->frame->image.cols).arg(shown->frame->image.rows));
    }
    return shown;
}

core::Result<geometry::Pointing> ImageRoutines::pdata(double x, double y, Picture picture) const {
    const auto shown = shownAt(x, y, picture);
    PMTS_TRY(shown);
    return targeting::pointingOfClick({.method = preferences_.settings().aiming.method, .measured_pixel_angle = {}},
                                      live_.model(), {x, y}, shown->pointing, live_.scene().range.slope_distance_m);
}

core::Result<ImageMark> ImageRoutines::markAt(double x, double y, Picture picture) const {
    const auto shown = shownAt(x, y, picture);
    PMTS_TRY(shown);
    // Whatever method clicks use: the mark must come back to its pixel.
    const auto pointing = live_.model().pointingForPixel({x, y}, shown->pointing, live_.scene().range.slope_distance_m);
    PMTS_TRY(pointing);
    ImageMark mark;
    mark.pointing = geometry::inFaceOf(shown->pointing, *pointing);
    mark.slope_distance_m = live_.scene().range.slope_distance_m;
    if (const auto& still = live_.still()) {
        const auto px = live_.model().pixelForPoint(
            geometry::stationFromPolar({.pointing = mark.pointing, .slope_distance_m = mark.slope_distance_m}), still->pointing);
        const QPointF on_still = picture == Picture::kStill ? QPointF(x, y) : (px ? QPointF(px->x(), px->y()) : QPointF(-1e9, 0));
        if (pictureOf(*still->frame).contains(on_still)) {  // the job keeps marks with the photo that shows them
            mark.photo_row_id = still->photo_row_id;
            mark.photo_px = on_still;
        }
    }
    return mark;
}

core::Result<qint64> ImageRoutines::pdraw(double x, double y, const QString& label, Picture picture) {
    auto mark = markAt(x, y, picture);
    PMTS_TRY(mark);
    mark->label = label;
    return marks_.add(*std::move(mark));
}

core::Result<void> ImageRoutines::moveMark(qint64 id, double x, double y, Picture picture) {
    const auto mark = markAt(x, y, picture);
    PMTS_TRY(mark);
    marks_.move(id, *mark);
    return {};
}

}  // namespace pmts::app
