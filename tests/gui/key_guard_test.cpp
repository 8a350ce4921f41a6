#include "window/key_guard.hpp"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QVBoxLayout>
#include <QWindow>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

class KeyGuardTest : public testing::Test {
protected:
    KeyGuardTest() {
        auto* const column = new QVBoxLayout(centre);
        for (QWidget* widget : {static_cast<QWidget*>(field), static_cast<QWidget*>(table),
                                static_cast<QWidget*>(button), static_cast<QWidget*>(picture)}) {
            column->addWidget(widget);
        }
        picture->setFocusPolicy(Qt::StrongFocus);
        window.setCentralWidget(centre);
        for (const auto& [action, key] : {std::pair{&measure, Qt::Key_D},
                                          {&move, Qt::Key_Return},
                                          {&all, Qt::Key_Space},
                                          {&left, Qt::Key_Left}}) {
            action->setShortcut(key);
            window.addAction(action);
        }
        window.show();
        window.activateWindow();
        QApplication::setActiveWindow(&window);
    }

    void press(QWidget* where, Qt::Key key) {
        where->setFocus();
        QTest::keyClick(where, key);
    }

    bool moving = false;
    int stopped = 0;
    KeyGuard guard{[this] {
        stopped += moving ? 1 : 0;
        return moving;
    }};
    QMainWindow window;
    QWidget* centre = new QWidget(&window);
    QLineEdit* field = new QLineEdit(centre);
    QTableWidget* table = new QTableWidget(3, 3, centre);
    QPushButton* button = new QPushButton(QStringLiteral("WALL"), centre);
    QWidget* picture = new QWidget(centre);
    QAction measure, move, all, left;
    QSignalSpy measured{&measure, &QAction::triggered};
    QSignalSpy moved{&move, &QAction::triggered};
    QSignalSpy recorded{&all, &QAction::triggered};
    QSignalSpy nudged{&left, &QAction::triggered};
};

TEST_F(KeyGuardTest, SingleKeysActWhileThePictureHasTheFocus) {
    press(picture, Qt::Key_D);
    press(picture, Qt::Key_Return);
    press(picture, Qt::Key_Space);
    EXPECT_EQ(measured.count(), 1);
    EXPECT_EQ(moved.count(), 1);
    EXPECT_EQ(recorded.count(), 1);
}

TEST_F(KeyGuardTest, LettersAreTextWhileAFieldIsTypedIn) {
    press(field, Qt::Key_D);
    press(field, Qt::Key_Space);
    EXPECT_EQ(field->text(), QStringLiteral("d "));
    EXPECT_EQ(measured.count() + recorded.count(), 0);
}

TEST_F(KeyGuardTest, EnterInAFieldDoesNotTurnTheTelescope) {
    press(field, Qt::Key_Return);
    EXPECT_EQ(moved.count(), 0);
}

TEST_F(KeyGuardTest, ArrowsWalkInATableInsteadOfTurningTheTelescope) {
    table->setCurrentCell(1, 1);
    press(table, Qt::Key_Left);
    EXPECT_EQ(nudged.count(), 0);
    EXPECT_EQ(table->currentColumn(), 0);
}

TEST_F(KeyGuardTest, ArrowsAndReturnChooseInAnOpenList) {
    QDialog dialog(&window);
    auto* const sizes = new QComboBox(&dialog);
    sizes->addItems({QStringLiteral("1920 x 1080"), QStringLiteral("1280 x 720"), QStringLiteral("640 x 480")});
    dialog.show();
    sizes->setFocus();
    sizes->showPopup();
    QWidget* const list = QApplication::activePopupWidget();
    ASSERT_NE(list, nullptr);
    for (const Qt::Key key : {Qt::Key_Down, Qt::Key_Down, Qt::Key_Return}) {
        QTest::keyClick(list->windowHandle(), key);
    }
    EXPECT_EQ(sizes->currentIndex(), 2);
    EXPECT_EQ(moved.count(), 0);
}

TEST_F(KeyGuardTest, LettersSearchInAnOpenList) {
    QDialog dialog(&window);
    auto* const doors = new QComboBox(&dialog);
    doors->addItems({QStringLiteral("Wall"), QStringLiteral("Door")});
    dialog.show();
    doors->showPopup();
    ASSERT_NE(QApplication::activePopupWidget(), nullptr);
    QWindow* const list = QApplication::activePopupWidget()->windowHandle();
    QTest::keyClick(list, Qt::Key_D);
    QTest::keyClick(list, Qt::Key_Return);
    EXPECT_EQ(doors->currentText(), QStringLiteral("Door"));
    EXPECT_EQ(measured.count(), 0);
}

TEST_F(KeyGuardTest, SpaceOnAFocusedButtonPressesTheButton) {
    QSignalSpy pressed(button, &QPushButton::clicked);
    press(button, Qt::Key_Space);
    EXPECT_EQ(pressed.count(), 1);
    EXPECT_EQ(recorded.count(), 0);
}

TEST_F(KeyGuardTest, EscapeStopsFirstAlsoInADialog) {
    QDialog dialog(&window);
    dialog.show();
    moving = true;
    QTest::keyClick(&dialog, Qt::Key_Escape);
    EXPECT_EQ(stopped, 1);
    EXPECT_TRUE(dialog.isVisible());
    moving = false;
    QTest::keyClick(&dialog, Qt::Key_Escape);
    EXPECT_FALSE(dialog.isVisible());
}

}  // namespace
}  // namespace pmts::gui
