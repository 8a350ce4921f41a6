#include "pmts/app/desk/whole_file.hpp"

#include "support/matchers.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pmts::app {
namespace {

using test::FailedWith;
using testing::HasSubstr;

class WholeFileTest : public testing::Test {
protected:
    [[nodiscard]] QString path() const { return folder.filePath(QStringLiteral("a.txt")); }
    QTemporaryDir folder;
};

TEST_F(WholeFileTest, WhatWasWrittenIsReadUpToTheLastByteThatIsAllowed) {
    ASSERT_TRUE(writeWhole(path(), "12345"));
    EXPECT_EQ(readWhole(path(), 5), QByteArray("12345"));
    const auto larger = readWhole(path(), 4);
    EXPECT_THAT(larger, FailedWith(core::ErrorKind::kFile));
    EXPECT_THAT(larger.error().happened.toStdString(), HasSubstr("too large"));
}

TEST_F(WholeFileTest, WhatCannotBeReadHasItsReason) {
    const auto missing = readWhole(path(), 5);
    EXPECT_THAT(missing, FailedWith(core::ErrorKind::kFile));
    EXPECT_THAT(missing.error().happened.toStdString(), HasSubstr("No such file"));
    EXPECT_THAT(readWhole(folder.path(), 5), FailedWith(core::ErrorKind::kFile)) << "a folder";
}

/// Its size says 0.
TEST_F(WholeFileTest, ADeviceWithoutEndIsTooLarge) {
    EXPECT_THAT(readWhole(QStringLiteral("/dev/zero"), 1000), FailedWith(core::ErrorKind::kFile));
}

}  // namespace
}  // namespace pmts::app
