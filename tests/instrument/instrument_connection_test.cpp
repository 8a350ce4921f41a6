#include "pmts/instrument/instrument_connection.hpp"

#include "scripted_instrument.hpp"

namespace pmts::instrument {
namespace {

/// Ports with an instrument behind each; a port is a name until a link is made for it.
class ConnectionTest : public testing::Test {
protected:
    struct Port {
        std::string serial = "620123";
        bool plugged = true;
        bool silent = false;
        test::ScriptedLink* link = nullptr;
        std::unique_ptr<ScriptedInstrument> instrument;
    };

    std::unique_ptr<transport::ByteLink> make(const QString& address) {
        auto& port = ports[address];
        opened.push_back(address);
        auto link = std::make_unique<test::ScriptedLink>(clock);
        link->close();
        link->unavailable = !port.plugged;
        link->reply_delay = reply_delay;
        port.link = link.get();
        port.instrument = std::make_unique<ScriptedInstrument>(*link, clock);
        port.instrument->labels[55] = port.serial;
        port.instrument->silent = port.silent;
        return link;
    }
    std::optional<core::Result<Identity>> connect(const QString& address) {
        return test::runToEnd(connection.connectTo(address), clock, 30s);
    }
    void unplug(const QString& address) {
        ports[address].plugged = false;
        ports[address].link->unplug();
    }
    void SetUp() override {
        connection.on_state = [this](ConnectionState state, const QString&) { states.push_back(state); };
    }

    core::VirtualClock clock;
    core::VideoGate gate;
    std::map<QString, Port> ports;
    std::vector<QString> opened;
    std::vector<ConnectionState> states;
    core::Duration reply_delay = 20ms;
    InstrumentConnection connection{[this](const QString& address) { return make(address); }, clock, gate};
};

TEST_F(ConnectionTest, AFileGoesInAtThePaceOfTheLine) {
    constexpr auto kByteTimeAt1200 = std::chrono::microseconds(8333);
    ConnectionSettings settings;
    settings.byte_time = kByteTimeAt1200;
    reply_delay = 200ms;  // no answer comes before the question has left the wire
    InstrumentConnection slow{[this](const QString& address) { return make(address); }, clock, gate, settings};
    ASSERT_TRUE(test::runToEnd(slow.connectTo(QStringLiteral("A")), clock, 30s)->has_value());
    auto& port = ports[QStringLiteral("A")];
    std::vector<std::string> lines(300, "37=123456789012.000");
    std::string heard;
    bool loading = false;
    // What is heard at 1200 baud: the end of the file has come when all its bytes have.
    port.link->respond = [&](const std::string& bytes) -> std::optional<std::string> {
        if (bytes.starts_with("LM=")) {
            loading = true;
            return "*";
        }
        if (bytes.starts_with("OM=")) {
            return heard + ">";
        }
        if (!loading) {
            return port.instrument->answer(bytes);
        }
        loading = bytes != ">";
        heard += loading ? bytes : std::string();
        return loading ? std::nullopt : std::optional<std::string>(">");
    };
    const core::Duration before = clock.now();
    core::Duration sent_all{0};
    const auto uploaded = test::runToEnd(
        slow.station().upload({protocol::Directory::kJob, QStringLiteral("B")}, lines,
                              [&](const TransferProgress& step) {
                                  sent_all = step.step == TransferStep::kSending ? clock.now() : sent_all;
                              },
                              {}),
        clock, 10min);
    ASSERT_TRUE(uploaded && uploaded->has_value());
    EXPECT_GT(sent_all - before, 300 * 21 * kByteTimeAt1200) << "the counter runs ahead of the line";
}

TEST_F(ConnectionTest, ConnectedMeansAnswering) {
    const auto identity = connect(QStringLiteral("A"));

    ASSERT_TRUE(identity.has_value() && identity->has_value());
    EXPECT_THAT(states, ElementsAre(ConnectionState::kConnecting, ConnectionState::kConnected));
    EXPECT_EQ(connection.identity()->serial_number, QStringLiteral("620123"));
}

TEST_F(ConnectionTest, AnOpenPortWithNobodyBehindIsNotConnected) {
    ports[QStringLiteral("A")].silent = true;
    const auto identity = connect(QStringLiteral("A"));

    EXPECT_THAT(*identity, test::FailedWith(ErrorKind::kTimeOut));
    EXPECT_EQ(connection.state(), ConnectionState::kDisconnected);
    EXPECT_FALSE(ports[QStringLiteral("A")].link->isOpen());
}

TEST_F(ConnectionTest, AMissingPortIsSaidWithItsReason) {
    ports[QStringLiteral("A")].plugged = false;

    EXPECT_THAT(*connect(QStringLiteral("A")), test::FailedWith(ErrorKind::kPortUnavailable));
    EXPECT_EQ(states.back(), ConnectionState::kDisconnected);
}

TEST_F(ConnectionTest, ReconnectsWhenTheCableIsBack) {
    (void)connect(QStringLiteral("A"));
    clock.advance(1s);
    unplug(QStringLiteral("A"));
    EXPECT_EQ(connection.state(), ConnectionState::kLost);
    clock.advance(20s);
    EXPECT_EQ(connection.state(), ConnectionState::kLost);
    ports[QStringLiteral("A")].plugged = true;
    clock.advance(10s);

    EXPECT_EQ(connection.state(), ConnectionState::kConnected);
    EXPECT_TRUE(connection.poller().isRunning());
}

TEST_F(ConnectionTest, ReconnectsUnderAnotherPortName) {
    (void)connect(QStringLiteral("A"));
    connection.find_again = [](const QString&) { return std::vector{QStringLiteral("B")}; };
    unplug(QStringLiteral("A"));
    clock.advance(5s);

    EXPECT_EQ(connection.state(), ConnectionState::kConnected);
    EXPECT_EQ(connection.address(), QStringLiteral("B"));
}

TEST_F(ConnectionTest, TheNameOfTheAdapterIsTriedBeforeTheOldOneWhichMayBeAnothers) {
    (void)connect(QStringLiteral("A"));
    connection.find_again = [](const QString&) { return std::vector{QStringLiteral("B")}; };
    ports[QStringLiteral("A")].link->unplug();
    opened.clear();
    clock.advance(5s);

    EXPECT_EQ(connection.state(), ConnectionState::kConnected);
    EXPECT_THAT(opened, ElementsAre(QStringLiteral("B")));
}

TEST_F(ConnectionTest, DoesNotTakeAnotherInstrumentForTheLostOne) {
    (void)connect(QStringLiteral("A"));
    ports[QStringLiteral("B")].serial = "999999";
    connection.find_again = [](const QString&) { return std::vector{QStringLiteral("B")}; };
    unplug(QStringLiteral("A"));
    clock.advance(20s);

    EXPECT_EQ(connection.state(), ConnectionState::kLost);
    EXPECT_EQ(connection.identity()->serial_number, QStringLiteral("620123"));
}

TEST_F(ConnectionTest, AnInstrumentThatFallsSilentIsLostAndComesBack) {
    (void)connect(QStringLiteral("A"));
    clock.advance(1s);
    ports[QStringLiteral("A")].silent = true;
    ports[QStringLiteral("A")].instrument->silent = true;
    clock.advance(15s);
    EXPECT_EQ(connection.state(), ConnectionState::kLost);
    ports[QStringLiteral("A")].silent = false;
    clock.advance(30s);

    EXPECT_EQ(connection.state(), ConnectionState::kConnected);
}

TEST_F(ConnectionTest, TheStationObjectStaysOverAReconnect) {
    (void)connect(QStringLiteral("A"));
    GeodimeterDriver& station = connection.station();
    ports[QStringLiteral("A")].link->unplug();
    clock.advance(5s);

    const geometry::Pointing target{.ha = Angle::fromGon(20), .va = Angle::fromGon(95)};
    const auto arrived = test::runToEnd(station.turnTo(target, Angle::fromCc(5), {}), clock, 30s);
    ASSERT_TRUE(arrived.has_value());
    EXPECT_TRUE(arrived->has_value());
}

TEST_F(ConnectionTest, UnpluggingInMidMotionFailsTheMotionAndReconnects) {
    (void)connect(QStringLiteral("A"));
    const geometry::Pointing target{.ha = Angle::fromGon(200), .va = Angle::fromGon(95)};
    const auto timer = clock.callAfter(500ms, [this] { ports[QStringLiteral("A")].link->unplug(); });
    const auto arrived =
        test::runToEnd(connection.station().turnTo(target, Angle::fromCc(5), {}), clock, 30s);

    ASSERT_TRUE(arrived.has_value());
    EXPECT_THAT(*arrived, test::FailedWith(ErrorKind::kLinkLost));
    clock.advance(5s);
    EXPECT_EQ(connection.state(), ConnectionState::kConnected);
}

TEST_F(ConnectionTest, DisconnectEndsTheTrying) {
    (void)connect(QStringLiteral("A"));
    unplug(QStringLiteral("A"));
    connection.disconnect();
    ports[QStringLiteral("A")].plugged = true;
    clock.advance(20s);

    EXPECT_EQ(connection.state(), ConnectionState::kDisconnected);
}

TEST_F(ConnectionTest, AnotherConnectWhileConnectingTakesOver) {
    ports[QStringLiteral("A")].silent = true;
    auto first = std::make_shared<std::optional<core::Result<Identity>>>();
    auto running = test::detail::keepOutcome(connection.connectTo(QStringLiteral("A")), first);
    clock.advance(500ms);
    const auto second = connect(QStringLiteral("B"));

    ASSERT_TRUE(second.has_value());
    EXPECT_TRUE(second->has_value());
    ASSERT_TRUE(first->has_value());
    EXPECT_THAT(first->value(), test::FailedWith(ErrorKind::kCancelled));
}

TEST_F(ConnectionTest, DestroyingItWhileConnectingCompletesTheAttempt) {
    ports[QStringLiteral("C")].silent = true;
    auto other = std::make_unique<InstrumentConnection>(
        [this](const QString& address) { return make(address); }, clock, gate);
    auto outcome = std::make_shared<std::optional<core::Result<Identity>>>();
    auto running = test::detail::keepOutcome(other->connectTo(QStringLiteral("C")), outcome);
    clock.advance(500ms);
    other.reset();
    clock.advance(5s);

    ASSERT_TRUE(outcome->has_value());
    EXPECT_THAT(outcome->value(), test::FailedWith(ErrorKind::kCancelled));
}

}  // namespace
}  // namespace pmts::instrument
