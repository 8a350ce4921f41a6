#include "bench_fixture.hpp"
#include "field/depth_popup.hpp"
#include "field/field_actions.hpp"
#include "field/field_workspace.hpp"
#include "field/live_panel.hpp"
#include "field/range_dialog.hpp"
#include "test_frame.hpp"
#include "field/zoom_box_page.hpp"

#include <QDialogButtonBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

namespace pmts::gui {
namespace {

class FieldToolsTest : public test::WindowFixture {
protected:
    FieldToolsTest() {
        window->setWindowState(Qt::WindowNoState);
        window->resize(1280, 800);
        window->show();
        QCoreApplication::processEvents();
    }
};

TEST_F(FieldToolsTest, RangeTextIsAButtonThatOpensTheRange) {
    auto* const button = window->field().findChild<QToolButton*>(QStringLiteral("range"));
    EXPECT_TRUE(button->text().contains(QStringLiteral("(assumed)")));
    button->click();
    auto* const dialog = window->findChild<RangeDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QLineEdit*>(QStringLiteral("assumed"))->setText(QStringLiteral("40 m"));
    dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
    EXPECT_FALSE(dialog->isVisible());
    EXPECT_TRUE(button->text().contains(QStringLiteral("40.000 m (assumed)")));
}

TEST_F(FieldToolsTest, RefusedRangeStaysOpenAndSaysWhy) {
    RangeDialog dialog(bench->ranges, bench->preferences.units());
    dialog.show();
    dialog.findChild<QLineEdit*>(QStringLiteral("far_end"))->setText(QStringLiteral("1 m"));
    dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
    EXPECT_TRUE(dialog.isVisible());
    auto* const problem = dialog.findChild<QLabel*>(QStringLiteral("problem"));
    EXPECT_TRUE(problem->isVisible());
    EXPECT_TRUE(problem->text().contains(QStringLiteral("far end")));
}

TEST_F(FieldToolsTest, SlidersSetNearAndFarAndNeverCross) {
    DepthPopup popup(bench->ranges);
    popup.findChild<QSlider*>(QStringLiteral("near"))->setValue(80);
    EXPECT_NEAR(bench->preferences.settings().image_tools.depth.near_m.value(), 100.0, 1e-6);
    popup.findChild<QSlider*>(QStringLiteral("far"))->setValue(60);
    const auto& depth = bench->preferences.settings().image_tools.depth;
    EXPECT_LT(depth.near_m.value(), depth.far_m.value());
    QTest::mouseClick(popup.findChild<QPushButton*>(), Qt::LeftButton);
    EXPECT_EQ(depth, app::DepthFilter{});
}

TEST_F(FieldToolsTest, ZoomBoxShowsThatPartAndItsClicksArePixelsOfThePicture) {
    ZoomBoxPage page;
    page.resize(400, 320);
    page.QWidget::show();
    page.open(app::Picture::kLive, QRectF(600, 300, 40, 30));
    page.show(test::frameWithBluePixel(620, 315), {});
    const PartView& view = page.view();
    EXPECT_NEAR(view.imageFromWidget(QPointF(view.width(), view.height()) / 2).x(), 620.0, 1e-9);
    EXPECT_GE(view.scale(), 9.0);
    QSignalSpy clicked(&view, &ImageView::pixelClicked);
    const QPointF at = view.widgetFromImage(QPointF(610.25, 310.5));
    QTest::mouseClick(&page.view(), Qt::LeftButton, {}, at.toPoint());
    ASSERT_EQ(clicked.count(), 1);
    EXPECT_NEAR(clicked[0][0].toPointF().x(), 610.25, 0.15);
}

TEST_F(FieldToolsTest, SnapIsAKeyAndAButtonAndIsKept) {
    auto* const button = window->findChild<QToolButton*>(QStringLiteral("snap"));
    EXPECT_EQ(button->defaultAction(), window->actions().snap);
    window->actions().snap->trigger();
    EXPECT_TRUE(bench->snap.isOn());
    EXPECT_TRUE(button->isChecked());
}

TEST_F(FieldToolsTest, OnlyOneToolIsInHandAndASecondPressPutsItAway) {
    const FieldActions& actions = window->actions();
    actions.mark->trigger();
    actions.zoom_box->trigger();
    EXPECT_FALSE(actions.mark->isChecked());
    actions.zoom_box->trigger();
    EXPECT_FALSE(actions.zoom_box->isChecked());
}

}  // namespace
}  // namespace pmts::gui
