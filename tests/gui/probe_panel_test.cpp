#include "line/probe_panel.hpp"

#include "bench_fixture.hpp"
#include "line/check_list.hpp"
#include "window/connection_dialog.hpp"
#include "parts/state_lamp.hpp"
#include "support/run_until.hpp"

#include <QApplication>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QTest>

namespace pmts::gui {
namespace {

using app::ConnectionState;

/// The page of the connection, over the simulated instrument at a real pty.
class ProbePanelTest : public test::WindowFixture {
protected:
    ProbePanelTest() {
        window->show();
        dialog.openPage(ConnectionDialog::Page::kInstrument);
    }
    /// The instrument at this setting; only its port is looked at, whatever this computer has.
    void switchOn(const char* line) {
        app::SimulationChoice choice;
        choice.line = QString::fromLatin1(line);
        int starts = 0;
        const QObject here;
        QObject::connect(&bench->simulation, &app::SimulationDesk::started, &here, [&starts] { ++starts; });
        bench->simulation.start(choice);
        ASSERT_TRUE(test::runUntil([&starts] { return starts > 0; }));
        auto& ports = part<QListWidget>("probe_ports");
        bool is_listed = false;
        for (int row = 0; row < ports.count(); ++row) {
            const bool is_it = ports.item(row)->data(Qt::UserRole).toString() == bench->simulation.portPath();
            ports.item(row)->setCheckState(is_it ? Qt::Checked : Qt::Unchecked);
            is_listed = is_listed || is_it;
        }
        ASSERT_TRUE(is_listed) << bench->simulation.portPath().toStdString();
    }
    void press(const char* button) { QTest::mouseClick(&part<QPushButton>(button), Qt::LeftButton); }
    template <class T>
    [[nodiscard]] T& part(const char* name) const {
        return *dialog.findChild<T*>(QLatin1String(name));
    }
    [[nodiscard]] QString verdict() const { return part<QLabel>("probe_verdict").text(); }
    [[nodiscard]] QString check(int row) const { return part<QLabel>(qPrintable(QStringLiteral("check_%1").arg(row))).text(); }

    ConnectionDialog dialog{*bench};
};

TEST_F(ProbePanelTest, TellsWhatItTriesAndHowFarItIsAndCanBeEnded) {
    switchOn("300-8N1");  // the last of the speeds
    EXPECT_EQ(part<QPushButton>("probe_start").text(), QStringLiteral("Look for the instrument"));
    EXPECT_FALSE(part<QPushButton>("probe_use").isEnabled());
    press("probe_start");
    EXPECT_EQ(part<QPushButton>("probe_start").text(), QStringLiteral("Cancel"));
    EXPECT_TRUE(part<QProgressBar>("probe_progress").isVisible());
    ASSERT_TRUE(test::runUntil([this] { return part<QProgressBar>("probe_progress").value() > 0; }));
    EXPECT_TRUE(verdict().startsWith(QStringLiteral("Asking on "))) << verdict().toStdString();
    EXPECT_TRUE(verdict().endsWith(QStringLiteral("of 36)."))) << verdict().toStdString();
    EXPECT_FALSE(part<QListWidget>("probe_ports").isEnabled());

    press("probe_start");
    ASSERT_TRUE(test::runUntil([this] { return !bench->probe.isRunning(); }));
    EXPECT_EQ(verdict().trimmed(), QStringLiteral("The search was ended."));
    EXPECT_EQ(part<QPushButton>("probe_start").text(), QStringLiteral("Look for the instrument"));
    EXPECT_FALSE(part<QProgressBar>("probe_progress").isVisible());
    EXPECT_FALSE(part<QPushButton>("probe_use").isEnabled()) << "nothing was found";
}

TEST_F(ProbePanelTest, WhatIsFoundIsTakenOverAndTheCheckListFillsIn) {
    switchOn("4800-8N1");
    press("probe_start");
    ASSERT_TRUE(test::runUntil([this] { return !bench->probe.isRunning(); }));
    EXPECT_TRUE(verdict().contains(QStringLiteral("at 4800 8N1."))) << verdict().toStdString();
    ASSERT_TRUE(part<QPushButton>("probe_use").isEnabled());

    press("probe_use");
    ASSERT_TRUE(test::runUntil([this] { return bench->instrument.connectionState() == ConnectionState::kConnected; }));
    EXPECT_TRUE(check(1).endsWith(QStringLiteral("is open."))) << check(1).toStdString();
    EXPECT_EQ(check(3), QStringLiteral("An instrument answers."));
    EXPECT_EQ(check(4), QStringLiteral("Every answer ends with \">\" (label 79 = 62)."));
    EXPECT_EQ(check(6), QStringLiteral("Label 55 = 620123."));
    EXPECT_FALSE(part<QPushButton>("probe_start").isEnabled()) << "a connected instrument is not disturbed";
    EXPECT_FALSE(part<QPushButton>("probe_use").isEnabled());
    EXPECT_EQ(verdict(), bench->probe.refusal()) << "and the panel says why";
}

TEST_F(ProbePanelTest, AWrongSpeedIsNamedInTheCheckList) {
    switchOn("4800-8N1");
    app::SerialChoice choice;
    choice.path = bench->simulation.portPath();
    bench->connection.connectFound(choice);  // 9600 8N1

    ASSERT_TRUE(test::runUntil([this] { return (check(2) + check(3)).contains(QStringLiteral("Look for the settings")); }))
        << check(2).toStdString() << ' ' << check(3).toStdString();
    EXPECT_EQ(check(4), QString()) << "nothing is known of the end mark";
}

}  // namespace
}  // namespace pmts::gui
