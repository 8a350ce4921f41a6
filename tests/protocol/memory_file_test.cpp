#include "pmts/protocol/memory_file.hpp"

#include "pmts/protocol/memory_records.hpp"

#include <QFile>
#include <gmock/gmock.h>

namespace pmts::protocol {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string dataFile(const char* name) {
    QFile file(QStringLiteral(PMTS_TEST_DATA "/") + QLatin1String(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

MemoryRecords recordsIn(const MemoryFile& file) { return recordsOf(file, unitsIn(file).value()); }

TEST(MemoryFileTest, EachLineIsALabelAndItsDataAsTheyStand) {
    const auto file = parseMemoryFile(dataFile("DEMO1.JOB"));
    ASSERT_EQ(file.lines.size(), 31U);
    EXPECT_THAT(file.bad, IsEmpty());
    EXPECT_EQ(file.lines[12], (MemoryLine{13, 0, "Measured point"}));
    EXPECT_EQ(file.lines[14], (MemoryLine{15, 4, "WALL"}));
}

TEST(MemoryFileTest, WrittenAgainItIsTheSameToTheByte) {
    for (const char* name : {"DEMO1.JOB", "DEMO1.ARE"}) {
        const auto bytes = dataFile(name);
        ASSERT_FALSE(bytes.empty());
        EXPECT_EQ(memoryFileText(parseMemoryFile(bytes).lines), bytes) << name;
    }
}

TEST(MemoryFileTest, CopiesWithOtherLineEndsReadTheSame) {
    const auto file = parseMemoryFile("5=1\r\n37=2.5\r\n");
    EXPECT_EQ(parseMemoryFile("5=1\n37=2.5"), file);
    EXPECT_EQ(parseMemoryFile("5=1\r37=2.5\r"), file);
}

TEST(MemoryFileTest, ALineWithoutEqualsIsAnErrorWithItsNumberAndTheRestIsRead) {
    const auto file = parseMemoryFile("5=1\r\n\r\nWALL\r\n37=2.5\r\n");
    EXPECT_THAT(file.bad, ElementsAre(BadLine{3, BadLineKind::kNoEquals, "WALL"}));
    EXPECT_EQ(file.lines.size(), 2U);
}

TEST(MemoryFileTest, AnEmptyValueAndAMissingLabelAreErrorsTheInstrumentWouldMake) {
    const auto file = parseMemoryFile("5=\n=7\nX1=7\n1234=7\n");
    EXPECT_THAT(file.bad,
                ElementsAre(BadLine{1, BadLineKind::kNoData, "5="}, BadLine{2, BadLineKind::kNoLabel, "=7"},
                            BadLine{3, BadLineKind::kNoLabel, "X1=7"}, BadLine{4, BadLineKind::kNoLabel, "1234=7"}));
}

TEST(MemoryFileTest, LabelsNobodyKnowsAreKeptAndTheFirstEqualsParts) {
    const auto file = parseMemoryFile("733=any thing\n0=a=b\n");
    EXPECT_THAT(file.lines, ElementsAre(MemoryLine{1, 733, "any thing"}, MemoryLine{2, 0, "a=b"}));
}

TEST(MemoryFileTest, AGeodatDumpIsReadWithDashesForNothing) {
    const auto file = parseMemoryFile(dataFile("geodat124.dat"));
    EXPECT_TRUE(file.is_geodat_dump);
    EXPECT_THAT(file.bad, IsEmpty());
    EXPECT_EQ(file.lines[6], (MemoryLine{2, 4, "JEL"}));
    const auto records = recordsIn(file);
    ASSERT_EQ(records.points.size(), 2U);
    EXPECT_EQ(records.points[0].code, "JEL") << "the code stands before the number in its quoted line";
    EXPECT_EQ(records.points[1].code, "");
    EXPECT_EQ(records.stations.at(0).instrument_height_m, 1.580);
}

TEST(MemoryRecordsTest, StationBacksightAndPointsOfTheExample) {
    const auto records = recordsIn(parseMemoryFile(dataFile("DEMO1.JOB")));
    ASSERT_EQ(records.stations.size(), 1U);
    EXPECT_EQ(records.stations[0].name, "100");
    EXPECT_EQ(records.stations[0].instrument_height_m, 1.5) << "3 comes after the backsight";
    EXPECT_EQ(records.stations[0].coordinates.e_m, 2000.0);
    ASSERT_EQ(records.points.size(), 3U);
    EXPECT_TRUE(records.points[0].is_backsight);
    EXPECT_EQ(records.points[0].coordinates.n_m, 1100.0);
    EXPECT_EQ(records.points[1].code, "WALL");
    EXPECT_EQ(records.points[2].line, 24);
}

TEST(MemoryRecordsTest, ThePointsOfTheExampleAreReproducedWithinAMillimetre) {
    const auto checks = checkPoints(recordsIn(parseMemoryFile(dataFile("DEMO1.JOB"))));
    ASSERT_EQ(checks.size(), 2U);
    EXPECT_TRUE(checks[0].within);
    EXPECT_TRUE(checks[1].within);
    EXPECT_NEAR(checks[0].de_m, 0.0, 0.0006) << "half the last digit of the file";
}

TEST(MemoryRecordsTest, AWrongDigitInACoordinateIsFound) {
    auto file = parseMemoryFile(dataFile("DEMO1.JOB"));
    file.lines[19].data = "1009.566";  // 2 mm
    const auto checks = checkPoints(recordsIn(file));
    EXPECT_FALSE(checks.at(0).within);
    EXPECT_NEAR(checks[0].dn_m, -0.002, 0.0006);
}

TEST(MemoryRecordsTest, TheUnitsAreThoseOfLabel23) {
    // Degrees-minutes-seconds: 90.0000 is a right angle, 67.3000 is 67.5 degrees.
    const auto file = parseMemoryFile(
        "2=1\n23=2112\n37=0\n38=0\n39=0\n3=0\n5=A\n7=90.0000\n8=67.3000\n9=10\n6=0\n"
        "37=0\n38=9.239\n39=3.827\n");
    const auto checks = checkPoints(recordsIn(file));
    ASSERT_EQ(checks.size(), 1U);
    EXPECT_TRUE(checks[0].within);
    EXPECT_FALSE(unitsIn(parseMemoryFile("5=1\n")).has_value()) << "gon and DMS look alike: it must be asked for";
}

TEST(MemoryRecordsTest, AHorizontalDistanceServesWhereTheSlopeDistanceIsMissing) {
    const auto file = parseMemoryFile(
        "2=1\n23=2111\n37=0\n38=0\n39=10\n3=1\n5=A\n24=0.0000\n25=50.0000\n11=10\n6=1\n37=10\n38=0\n39=20\n");
    const auto checks = checkPoints(recordsIn(file));
    ASSERT_EQ(checks.size(), 1U);
    EXPECT_TRUE(checks[0].within);
}

constexpr const char* kStationOfTwoFaces = "2=1\n23=2111\n37=0\n38=0\n39=10\n3=1\n5=A\n6=1\n9=100\n";

/// STD in two faces: 7, 8 are face I, 17, 18 face II; 20 mgon of collimation and index are 31 mm at 100 m.
TEST(MemoryRecordsTest, BothFacesOfAPointGiveTheirMean) {
    const auto records =
        recordsIn(parseMemoryFile(std::string(kStationOfTwoFaces) + "7=399.9800\n8=99.9800\n17=200.0200\n18=299.9800\n37=100\n38=0\n39=10\n"));
    const auto mean = meanOfFaces(records.points.at(0));
    ASSERT_TRUE(mean.has_value());
    EXPECT_NEAR(core::normalizedSigned(mean->ha).gon(), 0.0, 1e-9);
    EXPECT_NEAR(mean->va.gon(), 100.0, 1e-9);
    const auto checks = checkPoints(records);
    ASSERT_EQ(checks.size(), 1U);
    EXPECT_TRUE(checks[0].two_faces);
    EXPECT_TRUE(checks[0].within) << "the coordinates are those of the mean: " << checks[0].de_m;
}

TEST(MemoryRecordsTest, CoordinatesOfFaceOneAloneAreReproducedToo) {
    const auto records =
        recordsIn(parseMemoryFile(std::string(kStationOfTwoFaces) + "7=0.0000\n8=100.0000\n17=200.0400\n18=299.9600\n37=100\n38=0\n39=10\n"));
    const auto checks = checkPoints(records);
    ASSERT_EQ(checks.size(), 1U);
    EXPECT_TRUE(checks[0].two_faces);
    EXPECT_TRUE(checks[0].within);
}

/// D-bar in two faces (page 4.5): 7, 8 are the means already, 24, 25 face I; 24 must not come in the place of 7.
TEST(MemoryRecordsTest, OfABlockWithBothFacesAndTheirMeanTheMeanCounts) {
    const auto records = recordsIn(parseMemoryFile(std::string(kStationOfTwoFaces) +
                                                   "7=0.0000\n8=100.0000\n17=200.0200\n18=299.9800\n24=399.9800\n25=99.9800\n"
                                                   "37=100\n38=0\n39=10\n"));
    const auto& point = records.points.at(0);
    EXPECT_NEAR(point.ha->gon(), 0.0, 1e-9);
    EXPECT_NEAR(faceOneOf(point)->ha.gon(), 399.98, 1e-9);
    EXPECT_NEAR(meanOfFaces(point)->ha.gon(), 0.0, 1e-9);
    const auto checks = checkPoints(records);
    ASSERT_EQ(checks.size(), 1U);
    EXPECT_TRUE(checks[0].within);
}

TEST(MemoryRecordsTest, APointOfOneFaceHasNoMean) {
    const auto records = recordsIn(parseMemoryFile(dataFile("DEMO1.JOB")));
    EXPECT_FALSE(meanOfFaces(records.points.at(1)).has_value());
    EXPECT_FALSE(checkPoints(records).at(0).two_faces);
}

TEST(MemoryRecordsTest, AValueThatIsNoNumberIsNamedWithItsLine) {
    const auto records = recordsOf(parseMemoryFile("2=1\n3=1.5O0\n"), {});
    ASSERT_EQ(records.bad.size(), 1U);
    EXPECT_EQ(records.bad[0].line, 2);
    EXPECT_EQ(records.bad[0].label, 3);
}

}  // namespace
}  // namespace pmts::protocol
