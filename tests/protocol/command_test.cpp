#include "pmts/protocol/command.hpp"

#include "protocol/bytes.hpp"

namespace pmts::protocol {
namespace {

using test::bytesFromHex;

TEST(CommandTest, BytesAreThoseOfTheProtocolPage) {
    EXPECT_EQ(encode(ReadMeasurement{}), bytesFromHex("52 47 0D"));
    EXPECT_EQ(encode(Trigger{}), bytesFromHex("54 47 0D"));
    EXPECT_EQ(encode(WriteLabel{26, "96.1684"}), bytesFromHex("57 47 2C 32 36 3D 39 36 2E 31 36 38 34 0D"));
    EXPECT_EQ(encode(WriteLabel{27, "177.5612"}),
              bytesFromHex("57 47 2C 32 37 3D 31 37 37 2E 35 36 31 32 0D"));
    EXPECT_EQ(encode(Position{2, 2}), bytesFromHex("57 53 3D 50 48 30 32 56 30 32 0D"));
    EXPECT_EQ(encode(SignalTest{}), bytesFromHex("52 47 54 0D"));
}

TEST(CommandTest, ReadsInEveryFormAndFromBothDevices) {
    EXPECT_EQ(encode(ReadMeasurement{ReadForm::kNames}), "RGN\r");
    EXPECT_EQ(encode(ReadMeasurement{ReadForm::kDataOnly}), "RGD\r");
    EXPECT_EQ(encode(ReadMeasurement{ReadForm::kSeparate, Device::kControlUnit}), "RRV\r");
    EXPECT_EQ(encode(ReadLabel{5}), "RG,5\r");
    EXPECT_EQ(encode(ReadLabel{5, ReadForm::kNames}), "RGN,5\r");
    EXPECT_EQ(encode(ReadLabel{0, ReadForm::kStandard, Device::kControlUnit}), "RR,0\r");
    EXPECT_EQ(encode(WriteLabel{3, "1.5", Device::kControlUnit}), "WR,3=1.5\r");
}

TEST(CommandTest, TriggersInEveryRangeAndSelectsEveryMode) {
    EXPECT_EQ(encode(Trigger{TriggerRange::kShort}), "TG<\r");
    EXPECT_EQ(encode(Trigger{TriggerRange::kLong}), "TG>\r");
    EXPECT_EQ(encode(SetMode{EdmMode::kStd}), "PG,3=0\r");
    EXPECT_EQ(encode(SetMode{EdmMode::kTrk}), "PG,3=1\r");
    EXPECT_EQ(encode(SetMode{EdmMode::kDBar}), "PG,3=2\r");
    EXPECT_EQ(encode(SetMode{EdmMode::kFstd}), "PG,3=3\r");
    EXPECT_EQ(encode(SetMode{EdmMode::kDBarHighResolution}), "PG,3=4\r");
}

TEST(CommandTest, PositionNamesOneOrBothAxesWithTwoDigits) {
    EXPECT_EQ(encode(Position{5, 10}), "WS=PH05V10\r");
    EXPECT_EQ(encode(Position{1, std::nullopt}), "WS=PH01\r");
    EXPECT_EQ(encode(Position{std::nullopt, 15}), "WS=PV15\r");
    EXPECT_EQ(encode(Position{0, 99}), "WS=PH00V99\r");
}

TEST(CommandTest, FileCommandsNameTheirDirectory) {
    EXPECT_EQ(encode(ListFiles{Directory::kJob}), "OMC\r");
    EXPECT_EQ(encode(ListFiles{Directory::kArea}), "OIC\r");
    EXPECT_EQ(encode(ListFiles{Directory::kUserSequence}), "OUC\r");
    EXPECT_EQ(encode(ListFiles{Directory::kAll}), "O*C\r");
    EXPECT_EQ(encode(OutputFile{Directory::kJob, "JOB1", {}}), "OM=JOB1\r");
    EXPECT_EQ(encode(OutputFile{Directory::kArea, "Wall", 3}), "OI3=Wall\r");
    EXPECT_EQ(encode(OutputFile{Directory::kGeodatProtocol, "", {}}), "OD\r");
    EXPECT_EQ(encode(LoadFile{Directory::kJob, "DEMO1", {}}), "LM=DEMO1\r");
    EXPECT_EQ(encode(LoadFile{Directory::kGeodatProtocol, "", {}}), "LD\r");
    EXPECT_EQ(encode(EraseFile{Directory::kJob, "JOB1"}), "KM=JOB1\r");
    EXPECT_EQ(encode(EraseFile{Directory::kAll, ""}), "K*\r");
}

TEST(CommandTest, AsksForMemoryAndDrivesTheMainBoard) {
    EXPECT_EQ(encode(FreeMemory{}), "MG\r");
    EXPECT_EQ(encode(FreeMemory{Device::kControlUnit}), "MR\r");
    EXPECT_EQ(encode(CalibrateCompensator{}), "PV,20\r");
    EXPECT_EQ(encode(SwitchOff{}), "PV,21\r");
}

TEST(CommandTest, ValuesNoInstrumentHasAreRejected) {
    EXPECT_THROW((void)encode(ReadLabel{1000}), std::logic_error);
    EXPECT_THROW((void)encode(WriteLabel{-1, "1"}), std::logic_error);
    EXPECT_THROW((void)encode(Position{}), std::logic_error);
    EXPECT_THROW((void)encode(Position{100, {}}), std::logic_error);
    EXPECT_THROW((void)encode(OutputFile{Directory::kJob, "SIXTEENCHARACTER", {}}), std::logic_error);
    EXPECT_THROW((void)encode(OutputFile{Directory::kAll, "JOB1", {}}), std::logic_error);
}

TEST(CommandTest, DataThatWouldEndTheCommandEarlyIsRejected) {
    EXPECT_THROW((void)encode(WriteLabel{4, "WALL\rK*"}), std::logic_error);
    EXPECT_THROW((void)encode(WriteLabel{4, "M\xE4uerchen"}), std::logic_error);
}

}  // namespace
}  // namespace pmts::protocol
