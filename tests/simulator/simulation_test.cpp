#include "pmts/simulator/simulation.hpp"

#include "manual_client.hpp"
#include "pmts/simulator/simulated_rig.hpp"
#include "support/matchers.hpp"

#include <QDir>
#include <QEventLoop>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTimer>

#include <future>
#include <thread>

namespace pmts::simulator {
namespace {

using core::Angle;
using core::ErrorKind;
using test::FailedWith;
using test::IsNearAngle;
using testing::ElementsAre;

class SimulationTest : public testing::Test {
protected:
    SimulationTest() { settings.station.time_scale = 1000.0; }

    std::unique_ptr<Simulation> start() {
        auto simulation = Simulation::start(settings, clock);
        EXPECT_TRUE(simulation.has_value()) << testing::PrintToString(simulation.error());
        return simulation ? *std::move(simulation) : nullptr;
    }
    /// Runs this thread's event loop while a client works on a thread of its own.
    template <class Work>
    auto whileServing(Work work) {
        QEventLoop loop;
        std::promise<decltype(work())> done;
        std::thread client([&] {
            done.set_value(work());
            QMetaObject::invokeMethod(&loop, &QEventLoop::quit, Qt::QueuedConnection);
        });
        loop.exec();
        client.join();
        return done.get_future().get();
    }

    core::SystemClock clock;
    SimulationSettings settings;
};

TEST_F(SimulationTest, ServesTheStationAndSharesItsTruth) {
    const auto simulation = start();
    const std::string port = simulation->slaveName().toStdString();
    const bool turned = whileServing([&] {
        ManualClient client(port);
        return client.accepts("WG,27=50.0000") && client.accepts("WG,26=90.0000") &&
               client.accepts("WS=PH02V02");
    });
    EXPECT_TRUE(turned);
    EXPECT_THAT(simulation->pointing()->at(clock.now()).ha,
                IsNearAngle(Angle::fromGon(50), Angle::fromCc(2)));
    EXPECT_FALSE(simulation->scene()->panels().empty());
}

TEST_F(SimulationTest, PulledCableComesBackUnderAnotherNameWhileTheOldOneIsHeld) {
    const auto simulation = start();
    const QString before = simulation->slaveName();
    ManualClient holds_the_old_port(before.toStdString());
    simulation->unplug();
    EXPECT_EQ(simulation->slaveName(), QString());
    QString told;
    simulation->on_replugged = [&](const QString& name) { told = name; };
    ASSERT_TRUE(simulation->replug().has_value());
    EXPECT_EQ(told, simulation->slaveName());
    EXPECT_NE(told, before);
    const std::string port = told.toStdString();
    EXPECT_THAT(whileServing([&] { return ManualClient(port).ask("RG,23"); }), ElementsAre("23=1111"));
}

TEST_F(SimulationTest, APanelIsPluggedWhileTheInstrumentRuns) {
    const auto simulation = start();
    EXPECT_EQ(simulation->panelSlaveName(), QString());
    const auto port = simulation->plugPanel();
    ASSERT_TRUE(port.has_value());
    EXPECT_EQ(*simulation->plugPanel(), *port) << "there is one only";
    EXPECT_NE(*port, simulation->slaveName());
    EXPECT_NE(simulation->controlUnit(), nullptr);
    simulation->unplugPanel();
    EXPECT_EQ(simulation->panelSlaveName(), QString());
}

TEST_F(SimulationTest, FaultUnplugReplugsByItself) {
    const auto simulation = start();
    QEventLoop loop;
    QTimer::singleShot(20000, &loop, &QEventLoop::quit);
    ASSERT_TRUE(simulation->injectFault(QStringLiteral("unplug=10")).has_value());
    bool told = false;
    simulation->on_replugged = [&](const QString&) {
        told = true;
        loop.quit();
    };
    loop.exec();
    EXPECT_TRUE(told);
    EXPECT_NE(simulation->slaveName(), QString());
}

TEST_F(SimulationTest, LinkLivesAsLongAsTheSimulation) {
    const QTemporaryDir folder;
    settings.link_path = folder.filePath(QStringLiteral("port"));
    auto simulation = start();
    EXPECT_EQ(QFileInfo(settings.link_path).symLinkTarget(), simulation->slaveName());
    simulation.reset();
    EXPECT_FALSE(QFileInfo(settings.link_path).isSymLink());
}

TEST_F(SimulationTest, RefusesWhatNoInstrumentCanBe) {
    settings.station.time_scale = 0.0;
    EXPECT_THAT(Simulation::start(settings, clock), FailedWith(ErrorKind::kBadInput));
    settings.station.time_scale = 1.0;
    settings.faults = {QStringLiteral("earthquake")};
    EXPECT_THAT(Simulation::start(settings, clock), FailedWith(ErrorKind::kBadInput));
}

TEST(SimulatedRigTest, SeesTheTargetNearTheMiddleOfThePicture) {
    const camera::Rig rig = simulatedRig();
    // 50 m ahead: offset (12, 52) mm and turns of (0.15, -0.2) gon at 1400 px a radian.
    const auto px = camera::pixelFromStation(rig, {Angle{}, Angle::fromGon(100)}, {0.0, 50.0, 0.0});
    ASSERT_TRUE(px.has_value());
    EXPECT_NEAR(px->x(), 643.5 - 1400 * (0.15 * 3.14159 / 200 + 0.012 / 50), 0.05);
    EXPECT_NEAR(px->y(), 357.5 + 1400 * (-0.2 * 3.14159 / 200 + 0.052 / 50), 0.05);
}

}  // namespace
}  // namespace pmts::simulator
