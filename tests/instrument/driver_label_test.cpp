#include "label_access.hpp"
#include "scripted_instrument.hpp"

namespace pmts::instrument {
namespace {

TEST_F(DriverTest, SetWritesAndReadsBack) {
    connect();
    ASSERT_TRUE(run(driver.set(30, QStringLiteral("12.5"), {})).has_value());

    EXPECT_EQ(station.labels[30], "12.5");
    EXPECT_EQ(link.written.front(), "WG,30=12.5\r");
    EXPECT_GE(sent("RG,30"), 1);
}

TEST_F(DriverTest, SetComparesNumbersAsNumbers) {
    connect();
    station.next["RG,30"] = {"30=12.500\r\n>", "30=12.500\r\n>"};

    EXPECT_TRUE(run(driver.set(30, QStringLiteral("12.5"), {})).has_value());
}

TEST_F(DriverTest, AValueThatTheInstrumentDoesNotKeepIsReported) {
    connect();
    station.next["RG,30"] = std::deque<std::optional<std::string>>(8, "30=5.3\r\n>");

    const auto set = run(driver.set(30, QStringLiteral("12.5"), {}));

    ASSERT_FALSE(set.has_value());
    EXPECT_THAT(set.error().happened.toStdString(), testing::HasSubstr("did not keep"));
}

TEST_F(DriverTest, AValueOutOfRangeGoesUpWithItsInfoCode) {
    connect();
    station.next["WG,30"] = {"35.8\r\n>"};

    const auto set = run(driver.set(30, QStringLiteral("500"), {}));

    ASSERT_FALSE(set.has_value());
    EXPECT_EQ(set.error().info_code, 35);
    EXPECT_EQ(sent("WG,30=500"), 1);  // the surveyor's value, not ours: not tried again
}

TEST_F(DriverTest, EveryWritableLabelCanBeSetAndRead) {
    connect();
    for (const auto& label : protocol::allLabels()) {
        if (label.access != protocol::LabelAccess::kSet || label.number == protocol::kEndMark) {
            continue;
        }
        const auto value =
            label.kind == protocol::LabelKind::kText ? QStringLiteral("ABC") : QStringLiteral("1");
        EXPECT_TRUE(run(driver.set(label.number, value, {})).has_value()) << label.number;
        const auto read = run(driver.get(label.number, {}));
        ASSERT_TRUE(read.has_value()) << label.number;
        EXPECT_EQ(*read, value) << label.number;
    }
}

TEST_F(DriverTest, MeasuredLabelsAreNotWritten) {
    connect();
    EXPECT_THAT(run(driver.set(7, QStringLiteral("1.0"), {})), test::FailedWith(ErrorKind::kRefused));
    EXPECT_THAT(run(driver.set(127, QStringLiteral("1"), {})), test::FailedWith(ErrorKind::kRefused));
    EXPECT_TRUE(link.written.empty());
}

TEST_F(DriverTest, WhatCannotBeAValueIsNotSent) {
    connect();
    EXPECT_THAT(run(driver.set(30, QStringLiteral("twelve"), {})), test::FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(run(driver.set(30, QStringLiteral("1234567890"), {})),
                test::FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(run(driver.set(5, QStringLiteral("12345678901234567"), {})),
                test::FailedWith(ErrorKind::kBadInput));
    EXPECT_TRUE(link.written.empty());
}

TEST_F(DriverTest, ANewEndMarkHoldsFromTheVeryNextBlock) {
    connect();
    station.link.respond = [this](const std::string& command) {
        if (command.starts_with("WG,79=")) {
            station.end = "#";
        }
        return station.answer(command);
    };
    ASSERT_TRUE(run(driver.set(79, QStringLiteral("35"), {})).has_value());

    EXPECT_EQ(line.endMark(), '#');
    EXPECT_TRUE(run(driver.readPointing({})).has_value());
}

TEST_F(DriverTest, ASignalTestSaysYesOrNo) {
    connect();
    EXPECT_EQ(run(driver.testSignal({})).value(), true);
    station.signal = false;
    EXPECT_EQ(run(driver.testSignal({})).value(), false);
}

TEST_F(DriverTest, ARegKeyBlockCanBeRecordedAsAPoint) {
    connect();
    std::vector<UnsolicitedBlock> blocks;
    driver.on_unsolicited = [&](const UnsolicitedBlock& block) { blocks.push_back(block); };
    link.say("0\r\n5=104\r\n4=WALL\r\n7=10.2345\r\n8=101.1005\r\n9=145.324\r\n>");
    clock.advance(1ms);

    ASSERT_EQ(blocks.size(), 1U);
    EXPECT_EQ(blocks[0].point_number, QStringLiteral("104"));
    EXPECT_NEAR(blocks[0].slope_distance_m.value(), 145.324, 1e-9);
    EXPECT_THAT(*blocks[0].ha, test::IsNearAngle(Angle::fromGon(10.2345), Angle::fromCc(0.1)));
    EXPECT_FALSE(blocks[0].n_m.has_value());
}

TEST_F(DriverTest, ALateAnswerToAQuestionOfItsOwnIsNoRegistration) {
    connect();
    std::vector<UnsolicitedBlock> blocks;
    driver.on_unsolicited = [&](const UnsolicitedBlock& block) { blocks.push_back(block); };
    link.say("7=10.2345\r\n>");
    clock.advance(1ms);
    link.say("62=101\r\n>");
    clock.advance(1ms);

    EXPECT_EQ(blocks.size(), 1U) << "only the one that the driver never asks for";
}

TEST_F(DriverTest, ASlaveBlockGivesCoordinates) {
    connect();
    std::vector<UnsolicitedBlock> blocks;
    driver.on_unsolicited = [&](const UnsolicitedBlock& block) { blocks.push_back(block); };
    link.say("37=1000.000\r\n38=2000.000\r\n39=50.000\r\n>");
    clock.advance(1ms);

    ASSERT_EQ(blocks.size(), 1U);
    EXPECT_NEAR(blocks[0].n_m.value(), 1000.0, 1e-9);
    EXPECT_NEAR(blocks[0].e_m.value(), 2000.0, 1e-9);
    EXPECT_FALSE(blocks[0].ha.has_value());
}

TEST(ReadBack, IsComparedWithinTheShownDecimals) {
    EXPECT_TRUE(meansTheSame(30, "12.5", "12.500"));
    EXPECT_TRUE(meansTheSame(26, "96.16838", "96.1684"));
    EXPECT_FALSE(meansTheSame(26, "96.1684", "96.1694"));
    EXPECT_TRUE(meansTheSame(5, "104", "104"));
    EXPECT_FALSE(meansTheSame(5, "104", "0104"));
}

}  // namespace
}  // namespace pmts::instrument
