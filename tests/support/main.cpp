#include "pmts/core/virtual_clock.hpp"

#include <QCoreApplication>
#include <QStandardPaths>
#include <gmock/gmock.h>

namespace {

/// Lets routines that were cancelled at the end of a test return by themselves, before the next test begins.
class LastTurn final : public testing::EmptyTestEventListener {
    void OnTestEnd(const testing::TestInfo&) override { pmts::core::deliverQueuedEvents(); }
};

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleMock(&argc, argv);
    const QCoreApplication app(argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    testing::UnitTest::GetInstance()->listeners().Append(new LastTurn);
    return RUN_ALL_TESTS();
}
