#include "line/instrument_page.hpp"

#include "app/field_fixture.hpp"

#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

using namespace std::chrono_literals;
using core::Angle;
using testing::HasSubstr;

simulator::StationSettings crookedAndAsking() {
    simulator::StationSettings settings;
    settings.collimation = Angle::fromMgon(4);
    settings.calibration_asks = true;
    return settings;
}

/// The page with the simulated instrument behind it, in virtual time.
class InstrumentPageOnLineTest : public app::FieldTest {
protected:
    InstrumentPageOnLineTest() : FieldTest(crookedAndAsking()) {}

    QPushButton& button(const char* name) { return *page.findChild<QPushButton*>(QLatin1String(name)); }
    void click(const char* name) {
        ASSERT_TRUE(button(name).isEnabled()) << name;
        button(name).click();
    }
    [[nodiscard]] std::string text(const char* name) {
        return page.findChild<QLabel*>(QLatin1String(name))->text().toStdString();
    }
    [[nodiscard]] QMessageBox* question() {
        auto* const box = page.findChild<QMessageBox*>(QStringLiteral("instrument_question"));
        return box != nullptr && !box->isHidden() ? box : nullptr;
    }
    void aim() {
        const bool face_two = health.face().text == QLatin1String("Face II");
        true_pointing->place(face_two ? geometry::otherFace(level) : level);
        pass(2s);
    }
    void takePointing() {
        aim();
        click("axis_take");
        ASSERT_TRUE(until([this] { return !test.isReading(); }));
    }
    void measureFace() {
        aim();
        click("two_face_measure");
        ASSERT_TRUE(until([this] { return !faces.isBusy(); }));
        pass(1s);
    }
    void startCalibration() {
        click("compensator_calibrate");
        auto* const box = page.findChild<QMessageBox*>();
        for (auto* const each : box->buttons()) {
            if (box->buttonRole(each) == QMessageBox::AcceptRole) {
                each->click();
            }
        }
        ASSERT_TRUE(until([this] { return question() != nullptr; }));
    }
    static constexpr geometry::Pointing level{Angle::fromGon(10), Angle::fromGon(99)};

    app::InstrumentHealth health{instrument, preferences, messages, clock};
    app::AxisTestPresenter test{instrument, health, preferences, messages, clock};
    app::TwoFacePresenter faces{instrument, job_desk, points, station_page, preferences, messages};
    InstrumentPage page{health, test, faces};
};

TEST_F(InstrumentPageOnLineTest, TheCompensatorIsSwitchedByAClick) {
    connectInstrument();
    ASSERT_TRUE(until([this] { return health.compensatorOn().has_value(); }));
    click("compensator_switch");
    ASSERT_TRUE(until([this] { return health.compensatorOn() == false; }));
    EXPECT_THAT(text("instrument_compensator"), HasSubstr("not corrected"));
    EXPECT_TRUE(button("compensator_switch").text().contains(QLatin1String("&on")));
}

TEST_F(InstrumentPageOnLineTest, TheAxisTestIsMadeByClicksAndKeptWithATypedTemperature) {
    connectInstrument();
    ASSERT_TRUE(until([this] { return health.temperatureDegc().has_value(); }));
    EXPECT_THAT(text("axis_temperature_text"), HasSubstr("20.0 °C is noted"));
    for (int pair = 0; pair < 2; ++pair) {
        takePointing();
        click("axis_turn");
        EXPECT_FALSE(button("axis_take").isEnabled());
        ASSERT_TRUE(until([this] { return !test.isTurning(); }));
        pass(1s);
        takePointing();
    }
    EXPECT_EQ(page.findChild<QTableWidget*>(QStringLiteral("axis_pairs"))->rowCount(), 2);
    auto& temperature = *page.findChild<QLineEdit*>(QStringLiteral("axis_temperature"));
    temperature.setText(QStringLiteral("27.5"));
    Q_EMIT temperature.editingFinished();
    EXPECT_THAT(text("axis_temperature_text"), HasSubstr("27.5 °C is noted with the test, as you typed it"));
    click("axis_accept");
    const auto* const kept = preferences.settings().instrument_care.testOf(QStringLiteral("620123"));
    ASSERT_NE(kept, nullptr);
    EXPECT_EQ(kept->temperature_degc, 27.5);
    EXPECT_NEAR(kept->errors.collimation.value.mgon(), 4.0, 0.15);  // as the simulated instrument was made
    EXPECT_THAT(text("axis_kept"), HasSubstr("28 °C"));
    EXPECT_TRUE(temperature.text().isEmpty());
}

TEST_F(InstrumentPageOnLineTest, ThePointInTwoFacesIsRecordedUnderAnIdThatIsStillFree) {
    connectInstrument();
    openJob();
    measureFace();
    measureFace();
    auto& id = *page.findChild<QLineEdit*>(QStringLiteral("two_face_id"));
    EXPECT_EQ(id.text(), QStringLiteral("1"));
    ASSERT_TRUE(recordPoint());  // meanwhile, in the field: point 1
    ASSERT_EQ(points.points().size(), 1U);
    EXPECT_EQ(id.text(), QStringLiteral("2")) << "a proposal gives way";
    click("two_face_record");
    EXPECT_FALSE(button("two_face_cancel").isEnabled()) << "it is being written";
    ASSERT_TRUE(until([this] { return points.points().size() == 2; }));
    EXPECT_EQ(points.points()[1].id, QStringLiteral("2"));
}

TEST_F(InstrumentPageOnLineTest, WhatWasTypedAsIdStaysThoughItGetsUsed) {
    connectInstrument();
    openJob();
    measureFace();
    measureFace();
    auto& id = *page.findChild<QLineEdit*>(QStringLiteral("two_face_id"));
    recording.setPointId(QStringLiteral("77"));
    id.setText(QStringLiteral("77"));
    ASSERT_TRUE(recordPoint());
    EXPECT_EQ(id.text(), QStringLiteral("77"));
    click("two_face_record");
    EXPECT_EQ(points.points().size(), 1U);
    EXPECT_THAT(app::newestBar(messages).toStdString(), HasSubstr("has a point 77 already"));
}

TEST_F(InstrumentPageOnLineTest, TheQuestionOfTheInstrumentLeavesStopWithinReachAndIsAnswered) {
    connectInstrument();
    startCalibration();
    EXPECT_FALSE(question()->isModal());
    question()->button(QMessageBox::Yes)->click();
    ASSERT_TRUE(until([this] { return !health.isCalibrating(); }));
    EXPECT_THAT(health.calibrationText().toStdString(), HasSubstr("has calibrated"));
    EXPECT_EQ(question(), nullptr);
}

TEST_F(InstrumentPageOnLineTest, TheQuestionGoesWithTheCalibrationItBelongsTo) {
    connectInstrument();
    startCalibration();
    unplug();
    ASSERT_TRUE(until([this] { return !health.isCalibrating(); }, 2s));
    EXPECT_EQ(question(), nullptr);
}

}  // namespace
}  // namespace pmts::gui
