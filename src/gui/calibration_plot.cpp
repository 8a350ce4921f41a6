#include "calibration_plot.hpp"

#include <QContextMenuEvent>
#include <QCoreApplication>
#include <QFile>
#include <QFileDialog>
#include <QMenu>
#include <QMouseEvent>
#include <QSvgGenerator>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace pmts::gui {
namespace {

constexpr double kArrowShare = 0.10;  ///< of the picture's width: the longest residual
constexpr int kTicks = 5;

QString say(const char* text) { return QCoreApplication::translate("CalibrationPlot", text); }

/// 1, 2 or 5 times a power of ten, not above the value.
double roundBelow(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double lead = value / power;
    return (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
}

/// Axes with ticks and labels; maps values into the room that is left.
class Axes {
public:
    Axes(QPainter& painter, const QRectF& place, const PlotLook& look) : painter_(painter), look_(look), letters_(painter.fontMetrics()) {
        const double line = letters_.height();
        room_ = place.adjusted(4.2 * line, 0.7 * line, -0.9 * line, -2.7 * line);
        outer_ = place;
    }
    void setRange(double left, double right, double bottom, double top) {
        left_ = left, right_ = right > left ? right : left + 1;
        bottom_ = bottom, top_ = top == bottom ? bottom + 1 : top;
    }
    void keepSquare() {
        const double scale = std::max((right_ - left_) / room_.width(), std::abs(top_ - bottom_) / room_.height());
        const QPointF middle = room_.center();
        const QSizeF size((right_ - left_) / scale, std::abs(top_ - bottom_) / scale);
        room_ = QRectF(middle.x() - size.width() / 2, middle.y() - size.height() / 2, size.width(), size.height());
    }
    [[nodiscard]] QPointF at(double x, double y) const {
        return {room_.left() + (x - left_) / (right_ - left_) * room_.width(), room_.bottom() - (y - bottom_) / (top_ - bottom_) * room_.height()};
    }
    void draw(const QString& across, const QString& up) {
        painter_.setPen(QPen(look_.text, look_.line_px));
        painter_.drawRect(room_);
        const double line = letters_.height();
        ticks(left_, right_, [&](double x) {
            const QPointF foot(at(x, bottom_).x(), room_.bottom());
            painter_.drawLine(foot, foot + QPointF(0, line / 4));
            painter_.drawText(QRectF(foot.x() - 60, foot.y() + line / 4, 120, line), Qt::AlignHCenter | Qt::AlignTop, QString::number(x, 'g', 4));
        });
        ticks(std::min(bottom_, top_), std::max(bottom_, top_), [&](double y) {
            const QPointF foot(room_.left(), at(left_, y).y());
            painter_.drawLine(foot, foot - QPointF(line / 4, 0));
            painter_.drawText(QRectF(outer_.left(), foot.y() - line / 2, foot.x() - outer_.left() - line / 2, line), Qt::AlignRight | Qt::AlignVCenter,
                              QString::number(y, 'g', 4));
        });
        painter_.drawText(QRectF(room_.left() - 4 * line, room_.bottom() + 1.3 * line, room_.width() + 4 * line, 1.3 * line), Qt::AlignHCenter | Qt::AlignVCenter, across);
        painter_.save();
        painter_.translate(outer_.left() + line * 0.6, room_.center().y());
        painter_.rotate(-90);
        painter_.drawText(QRectF(-outer_.height() / 2, -line / 2, outer_.height(), line), Qt::AlignCenter, up);
        painter_.restore();
    }
    void curve(const std::vector<QPointF>& points, const QPen& pen) {
        QPolygonF line;
        for (const QPointF& point : points) {
            line.append(at(point.x(), point.y()));
        }
        painter_.setPen(pen);
        painter_.drawPolyline(line);
    }
    [[nodiscard]] const QRectF& room() const { return room_; }

private:
    template <class Draw>
    static void ticks(double from, double to, Draw draw) {
        const double step = roundBelow((to - from) / kTicks * 1.5);
        for (double value = std::ceil(from / step - 1e-9) * step; value <= to + 1e-9 * step; value += step) {
            draw(std::abs(value) < 1e-9 * step ? 0.0 : value);
        }
    }

    QPainter& painter_;
    const PlotLook& look_;
    QFontMetricsF letters_;
    QRectF room_, outer_;
    double left_ = 0, right_ = 1, bottom_ = 0, top_ = 1;
};

void arrow(QPainter& painter, const QPointF& from, const QPointF& to) {
    painter.drawLine(from, to);
    const QLineF line(to, from);
    if (line.length() > 4) {
        for (const double turn : {25.0, -25.0}) {
            QLineF head = line;
            head.setLength(std::min(7.0, line.length() / 2));
            head.setAngle(line.angle() + turn);
            painter.drawLine(head);
        }
    }
}

void nothing(QPainter& painter, const QRectF& place, const PlotLook& look, const QString& why) {
    painter.setPen(look.text);
    painter.drawText(place, Qt::AlignCenter | Qt::TextWordWrap, why);
}

void paintResiduals(QPainter& painter, const QRectF& place, const app::CalibrationReport& report, const PlotLook& look) {
    double largest_px = 0.0;
    for (const app::RecordedResidual& residual : report.residuals) {
        largest_px = std::max(largest_px, residual.residual_px.norm());
    }
    Axes axes(painter, place, look);
    axes.setRange(-0.5, report.image_px.width() - 0.5, report.image_px.height() - 0.5, -0.5);
    axes.keepSquare();
    if (!(largest_px > 0)) {
        return nothing(painter, place, look, say("This calibration kept no residuals."));
    }
    const double shown_px = roundBelow(largest_px);
    axes.draw(say("Column [px]; arrows: modelled less observed, %1 px as long as the bar").arg(shown_px), say("Row [px]"));
    const double scale = kArrowShare * report.image_px.width() / largest_px;
    for (const app::RecordedResidual& residual : report.residuals) {
        painter.setPen(QPen(residual.held_out ? look.va : look.ha, look.line_px));
        const Eigen::Vector2d end = residual.px + scale * residual.residual_px;
        arrow(painter, axes.at(residual.px.x(), residual.px.y()), axes.at(end.x(), end.y()));
    }
    painter.setPen(QPen(look.text, 2 * look.line_px));
    const double row = 0.96 * report.image_px.height();
    const double from = 0.03 * report.image_px.width();
    painter.drawLine(axes.at(from, row), axes.at(from + scale * shown_px, row));
}

void paintRadial(QPainter& painter, const QRectF& place, const app::CalibrationReport& report, const PlotLook& look) {
    std::vector<std::pair<QPointF, bool>> dots;
    QPointF most(1, 0.01);
    for (const app::RecordedResidual& residual : report.residuals) {
        const QPointF dot(std::hypot(residual.px.x() - report.centre_px.x(), residual.px.y() - report.centre_px.y()), residual.residual_px.norm());
        dots.emplace_back(dot, residual.held_out);
        most = {std::max(most.x(), dot.x()), std::max(most.y(), dot.y())};
    }
    if (dots.empty()) {
        return nothing(painter, place, look, say("This calibration kept no residuals."));
    }
    Axes axes(painter, place, look);
    axes.setRange(0, 1.05 * most.x(), 0, 1.1 * most.y());
    axes.draw(say("Distance from the principal point [px]"), say("Residual [px]"));
    for (const auto& [dot, held_out] : dots) {
        painter.setPen(QPen(held_out ? look.va : look.ha, 1.5 * look.line_px));
        const QPointF at = axes.at(dot.x(), dot.y());
        if (held_out) {  // told apart without colour
            painter.drawRect(QRectF(at - QPointF(2.5, 2.5), QSizeF(5, 5)));
        } else {
            painter.drawLine(at - QPointF(3, 0), at + QPointF(3, 0));
            painter.drawLine(at - QPointF(0, 3), at + QPointF(0, 3));
        }
    }
}

void paintCurves(QPainter& painter, const QRectF& place, const app::CalibrationReport& report, CalibrationFigure figure, const PlotLook& look) {
    const bool angle = figure == CalibrationFigure::kAngleCurve;
    const std::vector<QPointF>& curve = angle ? report.angle_curve : report.width_curve;
    if (curve.empty()) {
        return nothing(painter, place, look, say("This lens has no rays along its middle row."));
    }
    double least = angle ? 0.0 : 1e9;
    double most = 0.0;
    for (const std::vector<QPointF>* points : {&curve, angle ? &report.ideal_curve : &curve}) {
        for (const QPointF& point : *points) {
            least = std::min(least, point.y());
            most = std::max(most, point.y());
        }
    }
    const double margin = 0.05 * std::max(most - least, 0.02 * most);
    Axes axes(painter, place, look);
    axes.setRange(0, curve.back().x(), angle ? 0.0 : least - margin, most + margin);
    axes.draw(say("Distance from the principal point [px]"), angle ? say("Angle off the axis [gon]") : say("Angle of a pixel [gon]"));
    if (angle) {
        axes.curve(report.ideal_curve, QPen(look.text, look.line_px, Qt::DashLine));
    }
    axes.curve(curve, QPen(look.ha, 2 * look.line_px));
    if (angle) {
        const double off_gon = curve.back().y() - report.ideal_curve.back().y();
        painter.setPen(look.text);
        const double line = QFontMetricsF(painter.font()).height();
        painter.drawText(axes.room().adjusted(line / 2, line / 4, -line / 2, 0), Qt::AlignTop | Qt::AlignLeft,
                         say("— lens   - - ideal atan(r/f)\n%1 gon apart at %2 px").arg(off_gon, 0, 'f', 3).arg(curve.back().x(), 0, 'f', 0));
    }
}

}  // namespace

QString figureTitle(CalibrationFigure figure) {
    switch (figure) {
        case CalibrationFigure::kResiduals: return say("Residuals over the picture");
        case CalibrationFigure::kRadial: return say("Residuals over the radius");
        case CalibrationFigure::kAngleCurve: return say("Angle against pixel");
        case CalibrationFigure::kWidthCurve: return say("Pixel width");
    }
    return {};
}

void paintFigure(QPainter& painter, const QRectF& place, const app::CalibrationReport& report, CalibrationFigure figure, const PlotLook& look) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(place, look.ground);
    switch (figure) {
        case CalibrationFigure::kResiduals: paintResiduals(painter, place, report, look); break;
        case CalibrationFigure::kRadial: paintRadial(painter, place, report, look); break;
        case CalibrationFigure::kAngleCurve:
        case CalibrationFigure::kWidthCurve: paintCurves(painter, place, report, figure, look); break;
    }
    painter.restore();
}

QString figureCsv(const app::CalibrationReport& report, CalibrationFigure figure) {
    QStringList lines;
    const auto number = [](double value) { return QString::number(value, 'g', 10); };
    if (figure == CalibrationFigure::kResiduals || figure == CalibrationFigure::kRadial) {
        lines.append(QStringLiteral("u_px,v_px,du_px,dv_px,held_out"));
        for (const app::RecordedResidual& r : report.residuals) {
            lines.append(QStringList{number(r.px.x()), number(r.px.y()), number(r.residual_px.x()), number(r.residual_px.y()), r.held_out ? QStringLiteral("1") : QStringLiteral("0")}.join(u','));
        }
    } else if (figure == CalibrationFigure::kAngleCurve) {
        lines.append(QStringLiteral("radius_px,angle_gon,ideal_gon"));
        for (std::size_t i = 0; i < report.angle_curve.size(); ++i) {
            lines.append(QStringList{number(report.angle_curve[i].x()), number(report.angle_curve[i].y()), number(report.ideal_curve[i].y())}.join(u','));
        }
    } else {
        lines.append(QStringLiteral("radius_px,gon_per_px"));
        for (const QPointF& point : report.width_curve) {
            lines.append(number(point.x()) + u',' + number(point.y()));
        }
    }
    return lines.join(u'\n') + u'\n';
}

CalibrationPlot::CalibrationPlot(CalibrationFigure figure, QWidget* parent) : QWidget(parent), figure_(figure) {
    setMouseTracking(true);
    setAccessibleName(figureTitle(figure));
    setMinimumHeight(230);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void CalibrationPlot::show(const app::CalibrationReport& report) {
    report_ = report;
    update();
}

QSize CalibrationPlot::sizeHint() const { return {380, 250}; }

void CalibrationPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintFigure(painter, rect(), report_, figure_, screenLook());
}

void CalibrationPlot::mouseMoveEvent(QMouseEvent* event) {
    const std::vector<QPointF>& curve = figure_ == CalibrationFigure::kAngleCurve ? report_.angle_curve : report_.width_curve;
    if (figure_ == CalibrationFigure::kResiduals || figure_ == CalibrationFigure::kRadial || curve.empty()) {
        return;
    }
    const double line = QFontMetricsF(font()).height();
    const double share = (event->position().x() - 4.2 * line) / (width() - 5.1 * line);
    const auto index = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(curve.size() - 1));
    QToolTip::showText(event->globalPosition().toPoint(), tr("%1 px: %2 gon").arg(curve[index].x(), 0, 'f', 0).arg(curve[index].y(), 0, 'f', 5), this);
}

void CalibrationPlot::contextMenuEvent(QContextMenuEvent* event) {
    auto* const menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Save this plot…"), this, &CalibrationPlot::save);
    menu->popup(event->globalPos());
}

void CalibrationPlot::save() {
    const QString path = QFileDialog::getSaveFileName(this, tr("Save this plot"), {}, tr("Picture or numbers (*.png *.svg *.csv)"));
    if (path.endsWith(QLatin1String(".csv"))) {
        QFile file(path);
        if (file.open(QIODevice::WriteOnly)) {
            file.write(figureCsv(report_, figure_).toUtf8());
        }
    } else if (path.endsWith(QLatin1String(".svg"))) {
        QSvgGenerator file;
        file.setFileName(path);
        file.setSize(size());
        file.setViewBox(rect());
        QPainter painter(&file);
        paintFigure(painter, rect(), report_, figure_, paperLook());
    } else if (!path.isEmpty()) {
        grab().save(path.endsWith(QLatin1String(".png")) ? path : path + QStringLiteral(".png"));
    }
}

}  // namespace pmts::gui
