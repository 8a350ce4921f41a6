#include "field_fixture.hpp"
#include "pmts/app/line/instrument_health.hpp"

#include <QSignalSpy>
#include <gmock/gmock.h>

namespace pmts::app {
namespace {

using testing::HasSubstr;
using testing::Not;

/// An instrument that asks before it calibrates its compensator, and a surveyor who may not answer.
class QuestionTest : public FieldTest {
protected:
    static simulator::StationSettings asking() {
        simulator::StationSettings settings;
        settings.calibration_asks = true;
        return settings;
    }
    QuestionTest() : FieldTest(asking()) {}

    void calibrateUntilAsked() {
        const qsizetype before = asked.count();
        health.calibrateCompensator();
        ASSERT_TRUE(until([this, before] { return asked.count() > before; }));
    }
    bool isOver() {
        return until([this] { return !health.isCalibrating(); }, 2s);
    }
    /// Somebody presses No at the instrument.
    void answerAtTheInstrument() { station.receive("N\r"); }

    InstrumentHealth health{instrument, preferences, messages, clock};
    QSignalSpy asked{&health, &InstrumentHealth::questionAsked};
};

TEST_F(QuestionTest, YesLetsTheInstrumentTurnAndNoIsNotCalledCalibrated) {
    connectInstrument();
    calibrateUntilAsked();
    health.answer(true);
    ASSERT_TRUE(until([this] { return !health.isCalibrating(); }));
    EXPECT_THAT(health.calibrationText().toStdString(), HasSubstr("has calibrated"));

    calibrateUntilAsked();
    health.answer(false);
    ASSERT_TRUE(until([this] { return !health.isCalibrating(); }));
    EXPECT_THAT(health.calibrationText().toStdString(), HasSubstr("calibrated nothing"));
}

TEST_F(QuestionTest, CancelAnswersNoSoThatTheInstrumentObeysAgain) {
    connectInstrument();
    calibrateUntilAsked();
    health.cancel();
    ASSERT_TRUE(isOver());
    EXPECT_THAT(sent, HasSubstr("N\r"));
    EXPECT_TRUE(turnTo(20, 90));
    EXPECT_NEAR(true_pointing->at(clock.now()).ha.gon(), 20.0, 0.01);
}

TEST_F(QuestionTest, StopAnswersNoToo) {
    connectInstrument();
    calibrateUntilAsked();
    instrument.stop();
    ASSERT_TRUE(isOver());
    EXPECT_TRUE(turnTo(20, 90));
    EXPECT_NEAR(true_pointing->at(clock.now()).ha.gon(), 20.0, 0.01);
}

TEST_F(QuestionTest, ACableThatGoesEndsTheQuestionAndTheInstrumentComesBack) {
    connectInstrument();
    calibrateUntilAsked();
    unplug();
    EXPECT_TRUE(isOver()) << "the routine would wait for ever, and every request behind it";
    answerAtTheInstrument();
    plugIn();
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kConnected; }));
    EXPECT_TRUE(turnTo(20, 90));
    EXPECT_NEAR(true_pointing->at(clock.now()).ha.gon(), 20.0, 0.01);
}

TEST_F(QuestionTest, DisconnectEndsTheQuestion) {
    connectInstrument();
    calibrateUntilAsked();
    instrument.disconnectInstrument();
    EXPECT_TRUE(isOver());
    answerAtTheInstrument();
    connectInstrument();
}

TEST_F(QuestionTest, ConnectingElsewhereEndsTheQuestion) {
    connectInstrument();
    calibrateUntilAsked();
    answerAtTheInstrument();
    SerialChoice other;
    other.path = QStringLiteral("other");
    instrument.connectSerial(other);
    EXPECT_TRUE(isOver());
    ASSERT_TRUE(until([this] {
        return instrument.connectionState() == ConnectionState::kConnected &&
               instrument.choice().path == QLatin1String("other");
    }));
}

TEST_F(QuestionTest, ALateAnswerIsNotTakenForALaterQuestion) {
    connectInstrument();
    calibrateUntilAsked();
    instrument.disconnectInstrument();
    ASSERT_TRUE(isOver());
    answerAtTheInstrument();
    health.answer(true);
    connectInstrument();
    sent.clear();
    calibrateUntilAsked();
    pass(1s);
    EXPECT_THAT(sent, Not(HasSubstr("Y\r")));
    EXPECT_TRUE(health.isCalibrating());
}

}  // namespace
}  // namespace pmts::app
