#include "field_fixture.hpp"
#include "pmts/app/line/axis_test_presenter.hpp"
#include "pmts/app/line/two_face_presenter.hpp"

#include <QSignalSpy>
#include <gmock/gmock.h>

namespace pmts::app {
namespace {

using testing::HasSubstr;

simulator::StationSettings crooked() {
    simulator::StationSettings settings;
    settings.collimation = Angle::fromMgon(4);
    settings.index_error = Angle::fromMgon(-3);
    settings.trunnion_error = Angle::fromMgon(2);
    return settings;
}

/// A surveyor who aims at targets exactly, whatever the circles say.
class InstrumentCareTest : public FieldTest {
protected:
    explicit InstrumentCareTest(const simulator::StationSettings& settings = crooked()) : FieldTest(settings) {}

    void aimAt(const geometry::Pointing& truth) {
        const bool face_two = health.face().text == QLatin1String("Face II");
        true_pointing->place(face_two ? geometry::otherFace(truth) : truth);
        pass(2s);
    }
    void take() {
        test.take();
        ASSERT_TRUE(until([this] { return !test.isReading(); }));
    }
    void turn() {
        test.turnToOther();
        ASSERT_TRUE(until([this] { return !test.isTurning(); }));
        pass(1s);
    }
    void takePair(const geometry::Pointing& truth) {
        aimAt(truth);
        take();
        turn();
        aimAt(truth);
        take();
    }
    bool measureFace(const geometry::Pointing& truth) {
        aimAt(truth);
        faces.measure();
        return until([this] { return !faces.isBusy(); });
    }
    /// Six pairs estimate sigma so badly that a right result is three of it away once in 30 draws.
    static constexpr int kPairs = 40;
    static constexpr geometry::Pointing level{Angle::fromGon(10), Angle::fromGon(99)};
    static constexpr geometry::Pointing steep{Angle::fromGon(5), Angle::fromGon(72)};

    InstrumentHealth health{instrument, preferences, messages, clock};
    AxisTestPresenter test{instrument, health, preferences, messages, clock};
    TwoFacePresenter faces{instrument, job_desk, points, station_page, preferences, messages};
};

TEST_F(InstrumentCareTest, TheTestFindsCollimationAndIndexOfTheSimulatedInstrument) {
    connectInstrument();
    for (int i = 0; i < kPairs; ++i) {
        takePair(level);
    }
    const auto result = test.result();
    ASSERT_TRUE(result && result->collimation.sigma && result->index.sigma) << newestBar(messages).toStdString();
    // The trunnion error leaks in with cos VA: 2 mgon * cos 99 gon = 0.03 mgon.
    EXPECT_NEAR(result->collimation.value.mgon(), 4.0 + 0.03, 3 * result->collimation.sigma->mgon());
    EXPECT_NEAR(result->index.value.mgon(), -3.0, 3 * result->index.sigma->mgon());
    EXPECT_LT(result->collimation.sigma->mgon(), 0.02) << "3 cc a reading, five in each face: 0.095 mgon a pair";
    EXPECT_FALSE(result->tilting.has_value());
}

TEST_F(InstrumentCareTest, ASteepTargetShowsTheTiltingAxisToo) {
    connectInstrument();
    for (int i = 0; i < kPairs; ++i) {
        takePair(i % 2 == 0 ? level : steep);
    }
    const auto result = test.result();
    ASSERT_TRUE(result && result->tilting) << newestBar(messages).toStdString();
    EXPECT_NEAR(result->collimation.value.mgon(), 4.0, 3 * result->collimation.sigma->mgon());
    EXPECT_NEAR(result->tilting->value.mgon(), 2.0, 3 * result->tilting->sigma->mgon());
}

TEST_F(InstrumentCareTest, AnAcceptedTestIsKeptWithDateAndTemperatureAndExpires) {
    connectInstrument();
    ASSERT_TRUE(until([this] { return health.temperatureDegc().has_value(); }));
    takePair(level);
    EXPECT_FALSE(test.canAccept()) << "one pair says nothing of how sure it is";
    takePair(level);
    test.accept();
    EXPECT_EQ(test.kept().state, DeviceState::kGood) << test.kept().text.toStdString();
    EXPECT_TRUE(test.isEmpty());
    const auto& care = preferences.settings().instrument_care;
    const auto* record = care.testOf(QStringLiteral("620123"));
    ASSERT_NE(record, nullptr);
    EXPECT_EQ(record->temperature_degc, 20.0);
    EXPECT_EQ(axisTestState(care, record->serial_number, 31.0, record->utc).state, DeviceState::kWarning);
    EXPECT_EQ(axisTestState(care, record->serial_number, 29.0, record->utc).state, DeviceState::kGood);
    EXPECT_EQ(axisTestState(care, record->serial_number, 20.0, record->utc.addDays(31)).state, DeviceState::kWarning);
    EXPECT_EQ(axisTestState(care, QStringLiteral("other"), 20.0, record->utc).state, DeviceState::kIdle);
}

TEST_F(InstrumentCareTest, ATestFromTheFutureSaysThatTheClockWasSet) {
    connectInstrument();
    takePair(level);
    takePair(level);
    test.accept();
    clock.setTimeOfDayBy(std::chrono::hours(-30 * 24));
    EXPECT_EQ(test.kept().state, DeviceState::kWarning);
    EXPECT_THAT(test.kept().details.toStdString(), HasSubstr("the clock of this computer was set"));
    clock.setTimeOfDayBy(std::chrono::hours(30 * 24 - 1));
    EXPECT_EQ(test.kept().state, DeviceState::kGood) << "an hour is no reason";
    clock.setTimeOfDayBy(std::chrono::hours(31 * 24 + 1));
    EXPECT_EQ(test.kept().state, DeviceState::kWarning);
    EXPECT_THAT(test.kept().details.toStdString(), HasSubstr("31 days old"));
}

TEST_F(InstrumentCareTest, AnExpiredTestIsToldOnceWhenItsInstrumentIsConnected) {
    Settings settings = preferences.settings();
    settings.instrument_care.keep({.serial_number = QStringLiteral("620123"), .utc = clock.utcNow().addDays(-40),
                                   .temperature_degc = {},
                                   .errors = {.collimation = {}, .index = {}, .tilting = {}, .pairs = 3}});
    preferences.set(settings);
    connectInstrument();
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("axis test of this instrument"));
    messages.dismiss(messages.bars().front().id);
    health.refresh();
    pass(5s);
    EXPECT_TRUE(messages.bars().empty()) << "told again: " << newestBar(messages).toStdString();
    settings.instrument_care.expires_days = 60;
    test.setCare(settings.instrument_care);
    EXPECT_EQ(test.kept().state, DeviceState::kGood);
}

TEST_F(InstrumentCareTest, TheKeptTestSurvivesARestart) {
    InstrumentCareSettings care;
    care.target_test = {.on = false, .angle = Angle::fromMgon(30), .offset_m = 0.2};
    care.keep({.serial_number = QStringLiteral("620123"), .utc = QDateTime({2026, 6, 1}, {12, 0}, Qt::UTC), .temperature_degc = 21.5,
               .errors = {.collimation = {Angle::fromMgon(4), Angle::fromMgon(0.1)}, .index = {Angle::fromMgon(-3), {}},
                          .tilting = geometry::AxisError{Angle::fromMgon(2), {}}, .pairs = 6}});
    const QString path = folder.filePath(QStringLiteral("care.ini"));
    {
        QSettings file(path, QSettings::IniFormat);
        care.save(file);
    }
    InstrumentCareSettings loaded;
    loaded.load(QSettings(path, QSettings::IniFormat));
    EXPECT_EQ(loaded.target_test, care.target_test);
    const auto* const test_kept = loaded.testOf(QStringLiteral("620123"));
    ASSERT_NE(test_kept, nullptr);
    EXPECT_DOUBLE_EQ(test_kept->errors.collimation.sigma->mgon(), 0.1);
    EXPECT_FALSE(test_kept->errors.index.sigma.has_value());
    EXPECT_DOUBLE_EQ(test_kept->errors.tilting->value.mgon(), 2.0);
    EXPECT_EQ(test_kept->temperature_degc, 21.5);
}

TEST_F(InstrumentCareTest, AReadingEndsWithTheConnection) {
    connectInstrument();
    aimAt(level);
    test.take();
    ASSERT_TRUE(test.isReading());
    instrument.disconnectInstrument();
    pass(1s);
    EXPECT_FALSE(test.isReading());
    connectInstrument();
    pass(5s);
    EXPECT_TRUE(test.isEmpty()) << "nobody aimed at anything";
}

TEST_F(InstrumentCareTest, ATestIsKeptForTheInstrumentItWasMadeWithThoughThatHasGone) {
    connectInstrument();
    ASSERT_TRUE(until([this] { return health.temperatureDegc().has_value(); }));
    takePair(level);
    takePair(level);
    instrument.disconnectInstrument();
    pass(1s);
    ASSERT_TRUE(test.canAccept());
    test.accept();
    const auto& care = preferences.settings().instrument_care;
    ASSERT_NE(care.testOf(QStringLiteral("620123")), nullptr);
    EXPECT_EQ(care.testOf(QStringLiteral("620123"))->temperature_degc, 20.0);
    EXPECT_EQ(care.testOf(QString()), nullptr);
}

TEST_F(InstrumentCareTest, PointingsOfOneInstrumentNeverGoIntoTheTestOfAnother) {
    connectInstrument();
    takePair(level);
    takePair(level);
    instrument.disconnectInstrument();
    pass(1s);
    on_the_way = [](const std::string& bytes) {
        return bytes.starts_with("55=") ? std::string("55=999999\r\n>") : bytes;
    };
    connectInstrument();
    EXPECT_TRUE(test.isEmpty());
    EXPECT_FALSE(test.canAccept());
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("pointings of 620123 are dropped"));
}

TEST_F(InstrumentCareTest, ATypedTemperatureIsNotedInPlaceOfTheInstruments) {
    connectInstrument();
    ASSERT_TRUE(until([this] { return health.temperatureDegc().has_value(); }));
    EXPECT_THAT(test.temperatureText().toStdString(), HasSubstr("20.0 °C is noted with the test, as the instrument says"));
    test.typeTemperature(QStringLiteral("warm"));
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("no temperature"));
    test.typeTemperature(QStringLiteral("31.5"));
    EXPECT_THAT(test.temperatureText().toStdString(), HasSubstr("31.5 °C is noted with the test, as you typed it"));
    takePair(level);
    takePair(level);
    test.accept();
    EXPECT_EQ(preferences.settings().instrument_care.testOf(QStringLiteral("620123"))->temperature_degc, 31.5);
    EXPECT_TRUE(test.typedTemperature().isEmpty()) << "the next test is made on another day";
}

TEST_F(InstrumentCareTest, WithoutATemperatureItIsSaidThatNoneIsKnown) {
    on_the_way = [](const std::string& bytes) { return bytes.starts_with("56=") ? std::string("20\r\n>") : bytes; };
    connectInstrument();
    EXPECT_THAT(test.temperatureText().toStdString(), HasSubstr("not known"));
    takePair(level);
    takePair(level);
    test.accept();
    EXPECT_FALSE(preferences.settings().instrument_care.testOf(QStringLiteral("620123"))->temperature_degc);
    EXPECT_THAT(test.kept().text.toStdString(), HasSubstr("temperature not known"));
}

TEST_F(InstrumentCareTest, TheSameFaceTwiceAndAnotherTargetAreRefused) {
    connectInstrument();
    aimAt(level);
    take();
    take();
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("face is taken already"));
    turn();
    aimAt(steep);
    take();
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("another target"));
    EXPECT_TRUE(test.pairs().empty());
}

TEST_F(InstrumentCareTest, APointInTwoFacesIsRecordedAsTheMeanWithBothFacesInTheRawReply) {
    connectInstrument();
    openJob();
    ASSERT_TRUE(measureFace(level));
    ASSERT_EQ(faces.step(), TwoFaceStep::kSecond) << newestBar(messages).toStdString();
    pass(1s);
    ASSERT_TRUE(measureFace(level));
    ASSERT_EQ(faces.step(), TwoFaceStep::kDone) << newestBar(messages).toStdString();
    faces.record(QStringLiteral("7"), QStringLiteral("WALL"));
    ASSERT_TRUE(until([this] { return points.findId(QStringLiteral("7")) != nullptr; }));
    const auto& shot = points.findId(QStringLiteral("7"))->observation;
    // Free of 4, -3 and 2 mgon; left is the noise of two readings of 0.3 mgon a circle.
    EXPECT_NEAR(shot.pointing.ha.mgon(), level.ha.mgon(), 1.0);
    EXPECT_NEAR(shot.pointing.va.mgon(), level.va.mgon(), 1.0);
    EXPECT_EQ(shot.source, QStringLiteral("two_faces"));
    EXPECT_THAT(shot.raw_reply.toStdString(), HasSubstr("face I:"));
    EXPECT_THAT(shot.raw_reply.toStdString(), HasSubstr("face II:"));
}

TEST_F(InstrumentCareTest, AMeanUnderAUsedIdIsAskedAboutAndTheSecondTimeKept) {
    connectInstrument();
    openJob();
    const auto measureBoth = [this] {
        ASSERT_TRUE(measureFace(level));
        pass(1s);
        ASSERT_TRUE(measureFace(level));
        ASSERT_EQ(faces.step(), TwoFaceStep::kDone) << newestBar(messages).toStdString();
    };
    measureBoth();
    faces.record(QStringLiteral("7"), {});
    ASSERT_TRUE(until([this] { return points.points().size() == 1; }));
    EXPECT_EQ(faces.proposedId(), QStringLiteral("8"));
    measureBoth();
    faces.record(QStringLiteral("7"), {});
    pass(1s);
    EXPECT_EQ(points.points().size(), 1U);
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("has a point 7 already"));
    ASSERT_EQ(faces.step(), TwoFaceStep::kDone);
    faces.record(QStringLiteral("7"), {});
    EXPECT_FALSE(faces.canCancel()) << "it is being written";
    EXPECT_TRUE(until([this] { return points.points().size() == 2; }));
}

TEST_F(InstrumentCareTest, DifferencesOfTheFacesAreCheckedLessWhatTheKeptTestExplains) {
    connectInstrument();
    Settings settings = preferences.settings();
    settings.instrument_care.face_limit = Angle::fromMgon(3);
    settings.instrument_care.face_limit_m = 0.01;  // of a distance meter with 3 mm in each face
    preferences.set(settings);
    ASSERT_TRUE(measureFace(level));
    pass(1s);
    ASSERT_TRUE(measureFace(level));
    EXPECT_EQ(faces.outcome().state, DeviceState::kWarning) << "8 mgon of twice the collimation";
    settings.instrument_care.keep({.serial_number = QStringLiteral("620123"), .utc = clock.utcNow(), .temperature_degc = 20.0,
                                   .errors = {.collimation = {Angle::fromMgon(4), {}}, .index = {Angle::fromMgon(-3), {}},
                                              .tilting = std::nullopt, .pairs = 3}});
    preferences.set(settings);
    EXPECT_EQ(faces.outcome().state, DeviceState::kGood) << faces.outcome().details.toStdString();
}

class InstrumentHealthTest : public InstrumentCareTest {
protected:
    InstrumentHealthTest() : InstrumentCareTest(simulator::StationSettings{}) {}
};

TEST_F(InstrumentHealthTest, FaceAndCompensatorAreShownAndTheCompensatorIsSwitched) {
    connectInstrument();
    ASSERT_TRUE(until([this] { return health.compensatorOn().has_value(); }));
    EXPECT_TRUE(*health.compensatorOn());
    EXPECT_EQ(health.face().text, QStringLiteral("Face I"));
    EXPECT_EQ(health.battery().state, DeviceState::kIdle) << "nothing was said of it yet";
    health.switchCompensator(false);
    ASSERT_TRUE(until([this] { return health.compensatorOn() == false; }));
    EXPECT_EQ(health.compensator().state, DeviceState::kWarning);
    EXPECT_THAT(sent, HasSubstr("WG,22=0\r"));
}

TEST_F(InstrumentHealthTest, AnInstrumentWithoutALabelOfTheAirIsAskedForItOnlyOnce) {
    connectInstrument();
    ASSERT_TRUE(until([this] { return health.air().ppm.has_value(); }));
    const auto answer = instrument_end->on_received;
    instrument_end->on_received = [this, answer](std::string_view bytes) {
        if (bytes == "RG,65\r") {
            sent += bytes;
            return instrument_end->write("20\r\n>");
        }
        answer(bytes);
    };
    health.refresh();
    pass(3s);
    EXPECT_THAT(sent, HasSubstr("RG,65\r"));
    sent.clear();
    health.refresh();
    pass(3s);
    EXPECT_THAT(sent, HasSubstr("RG,74\r"));
    EXPECT_THAT(sent, testing::Not(HasSubstr("RG,65\r")));
    EXPECT_TRUE(messages.bars().empty()) << newestBar(messages).toStdString();
    EXPECT_EQ(health.airUsed().state, DeviceState::kGood);
}

TEST_F(InstrumentHealthTest, ALowBatteryShowsWithItsAgeUntilAMeasurementBringsNone) {
    connectInstrument();
    ASSERT_TRUE(station.injectFault(QStringLiteral("battery_low")).has_value());
    ASSERT_TRUE(measure());
    EXPECT_EQ(health.battery().state, DeviceState::kWarning);
    pass(3min);
    EXPECT_THAT(health.battery().details.toStdString(), HasSubstr("3 min ago"));
    ASSERT_TRUE(station.injectFault(QStringLiteral("battery_low=off")).has_value());
    ASSERT_TRUE(measure());
    EXPECT_EQ(health.battery().state, DeviceState::kGood);
}

TEST_F(InstrumentHealthTest, AnInstrumentOutOfLevelIsShownAndGoodAgainWithTheNextMeasurement) {
    connectInstrument();
    ASSERT_TRUE(station.injectFault(QStringLiteral("level_loss")).has_value());
    (void)measure();
    EXPECT_EQ(health.level().state, DeviceState::kFailed);
    EXPECT_EQ(health.state(), DeviceState::kFailed);
    ASSERT_TRUE(station.injectFault(QStringLiteral("level_loss=off")).has_value());
    ASSERT_TRUE(measure());
    EXPECT_EQ(health.level().state, DeviceState::kGood);
}

TEST_F(InstrumentHealthTest, TheCompensatorIsCalibratedWhileNobodyElseAsks) {
    connectInstrument();
    sent.clear();
    health.calibrateCompensator();
    ASSERT_TRUE(health.isCalibrating());
    ASSERT_TRUE(until([this] { return sent.find("PV,20\r") != std::string::npos; }));
    const auto began = sent.size();
    pass(10s);
    EXPECT_EQ(sent.size(), began) << "nothing is asked while it turns";
    ASSERT_TRUE(until([this] { return !health.isCalibrating(); }));
    EXPECT_THAT(health.calibrationText().toStdString(), HasSubstr("has calibrated"));
}

TEST_F(InstrumentHealthTest, TheTargetTestIsKeptAndHoldsForTheDriver) {
    const auto measureWhileItMoves = [this](const geometry::Pointing& from) {
        true_pointing->place(from);
        pass(2s);
        recording.measure();
        pass(2s);
        true_pointing->place({from.ha + Angle::fromMgon(30), from.va});
        return until([this] { return !recording.isBusy(); });
    };
    const auto shot = [this] { return recording.readings().shot; };
    health.setTargetTest({.on = true, .angle = Angle::fromMgon(20), .offset_m = 0.1});
    connectInstrument();
    ASSERT_TRUE(measureWhileItMoves(level));
    EXPECT_EQ(shot(), ShotState::kAbsurd);
    EXPECT_THAT(recording.readings().sentence.toStdString(), HasSubstr("moved while it measured"));

    health.setTargetTest({.on = false, .angle = Angle::fromMgon(20), .offset_m = 0.1});
    EXPECT_FALSE(preferences.settings().instrument_care.target_test.on);
    ASSERT_TRUE(measureWhileItMoves(level));
    EXPECT_EQ(shot(), ShotState::kMeasured) << newestBar(messages).toStdString();

    health.setTargetTest({.on = true, .angle = Angle::fromMgon(20), .offset_m = 0.1});
    instrument.disconnectInstrument();
    pass(1s);
    connectInstrument();
    ASSERT_TRUE(measureWhileItMoves(level));
    EXPECT_EQ(shot(), ShotState::kAbsurd) << "forgotten with the connection";
}

TEST(InstrumentAirTest, WhatRoundsToNothingHasNoSign) {
    const InstrumentAir air{.temperature_degc = -0.04, .pressure_mbar = 1013.04, .humidity_percent = {}, .ppm = -0.02};
    EXPECT_EQ(air.text(), QStringLiteral("0.0 °C, 1013.0 mbar, 0.0 ppm"));
}

}  // namespace
}  // namespace pmts::app
