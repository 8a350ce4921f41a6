#include "pmts/protocol/labels.hpp"

#include "support/matchers.hpp"

namespace pmts::protocol {
namespace {

using core::ErrorKind;
using test::FailedWith;

TEST(LabelsTest, TableHoldsEveryNumberFromZeroTo109InOrder) {
    ASSERT_EQ(allLabels().size(), 110U);
    for (int number = 0; number < 110; ++number) {
        ASSERT_NE(findLabel(number), nullptr);
        EXPECT_EQ(findLabel(number)->number, number);
    }
    EXPECT_EQ(findLabel(110), nullptr);
    EXPECT_EQ(findLabel(-1), nullptr);
}

TEST(LabelsTest, NamedLabelsShowTheInstrumentsPrompts) {
    EXPECT_EQ(findLabel(kHa)->prompt, "HA");
    EXPECT_EQ(findLabel(kVa)->prompt, "VA");
    EXPECT_EQ(findLabel(kSd)->prompt, "SD");
    EXPECT_EQ(findLabel(kTargetVa)->prompt, "SVA");
    EXPECT_EQ(findLabel(kTargetHa)->prompt, "SHA");
    EXPECT_EQ(findLabel(kEasting)->meaning, "easting");
    EXPECT_EQ(findLabel(kNorthing)->meaning, "northing");
}

TEST(LabelsTest, ValuesTheInstrumentTakesPass) {
    EXPECT_TRUE(checkLabelData(kTargetHa, "177.5612").has_value());
    EXPECT_TRUE(checkLabelData(kOffset, "-0.0345").has_value());
    EXPECT_TRUE(checkLabelData(kPointCode, "WALL EAST").has_value());
    EXPECT_TRUE(checkLabelData(kEndMark, "62").has_value());
    EXPECT_TRUE(checkLabelData(kNorthing, "523456.789").has_value());
}

TEST(LabelsTest, ValuesTheInstrumentWouldRefuseFailWithAReason) {
    EXPECT_THAT(checkLabelData(kPointNumber, ""), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(checkLabelData(kPointCode, "SEVENTEEN LETTERS"), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(checkLabelData(kPointCode, "T\xFCr"), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(checkLabelData(kNorthing, "5123456.7891"), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(checkLabelData(kTargetHeight, "1,5"), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(checkLabelData(kEndMark, "6.2"), FailedWith(ErrorKind::kBadInput));
}

TEST(LabelsTest, MeasuredAndInternalLabelsCannotBeSet) {
    EXPECT_THAT(checkLabelData(kHa, "1"), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(checkLabelData(kSerialNumber, "1"), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(checkLabelData(102, "0"), FailedWith(ErrorKind::kBadInput));
}

}  // namespace
}  // namespace pmts::protocol
