#include "scripted_instrument.hpp"

namespace pmts::instrument {
namespace {

/// Protocol page 2.10: what the driver does with a status of each class, seen on a plain read.
struct StatusCase {
    int code;
    bool comes_through;  ///< an instrument that answers so once is asked again
};

class StatusTest : public DriverTest, public testing::WithParamInterface<StatusCase> {};

TEST_P(StatusTest, IsHandledByItsClass) {
    connect();
    station.next["RG,30"] = {station.block(std::to_string(GetParam().code))};

    const auto read = run(driver.get(30, {}));

    EXPECT_EQ(read.has_value(), GetParam().comes_through) << GetParam().code;
    if (!GetParam().comes_through) {
        EXPECT_EQ(read.error().info_code, GetParam().code);
        EXPECT_FALSE(read.error().happened.isEmpty());
    }
}

INSTANTIATE_TEST_SUITE_P(EveryClass, StatusTest,
                         testing::Values(StatusCase{1, false},      // operator
                                         StatusCase{5, false},      // configuration
                                         StatusCase{8, false},      // power
                                         StatusCase{19, true},      // comm
                                         StatusCase{22, true},      // comm
                                         StatusCase{207, true},     // comm
                                         StatusCase{103, true},     // radio, comm
                                         StatusCase{197, true},     // retry
                                         StatusCase{24, false},     // state
                                         StatusCase{26, false},     // service
                                         StatusCase{221, false},    // angle unit, service
                                         StatusCase{151, false},    // motion
                                         StatusCase{161, false},    // target
                                         StatusCase{999, false}));  // not in the list

TEST_F(DriverTest, ACommErrorIsTriedThreeTimesAndThenReported) {
    connect();
    station.next["RG,30"] = std::deque<std::optional<std::string>>(10, "23\r\n>");

    const auto read = run(driver.get(30, {}));

    ASSERT_FALSE(read.has_value());
    EXPECT_EQ(read.error().info_code, 23);
    EXPECT_EQ(sent("RG,30"), 4);
}

TEST_F(DriverTest, ALostAnswerIsAskedForAgainAfterTheLineHasSettled) {
    connect();
    station.next["RG,30"] = {std::nullopt};

    const auto read = run(driver.get(30, {}));

    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(*read, QStringLiteral("5.3"));
    EXPECT_EQ(sent("RG,79"), 1);
}

TEST_F(DriverTest, ASilentInstrumentIsReportedWithinTenSeconds) {
    connect();
    station.silent = true;

    const auto read = run(driver.get(30, {}), 10s);

    EXPECT_THAT(read, test::FailedWith(ErrorKind::kTimeOut));
    EXPECT_FALSE(read.error().happened.contains(QStringLiteral("never answered")));
}

TEST_F(DriverTest, ADamagedAnswerIsAskedForAgain) {
    connect();
    station.next["RG,30"] = {"3=\x15\r\n>", "=5.3\r\n>", "30=.3\r\n>"};

    const auto read = run(driver.get(30, {}));

    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(*read, QStringLiteral("5.3"));
}

}  // namespace
}  // namespace pmts::instrument
