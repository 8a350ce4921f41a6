#include "station_fixture.hpp"

namespace pmts::simulator {
namespace {

using namespace std::chrono_literals;
using core::Angle;
using test::IsNearAngle;

class StationReadingTest : public StationTest {
protected:
    void measure() { ask("TG", 5s); }
};

TEST_F(StationReadingTest, ReadsAnglesWithoutDistance) {
    point(10.2345, 101.1005);
    EXPECT_EQ(ask("RG"), "0\r\n7=10.2345\r\n8=101.1005\r\n>");
}

TEST_F(StationReadingTest, ReadsStandardBlockByteForByte) {
    measure();
    // Protocol page 1.4: status, HA, VA, SD, end, with CR LF after each.
    EXPECT_EQ(ask("RG"), "0\r\n7=0.0000\r\n8=100.0000\r\n9=20.000\r\n>");
}

TEST_F(StationReadingTest, ReadsNames) {
    measure();
    EXPECT_EQ(ask("RGN"), "0\r\nHA=0.0000\r\nVA=100.0000\r\nSD=20.000\r\n>");
}

TEST_F(StationReadingTest, ReadsDataOnly) {
    measure();
    EXPECT_EQ(ask("RGD"), "0\r\n0.0000\r\n100.0000\r\n20.000\r\n>");
}

TEST_F(StationReadingTest, ReadsLabelAndDataOnSeparateLines) {
    measure();
    EXPECT_EQ(ask("RGV"), "0\r\n7\r\n0.0000\r\n8\r\n100.0000\r\n9\r\n20.000\r\n>");
}

TEST_F(StationReadingTest, OneLabelComesWithoutStatusInEveryForm) {
    ask("WG,5=104");
    EXPECT_EQ(ask("RG,5"), "5=104\r\n>");
    EXPECT_EQ(ask("RGS,5"), "5=104\r\n>");
    EXPECT_EQ(ask("RGN,5"), "Pno=104\r\n>");
    EXPECT_EQ(ask("RGD,5"), "104\r\n>");
    EXPECT_EQ(ask("RGV,5"), "5\r\n104\r\n>");
}

TEST_F(StationReadingTest, AcceptsTheFormOfTheManualsBoxes) {
    ask("WG,5=104");
    EXPECT_EQ(ask("RG=N,5"), "Pno=104\r\n>");
    EXPECT_EQ(ask("RG=S"), ask("RG"));
    EXPECT_EQ(ask("RG, 5"), "5=104\r\n>");
}

TEST_F(StationReadingTest, LastOfContradictingLettersCounts) {
    ask("WG,5=104");
    EXPECT_EQ(ask("RGND,5"), "104\r\n>");
    EXPECT_EQ(ask("RGDN,5"), "Pno=104\r\n>");
}

TEST_F(StationReadingTest, DistanceReadTwiceIsOld) {
    measure();
    ask("RG");
    EXPECT_EQ(ask("RG"), "3\r\n>");
    EXPECT_EQ(ask("RG,9"), "9=20.000\r\n>");  // a single label is only looked at
}

TEST_F(StationReadingTest, LookingAtOneLabelDoesNotMakeTheDistanceOld) {
    measure();
    ask("RG,9");
    EXPECT_THAT(ask("RG"), testing::StartsWith("0\r\n"));
}

TEST_F(StationReadingTest, OldDistanceMayComeWithAngles) {
    settings.reading_of_old_distance = QStringLiteral("3+angles");
    measure();
    ask("RG");
    EXPECT_EQ(ask("RG"), "3\r\n7=0.0000\r\n8=100.0000\r\n>");
}

TEST_F(StationReadingTest, DistanceLabelWithoutDistanceIsInfo7) {
    EXPECT_EQ(ask("RG,9"), "7\r\n>");
    EXPECT_EQ(ask("RG,11"), "7\r\n>");
    EXPECT_EQ(ask("RG,17"), "28\r\n>");
}

TEST_F(StationReadingTest, MissingDistanceMayBeRefused) {
    settings.reading_without_distance = QStringLiteral("7");
    EXPECT_EQ(ask("RG"), "7\r\n>");
}

TEST_F(StationReadingTest, WhileMeasuringTheConfiguredAnswerIsGiven) {
    settings.reading_while_measuring = QStringLiteral("4");
    ask("TG");
    EXPECT_EQ(ask("RG"), "4\r\n>");
}

// Computed by hand: HA 50 gon, VA 90 gon, the wall 20 m north: SD = 20 / (sin 90 gon cos 50 gon).
TEST_F(StationReadingTest, DerivesHeightDistanceAndCoordinates) {
    point(40.0, 90.0);
    for (const char* write :
         {"WG,3=1.500", "WG,6=1.600", "WG,37=1000.000", "WG,38=2000.000", "WG,39=50.000"}) {
        EXPECT_EQ(ask(write), ">");
    }
    measure();
    EXPECT_EQ(ask("RG,9"), "9=25.030\r\n>");
    EXPECT_EQ(ask("RG,11"), "11=24.721\r\n>");
    EXPECT_EQ(ask("RG,10"), "10=3.915\r\n>");
    EXPECT_EQ(ask("RG,49"), "49=3.815\r\n>");
    EXPECT_EQ(ask("RG,37"), "37=1020.000\r\n>");
    EXPECT_EQ(ask("RG,38"), "38=2014.531\r\n>");
    EXPECT_EQ(ask("RG,39"), "39=53.815\r\n>");
}

TEST_F(StationReadingTest, StationCoordinatesReadBackAsWritten) {
    measure();
    ask("WG,37=500.000");
    EXPECT_EQ(ask("RG,37"), "37=500.000\r\n>");
}

TEST_F(StationReadingTest, TwoFacesInStdAddTheReadingsOfFaceTwo) {
    settings.index_error = Angle::fromMgon(4);
    point(200.0, 300.0);
    measure();
    point(0.0, 100.0);
    measure();
    EXPECT_EQ(ask("RG"), "0\r\n7=0.0000\r\n8=100.0040\r\n9=20.000\r\n17=200.0000\r\n18=300.0040\r\n>");
}

TEST_F(StationReadingTest, TwoFacesInDBarGiveMeansFirst) {
    settings.index_error = Angle::fromMgon(4);
    ask("PG,3=2");
    point(200.0, 300.0);
    ask("TG", 6s);
    ask("TG");
    point(0.0, 100.0);
    ask("TG", 6s);
    ask("TG");
    EXPECT_EQ(ask("RG"),
              "0\r\n7=0.0000\r\n8=100.0000\r\n17=200.0000\r\n18=300.0040\r\n24=0.0000\r\n25=100.0040\r\n9=20."
              "000\r\n>");
}

TEST_F(StationReadingTest, FaceTwoOfAnotherTargetIsForgotten) {
    point(250.0, 300.0);
    measure();
    point(0.0, 100.0);
    measure();
    EXPECT_EQ(ask("RG"), "0\r\n7=0.0000\r\n8=100.0000\r\n9=20.000\r\n>");
}

TEST_F(StationReadingTest, HighResolutionShowsFiveDecimalsOfHa) {
    ask("PG,3=4");
    ask("TG", 6s);
    EXPECT_EQ(ask("RG"), "0\r\n7=0.00000\r\n8=100.0000\r\n9=20.000\r\n>");
}

TEST_F(StationReadingTest, UserOutputTableReplacesTheModesOwn) {
    settings.output_table = {37, 38, 39};
    measure();
    EXPECT_EQ(ask("RG"), "0\r\n37=20.000\r\n38=0.000\r\n39=0.000\r\n>");
}

TEST_F(StationReadingTest, TiltBeyondTheCompensatorIsInfo1) {
    settings.tilt_east = Angle::fromGon(0.2);
    EXPECT_EQ(ask("RG"), "1\r\n>");
    EXPECT_EQ(ask("RG,8"), "1\r\n>");
    ask("WG,22=0");
    EXPECT_THAT(ask("RG"), testing::StartsWith("0\r\n"));
}

TEST_F(StationReadingTest, FaceTwoMayBeRefused) {
    settings.refuse_face_two = true;
    point(200.0, 300.0);
    EXPECT_EQ(ask("RG"), "24\r\n>");
    EXPECT_EQ(ask("TG"), "24\r\n>");
    EXPECT_EQ(ask("WS=PH02"), "24\r\n>");
}

TEST_F(StationReadingTest, EncodersScatterAsTold) {
    settings.angle_sigma = Angle::fromCc(3);
    double sum = 0.0, squares = 0.0;
    constexpr int kReadings = 400;
    for (int i = 0; i < kReadings; ++i) {
        const double off_cc = (std::stod(ask("RG,8").substr(2)) - 100.0) * 1e4;
        sum += off_cc;
        squares += off_cc * off_cc;
    }
    EXPECT_NEAR(sum / kReadings, 0.0, 0.6);                  // four sigma of the mean
    EXPECT_NEAR(std::sqrt(squares / kReadings), 3.0, 0.45);  // four sigma of the spread, and 1 cc of rounding
}

TEST_F(StationReadingTest, SignalTestFollowsTheScene) {
    EXPECT_EQ(ask("RGT"), "301\r\n>");
    point(200.0, 100.0);  // black
    EXPECT_EQ(ask("RGT"), "300\r\n>");
    point(300.0, 100.0);  // sky
    EXPECT_EQ(ask("RGT"), "300\r\n>");
}

}  // namespace
}  // namespace pmts::simulator
