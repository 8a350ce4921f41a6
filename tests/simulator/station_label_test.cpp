#include "pmts/protocol/labels.hpp"
#include "station_fixture.hpp"

namespace pmts::simulator {
namespace {

using namespace std::chrono_literals;
using core::Angle;

class StationLabelTest : public StationTest {};

TEST_F(StationLabelTest, LowerCaseIsASyntaxError) {
    for (const char* command : {"rg", "Rg", "RGn", "wg,5=1", "RG,x", "XG", "R", "RX", "RG,1000", "RG,",
                                "RG,-7", "RG,7=1", "TG,7", "?"}) {
        EXPECT_EQ(ask(command), "30\r\n>") << command;
    }
}

TEST_F(StationLabelTest, UnknownLabelIsInfo20) {
    EXPECT_EQ(ask("RG,110"), "20\r\n>");
    EXPECT_EQ(ask("WG,110=1"), "20\r\n>");
    EXPECT_EQ(ask("RG,57"), "20\r\n>");  // the empty line of a user sequence
}

TEST_F(StationLabelTest, LettersInANumberAreBadData) {
    for (const char* command :
         {"WG,3=abc", "WG,3=1.5m", "WG,3=", "WG,5=", "WG,26=1,5", "WG,22=1.0", "WG,3=1234567890"}) {
        EXPECT_EQ(ask(command), "35\r\n>") << command;
    }
}

TEST_F(StationLabelTest, NineDigitsAreCountedWithoutSignAndPoint) { EXPECT_EQ(ask("WG,3=-12345.6789"), ">"); }

TEST_F(StationLabelTest, NineDigitsMayCountSignAndPoint) {
    settings.sign_and_point_count = true;
    EXPECT_EQ(ask("WG,3=-12345.6789"), "35\r\n>");
    EXPECT_EQ(ask("WG,3=-12345.67"), ">");
}

TEST_F(StationLabelTest, KnownLimitsAreKept) {
    EXPECT_EQ(ask("WG,20=1.001"), "35\r\n>");
    EXPECT_EQ(ask("WG,20=-1"), ">");
    EXPECT_EQ(ask("WG,30=-60.1"), "35\r\n>");
    EXPECT_EQ(ask("WG,30=195"), ">");
    EXPECT_EQ(ask("WG,22=2"), "35\r\n>");
    EXPECT_EQ(ask("WG,79=256"), "35\r\n>");
    EXPECT_EQ(ask("WG,4=SEVENTEEN LETTERS"), "35\r\n>");
    EXPECT_EQ(ask("WG,78=1.8.3.9600"), "35\r\n>");
    EXPECT_EQ(ask("WG,78=2.7.1.4800"), ">");
}

TEST_F(StationLabelTest, MeasuredLabelIsOfTheWrongType) {
    EXPECT_EQ(ask("WG,7=1"), "41\r\n>");
    EXPECT_EQ(ask("WG,23=1112"), "41\r\n>");
}

TEST_F(StationLabelTest, EveryWritableLabelReadsBack) {
    for (const protocol::Label& label : protocol::allLabels()) {
        const bool special =
            label.number == 51 || label.number == 52 || label.number == 78 || label.number == 79;
        if (label.access != protocol::LabelAccess::kSet || special) {
            continue;
        }
        const std::string number = std::to_string(label.number);
        EXPECT_EQ(ask("WG," + number + "=1"), ">") << number;
        EXPECT_THAT(ask("RG," + number), testing::StartsWith(number + "=1")) << number;
    }
}

TEST_F(StationLabelTest, TextMayHoldAnyBytesAndAnEqualsSign) {
    EXPECT_EQ(ask("WG,4=a {b}=c"), ">");
    EXPECT_EQ(ask("RG,4"), "4=a {b}=c\r\n>");
}

TEST_F(StationLabelTest, AirRecomputesThePpm) {
    EXPECT_EQ(ask("WG,56=22"), ">");
    EXPECT_EQ(ask("WG,74=1000"), ">");
    EXPECT_EQ(ask("RG,30"), "30=5.34\r\n>");  // the page's test value
    EXPECT_EQ(ask("WG,30=12.5"), ">");
    EXPECT_EQ(ask("RG,30"), "30=12.5\r\n>");
}

TEST_F(StationLabelTest, ControlUnitKeepsItsOwnAir) {
    EXPECT_EQ(ask("WR,56=22"), ">");
    EXPECT_EQ(ask("WR,74=1000"), ">");
    EXPECT_EQ(ask("RR,30"), "30=5.34\r\n>");
    EXPECT_EQ(ask("RG,56"), "56=20.0\r\n>");
    EXPECT_EQ(ask("RR,7"), "7=0.0000\r\n>");
}

TEST_F(StationLabelTest, UnitDigitsChangeAngleAndLengthText) {
    settings.unit_status = QStringLiteral("1122");  // DMS and feet
    point(100.0, 100.0);
    ask("TG", 5s);
    EXPECT_EQ(ask("RG"), "0\r\n7=90.0000\r\n8=90.0000\r\n9=328.084\r\n>");
    EXPECT_EQ(ask("RG,23"), "23=1122\r\n>");
}

TEST_F(StationLabelTest, SecondsOfAReadingCarryIntoTheMinute) {
    settings.unit_status = QStringLiteral("1112");
    point(Angle::fromArcsec(59.6).gon(), 100.0);
    EXPECT_EQ(ask("RG,7"), "7=0.0100\r\n>");
}

TEST_F(StationLabelTest, DegreesAndMils) {
    settings.unit_status = QStringLiteral("1114");
    point(50.0, 100.0);
    EXPECT_EQ(ask("RG"), "0\r\n7=800.000\r\n8=1600.000\r\n>");
}

TEST_F(StationLabelTest, FahrenheitAndInchesOfMercury) {
    settings.unit_status = QStringLiteral("3211");
    EXPECT_EQ(ask("WG,56=71.6"), ">");
    EXPECT_EQ(ask("WG,74=29.53"), ">");
    EXPECT_EQ(ask("RG,30"), "30=5.34\r\n>");
    EXPECT_EQ(ask("RG,56"), "56=71.6\r\n>");
}

TEST_F(StationLabelTest, EndMarkChangesForTheVeryNextBlock) {
    EXPECT_EQ(ask("WG,79=36"), "$");
    EXPECT_EQ(ask("RG,5"), "5=\r\n$");
    EXPECT_EQ(ask("WG,79=0"), "");
    EXPECT_EQ(ask("RG,5"), "5=\r\n");
}

TEST_F(StationLabelTest, EndMarkMayChangeAfterTheAnswerToItsOwnWrite) {
    settings.end_mark_changes_at_once = false;
    EXPECT_EQ(ask("WG,79=36"), ">");
    EXPECT_EQ(ask("RG,5"), "5=\r\n$");
}

TEST_F(StationLabelTest, ClockRunsOnFromWhatWasSet) {
    EXPECT_EQ(ask("RG,51"), "51=2026.0601\r\n>");
    EXPECT_EQ(ask("WG,51=1999.1231"), ">");
    EXPECT_EQ(ask("WG,52=23.5959"), ">");
    clock.advance(1s);
    EXPECT_EQ(ask("RG,51"), "51=2000.0101\r\n>");
    EXPECT_EQ(ask("RG,52"), "52=00.0000\r\n>");
    EXPECT_EQ(ask("WG,51=today"), "35\r\n>");
}

TEST_F(StationLabelTest, ImpossibleDateIsBadData) {
    EXPECT_EQ(ask("WG,51=2026.1345"), "35\r\n>");
    EXPECT_EQ(ask("WG,52=25.0000"), "35\r\n>");
}

TEST_F(StationLabelTest, StatusMayNameItsDevice) {
    settings.status_suffix = 8;
    EXPECT_EQ(ask("WG,3=x"), "35.8\r\n>");
    EXPECT_THAT(ask("RG"), testing::StartsWith("0\r\n"));
    EXPECT_EQ(ask("RGT"), "301\r\n>");
}

TEST_F(StationLabelTest, SerialNumberAndLineParametersAreTold) {
    EXPECT_EQ(ask("RG,55"), "55=620123\r\n>");
    EXPECT_EQ(ask("RGN,78"), "Com=1.8.0.9600\r\n>");
    EXPECT_EQ(ask("RG,79"), "79=62\r\n>");
}

}  // namespace
}  // namespace pmts::simulator
