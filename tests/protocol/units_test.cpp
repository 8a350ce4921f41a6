#include "pmts/protocol/units.hpp"

#include "support/matchers.hpp"

#include <random>

namespace pmts::protocol {
namespace {

using core::Angle;
using core::ErrorKind;
using test::FailedWith;
using test::IsNearAngle;
using enum WireAngleUnit;

const Angle kThesisHa = Angle::fromGon(177.56115);

TEST(UnitsTest, AngleTextsAreThoseOfTheProtocolPage) {
    EXPECT_EQ(wireAngle(kThesisHa, kGon, 4), "177.5612");
    EXPECT_EQ(wireAngle(kThesisHa, kDms, 4), "159.4818");
    EXPECT_EQ(wireAngle(kThesisHa, kDegree, 4), "159.8050");
    EXPECT_EQ(wireAngle(kThesisHa, kMil, 3), "2840.978");
}

TEST(UnitsTest, AngleTextsOfTheProtocolPageAreRead) {
    EXPECT_THAT(angleFromWire("177.5612", kGon).value(), IsNearAngle(kThesisHa, Angle::fromCc(0.51)));
    EXPECT_THAT(angleFromWire("159.4818", kDms).value(), IsNearAngle(kThesisHa, Angle::fromArcsec(0.51)));
    EXPECT_THAT(angleFromWire("159.8050", kDegree).value(), IsNearAngle(kThesisHa, Angle::fromArcsec(0.19)));
    EXPECT_THAT(angleFromWire("2840.978", kMil).value(), IsNearAngle(kThesisHa, Angle::fromMil(0.00051)));
}

TEST(UnitsTest, SecondsCarryIntoMinutesAndDegrees) {
    const Angle almost = Angle::fromDeg(12) + Angle::fromArcsec(34 * 60 + 59.6);
    EXPECT_EQ(wireAngle(almost, kDms, 4), "12.3500");
    EXPECT_EQ(wireAngle(almost, kDms, 5), "12.34596");
    EXPECT_EQ(wireAngle(Angle::fromDeg(60) - Angle::fromArcsec(0.4), kDms, 4), "60.0000");
    EXPECT_EQ(wireAngle(Angle::fromDeg(12.5), kDms, 2), "12.30");
    EXPECT_EQ(wireAngle(Angle::fromDeg(-0.5), kDms, 4), "-0.3000");
}

TEST(UnitsTest, FullCircleReachedByRoundingIsWrittenAsZero) {
    EXPECT_EQ(wireAngle(Angle::fromGon(399.99996), kGon, 4), "0.0000");
    EXPECT_EQ(wireAngle(Angle::fromDeg(360) - Angle::fromArcsec(0.4), kDms, 4), "0.0000");
    EXPECT_EQ(wireAngle(Angle::fromGon(399.9999), kGon, 4), "399.9999");
    EXPECT_EQ(wireAngle(Angle::fromGon(-0.00001), kGon, 4), "0.0000");
}

TEST(UnitsTest, DmsDigitsThatAreLeftOutAreZero) {
    EXPECT_THAT(angleFromWire("159.48", kDms).value(),
                IsNearAngle(Angle::fromDeg(159.8), Angle::fromCc(0.001)));
    EXPECT_THAT(angleFromWire("159.3", kDms).value(),
                IsNearAngle(Angle::fromDeg(159.5), Angle::fromCc(0.001)));
    EXPECT_THAT(angleFromWire("159", kDms).value(), IsNearAngle(Angle::fromDeg(159), Angle::fromCc(0.001)));
    EXPECT_THAT(angleFromWire("0.000050", kDms).value(),
                IsNearAngle(Angle::fromArcsec(0.5), Angle::fromCc(0.001)));
}

TEST(UnitsTest, DamagedAnglesAreRefusedNotGuessed) {
    for (const char* text : {"", ".", "1e2", "12,5", "177.56.12",
                             "177\xFF"
                             "5612",
                             "nan", "--5", "17756.12", "0x10"}) {
        EXPECT_THAT(angleFromWire(text, kGon), FailedWith(ErrorKind::kProtocol)) << text;
    }
    EXPECT_THAT(angleFromWire("159.6018", kDms), FailedWith(ErrorKind::kProtocol));
    EXPECT_THAT(angleFromWire("159.4860", kDms), FailedWith(ErrorKind::kProtocol));
    EXPECT_THAT(angleFromWire("361", kDegree), FailedWith(ErrorKind::kProtocol));
}

TEST(UnitsTest, NineDigitsAtMostDecimalsGiveWay) {
    EXPECT_EQ(wireAngle(kThesisHa, kGon, 8), "177.561150");
    EXPECT_EQ(wireNumber(523456.7891, 4), "523456.789");
    EXPECT_EQ(wireNumber(-12.0, 2), "-12.00");
    EXPECT_EQ(wireNumber(-0.001, 2), "0.00");
    EXPECT_THROW((void)wireNumber(1e9, 0), std::logic_error);
}

TEST(UnitsTest, EveryAngleUnitComesBackWithinHalfItsLastDigit) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> gon(0.0, 400.0);
    const std::vector<std::tuple<WireAngleUnit, int, Angle>> cases{{kGon, 4, Angle::fromCc(0.5)},
                                                                   {kDms, 4, Angle::fromArcsec(0.5)},
                                                                   {kDegree, 4, Angle::fromDeg(0.00005)},
                                                                   {kMil, 3, Angle::fromMil(0.0005)}};
    for (int i = 0; i < 2000; ++i) {
        const Angle angle = Angle::fromGon(gon(random));
        for (const auto& [unit, decimals, half_digit] : cases) {
            const auto back = angleFromWire(wireAngle(angle, unit, decimals), unit);
            ASSERT_TRUE(back.has_value());
            EXPECT_THAT(*back, IsNearAngle(angle, half_digit * 1.0001));
        }
    }
}

TEST(UnitsTest, UnitStatusIsReadFromTheRight) {
    EXPECT_EQ(
        parseUnitStatus("3214").value(),
        (WireUnits{kMil, WireLengthUnit::kMetre, WireTemperatureUnit::kFahrenheit, WirePressureUnit::kInHg}));
    EXPECT_EQ(parseUnitStatus("2112").value().angle, kDms);
    EXPECT_EQ(parseUnitStatus("1111").value(), WireUnits{});
    EXPECT_EQ(unitStatusText(parseUnitStatus("3214").value()), "3214");
    for (const char* text : {"", "111", "11111", "1115", "1131", "1311", "4111", "0111", "x111"}) {
        EXPECT_THAT(parseUnitStatus(text), FailedWith(ErrorKind::kProtocol)) << text;
    }
}

TEST(UnitsTest, LengthsTemperaturesAndPressuresInTheInstrumentsUnits) {
    EXPECT_EQ(wireLength(145.324, WireLengthUnit::kMetre, 3), "145.324");
    EXPECT_EQ(wireLength(0.3048, WireLengthUnit::kFoot, 3), "1.000");
    EXPECT_NEAR(metresFromWire("100.000", WireLengthUnit::kFoot).value(), 30.48, 1e-9);
    EXPECT_EQ(wireTemperature(20.0, WireTemperatureUnit::kFahrenheit), "68.0");
    EXPECT_NEAR(degcFromWire("212", WireTemperatureUnit::kFahrenheit).value(), 100.0, 1e-9);
    EXPECT_NEAR(mbarFromWire("760", WirePressureUnit::kMmHg).value(), 1013.25, 0.01);
    EXPECT_NEAR(mbarFromWire("29.92", WirePressureUnit::kInHg).value(), 1013.21, 0.01);
    EXPECT_EQ(wirePressure(1013.25, WirePressureUnit::kMmHg), "760.0");
}

TEST(UnitsTest, LineParametersAreStopDataParityBaud) {
    EXPECT_EQ(parseLineParameters("1.8.0.9600").value(), LineParameters{});
    EXPECT_EQ(lineParametersText({2, 7, 1, 4800}), "2.7.1.4800");
    for (const char* text :
         {"", "1.8.0", "3.8.0.9600", "1.9.0.9600", "1.8.3.9600", "1.8.0.10", "1.8.0.9600.1", "1..0.9600"}) {
        EXPECT_THAT(parseLineParameters(text), FailedWith(ErrorKind::kProtocol)) << text;
    }
}

}  // namespace
}  // namespace pmts::protocol
