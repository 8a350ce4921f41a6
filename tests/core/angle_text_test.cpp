#include "pmts/core/angle_text.hpp"

#include "support/matchers.hpp"

namespace pmts::core {
namespace {

using test::FailedWith;
using test::IsNearAngle;

TEST(AngleTextTest, ShowsThePanelsDmsOfTheThesis) {
    // Thesis 3.5.3: the panel showed 86.33.06 and 159.48.18 for these two.
    EXPECT_EQ(angleText(Angle::fromGon(96.16838), AngleUnit::kDms, 0), QStringLiteral("86°33'06\""));
    EXPECT_EQ(angleText(Angle::fromGon(177.56115), AngleUnit::kDms, 0), QStringLiteral("159°48'18\""));
}

TEST(AngleTextTest, SecondsCarryIntoMinutesAndDegrees) {
    EXPECT_EQ(angleText(Angle::fromArcsec(3599.6), AngleUnit::kDms, 0), QStringLiteral("1°00'00\""));
    EXPECT_EQ(angleText(Angle::fromArcsec(-59.96), AngleUnit::kDms, 1), QStringLiteral("-0°01'00.0\""));
    EXPECT_EQ(angleText(Angle::fromArcsec(-0.01), AngleUnit::kDms, 0), QStringLiteral("0°00'00\""));
}

TEST(AngleTextTest, ShowsGonDegreeAndMil) {
    const Angle ha = Angle::fromGon(177.56117);
    EXPECT_EQ(angleText(ha, AngleUnit::kGon, 4), QStringLiteral("177.5612 gon"));
    EXPECT_EQ(angleText(ha, AngleUnit::kDegree, 4), QStringLiteral("159.8051°"));
    EXPECT_EQ(angleText(ha, AngleUnit::kMil, 3), QStringLiteral("2840.979 mil"));
}

struct Typed {
    const char* text;
    AngleUnit unit;
    double gon;
};

class TypedAngleTest : public testing::TestWithParam<Typed> {};

TEST_P(TypedAngleTest, IsUnderstood) {
    const auto angle = angleFromText(QString::fromUtf8(GetParam().text), GetParam().unit);
    ASSERT_TRUE(angle.has_value());
    EXPECT_THAT(*angle, IsNearAngle(Angle::fromGon(GetParam().gon), Angle::fromCc(0.01)));
}

INSTANTIATE_TEST_SUITE_P(
    EveryWay, TypedAngleTest,
    testing::Values(Typed{"12.5", AngleUnit::kGon, 12.5}, Typed{"12,5", AngleUnit::kGon, 12.5},
                    Typed{" 12.5 gon", AngleUnit::kDms, 12.5}, Typed{"5'", AngleUnit::kGon, 5.0 / 60 / 0.9},
                    Typed{"-5'", AngleUnit::kGon, -5.0 / 60 / 0.9}, Typed{"159°48'18.126\"", AngleUnit::kGon, 177.56115},
                    Typed{"159 48 18.126", AngleUnit::kDms, 177.56115}, Typed{"90", AngleUnit::kDms, 100},
                    Typed{"-0 30", AngleUnit::kDms, -0.5 / 0.9}, Typed{"90", AngleUnit::kDegree, 100},
                    Typed{"1600", AngleUnit::kMil, 100}, Typed{"30 cc", AngleUnit::kGon, 0.003},
                    Typed{"2 MGON", AngleUnit::kGon, 0.002}, Typed{"86° 33′ 05.55″", AngleUnit::kGon, 96.168380}));

TEST(AngleTextTest, RefusesWhatIsNotAnAngle) {
    for (const char* text : {"", "abc", "12 parsec", "1.2.3", "12 13", "--3", "gon"}) {
        EXPECT_THAT(angleFromText(QString::fromUtf8(text), AngleUnit::kGon), FailedWith(ErrorKind::kBadInput)) << text;
    }
}

}  // namespace
}  // namespace pmts::core
