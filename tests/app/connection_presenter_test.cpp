#include "app/field_fixture.hpp"

#include "pmts/app/desk/job_presenter.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

class ConnectionPresenterTest : public FieldTest {
protected:
    static SerialChoice typedPath() {
        SerialChoice choice;
        choice.path = QStringLiteral("memory");
        return choice;
    }

    const video::SourceAddress webcam{.kind = video::SourceKind::kV4l2, .location = QStringLiteral("/dev/video2"),
                                      .name = QStringLiteral("HD Pro Webcam")};
    SimulationDesk simulation;
    ConnectionPresenter connection{instrument, simulation, live, gate, preferences, messages,
                                   [this] { return std::vector{webcam}; }};
};

TEST_F(ConnectionPresenterTest, ConnectedMeansTheInstrumentAnsweredAndSaidWhoItIs) {
    connection.connectSerial(typedPath());
    ASSERT_TRUE(until([this] { return instrument.identity().has_value(); }));
    QStringList values;
    for (const IdentityLine& line : connection.identityLines()) {
        values.append(line.value);
    }
    EXPECT_TRUE(values.contains(QStringLiteral("620123"))) << values.join(u'|').toStdString();
    EXPECT_TRUE(values.contains(QStringLiteral("1111")));
    EXPECT_TRUE(values.contains(QStringLiteral("> (62)")));
    EXPECT_EQ(connection.instrumentStatus().state, DeviceState::kGood);
    EXPECT_TRUE(connection.doctorSteps().empty());
}

TEST_F(ConnectionPresenterTest, SilentInstrumentOpensTheDoctorsPage) {
    answers = false;
    QSignalSpy failed(&instrument, &InstrumentDesk::connectFailed);
    connection.connectSerial(typedPath());
    ASSERT_TRUE(until([&] { return !failed.empty(); }));
    QString all;
    for (const DoctorStep& step : connection.doctorSteps()) {
        all += step.title + step.text;
    }
    EXPECT_TRUE(all.contains(QStringLiteral("1.8.0.9600")));
    EXPECT_TRUE(all.contains(QStringLiteral("label 79")));
    EXPECT_TRUE(all.contains(QStringLiteral("Cable")));
    EXPECT_EQ(connection.instrumentStatus().state, DeviceState::kFailed);
    EXPECT_EQ(messages.bars().back().action, MessageAction::kOpenConnectionPage);
}

TEST_F(ConnectionPresenterTest, PortThatCannotBeOpenedIsTheFirstThingTheDoctorNames) {
    unplug();
    QSignalSpy failed(&instrument, &InstrumentDesk::connectFailed);
    connection.connectSerial(typedPath());
    ASSERT_TRUE(until([&] { return !failed.empty(); }));
    EXPECT_EQ(connection.doctorSteps().front().title, QStringLiteral("The port"));
}

TEST_F(ConnectionPresenterTest, LostInstrumentIsSaidAndTheBarGoesWhenItIsBack) {
    connection.connectSerial(typedPath());
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kConnected; }));
    unplug();
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kReconnecting; }));
    EXPECT_EQ(connection.instrumentStatus().state, DeviceState::kWarning);
    ASSERT_FALSE(messages.bars().empty());
    plugIn();
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kConnected; }));
    EXPECT_TRUE(messages.bars().empty());
}

TEST_F(ConnectionPresenterTest, InstrumentThatFallsSilentIsNotCalledConnected) {
    connection.connectSerial(typedPath());
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kConnected; }));
    answers = false;
    EXPECT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kReconnecting; }));
}

TEST_F(ConnectionPresenterTest, SecondConnectWhileTheFirstStillAsksTakesOver) {
    answers = false;
    connection.connectSerial(typedPath());
    pass(500ms);
    answers = true;
    connection.connectSerial(typedPath());
    EXPECT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kConnected; }));
}

TEST_F(ConnectionPresenterTest, AnInstrumentThatIsOffIsSwitchedOnOverItsLine) {
    connection.connectSerial(typedPath());
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kConnected; }));
    EXPECT_FALSE(connection.canSwitchOn()) << "it is on";
    connection.disconnectInstrument();
    pass(1s);
    ASSERT_TRUE(station.injectFault(QStringLiteral("power_off=0")).has_value());
    QSignalSpy failed(&instrument, &InstrumentDesk::connectFailed);
    connection.connectSerial(typedPath());
    ASSERT_TRUE(until([&] { return !failed.empty(); }));
    ASSERT_TRUE(connection.canSwitchOn());
    connection.switchOn();
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kConnected; }));
    EXPECT_EQ(instrument.identity()->serial_number, QStringLiteral("620123"));
    EXPECT_FALSE(connection.canSwitchOn());
}

TEST_F(ConnectionPresenterTest, ChosenPortIsRemembered) {
    SerialChoice choice = typedPath();
    choice.baud = 4800;
    connection.connectSerial(choice);
    EXPECT_EQ(preferences.settings().last_device, LastDevice::kSerial);
    EXPECT_EQ(connection.serialChoice().baud, 4800);
    EXPECT_EQ(choice.text(), QStringLiteral("memory at 4800 8N1"));
}

TEST_F(ConnectionPresenterTest, CamerasAreLookedForElsewhereAndTheSimulatedOneIsAlwaysFirst) {
    QSignalSpy changed(&connection, &ConnectionPresenter::camerasChanged);
    connection.refresh();
    EXPECT_TRUE(connection.isLookingForCameras());
    EXPECT_EQ(connection.cameraListNote(), QStringLiteral("Looking for cameras…"));
    EXPECT_EQ(connection.cameras().front().kind, video::SourceKind::kSimulated) << "to choose from meanwhile";
    ASSERT_EQ(changed.size(), 1) << "the note is to be shown";

    ASSERT_TRUE(changed.wait(60000));

    EXPECT_FALSE(connection.isLookingForCameras());
    EXPECT_TRUE(connection.cameraListNote().isEmpty());
    ASSERT_EQ(connection.cameras().size(), 2u);
    EXPECT_EQ(connection.cameras().front().kind, video::SourceKind::kSimulated);
    EXPECT_EQ(connection.cameras().back(), webcam);
}

TEST_F(ConnectionPresenterTest, SimulatorOfOneStartLeavesTheRememberedDevicesAlone) {
    SerialChoice choice = typedPath();
    choice.baud = 4800;
    connection.connectSerial(choice);
    Settings settings = preferences.settings();
    settings.camera = webcam;
    preferences.set(settings);
    QSignalSpy started(&simulation, &SimulationDesk::started);

    connection.startSimulated();
    ASSERT_TRUE(started.wait(60000));

    EXPECT_EQ(preferences.settings().last_device, LastDevice::kSerial);
    EXPECT_EQ(preferences.settings().serial.baud, 4800);
    EXPECT_EQ(preferences.settings().camera.location, QStringLiteral("/dev/video2"));
    EXPECT_EQ(live.cameraStatus().text, QStringLiteral("Simulated camera"));
    connection.connectSimulated();
    EXPECT_EQ(preferences.settings().last_device, LastDevice::kSimulated) << "chosen by hand";
}

TEST_F(ConnectionPresenterTest, SavedRigProfileIsUsedByTheLiveViewOfARealCamera) {
    live.setSource(std::make_unique<HandSource>(video::SourceKind::kV4l2));
    RigProfile profile = connection.rigProfile();
    profile.name = QStringLiteral("Webcam");
    profile.rig.mount.offset_m = {0.0, 0.0, 0.5};
    QSignalSpy changed(&connection, &ConnectionPresenter::rigChanged);
    connection.saveRigProfile(profile);
    EXPECT_EQ(changed.size(), 1);
    EXPECT_EQ(live.model().rig().mount.offset_m.z(), 0.5);
    connection.chooseRigProfile(connection.rigProfiles().front().name);
    EXPECT_NE(live.model().rig().mount.offset_m.z(), 0.5);
}

TEST_F(ConnectionPresenterTest, RigFollowsTheCameraInUse) {
    RigProfile profile = connection.rigProfile();
    profile.name = QStringLiteral("Webcam");
    profile.rig.mount.offset_m = {0.0, 0.0, 0.5};
    connection.saveRigProfile(profile);
    const auto height_m = [this] { return live.model().rig().mount.offset_m.z(); };
    EXPECT_EQ(height_m(), simulatedRigProfile().rig.mount.offset_m.z()) << "the simulated camera aims with its own rig";
    EXPECT_FALSE(connection.rigNote().isEmpty());

    live.setSource(std::make_unique<HandSource>(video::SourceKind::kV4l2));
    EXPECT_EQ(height_m(), 0.5);
    EXPECT_TRUE(connection.rigNote().isEmpty());
    live.setSource(std::make_unique<HandSource>());
    EXPECT_EQ(height_m(), simulatedRigProfile().rig.mount.offset_m.z());
    EXPECT_EQ(connection.rigProfile().name, profile.name) << "still chosen";
}

TEST_F(ConnectionPresenterTest, RigProfileWithoutANameIsNotKept) {
    RigProfile profile = connection.rigProfile();
    profile.name.clear();
    connection.saveRigProfile(profile);
    EXPECT_TRUE(preferences.settings().rig_profiles.empty());
    EXPECT_FALSE(messages.bars().empty());
}

TEST_F(ConnectionPresenterTest, StatusLineShowsBusyAfterAMomentAndTheUsualTimeAfterTwoSeconds) {
    JobPresenter job(job_desk, preferences, messages);
    ControlPresenter control(instrument, preferences, messages, clock);
    StatusPresenter status(job, station_page, connection, live, control, instrument);
    connection.connectSerial(typedPath());
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kConnected && !instrument.isBusy(); }));
    EXPECT_FALSE(status.line().busy_shown);
    EXPECT_EQ(status.line().job.state, DeviceState::kWarning) << "no job";
    recording.measure();
    pass(1s);
    EXPECT_TRUE(status.line().busy_shown);
    EXPECT_EQ(status.line().busy_text, QStringLiteral("Measuring"));
    ASSERT_TRUE(until([this] { return !recording.isBusy(); }));
    pass(100ms);
    EXPECT_FALSE(status.line().busy_shown);
}

TEST_F(ConnectionPresenterTest, LowBatteryIsSaidOnceUntilItIsSolvedAndTheDistanceIsKept) {
    connectInstrument();
    openJob();
    ASSERT_TRUE(station.injectFault(QStringLiteral("battery_low")).has_value());
    ASSERT_TRUE(recordPoint());
    EXPECT_EQ(points.points().size(), 1U);
    ASSERT_EQ(messages.bars().size(), 1U);
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("battery of the instrument is low"));
    messages.dismiss(messages.bars().back().id);
    ASSERT_TRUE(recordPoint());
    EXPECT_TRUE(messages.bars().empty()) << "it was dismissed and is still low";

    ASSERT_TRUE(station.injectFault(QStringLiteral("battery_low=off")).has_value());
    ASSERT_TRUE(recordPoint());
    ASSERT_TRUE(station.injectFault(QStringLiteral("battery_low")).has_value());
    ASSERT_TRUE(recordPoint());
    EXPECT_EQ(messages.bars().size(), 1U) << "low again";
}

}  // namespace
}  // namespace pmts::app
