#include "app/field_fixture.hpp"

#include "pmts/app/desk/job_presenter.hpp"
#include "pmts/simulator/simulation.hpp"
#include "pmts/transport/pty_link.hpp"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QSignalSpy>
#include <QTimer>

#include <fcntl.h>
#include <unistd.h>

namespace pmts::app {
namespace {

/// Runs the event loop until it is so, woken by a tick; false after a generous time. The tick also shows that the GUI
/// thread was never kept for long.
class Watch {
public:
    bool until(const std::function<bool()>& so, std::chrono::milliseconds limit = 60s) {
        QEventLoop loop;
        QTimer tick;
        QElapsedTimer passed;
        passed.start();
        last_.start();
        QObject::connect(&tick, &QTimer::timeout, &loop, [&] {
            longest_gap_ms_ = std::max(longest_gap_ms_, last_.restart());
            if (so() || passed.hasExpired(limit.count())) {
                loop.quit();
            }
        });
        tick.start(5ms);
        loop.exec();
        return so();
    }
    [[nodiscard]] qint64 longestGapMs() const { return longest_gap_ms_; }

private:
    QElapsedTimer last_;
    qint64 longest_gap_ms_ = 0;
};

constexpr qint64 kFreezeMs = 1000;  ///< a loaded machine's hiccup is shorter, waiting for a silent line is longer

/// The desks as the program has them, on their own threads, against the real Simulation on a pty, ten times as fast.
class DeviceFaultTest : public testing::Test {
protected:
    DeviceFaultTest() { simulation_choice.time_scale = 10.0; }

    void startAll() {
        connection.setSimulation(simulation_choice);
        connection.connectSimulated();
        job_desk.create(folder.filePath(QStringLiteral("wall.gpkg")));
        ASSERT_TRUE(watch.until([this] { return isConnected() && job_desk.isOpen() && instrument.track().newest(); }));
    }
    [[nodiscard]] bool isConnected() const { return instrument.connectionState() == ConnectionState::kConnected; }
    [[nodiscard]] bool isMeasuring() const { return instrument.progress().activity == instrument::Activity::kMeasuring; }
    /// The cable goes and comes back under another name while `held` still keeps the old one.
    void pullCable() {
        old_port = simulation.portPath();
        simulation.unplug();
        ASSERT_TRUE(watch.until([this] { return instrument.connectionState() == ConnectionState::kReconnecting; }));
        EXPECT_EQ(connection.instrumentStatus().state, DeviceState::kWarning);
        ASSERT_FALSE(messages.bars().empty());
        EXPECT_EQ(messages.bars().front().action, MessageAction::kOpenConnectionPage);
    }
    void plugIn() {
        simulation.plugIn();
        ASSERT_TRUE(watch.until([this] { return connection.instrumentStatus().state == DeviceState::kGood; }));
    }
    [[nodiscard]] QString doctorText() const {
        QString text;
        for (const DoctorStep& step : connection.doctorSteps()) {
            text += step.title + u' ' + step.text + u'\n';
        }
        return text;
    }
    bool connectTo(const QString& path, int baud = 9600) {
        SerialChoice choice;
        choice.path = path;
        choice.baud = baud;
        QSignalSpy failed(&instrument, &InstrumentDesk::connectFailed);
        connection.connectSerial(choice);
        return watch.until([&] { return !failed.empty() || isConnected(); });
    }

    Watch watch;
    QTemporaryDir folder;
    core::SystemClock clock;
    core::VideoGate gate;
    QString old_port;
    SimulationChoice simulation_choice;
    QUndoStack undo;
    Preferences preferences{QString()};
    MessageCentre messages;
    RangeKeeper range{25.0};
    SimulationDesk simulation;
    InstrumentDesk instrument{gate};
    JobDesk job_desk;
    PointsModel points{job_desk, preferences, messages, undo};
    StationPresenter station_page{job_desk, points, instrument, preferences, messages, undo};
    LivePresenter live{instrument, points, station_page, range, job_desk, preferences, messages, gate, clock};
    TargetingPresenter targeting{instrument, live, points, station_page, range, preferences, messages};
    RecordingPresenter recording{instrument, job_desk, points, station_page, range, preferences, messages, clock};
    JobPresenter job{job_desk, preferences, messages};
    ConnectionPresenter connection{instrument, simulation, live, gate, preferences, messages};
};

TEST_F(DeviceFaultTest, CablePulledWhileMovingEndsTheMoveAndTheNextOneArrives) {
    startAll();
    targeting.aimAtText(QStringLiteral("180 gon"), QStringLiteral("95 gon"));
    targeting.move();
    ASSERT_TRUE(watch.until([this] { return instrument.isTurning(); }));

    pullCable();
    ASSERT_TRUE(watch.until([this] { return !targeting.isMoving(); }));
    EXPECT_EQ(targeting.target()->state, MoveState::kLost);
    plugIn();

    targeting.move();
    ASSERT_TRUE(watch.until([this] { return !targeting.isMoving(); }));
    EXPECT_EQ(targeting.target()->state, MoveState::kArrived) << targeting.target()->sentence.toStdString();
    EXPECT_LT(watch.longestGapMs(), kFreezeMs);
}

TEST_F(DeviceFaultTest, CablePulledWhileMeasuringRecordsNothingAndSpaceWorksAfterwards) {
    startAll();
    recording.all();
    ASSERT_TRUE(watch.until([this] { return isMeasuring(); }));

    pullCable();
    ASSERT_TRUE(watch.until([this] { return !recording.isBusy(); }));
    EXPECT_EQ(points.rowCount(), 0);
    plugIn();

    recording.all();
    ASSERT_TRUE(watch.until([this] { return !recording.isBusy(); }));
    EXPECT_EQ(recording.readings().shot, ShotState::kRecorded) << recording.readings().sentence.toStdString();
    EXPECT_EQ(points.rowCount(), 1);
}

TEST_F(DeviceFaultTest, CablePulledWhileRecordingLosesNothing) {
    startAll();
    recording.measure();
    ASSERT_TRUE(watch.until([this] { return !recording.isBusy(); }));

    simulation.unplug();
    recording.record();  // the wire is not needed any more
    ASSERT_TRUE(watch.until([this] { return recording.readings().shot == ShotState::kRecorded; }));
    ASSERT_TRUE(watch.until([this] { return instrument.connectionState() == ConnectionState::kReconnecting; }));
    plugIn();

    ASSERT_EQ(points.rowCount(), 1);
    EXPECT_TRUE(points.points()[0].hasCoordinates());
    job_desk.close();
    ASSERT_TRUE(watch.until([this] { return !job_desk.isOpen(); }));
    EXPECT_EQ((*job::Job::open(folder.filePath(QStringLiteral("wall.gpkg"))))->points()->size(), 1U);
}

TEST_F(DeviceFaultTest, CableThatComesBackUnderAnotherNameIsFound) {
    startAll();
    const int holds_the_old_name = ::open(simulation.portPath().toLocal8Bit().constData(), O_RDWR | O_NOCTTY);
    pullCable();
    plugIn();
    EXPECT_NE(simulation.portPath(), old_port);
    EXPECT_EQ(instrument.connectionState(), ConnectionState::kConnected);
    ::close(holds_the_old_name);
}

TEST_F(DeviceFaultTest, NobodyAtThePortIsTheDoctorsPageWithoutAFreeze) {
    transport::PtyLink silent;
    ASSERT_TRUE(silent.open().has_value());
    ASSERT_TRUE(connectTo(silent.slaveName()));
    EXPECT_EQ(connection.instrumentStatus().state, DeviceState::kFailed);
    EXPECT_FALSE(connection.instrumentStatus().details.isEmpty());
    EXPECT_THAT(doctorText().toStdString(), testing::HasSubstr("Cable"));
    EXPECT_LT(watch.longestGapMs(), kFreezeMs);
}

TEST_F(DeviceFaultTest, AnotherDeviceAtThePortIsTheDoctorsPageWithoutAFreeze) {
    transport::PtyLink receiver;  // a satellite receiver talks of its place whatever it is asked
    ASSERT_TRUE(receiver.open().has_value());
    receiver.on_received = [&receiver](std::string_view) { receiver.write("$GPGGA,123519,4807.038,N,01131.000,E\r\n"); };
    ASSERT_TRUE(connectTo(receiver.slaveName()));
    EXPECT_FALSE(isConnected());
    EXPECT_THAT(connection.doctorSteps().front().text.toStdString(), testing::HasSubstr("$GPGGA"));
    EXPECT_EQ(connection.instrumentStatus().state, DeviceState::kFailed);
    EXPECT_LT(watch.longestGapMs(), kFreezeMs);
}

TEST_F(DeviceFaultTest, WrongBaudRateIsSaidOnTheDoctorsPageWithTheRateInUse) {
    transport::PtyLink garbler;  // what a receiver at another rate sees of every answer
    ASSERT_TRUE(garbler.open().has_value());
    garbler.on_received = [&garbler](std::string_view) { garbler.write("\x80\xfe\x1c\xe0\xfc\x00\x98\xe6"); };
    ASSERT_TRUE(connectTo(garbler.slaveName(), 4800));
    EXPECT_FALSE(isConnected());
    EXPECT_THAT(connection.doctorSteps().front().text.toStdString(), testing::HasSubstr("baud rates differ"));
    EXPECT_THAT(doctorText().toStdString(), testing::HasSubstr("4800 8N1"));
    EXPECT_LT(watch.longestGapMs(), kFreezeMs);
}

TEST_F(DeviceFaultTest, PortThatIsNotThereIsSaidWithItsName) {
    ASSERT_TRUE(connectTo(QStringLiteral("/dev/ttyUSB99")));
    EXPECT_EQ(connection.doctorSteps().front().title, QStringLiteral("The port"));
    EXPECT_FALSE(messages.bars().empty());
}

}  // namespace
}  // namespace pmts::app
