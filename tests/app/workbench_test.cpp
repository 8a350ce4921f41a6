#include "pmts/app/desk/workbench.hpp"

#include "support/matchers.hpp"
#include "support/run_until.hpp"

#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace pmts::app {
namespace {

using namespace std::chrono_literals;

/// The whole program without its window: real threads, a real pty, the simulator ten times as fast.
class WorkbenchTest : public testing::Test {
protected:
    [[nodiscard]] StartOptions options() const {
        StartOptions options;
        options.data_folder = folder.path();
        options.simulation.time_scale = 10.0;
        return options;
    }
    static bool isReady(const Workbench& bench) {
        return bench.job_desk.isOpen() && bench.instrument.connectionState() == ConnectionState::kConnected &&
               bench.live.scene().frame && bench.live.scene().pointing;
    }

    QTemporaryDir folder;
};

TEST_F(WorkbenchTest, StartsWithSimulatorCameraAndSampleJobAndAsksNothing) {
    Workbench bench(options());
    bench.start();
    ASSERT_TRUE(test::runUntil([&] { return isReady(bench); }));
    EXPECT_EQ(bench.job_desk.name(), QStringLiteral("sample"));
    EXPECT_TRUE(bench.messages.bars().empty());
    EXPECT_EQ(bench.live.scene().frame->image.cols, 1280);
}

TEST_F(WorkbenchTest, ClickTurnMeasureRecordOverTheRealPty) {
    Workbench bench(options());
    bench.start();
    ASSERT_TRUE(test::runUntil([&] { return isReady(bench); }));
    bench.live.capture();
    ASSERT_TRUE(test::runUntil([&] { return bench.live.still().has_value(); }));
    bench.targeting.moveToStillPixel({800, 400});
    ASSERT_TRUE(test::runUntil([&] { return !bench.targeting.isMoving(); }));
    ASSERT_EQ(bench.targeting.target()->state, MoveState::kArrived) << bench.targeting.target()->sentence.toStdString();
    bench.recording.all();
    ASSERT_TRUE(test::runUntil([&] { return !bench.recording.isBusy(); }));
    EXPECT_EQ(bench.recording.readings().shot, ShotState::kRecorded) << bench.recording.readings().sentence.toStdString();
    EXPECT_EQ(bench.points.rowCount(), 1);
}

TEST_F(WorkbenchTest, UnpluggedInstrumentComesBackUnderAnotherPortName) {
    Workbench bench(options());
    bench.start();
    ASSERT_TRUE(test::runUntil([&] { return isReady(bench); }));
    const QString old_port = bench.simulation.portPath();
    bench.simulation.unplug();
    ASSERT_TRUE(test::runUntil([&] { return bench.instrument.connectionState() == ConnectionState::kReconnecting; }));
    bench.simulation.plugIn();
    EXPECT_TRUE(test::runUntil([&] { return bench.instrument.connectionState() == ConnectionState::kConnected; }))
        << "was " << old_port.toStdString() << ", is " << bench.simulation.portPath().toStdString();
}

TEST_F(WorkbenchTest, EndsCleanlyInTheMiddleOfAMeasurement) {
    Workbench bench(options());
    bench.start();
    ASSERT_TRUE(test::runUntil([&] { return isReady(bench); }));
    bench.recording.measure();
    ASSERT_TRUE(test::runUntil([&] { return bench.instrument.isBusy(); }));
}

TEST_F(WorkbenchTest, EndsCleanlyBeforeAnythingHasStarted) {
    Workbench bench(options());
    bench.start();
}

TEST_F(WorkbenchTest, SecondStartOpensTheLastJobWithItsPoints) {
    {
        Workbench bench(options());
        bench.start();
        ASSERT_TRUE(test::runUntil([&] { return isReady(bench); }));
        bench.recording.all();
        ASSERT_TRUE(test::runUntil([&] { return bench.points.rowCount() == 1; }));
    }
    Workbench bench(options());
    bench.start();
    ASSERT_TRUE(test::runUntil([&] { return bench.points.rowCount() == 1; }));
    EXPECT_EQ(bench.recording.pointId(), QStringLiteral("2"));
}

TEST_F(WorkbenchTest, LastJobThatIsGoneGivesTheSampleJobAndAMessage) {
    {
        Preferences preferences(folder.filePath(QStringLiteral("settings.ini")));
        Settings settings = preferences.settings();
        settings.last_job = folder.filePath(QStringLiteral("gone.gpkg"));
        preferences.set(settings);
    }
    Workbench bench(options());
    bench.start();
    ASSERT_TRUE(test::runUntil([&] { return bench.job_desk.isOpen(); }));
    EXPECT_EQ(bench.job_desk.name(), QStringLiteral("sample"));
}

TEST_F(WorkbenchTest, CommandLineIsReadAndItsMistakesAreNamed) {
    const auto good = StartOptions::fromArguments({QStringLiteral("--job"), QStringLiteral("a.gpkg"), QStringLiteral("--seed"),
                                                   QStringLiteral("7"), QStringLiteral("--simulated"),
                                                   QStringLiteral("--fault"), QStringLiteral("late=3")});
    ASSERT_TRUE(good.has_value());
    EXPECT_EQ(good->job_path, QStringLiteral("a.gpkg"));
    EXPECT_EQ(good->simulation.seed, 7U);
    EXPECT_TRUE(good->force_simulated);
    EXPECT_EQ(good->simulation.faults, QStringList{QStringLiteral("late=3")});
    for (const QStringList& bad : {QStringList{QStringLiteral("--jib")}, QStringList{QStringLiteral("--seed"), QStringLiteral("x")},
                                   QStringList{QStringLiteral("--job")}, QStringList{QStringLiteral("--time-scale"), QStringLiteral("0")}}) {
        EXPECT_THAT(StartOptions::fromArguments(bad), test::FailedWith(core::ErrorKind::kBadInput)) << bad.first().toStdString();
    }
}

TEST(SceneMarkTest, IsPointedAtInTheFaceThatTheTelescopeIsIn) {
    const auto gon = [](double ha, double va) {
        return geometry::Pointing{.ha = core::Angle::fromGon(ha), .va = core::Angle::fromGon(va)};
    };
    const SceneMark mark{.name = QStringLiteral("T2"), .pointing = gon(351.5, 87.25)};
    EXPECT_EQ(inPresentFace(mark, std::nullopt), mark.pointing);
    EXPECT_EQ(inPresentFace(mark, gon(10, 99)), mark.pointing);
    const auto face_two = inPresentFace(mark, gon(210, 301));
    EXPECT_THAT(face_two.ha, test::IsNearAngle(core::Angle::fromGon(151.5), core::Angle::fromCc(0.001)));
    EXPECT_THAT(face_two.va, test::IsNearAngle(core::Angle::fromGon(312.75), core::Angle::fromCc(0.001)));
}

}  // namespace
}  // namespace pmts::app
