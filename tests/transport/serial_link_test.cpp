#include "pmts/transport/serial_link.hpp"

#include "pmts/transport/pty_link.hpp"
#include "support/matchers.hpp"
#include "transport/link_probe.hpp"

#include <QTemporaryDir>
#include <QTemporaryFile>
#include <QThread>

#include <atomic>

namespace pmts::transport {
namespace {

using core::ErrorKind;
using test::comesToRest;
using test::FailedWith;
using test::LinkProbe;
using test::waitUntil;

/// A serial port and the instrument's end of its cable.
class SerialLinkTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(instrument.open().has_value()); }

    [[nodiscard]] SerialSettings settings() const {
        SerialSettings values;
        values.port_name = instrument.slaveName();
        return values;
    }

    PtyLink instrument;
    LinkProbe at_instrument{instrument};
};

TEST_F(SerialLinkTest, CommandAndReplyPassTheRealDevice) {
    SerialLink port(settings());
    LinkProbe at_port(port);
    ASSERT_TRUE(port.open().has_value());
    port.write("RG\r");
    ASSERT_TRUE(waitUntil([&] { return at_instrument.received == "RG\r"; }));
    instrument.write("0\r\n7=177.5612\r\n8=96.1684\r\n>");
    ASSERT_TRUE(waitUntil([&] { return at_port.received.ends_with('>'); }));
    EXPECT_EQ(at_port.received, "0\r\n7=177.5612\r\n8=96.1684\r\n>");
}

TEST_F(SerialLinkTest, APtyHasNoControlLinesAndSaysSo) {
    SerialLink port(settings());
    ASSERT_TRUE(port.open().has_value());

    EXPECT_THAT(port.setControlLines({.dtr = true, .rts = std::nullopt}), FailedWith(ErrorKind::kUnsupported));
    EXPECT_TRUE(port.setControlLines({}).has_value());  // nothing asked for
    EXPECT_TRUE(port.isOpen());
}

TEST_F(SerialLinkTest, GarbageArrivesByteForByte) {
    SerialLink port(settings());
    LinkProbe at_port(port);
    ASSERT_TRUE(port.open().has_value());
    std::string garbage;
    for (int value = 255; value >= 0; --value) {
        garbage += static_cast<char>(value);
    }
    instrument.write(garbage);
    ASSERT_TRUE(waitUntil([&] { return at_port.received.size() >= garbage.size(); }));
    EXPECT_EQ(at_port.received, garbage);
}

TEST_F(SerialLinkTest, PulledCableIsReportedOnceAndTheLoopComesToRest) {
    SerialLink port(settings());
    LinkProbe at_port(port);
    ASSERT_TRUE(port.open().has_value());
    port.write("WS=PH02V02\r");
    instrument.close();
    ASSERT_TRUE(waitUntil([&] { return !at_port.losses.empty(); }));
    EXPECT_TRUE(comesToRest());
    ASSERT_EQ(at_port.losses.size(), 1U);
    EXPECT_EQ(at_port.losses[0].kind, ErrorKind::kLinkLost);
    EXPECT_FALSE(port.isOpen());
    port.write("RG\r");
    EXPECT_TRUE(comesToRest());
    EXPECT_EQ(at_port.losses.size(), 1U);
}

TEST_F(SerialLinkTest, SamePortOpensAgainWhenTheCableIsBackUnderAnotherName) {
    const QTemporaryDir folder;
    PtyLink linked(folder.filePath(QStringLiteral("instrument")));
    ASSERT_TRUE(linked.open().has_value());
    SerialSettings values;
    values.port_name = folder.filePath(QStringLiteral("instrument"));
    SerialLink port(values);
    LinkProbe at_port(port);
    ASSERT_TRUE(port.open().has_value());
    linked.close();
    ASSERT_TRUE(waitUntil([&] { return !at_port.losses.empty(); }));
    EXPECT_THAT(port.open(), FailedWith(ErrorKind::kPortUnavailable));
    ASSERT_TRUE(linked.open().has_value());
    ASSERT_TRUE(port.open().has_value());
    ASSERT_TRUE(waitUntil([&] { return linked.hasClient(); }));
    linked.write(">");
    EXPECT_TRUE(waitUntil([&] { return at_port.received == ">"; }));
}

TEST_F(SerialLinkTest, SecondProgramIsToldThatThePortIsTaken) {
    SerialLink first(settings());
    ASSERT_TRUE(first.open().has_value());
    SerialLink second(settings());
    const auto outcome = second.open();
    ASSERT_THAT(outcome, FailedWith(ErrorKind::kPortUnavailable));
    EXPECT_TRUE(outcome.error().happened.contains(QStringLiteral("Another program")));
}

TEST_F(SerialLinkTest, LinkToATakenPortIsTakenToo) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("alias"));
    ASSERT_TRUE(QFile::link(instrument.slaveName(), path));
    SerialLink first(settings());
    ASSERT_TRUE(first.open().has_value());
    SerialSettings alias = settings();
    alias.port_name = path;
    EXPECT_THAT(SerialLink(alias).open(), FailedWith(ErrorKind::kPortUnavailable));
}

TEST_F(SerialLinkTest, ClosedPortIsFreeForTheNext) {
    SerialLink first(settings());
    ASSERT_TRUE(first.open().has_value());
    first.close();
    SerialLink second(settings());
    EXPECT_TRUE(second.open().has_value());
}

TEST(SerialLinkOpenTest, MissingPortAndOrdinaryFileAreRefusedWithASentence) {
    SerialSettings values;
    values.port_name = QStringLiteral("/dev/ttyUSB-none");
    const auto missing = SerialLink(values).open();
    ASSERT_THAT(missing, FailedWith(ErrorKind::kPortUnavailable));
    EXPECT_TRUE(missing.error().sentence().contains(QStringLiteral("is not there")));

    QTemporaryFile file;
    ASSERT_TRUE(file.open());
    values.port_name = file.fileName();
    EXPECT_THAT(SerialLink(values).open(), FailedWith(ErrorKind::kPortUnavailable));
}

TEST_F(SerialLinkTest, SettingTheDeviceCannotDoIsSaidAndLivedWith) {
    SerialSettings values = settings();
    values.data_bits = 7;
    values.parity = Parity::kEven;
    SerialLink port(values);
    LinkProbe at_port(port);
    ASSERT_TRUE(port.open().has_value());
    EXPECT_TRUE(port.description().contains(QStringLiteral("9600 7E1")));
    port.write("RG\r");
    ASSERT_TRUE(waitUntil([&] { return at_instrument.received == "RG\r"; }));
    EXPECT_TRUE(port.isOpen());
    EXPECT_TRUE(at_port.losses.empty());
}

TEST_F(SerialLinkTest, LinkMayBeDestroyedInsideItsCallbacks) {
    auto port = std::make_unique<SerialLink>(settings());
    ASSERT_TRUE(port->open().has_value());
    port->on_received = [&](std::string_view) { port.reset(); };
    ASSERT_TRUE(waitUntil([&] { return instrument.hasClient(); }));
    instrument.write(">");
    EXPECT_TRUE(waitUntil([&] { return port == nullptr; }));

    port = std::make_unique<SerialLink>(settings());
    ASSERT_TRUE(port->open().has_value());
    port->on_lost = [&](const core::Error&) { port.reset(); };
    instrument.close();
    EXPECT_TRUE(waitUntil([&] { return port == nullptr; }));
    EXPECT_TRUE(comesToRest());
}

/// A thread with an event loop that belongs to the instrument, as in the program.
class InstrumentThread {
public:
    InstrumentThread() {
        place_.moveToThread(&thread_);
        thread_.start();
    }
    ~InstrumentThread() {
        thread_.quit();
        thread_.wait();
    }
    void run(std::function<void()> action) {
        QMetaObject::invokeMethod(&place_, std::move(action), Qt::BlockingQueuedConnection);
    }

private:
    QThread thread_;
    QObject place_;
};

TEST_F(SerialLinkTest, PortLivesOnItsOwnThread) {
    InstrumentThread thread;
    std::unique_ptr<SerialLink> port;
    std::atomic<bool> answered = false;
    std::atomic<int> losses = 0;
    thread.run([&] {
        port = std::make_unique<SerialLink>(settings());
        port->on_received = [&](std::string_view) { answered = true; };
        port->on_lost = [&](const core::Error&) { ++losses; };
        ASSERT_TRUE(port->open().has_value());
        port->write("RG\r");
    });
    ASSERT_TRUE(waitUntil([&] { return at_instrument.received == "RG\r"; }));
    instrument.write(">");
    EXPECT_TRUE(waitUntil([&] { return answered.load(); }));
    instrument.close();
    EXPECT_TRUE(waitUntil([&] { return losses > 0; }));
    thread.run([&] { port.reset(); });
    EXPECT_EQ(losses, 1);
}

TEST(SerialSettingsTest, LineTextIsBaudDataParityStop) {
    SerialSettings values;
    EXPECT_EQ(values.lineText(), QStringLiteral("9600 8N1"));
    values = {.port_name = {}, .baud = 4800, .data_bits = 7, .parity = Parity::kOdd, .stop_bits = 2};
    EXPECT_EQ(values.lineText(), QStringLiteral("4800 7O2"));
}

}  // namespace
}  // namespace pmts::transport
