#include "pmts/targeting/target_list.hpp"

#include "support/matchers.hpp"

namespace pmts::targeting {
namespace {

using core::ErrorKind;
using test::FailedWith;

TEST(TargetListTest, ThesisTableIsReadWithItsPrintedColumns) {
    const auto targets = readTargetFile(PMTS_TEST_DATA "/icsm.csv");
    ASSERT_TRUE(targets.has_value()) << targets.error().sentence().toStdString();
    ASSERT_EQ(targets->size(), 11U);
    const ListedTarget& fifth = targets->at(4);
    EXPECT_EQ(fifth.name, "5");
    EXPECT_DOUBLE_EQ(fifth.observed.slope_distance_m, 43.0422);
    EXPECT_DOUBLE_EQ(fifth.observed.pointing.ha.gon(), 225.0055);
    EXPECT_EQ(fifth.px, Eigen::Vector2d(624, 182));
    EXPECT_DOUBLE_EQ(fifth.printed_oatpa->ha.gon(), 223.30);
}

TEST(TargetListTest, ColumnsMayComeInAnyOrderWithSemicolonsAndDecimalCommas) {
    const auto targets =
        readTargetList("v;u;SVA;SHA;SD;name;remark\n371,5;157;116,7947;186,1377;5,7207;door;x\n");
    ASSERT_TRUE(targets.has_value()) << targets.error().sentence().toStdString();
    EXPECT_EQ(targets->front().name, "door");
    EXPECT_EQ(targets->front().px, Eigen::Vector2d(157, 371.5));
    EXPECT_DOUBLE_EQ(targets->front().observed.pointing.va.gon(), 116.7947);
    EXPECT_FALSE(targets->front().printed_apa.has_value());
}

TEST(TargetListTest, WrittenListIsReadAgain) {
    const auto targets = readTargetFile(PMTS_TEST_DATA "/icsm.csv").value();
    const QString text = targetListText(targets, "image 640x480\ntaken by hand");
    EXPECT_TRUE(text.startsWith("# image 640x480\n# taken by hand\nno,sd,sha,sva,u,v,apa_sha"));
    const auto back = readTargetList(text).value();
    ASSERT_EQ(back.size(), targets.size());
    EXPECT_EQ(back[4].name, "5");
    EXPECT_EQ(back[4].px, targets[4].px);
    EXPECT_NEAR(back[4].observed.pointing.ha.gon(), 225.0055, 1e-5);
    EXPECT_NEAR(back[4].observed.slope_distance_m, 43.0422, 1e-4);
    EXPECT_NEAR(back[4].printed_oatpa->ha.gon(), 223.30, 1e-5);
}

TEST(TargetListTest, ListWithoutPrintedColumnsIsWrittenWithoutThem) {
    auto targets = readTargetFile(PMTS_TEST_DATA "/icsm.csv").value();
    for (ListedTarget& target : targets) {
        target.printed_apa.reset();
        target.printed_tpa.reset();
        target.printed_oatpa.reset();
    }
    targets[0].name = "door, left";
    const auto back = readTargetList(targetListText(targets, {})).value();
    EXPECT_EQ(back[0].name, "door  left");
    EXPECT_FALSE(back[0].printed_tpa.has_value());
}

TEST(TargetListTest, WrongNumberIsNamedWithItsLineAndColumn) {
    const auto targets =
        readTargetList("# mine\nno,sd,sha,sva,u,v\n1,5.7,186,116,157,371\n2,13.5,19x,107,246,257\n");
    ASSERT_THAT(targets, FailedWith(ErrorKind::kBadInput));
    EXPECT_TRUE(targets.error().happened.contains("4"));
    EXPECT_TRUE(targets.error().happened.contains("19x"));
    EXPECT_TRUE(targets.error().happened.contains("sha"));
}

TEST(TargetListTest, ShortLineIsNamedWithTheColumnItLacks) {
    const auto targets = readTargetList("no,sd,sha,sva,u,v\n1,5.7,186,116,157\n");
    ASSERT_THAT(targets, FailedWith(ErrorKind::kBadInput));
    EXPECT_TRUE(targets.error().happened.contains("2"));
    EXPECT_TRUE(targets.error().happened.contains(QString::fromUtf8("“v”")));
}

TEST(TargetListTest, MissingColumnEmptyTableAndZeroDistanceAreRefused) {
    EXPECT_THAT(readTargetList("no,sd,sha,u,v\n1,5,1,2,3\n"), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(readTargetList("no,sd,sha,sva,u,v\n"), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(readTargetList(""), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(readTargetList("no,sd,sha,sva,u,v\n1,0,1,2,3,4\n"), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(readTargetList("no,sd,sha,sva,u,v\n1,nan,1,2,3,4\n"), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(readTargetFile("/nowhere/targets.csv"), FailedWith(ErrorKind::kFile));
}

}  // namespace
}  // namespace pmts::targeting
