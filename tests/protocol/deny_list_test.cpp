#include "pmts/protocol/command.hpp"
#include "support/matchers.hpp"

namespace pmts::protocol {
namespace {

using core::ErrorKind;
using test::FailedWith;

TEST(DenyListTest, ErasingAndServiceCommandsAreRefused) {
    for (const char* line :
         {"K*", "KM=JOB1\r\n", "LV", "LV3", "OV*", "RG,127", "WG,127=1", "WV,127=1", "WR,127=0"}) {
        EXPECT_THAT(checkDenyList(line), FailedWith(ErrorKind::kRefused)) << line;
    }
}

TEST(DenyListTest, InternalLabelsOfTheStationAreNeverWrittenButMayBeRead) {
    EXPECT_THAT(checkDenyList("WG,100=1"), FailedWith(ErrorKind::kRefused));
    EXPECT_THAT(checkDenyList("WG,210=0.0012\r"), FailedWith(ErrorKind::kRefused));
    EXPECT_TRUE(checkDenyList("WG,99=1").has_value());
    EXPECT_TRUE(checkDenyList("RG,165").has_value());
    EXPECT_TRUE(checkDenyList("WV,102=0").has_value());  // the published laser sequence of dialect B
}

TEST(DenyListTest, OrdinaryWorkPasses) {
    for (const char* line : {"RG\r", "RGT\r", "TG>\r\n", "WG,26=96.1684\r", "WS=PH02V02\r", "PG,3=1\r",
                             "OMC\r", "LM=DEMO1\r", "PV,20\r", "MG\r", ""}) {
        EXPECT_TRUE(checkDenyList(line).has_value()) << line;
    }
}

TEST(DenyListTest, DisguisesAreSeenThrough) {
    for (const char* line : {"k*", " K*", "\x11K*", "RG\rK*\r", "RG\nKM=JOB1", "WG, 127=1", "WG,0127=1",
                             "wg,165=3", "WG,99999999999=1"}) {
        EXPECT_THAT(checkDenyList(line), FailedWith(ErrorKind::kRefused)) << line;
    }
}

TEST(DenyListTest, RefusalSaysWhatTheCommandWouldDo) {
    const auto refused = checkDenyList("KM=JOB1\r");
    ASSERT_FALSE(refused.has_value());
    EXPECT_THAT(refused.error().sentence().toStdString(), testing::HasSubstr("erases files"));
    EXPECT_EQ(refused.error().detail, QStringLiteral("KM=JOB1"));
}

}  // namespace
}  // namespace pmts::protocol
