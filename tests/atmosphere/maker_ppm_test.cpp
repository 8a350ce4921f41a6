#include "pmts/atmosphere/maker_ppm.hpp"

#include "support/matchers.hpp"

#include <limits>

namespace pmts::atmosphere {
namespace {

using core::ErrorKind;
using test::FailedWith;

TEST(MakerPpmTest, GivesTheMakersTestValue) {
    // Protocol page 4.5: p = 1000 mbar, t = 22 deg C -> 5.34.
    const auto ppm = makerPpm(1000.0, 22.0);
    ASSERT_TRUE(ppm.has_value());
    EXPECT_NEAR(*ppm, 5.34, 0.005);
}

TEST(MakerPpmTest, FollowsTheRulesOfThumbForOneDegreeAndOneMbar) {
    // Rule of thumb of the trade: 1 ppm per deg C, 0.3 ppm per mbar.
    EXPECT_NEAR(*makerPpm(1013.0, 21.0) - *makerPpm(1013.0, 20.0), 0.94, 0.05);
    EXPECT_NEAR(*makerPpm(1014.0, 20.0) - *makerPpm(1013.0, 20.0), -0.27, 0.01);
}

TEST(MakerPpmTest, RefusesWhatLabel30DoesNotTake) {
    EXPECT_THAT(makerPpm(200.0, 20.0), FailedWith(ErrorKind::kLimit));    // would be 220 ppm
    EXPECT_THAT(makerPpm(1090.0, -30.0), FailedWith(ErrorKind::kLimit));  // would be -82 ppm
    EXPECT_TRUE(makerPpm(540.0, -10.0).has_value());                      // 5000 m above the sea
}

TEST(MakerPpmTest, RefusesAirThatCannotBe) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(makerPpm(0.0, 20.0), FailedWith(ErrorKind::kLimit));
    EXPECT_THAT(makerPpm(1013.0, -273.0), FailedWith(ErrorKind::kLimit));
    EXPECT_THAT(makerPpm(nan, 20.0), FailedWith(ErrorKind::kLimit));
    EXPECT_THAT(makerPpm(1013.0, nan), FailedWith(ErrorKind::kLimit));
}

}  // namespace
}  // namespace pmts::atmosphere
