#include "line/control_page.hpp"

#include "bench_fixture.hpp"
#include "field/field_actions.hpp"
#include "window/message_area.hpp"
#include "pmts/instrument/control_settings.hpp"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

namespace pmts::gui {
namespace {

using scheduler::ControlMode;

class ControlPageTest : public test::WindowFixture {
protected:
    ControlPageTest() : page(*window->findChild<ControlPage*>()) {
        window->resize(1280, 800);
        window->show();
        window->activateWindow();
        QApplication::setActiveWindow(&*window);
    }

    void openPage() {
        window->findChild<QToolButton*>(QStringLiteral("control"))->click();
        QCoreApplication::processEvents();
    }
    [[nodiscard]] QPushButton& button(const char* name) const { return *page.findChild<QPushButton*>(QLatin1String(name)); }
    [[nodiscard]] QCheckBox& tick(const char* name) const { return *page.findChild<QCheckBox*>(QLatin1String(name)); }

    ControlPage& page;
};

TEST_F(ControlPageTest, TheTopBarsItemOpensIt) {
    EXPECT_FALSE(page.isVisible());
    openPage();
    EXPECT_TRUE(page.isVisible());
}

TEST_F(ControlPageTest, AButtonChoosesTheModeAndStaysPressed) {
    openPage();
    EXPECT_TRUE(button("control_mode_1").isChecked());
    button("control_mode_3").click();
    EXPECT_EQ(bench->control.wantedMode(), ControlMode::kPanel);
    EXPECT_TRUE(button("control_mode_3").isChecked());
    EXPECT_FALSE(button("control_mode_1").isChecked());
    button("control_mode_3").click();
    EXPECT_TRUE(button("control_mode_3").isChecked()) << "a second click changes nothing";
}

TEST_F(ControlPageTest, ItsKeysWorkWhileItIsShownOnly) {
    QTest::keyClick(&*window, Qt::Key_2);
    EXPECT_EQ(bench->control.wantedMode(), ControlMode::kShared);
    openPage();
    QTest::keyClick(&*window, Qt::Key_2);
    EXPECT_EQ(bench->control.wantedMode(), ControlMode::kComputer);
    window->actions().field->trigger();
    QTest::keyClick(&*window, Qt::Key_3);
    EXPECT_EQ(bench->control.wantedMode(), ControlMode::kComputer);
}

TEST_F(ControlPageTest, MainButtonsAreForAGlovedFinger) {
    openPage();
    for (const char* const name : {"control_mode_1", "control_mode_2", "control_mode_3", "control_use_panel", "control_remove_panel"}) {
        EXPECT_GE(button(name).height(), 44) << name;
    }
}

TEST_F(ControlPageTest, ATypedPathIsTheInstrumentsSecondPort) {
    openPage();
    page.findChild<QComboBox*>(QStringLiteral("port"))->setEditText(QStringLiteral("/dev/ttyUSB9"));
    page.findChild<QComboBox*>(QStringLiteral("baud"))->setCurrentText(QStringLiteral("4800"));
    page.findChild<QComboBox*>(QStringLiteral("framing"))->setCurrentText(QStringLiteral("7E1"));
    button("control_use_panel").click();
    ASSERT_TRUE(bench->preferences.settings().control.panel.has_value());
    EXPECT_EQ(bench->preferences.settings().control.panel->text(), QStringLiteral("/dev/ttyUSB9 at 4800 7E1"));
    button("control_remove_panel").click();
    EXPECT_FALSE(bench->preferences.settings().control.panel.has_value());
    EXPECT_FALSE(button("control_remove_panel").isEnabled());
}

TEST_F(ControlPageTest, TheSwitchBoxIsSetLineByLine) {
    openPage();
    EXPECT_FALSE(tick("dtr_in_mode_1").isEnabled());
    tick("dtr").click();
    tick("dtr_in_mode_1").click();
    tick("switch_inverted").click();
    const auto path_switch = bench->preferences.settings().control.path_switch;
    ASSERT_TRUE(path_switch.dtr.has_value());
    EXPECT_TRUE(path_switch.dtr->shared);
    EXPECT_FALSE(path_switch.dtr->computer);
    EXPECT_TRUE(path_switch.dtr->panel);
    EXPECT_FALSE(path_switch.rts.has_value());
    EXPECT_TRUE(path_switch.inverted);
}

TEST_F(ControlPageTest, TheCountersAreATable) {
    openPage();
    const auto* const table = page.findChild<QTableWidget*>(QStringLiteral("control_counters"));
    EXPECT_EQ(table->rowCount(), static_cast<int>(bench->control.counters().size()));
    EXPECT_EQ(table->item(0, 1)->text(), QStringLiteral("0"));
}

TEST_F(ControlPageTest, TheBarOfARefusalTakesControlBack) {
    bench->control.setMode(ControlMode::kPanel);
    bench->messages.report(instrument::panelHasControl());
    QCoreApplication::processEvents();
    auto* const bar = window->findChild<MessageBar*>();
    ASSERT_NE(bar, nullptr);
    auto* const act = bar->findChild<QPushButton*>(QStringLiteral("act"));
    EXPECT_EQ(act->text(), QStringLiteral("Take control back"));
    act->click();
    EXPECT_EQ(bench->control.wantedMode(), ControlMode::kShared);
    EXPECT_TRUE(bench->messages.bars().empty());
}

}  // namespace
}  // namespace pmts::gui
