#include "field/readings_panel.hpp"

#include <QFontInfo>
#include <QLabel>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

app::Readings measuredReadings() {
    app::Readings readings;
    readings.ha = QStringLiteral("177.5612");
    readings.va = QStringLiteral("96.1684");
    readings.sd = QStringLiteral("23.418");
    readings.angle_unit = QStringLiteral("gon");
    readings.length_unit = QStringLiteral("m");
    readings.shot = app::ShotState::kMeasured;
    return readings;
}

class ReadingsPanelTest : public testing::Test {
protected:
    ReadingsPanelTest() { panel.show(); }
    [[nodiscard]] QLabel* label(const char* name) const {
        return panel.findChild<QLabel*>(QString::fromLatin1(name));
    }

    ReadingsPanel panel;
};

TEST_F(ReadingsPanelTest, DigitsAreAtLeast28PixelsHighAndRightAligned) {
    for (const char* name : {"ha", "va", "sd", "easting", "northing", "height"}) {
        EXPECT_GE(QFontInfo(label(name)->font()).pixelSize(), 28) << name;
        EXPECT_TRUE(label(name)->alignment() & Qt::AlignRight) << name;
    }
}

TEST_F(ReadingsPanelTest, AllDigitsAreEquallyWide) {
    const QFontMetricsF metrics(label("ha")->font());
    for (char digit = '1'; digit <= '9'; ++digit) {
        EXPECT_DOUBLE_EQ(metrics.horizontalAdvance(QChar::fromLatin1(digit)),
                         metrics.horizontalAdvance(u'0'));
    }
}

TEST_F(ReadingsPanelTest, AbsentIsADashNotAZero) {
    EXPECT_EQ(label("sd")->text(), QStringLiteral("\u2013"));
    EXPECT_EQ(label("easting")->text(), QStringLiteral("\u2013"));
}

TEST_F(ReadingsPanelTest, AShotMadeElsewhereIsSlantedAndSaysWhy) {
    app::Readings old = measuredReadings();
    old.shot_is_elsewhere = true;
    panel.showReadings(old);
    EXPECT_TRUE(label("sd")->font().italic());
    EXPECT_FALSE(label("sd")->toolTip().isEmpty());
    EXPECT_FALSE(label("ha")->font().italic());
}

TEST_F(ReadingsPanelTest, AFreshShotIsUpright) {
    panel.showReadings(measuredReadings());
    EXPECT_EQ(label("sd")->text(), QStringLiteral("23.418"));
    EXPECT_FALSE(label("sd")->font().italic());
}

TEST_F(ReadingsPanelTest, CirclesOfAnInstrumentThatDoesNotAnswerAreOld) {
    panel.showReadings(measuredReadings());
    panel.setCirclesLive(false);
    EXPECT_TRUE(label("ha")->font().italic());
    EXPECT_FALSE(label("va")->toolTip().isEmpty());
    panel.setCirclesLive(true);
    EXPECT_FALSE(label("ha")->font().italic());
}

TEST(ShotStatus, AbsurdIsAWarningAndKeptAFailure) {
    EXPECT_EQ(shotStatus(app::ShotState::kAbsurd).state, app::DeviceState::kWarning);
    EXPECT_EQ(shotStatus(app::ShotState::kKept).state, app::DeviceState::kFailed);
    EXPECT_EQ(shotStatus(app::ShotState::kNone).state, app::DeviceState::kIdle);
}

}  // namespace
}  // namespace pmts::gui
