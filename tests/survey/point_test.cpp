#include "pmts/survey/point.hpp"

#include <gtest/gtest.h>

namespace pmts::survey {
namespace {

struct Next {
    const char* id;
    const char* next;
};

class NextPointIdTest : public testing::TestWithParam<Next> {};

TEST_P(NextPointIdTest, CountsTheLastNumberUp) {
    EXPECT_EQ(nextPointId(QString::fromUtf8(GetParam().id)), QString::fromUtf8(GetParam().next));
}

INSTANTIATE_TEST_SUITE_P(EveryForm, NextPointIdTest,
                         testing::Values(Next{"A09", "A10"}, Next{"WALL", "WALL1"}, Next{"104", "105"},
                                         Next{"", "1"}, Next{"0", "1"}, Next{"9", "10"}, Next{"A99", "A100"},
                                         Next{"000", "001"}, Next{"099", "100"}, Next{"12B", "13B"},
                                         Next{"P1-2", "P1-3"}, Next{"F3.9", "F3.10"},
                                         Next{"wall 7", "wall 8"}, Next{"-5", "-6"},
                                         Next{"2015-07-09", "2015-07-10"}, Next{"Tür", "Tür1"},
                                         Next{"Ecke²", "Ecke²1"},
                                         Next{"99999999999999999999", "100000000000000000000"}));

TEST(NextPointIdTest, AThousandStepsNeverRepeat) {
    QString id = QStringLiteral("A009");
    for (int i = 10; i < 1010; ++i) {
        id = nextPointId(id);
        ASSERT_EQ(id, QStringLiteral("A%1").arg(i, 3, 10, QChar(u'0')));
    }
}

TEST(FreePointIdTest, IdsInUseAreSkippedAndAFreeOneIsKept) {
    const QStringList used{QStringLiteral("A9"), QStringLiteral("A10"), QStringLiteral("A12")};
    const auto is_used = [&used](const QString& id) { return used.contains(id); };
    EXPECT_EQ(freePointId(QStringLiteral("A9"), is_used), QStringLiteral("A11"));
    EXPECT_EQ(freePointId(QStringLiteral("A12"), is_used), QStringLiteral("A13"));
    EXPECT_EQ(freePointId(QStringLiteral("A8"), is_used), QStringLiteral("A8"));
}

}  // namespace
}  // namespace pmts::survey
