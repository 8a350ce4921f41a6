#pragma once

#include "pmts/app/field/image_marks.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/core/result.hpp"

#include <QObject>
#include <QRectF>

namespace pmts::app {

/// The routines of the annexure that work on a picture, for the interface and for programs:
///
///     routines.zoomBox(400, 200, 560, 290);             // R15 Zoombox: an enlarged, live view of that part
///     const auto circles = routines.pdata(640.5, 355);  // R21 Pdata: HA and VA of that pixel, nothing moves
///     routines.pdraw(640.5, 355, "gutter");             // R26 Pdraw: an editable mark
///
/// Pixels are those of the picture, fractions allowed, centre of the top-left one (0, 0). Pointings are for the range in
/// use (LiveScene::range). Every routine fails with kUndefined outside the picture or when the lens has no ray there, and
/// with kNotConnected when the picture has no circle readings. GUI thread.
class ImageRoutines : public QObject {
    Q_OBJECT
public:
    static constexpr double kLeastBox_px = 8.0;

    ImageRoutines(LivePresenter& live, ImageMarks& marks, const Preferences& preferences, QObject* parent = nullptr);

    /// R15. Opposite corners in any order; the box is cut to the picture. Fails with kBadInput below 8 x 8 pixels.
    core::Result<QRectF> zoomBox(double x1, double y1, double x2, double y2, Picture picture = Picture::kLive);
    /// R21. In the face in which the picture was taken, by the method clicks use.
    [[nodiscard]] core::Result<geometry::Pointing> pdata(double x, double y, Picture picture = Picture::kLive) const;
    /// R26. The mark's id; an empty label becomes `M1`, `M2`, ...
    core::Result<qint64> pdraw(double x, double y, const QString& label, Picture picture = Picture::kLive);
    /// Moves a mark made by pdraw(). Unknown ids do nothing.
    core::Result<void> moveMark(qint64 id, double x, double y, Picture picture = Picture::kLive);

Q_SIGNALS:
    void zoomBoxAsked(pmts::app::Picture picture, const QRectF& box_px);

private:
    struct Shown {
        camera::FramePtr frame;
        geometry::Pointing pointing;
    };
    [[nodiscard]] core::Result<Shown> shownAt(double x, double y, Picture picture) const;
    [[nodiscard]] core::Result<Shown> shownIn(Picture picture) const;
    [[nodiscard]] core::Result<ImageMark> markAt(double x, double y, Picture picture) const;

    LivePresenter& live_;
    ImageMarks& marks_;
    const Preferences& preferences_;
};

}  // namespace pmts::app
