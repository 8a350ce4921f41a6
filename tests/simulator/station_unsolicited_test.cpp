#include "station_fixture.hpp"

namespace pmts::simulator {
namespace {

using namespace std::chrono_literals;

class StationUnsolicitedTest : public StationTest {};

const std::string kBlock = "7=0.0000\r\n8=100.0000\r\n9=20.000\r\n>";

TEST_F(StationUnsolicitedTest, SlaveSendsABlockAfterEveryMeasurement) {
    settings.output = QStringLiteral("slave");
    EXPECT_EQ(ask("TG", 5s), ">" + kBlock);
}

TEST_F(StationUnsolicitedTest, SlaveInTrackingStreams) {
    settings.output = QStringLiteral("slave");
    settings.output_table = {37, 38, 39};
    ask("PG,3=1");
    ask("TG");
    clock.advance(1200ms);
    const std::string block = "37=20.000\r\n38=0.000\r\n39=0.000\r\n>";
    EXPECT_EQ(heard(), block + block + block);
}

TEST_F(StationUnsolicitedTest, SlaveSendsTheMeanOfDBarOnce) {
    settings.output = QStringLiteral("slave");
    ask("PG,3=2");
    EXPECT_EQ(ask("TG", 10s), ">");
    EXPECT_EQ(ask("TG"), kBlock + ">");
}

TEST_F(StationUnsolicitedTest, BlockMayComeWhileACommandIsBeingCarriedOut) {
    settings.output = QStringLiteral("slave");
    ask("PG,3=1");
    ask("TG");
    const std::string early = ask("WS=PH02", 500ms);  // tracking does not wait for the servo
    EXPECT_THAT(early, testing::EndsWith("9=20.000\r\n>"));
    clock.advance(700ms);
    EXPECT_THAT(heard(), testing::AllOf(testing::HasSubstr("\r\n>>7="), testing::EndsWith("9=20.000\r\n>")));
}

TEST_F(StationUnsolicitedTest, BlockComesBetweenACommandAndItsLateAnswer) {
    settings.output = QStringLiteral("slave");
    ask("TG", 4500ms);
    inject("late=2,on=RG");
    EXPECT_EQ(ask("RG,5", 1s), kBlock);
    clock.advance(1s);
    EXPECT_EQ(heard(), "5=\r\n>");
}

TEST_F(StationUnsolicitedTest, UnaskedBlockMayCarryAStatus) {
    settings.output = QStringLiteral("slave");
    settings.unsolicited_status = true;
    EXPECT_EQ(ask("TG", 5s), ">0\r\n" + kBlock);
}

TEST_F(StationUnsolicitedTest, SlaveBlockLeavesTheDistanceToBeRead) {
    settings.output = QStringLiteral("slave");
    ask("TG", 5s);
    EXPECT_EQ(ask("RG"), "0\r\n" + kBlock);
}

TEST_F(StationUnsolicitedTest, RegKeySendsABlockAndUsesTheDistanceUp) {
    ask("TG", 5s);
    station().pressRegKey();
    EXPECT_EQ(heard(), kBlock);
    EXPECT_EQ(ask("RG"), "3\r\n>");
}

TEST_F(StationUnsolicitedTest, RegKeyWithoutDistanceSendsTheAngles) {
    station().pressRegKey();
    EXPECT_EQ(heard(), "7=0.0000\r\n8=100.0000\r\n>");
}

}  // namespace
}  // namespace pmts::simulator
