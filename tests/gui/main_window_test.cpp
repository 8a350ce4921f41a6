#include "pmts/gui/main_window.hpp"

#include "parts/action_button.hpp"
#include "bench_fixture.hpp"
#include "field/field_actions.hpp"
#include "field/field_workspace.hpp"
#include "field/image_view.hpp"
#include "field/live_panel.hpp"

#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QSet>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

namespace pmts::gui {
namespace {

class MainWindowTest : public test::WindowFixture {
protected:
    void showAt(const QSize& size) {
        window->setWindowState(Qt::WindowNoState);  // the offscreen screen is small: a first start fills it
        window->resize(size);
        window->show();
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
    }

    /// A page of a tab that is not in front is neither inside nor outside.
    static bool isBehind(const QWidget* widget) {
        for (const QWidget* parent = widget; parent != nullptr; parent = parent->parentWidget()) {
            if (qobject_cast<const QDockWidget*>(parent) != nullptr) {
                return parent->visibleRegion().isEmpty();
            }
        }
        return false;
    }

    /// Every visible button whole inside the window.
    void expectButtonsInside() const {
        const QRect all = window->rect();
        for (const QAbstractButton* button : window->findChildren<QAbstractButton*>()) {
            if (!button->isVisible() || button->window() != &*window || isBehind(button)) {
                continue;
            }
            const QRect place(button->mapTo(&*window, QPoint(0, 0)), button->size());
            EXPECT_TRUE(all.contains(place))
                << button->objectName().toStdString() << " " << button->text().toStdString();
        }
    }

    void TearDown() override {
        window->setTextScale(1.0);
        QApplication::setLayoutDirection(Qt::LeftToRight);
    }
};

TEST_F(MainWindowTest, FitsTheSmallestScreen) {
    showAt({1280, 740});                          // 800 less the title bar and a panel of the desktop
    EXPECT_EQ(window->size(), QSize(1280, 740));  // nothing forces it larger
    expectButtonsInside();
}

TEST_F(MainWindowTest, FitsTheSmallestScreenWithLargerText) {
    window->setTextScale(1.4);
    showAt({1280, 740});
    EXPECT_EQ(window->size(), QSize(1280, 740));
    expectButtonsInside();
}

TEST_F(MainWindowTest, MirrorsForRightToLeft) {
    QApplication::setLayoutDirection(Qt::RightToLeft);
    showAt({1280, 800});
    const auto* const stop = window->findChild<ActionButton*>(QStringLiteral("stop"));
    EXPECT_LT(stop->mapTo(&*window, QPoint(0, 0)).x(), 640);
    expectButtonsInside();
}

TEST_F(MainWindowTest, LiveViewIsTheLargestThing) {
    showAt({1280, 800});
    const QSize live = window->field().live().view().size();
    EXPECT_GE(live.width(), 780);
    EXPECT_GE(live.height(), 380);
}

TEST_F(MainWindowTest, MainActionsAreLargeAndShowTheirKey) {
    showAt({1280, 800});
    for (const ActionButton* button : window->findChildren<ActionButton*>()) {
        EXPECT_GE(button->height(), 44) << button->text().toStdString();
        EXPECT_GE(button->width(), 44) << button->text().toStdString();
        EXPECT_FALSE(button->defaultAction()->shortcut().isEmpty());
    }
}

TEST_F(MainWindowTest, EveryButtonHasANameForAScreenReader) {
    showAt({1280, 800});
    for (const QAbstractButton* button : window->findChildren<QAbstractButton*>()) {
        const bool of_qt = button->objectName().startsWith(QStringLiteral("qt_")) ||
                           button->metaObject()->className() == QByteArray("QTableCornerButton") ||
                           button->inherits("QDockWidgetTitleButton") ||
                           button->parentWidget()->inherits("QTabBar") ||
                           button->parentWidget()->inherits("QLineEdit");
        if (!of_qt) {
            EXPECT_FALSE(button->accessibleName().isEmpty() && button->text().isEmpty())
                << button->objectName().toStdString();
        }
    }
}

TEST_F(MainWindowTest, OnlyLiveViewHidesTheRestAndBringsItBack) {
    showAt({1280, 800});
    window->actions().focus->trigger();
    EXPECT_FALSE(window->findChild<QWidget*>(QStringLiteral("topBar"))->isVisible());
    EXPECT_FALSE(window->findChild<QWidget*>(QStringLiteral("modeBar"))->isVisible());
    EXPECT_TRUE(window->findChild<QWidget*>(QStringLiteral("actionBar"))->isVisible());
    EXPECT_TRUE(window->field().live().view().isVisible());
    EXPECT_FALSE(window->field().pointsDock()->isVisible());
    window->actions().focus->trigger();
    EXPECT_TRUE(window->findChild<QWidget*>(QStringLiteral("topBar"))->isVisible());
    EXPECT_TRUE(window->field().pointsDock()->isVisible());
}

TEST_F(MainWindowTest, TypingACodeMeasuresNothing) {
    showAt({1280, 800});
    QSignalSpy measured(window->actions().measure, &QAction::triggered);
    auto* const code = window->findChild<QLineEdit*>(QStringLiteral("code"));
    code->setFocus();
    QTest::keyClicks(code, QStringLiteral("door d"));
    EXPECT_EQ(code->text(), QStringLiteral("door d"));
    EXPECT_EQ(bench->recording.code(), QStringLiteral("door d"));
    EXPECT_EQ(measured.count(), 0);
}

TEST_F(MainWindowTest, MoveWithoutATargetSaysWhatToDo) {
    showAt({1280, 800});
    window->actions().move->trigger();
    ASSERT_EQ(bench->messages.bars().size(), 1U);
    EXPECT_TRUE(window->findChild<QWidget*>(QStringLiteral("messages"))->isVisible());
}

TEST_F(MainWindowTest, ALostInstrumentIsSaidAboveTheWorkspaceWithTheWayOut) {
    showAt({1280, 800});
    bench->messages.warn(QStringLiteral("The instrument is gone."), QStringLiteral("Check the cable."),
                         app::MessageAction::kOpenConnectionPage);
    auto* const act = window->findChild<QPushButton*>(QStringLiteral("act"));
    ASSERT_NE(act, nullptr);
    QTest::mouseClick(act, Qt::LeftButton);
    EXPECT_TRUE(window->findChild<QDialog*>(QStringLiteral("ConnectionDialog"))->isVisible());
}

TEST_F(MainWindowTest, NoAltKeyMeansTwoThings) {
    showAt({1280, 800});
    QStringList texts;
    for (const QAction* menu : window->menuBar()->actions()) {
        texts.append(menu->text());
    }
    for (const QLabel* label : window->field().findChildren<QLabel*>()) {
        if (label->buddy() != nullptr) {
            texts.append(label->text());
        }
    }
    QSet<QKeySequence> seen;
    for (const QString& text : texts) {
        const QKeySequence key = QKeySequence::mnemonic(text);
        EXPECT_FALSE(!key.isEmpty() && seen.contains(key)) << text.toStdString();
        seen.insert(key);
    }
}

TEST_F(MainWindowTest, KeyListNamesEveryKey) {
    showAt({1280, 800});
    window->actions().keys->trigger();
    EXPECT_NE(window->findChild<QDialog*>(QStringLiteral("KeysDialog")), nullptr);
}

TEST_F(MainWindowTest, RemembersPaletteTextSizeAndLayout) {
    showAt({1300, 820});
    window->actions().night->trigger();
    window->setTextScale(1.2);
    window->close();
    window.reset();
    bench.reset();
    app::StartOptions options;
    options.data_folder = folder.path();
    bench.emplace(options);
    window.emplace(*bench);
    EXPECT_EQ(currentTheme().name, PaletteName::kNight);
    EXPECT_DOUBLE_EQ(window->textScale(), 1.2);
    EXPECT_EQ(window->size(), QSize(1300, 820));
    window->actions().day->trigger();
}

}  // namespace
}  // namespace pmts::gui
