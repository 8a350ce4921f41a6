#include "pmts/app/desk/bus_simulation_desk.hpp"

#include "pmts/transport/serial_link.hpp"
#include "support/matchers.hpp"
#include "support/run_until.hpp"

#include <gmock/gmock.h>

namespace pmts::app {
namespace {

using testing::HasSubstr;

/// The simulated base at a real pty; the test is the host.
class BusSimulationDeskTest : public testing::Test {
protected:
    void connectTo(double failure_per_frame) {
        QString port;
        const QObject here;
        QObject::connect(&desk, &BusSimulationDesk::started, &here, [&port](const QString& path) { port = path; });
        desk.setVideoSensitivity(failure_per_frame);
        desk.start();
        ASSERT_TRUE(test::runUntil([&port] { return !port.isEmpty(); }));
        transport::SerialSettings settings;
        settings.port_name = port;
        link = std::make_unique<transport::SerialLink>(settings);
        link->on_received = [this](std::string_view bytes) { heard += bytes; };
        ASSERT_TRUE(link->open().has_value());
    }
    /// The first step of the start-up, while the host draws pictures, or none.
    std::string startUpStep(bool beside_video) {
        heard.clear();
        link->write("PV,30=1\r");
        EXPECT_TRUE(test::runUntil([&] {
            if (beside_video) {
                desk.countFrame();
            }
            return heard.find("24") != std::string::npos && heard.find(".8") != std::string::npos;
        }));
        return heard;
    }

    /// A busy machine may draw no picture during the 20 ms of one step.
    bool failsBesideVideo() {
        for (int i = 0; i < 20; ++i) {
            if (startUpStep(true).find("248.8") != std::string::npos) {
                return true;
            }
        }
        return false;
    }

    BusSimulationDesk desk;
    std::unique_ptr<transport::SerialLink> link;
    std::string heard;
};

TEST_F(BusSimulationDeskTest, TheStartUpFailsWhileTheHostDrawsPicturesAndSucceedsWhileItDrawsNone) {
    connectTo(1.0);  // any picture during a step
    EXPECT_TRUE(failsBesideVideo());
    EXPECT_THAT(startUpStep(false), HasSubstr("240.8"));
}

TEST_F(BusSimulationDeskTest, AnInsensitiveBaseDoesNotMindTheVideo) {
    connectTo(0.0);
    EXPECT_THAT(startUpStep(true), HasSubstr("240.8"));
}

TEST_F(BusSimulationDeskTest, AnotherSensitivityStartsAnotherBase) {
    connectTo(0.0);
    connectTo(1.0);
    EXPECT_TRUE(failsBesideVideo());
}

}  // namespace
}  // namespace pmts::app
