#pragma once

#include <QPointF>
#include <QString>

#include <optional>
#include <vector>

class QPainter;
class QTransform;
class QRect;

namespace pmts::gui {

struct Theme;

/// How far a target has come; drawn at its place with a shape and a word of its own.
enum class TargetLook { kClicked, kQueued, kTurning, kRecentring, kArrived, kLost };

[[nodiscard]] QString targetText(TargetLook look);

/// Recorded points are crosses, planned ones diamonds, marks flags.
enum class PointLook { kRecorded, kPlanned, kMark };

/// What is drawn over a picture. Places are pixels of the image, the centre of the top-left pixel is (0, 0).
struct ImageOverlay {
    struct Point {
        QPointF px;
        QString label;
        bool selected = false;
        PointLook look = PointLook::kRecorded;
        qint64 row_id = 0;
    };
    struct Label {
        QPointF px;
        QString text;
    };
    struct Target {
        QPointF px;
        TargetLook look = TargetLook::kClicked;
        QString note;  ///< drawn below the word, for example its HA and VA
    };

    std::optional<QPointF> reticle{};
    std::vector<Point> points{};
    std::optional<Target> target{};
    std::vector<QPointF> parallax{};  ///< where the axis meets the view from near to far
    std::vector<Label> parallax_marks{};
};

/// Draws with a dark and a light edge, so that it reads on any ground. `widget_from_image` maps pixel
/// centres.
void paintOverlay(QPainter& painter, const ImageOverlay& overlay, const QTransform& widget_from_image,
                  const Theme& theme);

/// A line of text on a plate, inside `area`, aligned as told: captions and notices of a view.
void paintPlate(QPainter& painter, const QRect& area, Qt::Alignment alignment, const QString& text,
                const Theme& theme);

}  // namespace pmts::gui
