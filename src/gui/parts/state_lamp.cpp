#include "state_lamp.hpp"

#include "painted_icon.hpp"
#include "pmts/gui/theme.hpp"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace pmts::gui {

using app::DeviceState;

namespace {

constexpr int kSpinInterval_ms = 80;
constexpr double kSpinStep = 0.08;

QPainterPath triangleIn(const QRectF& box) {
    QPainterPath path(QPointF(box.center().x(), box.top()));
    path.lineTo(box.bottomRight());
    path.lineTo(box.bottomLeft());
    path.closeSubpath();
    return path;
}

void paintWarning(QPainter& painter, const QRectF& box, const Theme& theme, double width) {
    painter.setPen(QPen(theme.text, std::max(1.0, width * 0.5), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(theme.warning);
    painter.drawPath(triangleIn(box));
}

void paintFailed(QPainter& painter, const QRectF& box, const Theme& theme, double width) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.failed);
    painter.drawRect(box);
    const QRectF cross = box.adjusted(width * 1.4, width * 1.4, -width * 1.4, -width * 1.4);
    painter.setPen(QPen(theme.window, width * 0.8, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(cross.topLeft(), cross.bottomRight());
    painter.drawLine(cross.topRight(), cross.bottomLeft());
}

}  // namespace

QIcon lampIcon(DeviceState state) {
    return paintedIcon([state](QPainter& painter, const QRect& rect, QIcon::Mode mode, QIcon::State) {
        if (mode == QIcon::Selected) {  // a busy lamp has the colour of a chosen row
            painter.setRenderHint(QPainter::Antialiasing);
            painter.setPen(Qt::NoPen);
            painter.setBrush(currentTheme().window);
            painter.drawEllipse(rect);
        }
        paintLamp(painter, QRectF(rect).adjusted(1, 1, -1, -1), state, currentTheme());
    });
}

void paintLamp(QPainter& painter, const QRectF& place, DeviceState state, const Theme& theme, double turn) {
    const double side = std::min(place.width(), place.height());
    const double width = std::max(1.5, side * 0.14);
    QRectF box(0, 0, side - width, side - width);
    box.moveCenter(place.center());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    switch (state) {
        case DeviceState::kIdle:
            painter.setPen(QPen(theme.idle, width));
            painter.drawEllipse(box.adjusted(1, 1, -1, -1));
            break;
        case DeviceState::kBusy:
            painter.setPen(QPen(theme.busy, width * 1.3, Qt::SolidLine, Qt::FlatCap));
            painter.drawArc(box.adjusted(1, 1, -1, -1), static_cast<int>(-turn * 360 * 16), 250 * 16);
            break;
        case DeviceState::kGood:
            painter.setPen(Qt::NoPen);
            painter.setBrush(theme.good);
            painter.drawEllipse(box);
            break;
        case DeviceState::kWarning:
            paintWarning(painter, box, theme, width);
            break;
        case DeviceState::kFailed:
            paintFailed(painter, box, theme, width);
            break;
    }
    painter.restore();
}

QString lampText(DeviceState state) {
    switch (state) {
        case DeviceState::kIdle:
            return QCoreApplication::translate("Lamp", "idle");
        case DeviceState::kBusy:
            return QCoreApplication::translate("Lamp", "busy");
        case DeviceState::kGood:
            return QCoreApplication::translate("Lamp", "good");
        case DeviceState::kWarning:
            return QCoreApplication::translate("Lamp", "warning");
        case DeviceState::kFailed:
            break;
    }
    return QCoreApplication::translate("Lamp", "failed");
}

StateLamp::StateLamp(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setState(DeviceState::kIdle);
    connect(&spin_, &QTimer::timeout, this, [this] {
        turn_ = std::fmod(turn_ + kSpinStep, 1.0);
        update();
    });
}

void StateLamp::setState(DeviceState state) {
    state_ = state;
    setToolTip(lampText(state));
    setAccessibleName(lampText(state));
    if (state == DeviceState::kBusy) {
        spin_.start(kSpinInterval_ms);
    } else {
        spin_.stop();
    }
    update();
}

QSize StateLamp::sizeHint() const {
    const int side = fontMetrics().height();
    return {side, side};
}

void StateLamp::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintLamp(painter, rect(), state_, currentTheme(), turn_);
}

}  // namespace pmts::gui
