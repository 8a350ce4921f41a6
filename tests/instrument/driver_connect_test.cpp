#include "scripted_instrument.hpp"

namespace pmts::instrument {
namespace {

TEST_F(DriverTest, ConnectLearnsEndMarkUnitsAndSerialNumber) {
    const auto identity = run(driver.connectTo({}));

    ASSERT_TRUE(identity.has_value());
    EXPECT_EQ(identity->serial_number, QStringLiteral("620123"));
    EXPECT_EQ(identity->end_mark, '>');
    EXPECT_EQ(identity->units.angle, protocol::WireAngleUnit::kGon);
    EXPECT_TRUE(identity->units_known);
}

TEST_F(DriverTest, ConnectFindsAnotherEndMark) {
    station.labels[79] = "4";
    station.end = "\x04";

    const auto identity = run(driver.connectTo({}));

    ASSERT_TRUE(identity.has_value());
    EXPECT_EQ(identity->end_mark, '\x04');
}

TEST_F(DriverTest, ConnectLivesWithoutAnyEndMark) {
    station.labels[79] = "0";
    station.end = "";

    const auto identity = run(driver.connectTo({}));

    ASSERT_TRUE(identity.has_value());
    EXPECT_FALSE(identity->end_mark.has_value());
    const auto arrived = run(driver.turnTo(pointing(20.0, 95.0), Angle::fromCc(5), {}));
    EXPECT_TRUE(arrived.has_value());
}

TEST_F(DriverTest, ConnectReadsAnglesInTheUnitOfLabel23) {
    station.labels[23] = "1112";
    station.ha = 159.4818;  // 159 deg 48' 18", 177.5611 gon
    connect();

    const auto read = run(driver.readPointing({}));

    ASSERT_TRUE(read.has_value());
    EXPECT_THAT(read->ha, test::IsNearAngle(Angle::fromGon(177.56111), Angle::fromCc(0.1)));
}

TEST_F(DriverTest, SilenceSaysWhatToSetOnTheInstrument) {
    station.silent = true;

    const auto identity = run(driver.connectTo({}), 15s);

    ASSERT_THAT(identity, test::FailedWith(ErrorKind::kTimeOut));
    EXPECT_THAT(identity.error().sentence().toStdString(), testing::HasSubstr("9600 baud"));
}

TEST_F(DriverTest, UnreadableBytesSayThatTheBaudRatesDiffer) {
    link.respond = [](const std::string&) { return std::optional<std::string>("\xf8\x80\x1e\x06\xfe\xe0"); };

    const auto identity = run(driver.connectTo({}), 15s);

    ASSERT_THAT(identity, test::FailedWith(ErrorKind::kProtocol));
    EXPECT_THAT(identity.error().happened.toStdString(), testing::HasSubstr("baud rates differ"));
}

TEST_F(DriverTest, AnotherDeviceIsNamedByWhatItSays) {
    link.respond = [](const std::string&) {
        return std::optional<std::string>("$GPGGA,123519,4807.038,N\r\n");
    };

    const auto identity = run(driver.connectTo({}), 15s);

    ASSERT_THAT(identity, test::FailedWith(ErrorKind::kUnsupported));
    EXPECT_THAT(identity.error().happened.toStdString(), testing::HasSubstr("$GPGGA"));
}

TEST_F(DriverTest, AnUnfinishedCommandOfAnEarlierProgramDoesNotHinderConnecting) {
    station.next["RG,79"] = {"30\r\n>"};  // what stood in the instrument's buffer, and our question

    EXPECT_TRUE(run(driver.connectTo({})).has_value());
}

TEST_F(DriverTest, WithoutUnitsTheInstrumentIsNotMoved) {
    station.labels.erase(23);
    const auto identity = run(driver.connectTo({}));
    ASSERT_TRUE(identity.has_value());
    EXPECT_FALSE(identity->units_known);
    link.written.clear();

    const auto turned = run(driver.turnTo(pointing(20.0, 95.0), Angle::fromCc(5), {}));

    EXPECT_THAT(turned, test::FailedWith(ErrorKind::kRefused));
    EXPECT_TRUE(link.written.empty());
}

TEST_F(DriverTest, NothingIsSentBeforeAConnection) {
    const auto turned = run(driver.turnTo(pointing(20.0, 95.0), Angle::fromCc(5), {}));

    EXPECT_THAT(turned, test::FailedWith(ErrorKind::kNotConnected));
    EXPECT_TRUE(link.written.empty());
}

TEST_F(DriverTest, ConnectingCanBeCancelled) {
    station.silent = true;
    std::stop_source cancel;
    const auto timer = clock.callAfter(500ms, [&] { cancel.request_stop(); });

    const auto identity = run(driver.connectTo(cancel.get_token()), 1s);

    EXPECT_THAT(identity, test::FailedWith(ErrorKind::kCancelled));
}

TEST_F(DriverTest, AProfilesUnitsNeedNoLabel23) {
    station.labels.erase(23);
    auto settings = profile();
    settings.unit_override = protocol::WireUnits{};
    GeodimeterDriver with_profile(line, clock, settings);

    const auto identity = run(with_profile.connectTo({}));

    ASSERT_TRUE(identity.has_value());
    EXPECT_TRUE(identity->units_known);
}

}  // namespace
}  // namespace pmts::instrument
