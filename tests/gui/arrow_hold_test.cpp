#include "field/arrow_hold.hpp"

#include "parts/action_button.hpp"
#include "bench_fixture.hpp"
#include "field/field_actions.hpp"
#include "pmts/core/virtual_clock.hpp"

#include <QSignalSpy>
#include <QTest>

namespace pmts::gui {
namespace {

/// Without an instrument every step is refused with one report: they can be counted.
class ArrowHoldTest : public test::WindowFixture {
protected:
    ArrowHoldTest() : actions(&panel), button(&panel) {
        button.setAction(actions.right);
        button.resize(60, 60);
        hold.emplace(actions, steps, nullptr);
        panel.show();
        panel.activateWindow();
        QCoreApplication::processEvents();
        QObject::connect(&bench->messages, &app::MessageCentre::barKept, &panel, [this] { ++refused; });
    }

    QWidget panel;
    FieldActions actions;
    ActionButton button;
    core::VirtualClock clock;
    app::StepRunner steps{bench->targeting, clock};
    std::optional<ArrowHold> hold;
    int refused = 0;
};

TEST_F(ArrowHoldTest, KeyStepsOnceAndRunsWhenItIsHeld) {
    QTest::keyPress(&panel, Qt::Key_Right);
    EXPECT_EQ(refused, 1);
    clock.advance(std::chrono::milliseconds(500));
    EXPECT_TRUE(steps.isRunning());
    QTest::keyRelease(&panel, Qt::Key_Right);
    clock.advance(app::StepRunner::kKeyGap);
    EXPECT_FALSE(steps.isRunning());
}

TEST_F(ArrowHoldTest, HeldButtonRunsAndItsReleaseEndsTheRun) {
    QTest::mousePress(&button, Qt::LeftButton);
    EXPECT_EQ(refused, 0);
    clock.advance(std::chrono::milliseconds(500));
    EXPECT_TRUE(steps.isRunning());
    const int before = refused;
    QTest::mouseRelease(&button, Qt::LeftButton);
    EXPECT_FALSE(steps.isRunning());
    EXPECT_EQ(refused, before);
}

TEST_F(ArrowHoldTest, ClickedButtonStepsOnce) {
    QTest::mouseClick(&button, Qt::LeftButton);
    EXPECT_EQ(refused, 1);
}

TEST_F(ArrowHoldTest, AnotherWindowInFrontEndsTheRun) {
    QTest::keyPress(&panel, Qt::Key_Right);
    clock.advance(std::chrono::milliseconds(500));
    QEvent away(QEvent::WindowDeactivate);
    QCoreApplication::sendEvent(&panel, &away);
    EXPECT_FALSE(steps.isRunning());
}

}  // namespace
}  // namespace pmts::gui
