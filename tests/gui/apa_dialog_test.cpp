#include "field/apa_dialog.hpp"

#include "bench_fixture.hpp"
#include "field/image_view.hpp"

#include <QLabel>
#include <QPushButton>
#include <QTest>

namespace pmts::gui {
namespace {

/// The dialog over a workbench without an instrument; a still is put before it by hand.
class ApaDialogTest : public test::WindowFixture {
protected:
    ApaDialogTest() {
        dialog.emplace(bench->apa, bench->instrument, bench->preferences);
        dialog->show();
    }
    template <class Widget>
    [[nodiscard]] Widget* child(const char* name) const {
        auto* const found = dialog->findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    void press(const char* button) const { QTest::mouseClick(child<QPushButton>(button), Qt::LeftButton); }
    void takeStill() {
        press("capture");
        auto frame = std::make_shared<camera::Frame>();
        frame->image = cv::Mat(720, 1280, CV_8UC3, cv::Scalar::all(90));
        Q_EMIT bench->live.stillCaptured({.number = 1, .frame = frame,
                                          .pointing = {core::Angle::fromGon(50), core::Angle::fromGon(100)},
                                          .ha_text = {}, .va_text = {}, .utc = {}, .photo_row_id = 0});
    }
    void clickPicture(const QPointF& px) const {
        auto* const picture = child<ImageView>("picture");
        QTest::mouseClick(picture, Qt::LeftButton, {}, picture->widgetFromImage(px).toPoint());
    }

    std::optional<ApaDialog> dialog;
};

TEST_F(ApaDialogTest, SaysTheNextStepAllTheWay) {
    EXPECT_THAT(child<QLabel>("step")->text().toStdString(), testing::HasSubstr("Take a still"));
    EXPECT_FALSE(child<QPushButton>("reading")->isEnabled());
    takeStill();
    EXPECT_THAT(child<QLabel>("step")->text().toStdString(), testing::HasSubstr("Click the left object"));
    clickPicture({80, 360});
    EXPECT_THAT(child<QLabel>("step")->text().toStdString(), testing::HasSubstr("take the reading"));
}

TEST_F(ApaDialogTest, ClickShowsColumnOrRowOfTheChosenObject) {
    takeStill();
    clickPicture({80, 360});
    EXPECT_TRUE(child<QLabel>("left_px")->text().startsWith(QStringLiteral("column ")));
    press("lower");
    clickPicture({640, 700});
    EXPECT_TRUE(child<QLabel>("lower_px")->text().startsWith(QStringLiteral("row ")));
    EXPECT_EQ(child<ImageView>("picture")->overlay().points.size(), 2U);
}

TEST_F(ApaDialogTest, RefusalIsSaidInTheDialog) {
    takeStill();
    press("reading");
    EXPECT_THAT(child<QLabel>("message")->text().toStdString(), testing::HasSubstr("not connected"));
    EXPECT_FALSE(child<QPushButton>("store")->isEnabled());
}

TEST_F(ApaDialogTest, ShowsWhatTheRigHasAlready) {
    EXPECT_THAT(child<QLabel>("kept")->text().toStdString(), testing::HasSubstr("no average pixel angle"));
    bench->preferences.setAveragePixelAngle({core::Angle::fromGon(0.0785), core::Angle::fromGon(0.0791)});
    EXPECT_THAT(child<QLabel>("kept")->text().toStdString(), testing::HasSubstr("0.07850 gon"));
}

TEST_F(ApaDialogTest, OpensFromTheMenuBesideTheWindow) {
    window->findChild<QAction*>(QStringLiteral("measure_apa"))->trigger();
    const auto* const opened = window->findChild<ApaDialog*>();
    ASSERT_NE(opened, nullptr);
    EXPECT_FALSE(opened->isModal());
    EXPECT_LE(opened->minimumSizeHint().height(), 740);
}

}  // namespace
}  // namespace pmts::gui
