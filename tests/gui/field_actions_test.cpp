#include "field/field_actions.hpp"

#include <QSet>
#include <QWidget>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

TEST(FieldActionsTest, KeysOfTheMainJobAreThoseOfTheThesis) {
    QWidget window;
    const FieldActions actions(&window);
    EXPECT_EQ(actions.capture->shortcut(), QKeySequence(Qt::Key_C));
    EXPECT_EQ(actions.move->shortcut(), QKeySequence(Qt::Key_Return));
    EXPECT_EQ(actions.measure->shortcut(), QKeySequence(Qt::Key_D));
    EXPECT_EQ(actions.convert->shortcut(), QKeySequence(Qt::Key_M));
    EXPECT_EQ(actions.record->shortcut(), QKeySequence(Qt::Key_R));
    EXPECT_EQ(actions.edit_point->shortcut(), QKeySequence(Qt::Key_P));
    EXPECT_EQ(actions.step->shortcut(), QKeySequence(Qt::Key_S));
    EXPECT_EQ(actions.all->shortcut(), QKeySequence(Qt::Key_Space));
    EXPECT_EQ(actions.stop->shortcut(), QKeySequence(Qt::Key_Escape));
}

TEST(FieldActionsTest, NoKeyMeansTwoThings) {
    QWidget window;
    const FieldActions actions(&window);
    QSet<QKeySequence> seen;
    for (const QAction* action : actions.withKeys()) {
        for (const QKeySequence& key : action->shortcuts()) {
            EXPECT_FALSE(seen.contains(key)) << key.toString().toStdString();
            seen.insert(key);
        }
    }
}

TEST(FieldActionsTest, AKeyHeldDownMovesOnce) {
    QWidget window;
    const FieldActions actions(&window);
    for (const QAction* arrow : {actions.left, actions.right, actions.up, actions.down, actions.move}) {
        EXPECT_FALSE(arrow->autoRepeat());
    }
}

TEST(BelongsToField, LettersDoEscapeAndControlKeysDoNot) {
    EXPECT_TRUE(belongsToField(Qt::Key_D, Qt::NoModifier));
    EXPECT_TRUE(belongsToField(Qt::Key_Space, Qt::NoModifier));
    EXPECT_TRUE(belongsToField(Qt::Key_Return, Qt::NoModifier));
    EXPECT_FALSE(belongsToField(Qt::Key_Escape, Qt::NoModifier));
    EXPECT_FALSE(belongsToField(Qt::Key_Z, Qt::ControlModifier));
    EXPECT_FALSE(belongsToField(Qt::Key_F1, Qt::NoModifier));
}

}  // namespace
}  // namespace pmts::gui
