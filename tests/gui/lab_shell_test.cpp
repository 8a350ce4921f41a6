#include "bench_fixture.hpp"
#include "field/field_actions.hpp"
#include "field/image_view.hpp"
#include "lab/lab_step.hpp"
#include "lab/lab_workspace.hpp"
#include "field/live_panel.hpp"
#include "picture_source.hpp"

#include <QApplication>
#include <QCheckBox>
#include <QListWidget>
#include <QScrollArea>
#include <QTest>

namespace pmts::gui {
namespace {

class LabShellTest : public test::WindowFixture {
protected:
    LabShellTest() : lab(*window->findChild<LabWorkspace*>()), steps(*lab.findChild<QListWidget*>(QStringLiteral("lab_steps"))) {
        bench->live.setSource(std::make_unique<test::PictureSource>());
        window->resize(1280, 800);
        window->show();
        window->activateWindow();
        QApplication::setActiveWindow(&*window);
    }

    void openLab() { QTest::keyClick(&*window, Qt::Key_4, Qt::ControlModifier); }
    void clickPicture() {
        ImageView& view = lab.live().view();
        QTest::mouseClick(&view, Qt::LeftButton, {}, view.rect().center());
    }

    LabWorkspace& lab;
    QListWidget& steps;
};

TEST_F(LabShellTest, ControlFourShowsTheLaboratory) {
    EXPECT_FALSE(lab.isVisible());
    openLab();
    EXPECT_TRUE(lab.isVisible());
    EXPECT_TRUE(window->actions().lab->shortcuts().contains(QKeySequence(Qt::CTRL | Qt::Key_4)));
}

TEST_F(LabShellTest, StepsStandInTheOrderOfTheWork) {
    QStringList titles;
    for (int row = 0; row < steps.count(); ++row) {
        titles << steps.item(row)->text();
        EXPECT_GE(steps.item(row)->sizeHint().height(), 44) << "for gloves";
        EXPECT_LE(steps.fontMetrics().horizontalAdvance(titles.back()), steps.width() - 40) << titles.back().toStdString();
    }
    EXPECT_EQ(titles.mid(0, 5), QStringList({"Camera", "Mount", "Twist", "Parallax", "Table"}));
    EXPECT_EQ(titles.last(), QStringLiteral("Report"));
}

TEST_F(LabShellTest, EveryStepIsAsWideAsItsPlace) {
    openLab();
    for (int row = 0; row < steps.count(); ++row) {
        steps.setCurrentRow(row);
        QCoreApplication::processEvents();
        const auto* const area = qobject_cast<QScrollArea*>(lab.current()->parentWidget()->parentWidget());
        ASSERT_NE(area, nullptr);
        EXPECT_LE(lab.current()->width(), area->viewport()->width()) << steps.item(row)->text().toStdString();
    }
}

TEST_F(LabShellTest, ClickGoesToTheStepFirst) {
    openLab();
    lab.openStep(QStringLiteral("camera_step"));
    clickPicture();
    EXPECT_TRUE(bench->camera.box()) << "the sharpness is measured there";
    EXPECT_FALSE(bench->targeting.target());
}

TEST_F(LabShellTest, ClickAStepHasNoUseForAims) {
    openLab();
    lab.openStep(QStringLiteral("mount"));
    clickPicture();
    EXPECT_TRUE(bench->targeting.target());
    EXPECT_FALSE(bench->camera.box());
}

TEST_F(LabShellTest, StepLeftIsNoLongerAsked) {
    openLab();
    lab.findChild<QCheckBox*>(QStringLiteral("burnt"))->setChecked(true);
    EXPECT_TRUE(bench->camera.showsBurnt());
    lab.openStep(QStringLiteral("report"));
    EXPECT_FALSE(bench->camera.showsBurnt());
}

}  // namespace
}  // namespace pmts::gui
