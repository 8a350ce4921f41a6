#pragma once

#include "pmts/app/desk/device_state.hpp"

#include <QIcon>
#include <QTimer>
#include <QWidget>

class QPainter;

namespace pmts::gui {

struct Theme;

/// Idle: hollow circle. Busy: turning arc. Good: disc. Warning: triangle. Failed: square with a cross.
void paintLamp(QPainter& painter, const QRectF& place, app::DeviceState state, const Theme& theme,
               double turn = 0.0);

/// A lamp as an icon for buttons; it follows a change of palette by itself.
[[nodiscard]] QIcon lampIcon(app::DeviceState state);

/// The word for a state, for accessible names and tool tips.
[[nodiscard]] QString lampText(app::DeviceState state);

/// A lamp as a widget; its arc turns only while busy and visible.
class StateLamp : public QWidget {
    Q_OBJECT
public:
    explicit StateLamp(QWidget* parent = nullptr);

    void setState(app::DeviceState state);
    [[nodiscard]] app::DeviceState state() const { return state_; }
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    app::DeviceState state_ = app::DeviceState::kIdle;
    double turn_ = 0.0;
    QTimer spin_;
};

}  // namespace pmts::gui
