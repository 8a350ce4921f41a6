#include "residual_plot.hpp"

#include <qcustomplot.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::gui {
namespace {

using Role = DrawnResidual::Role;

constexpr double kArrowShare = 0.09;          ///< of the frame's width: a long arrow
constexpr double kLongestArrowShare = 0.225;  ///< an outlier's arrow ends inside the plot
constexpr double kLengthRoom = 1.25;          ///< what is longer than this many longest ones in the fit lies on the edge
constexpr double kEdgeRoom = 1.02;            ///< of the highest
constexpr double kLegendRoom = 1.4;
constexpr double kReach_px = 10.0;            ///< of the hover
constexpr std::array kRoles{Role::kUsed, Role::kHeldOut, Role::kLeftOut};

double lengthOf(const QPointF& vector) { return std::hypot(vector.x(), vector.y()); }

/// Lengths of those in the fit, shortest first.
std::vector<double> usedLengths(const std::vector<DrawnResidual>& residuals) {
    std::vector<double> lengths;
    for (const DrawnResidual& residual : residuals) {
        if (residual.role == Role::kUsed) {
            lengths.push_back(lengthOf(residual.residual_px));
        }
    }
    std::ranges::sort(lengths);
    return lengths;
}

QString nameOf(Role role) {
    switch (role) {
        case Role::kUsed: return ResidualPlot::tr("in the fit");
        case Role::kLeftOut: return ResidualPlot::tr("left out");
        case Role::kHeldOut: return ResidualPlot::tr("not in the fit");
    }
    return {};
}

QCPScatterStyle styleOf(Role role, const PlotLook& look) {
    switch (role) {
        case Role::kUsed: return {QCPScatterStyle::ssDisc, QPen(look.ha, look.line_px), look.ha, 5};
        case Role::kLeftOut: return {QCPScatterStyle::ssCross, QPen(look.text, 1.5 * look.line_px), Qt::NoBrush, 7};
        case Role::kHeldOut: return {QCPScatterStyle::ssSquare, QPen(look.va, 1.5 * look.line_px), look.ground, 6};
    }
    return {};
}

}  // namespace

ResidualPlot::ResidualPlot(Kind kind, QWidget* parent) : PlotWidget(QStringLiteral("residuals"), parent), kind_(kind) {
    setMinimumHeight(240);
}

void ResidualPlot::showResiduals(const DrawnResiduals& shown) {
    shown_ = shown;
    redraw();
}

void ResidualPlot::draw() {
    if (shown_.residuals.empty()) {
        return drawNotice();
    }
    kind_ == Kind::kVectors ? drawVectors() : drawRadius();
    for (const Role role : kRoles) {
        QVector<double> x, y;
        for (const DrawnResidual& residual : shown_.residuals) {
            if (residual.role == role) {
                x.append(placeOf(residual).x());
                y.append(placeOf(residual).y());
            }
        }
        if (!x.isEmpty()) {
            addDots(x, y, styleOf(role, look()))->setName(nameOf(role));
        }
    }
    canvas().legend->setVisible(kind_ == Kind::kRadius && canvas().graphCount() > 1);
}

bool ResidualPlot::has(DrawnResidual::Role role) const { return std::ranges::find(shown_.residuals, role, &DrawnResidual::role) != shown_.residuals.end(); }

/// By what nine in ten stay below: one stray arrow does not shrink the others.
double ResidualPlot::magnification() const {
    const std::vector<double> lengths = usedLengths(shown_.residuals);
    const double usual = lengths.empty() ? 0.0 : lengths[lengths.size() * 9 / 10];
    return usual > 0 ? roundBelow(kArrowShare * shown_.frame_px.width() / usual) : 1.0;
}

double ResidualPlot::highest() const {
    const std::vector<double> lengths = usedLengths(shown_.residuals);
    return std::max(1e-6, kLengthRoom * (lengths.empty() ? 0.0 : lengths.back()));
}

QPointF ResidualPlot::placeOf(const DrawnResidual& residual) const {
    return kind_ == Kind::kVectors ? residual.px
                                   : QPointF(lengthOf(residual.px - shown_.centre_px), std::min(lengthOf(residual.residual_px), highest()));
}

void ResidualPlot::drawVectors() {
    const double magnified = magnification();
    QString below = tr("Column [px]; arrows %1 times as long").arg(magnified);
    if (has(Role::kHeldOut)) {
        below += u'\n' + tr("squares: not in the fit");
    }
    if (has(Role::kLeftOut)) {
        below += u'\n' + tr("crosses: left out");
    }
    drawFrame(shown_.frame_px, below);
    const double most = kLongestArrowShare * shown_.frame_px.width();
    for (const DrawnResidual& residual : shown_.residuals) {
        const double scale = std::min(magnified, most / std::max(1e-9, lengthOf(residual.residual_px)));
        const bool used = residual.role == Role::kUsed;
        addArrow(residual.px, residual.px + residual.residual_px * scale,
                 QPen(used ? look().ha : look().text, look().line_px + 0.5, residual.role == Role::kLeftOut ? Qt::DotLine : Qt::SolidLine));
    }
}

void ResidualPlot::drawRadius() {
    canvas().xAxis->setLabel(tr("Radius from the centre [px]"));
    canvas().yAxis->setLabel(tr("Residual [px]"));
    canvas().xAxis->setRange(0, std::hypot(shown_.frame_px.width(), shown_.frame_px.height()) / 2);
    canvas().yAxis->setRange(0, (has(Role::kHeldOut) || has(Role::kLeftOut) ? kLegendRoom : kEdgeRoom) * highest());
    canvas().axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignRight);
    canvas().legend->setFillOrder(QCPLegend::foColumnsFirst);
}

QString ResidualPlot::textAt(const QPoint& at) const {
    for (const DrawnResidual& residual : shown_.residuals) {
        const QPointF place = placeOf(residual);
        if (std::hypot(plot().xAxis->coordToPixel(place.x()) - at.x(), plot().yAxis->coordToPixel(place.y()) - at.y()) < kReach_px) {
            return tr("%1, %2 px, %3").arg(residual.residual_px.x(), 0, 'f', 3).arg(residual.residual_px.y(), 0, 'f', 3).arg(nameOf(residual.role));
        }
    }
    return {};
}

QString ResidualPlot::csv() const {
    QString text = QStringLiteral("column_px,row_px,residual_x_px,residual_y_px,spot,left_out,held_out\n");
    for (const DrawnResidual& residual : shown_.residuals) {
        text += QStringLiteral("%1,%2,%3,%4,%5,%6,%7\n")
                    .arg(residual.px.x(), 0, 'f', 4)
                    .arg(residual.px.y(), 0, 'f', 4)
                    .arg(residual.residual_px.x(), 0, 'f', 5)
                    .arg(residual.residual_px.y(), 0, 'f', 5)
                    .arg(residual.spot ? QString::number(*residual.spot) : QString())
                    .arg(residual.role == Role::kLeftOut ? 1 : 0)
                    .arg(residual.role == Role::kHeldOut ? 1 : 0);
    }
    return text;
}

}  // namespace pmts::gui
