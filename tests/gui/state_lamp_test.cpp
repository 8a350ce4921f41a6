#include "parts/state_lamp.hpp"

#include "pmts/gui/theme.hpp"

#include <QImage>
#include <QPainter>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

using app::DeviceState;

/// Ink or ground: what is left when all colours are gone.
QImage shapeOf(DeviceState state) {
    Theme ink = themeNamed(PaletteName::kDay);
    ink.idle = ink.busy = ink.good = ink.warning = ink.failed = ink.text = Qt::black;
    ink.window = Qt::white;
    QImage image(32, 32, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    paintLamp(painter, image.rect(), state, ink);
    return image;
}

TEST(StateLampTest, FiveStatesHaveFiveShapes) {
    const DeviceState states[] = {DeviceState::kIdle, DeviceState::kBusy, DeviceState::kGood,
                                  DeviceState::kWarning, DeviceState::kFailed};
    for (const DeviceState a : states) {
        for (const DeviceState b : states) {
            if (a != b) {
                EXPECT_NE(shapeOf(a), shapeOf(b)) << static_cast<int>(a) << " and " << static_cast<int>(b);
            }
        }
    }
}

TEST(StateLampTest, IdleIsHollowAndGoodIsFull) {
    EXPECT_EQ(shapeOf(DeviceState::kIdle).pixelColor(16, 16), QColor(Qt::white));
    EXPECT_EQ(shapeOf(DeviceState::kGood).pixelColor(16, 16), QColor(Qt::black));
}

TEST(StateLampTest, SaysItsStateInWords) {
    StateLamp lamp;
    lamp.setState(DeviceState::kFailed);
    EXPECT_EQ(lamp.accessibleName(), lampText(DeviceState::kFailed));
    EXPECT_FALSE(lamp.toolTip().isEmpty());
}

}  // namespace
}  // namespace pmts::gui
