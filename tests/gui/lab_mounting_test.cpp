#include "lab/curve_plot.hpp"
#include "field/image_view.hpp"
#include "lab_fixture.hpp"
#include "lab/mount_step.hpp"
#include "lab/parallax_step.hpp"
#include "lab/table_step.hpp"
#include "lab/twist_step.hpp"

#include <QCheckBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>

namespace pmts::gui {
namespace {

class LabMountingTest : public test::LabFixture {
protected:
    [[nodiscard]] static std::string sentence(const LabStep* panel) { return child<QLabel>(panel, "step")->text().toStdString(); }
};

TEST_F(LabMountingTest, MountIsChosenByTheUserToo) {
    auto* const panel = step<MountStep>();
    EXPECT_TRUE(child<QPushButton>(panel, "telescope")->isChecked());
    child<QPushButton>(panel, "handle")->click();

    EXPECT_EQ(bench->live.model().rig().mount.kind, camera::MountKind::kHandle);
    EXPECT_TRUE(child<QPushButton>(panel, "handle")->isChecked());
    EXPECT_FALSE(child<QPushButton>(panel, "telescope")->isChecked());
}

TEST_F(LabMountingTest, MountCheckWithoutInstrumentSaysWhatItNeeds) {
    auto* const panel = step<MountStep>();
    child<QPushButton>(panel, "check")->click();

    EXPECT_THAT(sentence(panel), testing::HasSubstr("connect"));
}

TEST_F(LabMountingTest, TwistAsksForTheInstrumentAndOffersNothingYet) {
    auto* const panel = step<TwistStep>();

    EXPECT_THAT(sentence(panel), testing::HasSubstr("Connect the instrument"));
    EXPECT_FALSE(child<QPushButton>(panel, "verify")->isEnabled());
    EXPECT_FALSE(child<QPushButton>(panel, "accept")->isEnabled());
}

TEST_F(LabMountingTest, OffsetCaseIsChosenAndTheFirstOpenStepIsMarked) {
    auto* const panel = step<ParallaxStep>();
    child<QCheckBox>(panel, "y")->click();

    EXPECT_TRUE(bench->board_parallax.sought().y);
    EXPECT_THAT(child<QLabel>(panel, "steps")->text().toStdString(), testing::HasSubstr("▶ b"));
    EXPECT_FALSE(child<QPushButton>(panel, "accept")->isEnabled());
}

TEST_F(LabMountingTest, TableIsEditedAndARowThatFallsBackCannotBeAccepted) {
    auto* const panel = step<TableStep>();
    for (int i = 0; i < 4; ++i) {
        child<QPushButton>(panel, "add_row")->click();
    }
    auto* const rows = child<QTableWidget>(panel, "rows");
    ASSERT_EQ(rows->rowCount(), 5);
    EXPECT_TRUE(child<QPushButton>(panel, "accept")->isEnabled());
    rows->item(2, 1)->setText(QStringLiteral("0.1 gon"));

    EXPECT_FALSE(child<QPushButton>(panel, "accept")->isEnabled());
    EXPECT_THAT(child<QLabel>(panel, "rows_trouble")->text().toStdString(), testing::HasSubstr("Row 3"));
}

TEST_F(LabMountingTest, PlotsShowTheTableBesideTheIdealLineAndLens) {
    auto* const panel = step<TableStep>();
    for (const CurvePlot* const plot : panel->findChildren<CurvePlot*>()) {
        EXPECT_TRUE(plot->isEmpty()) << "says how to get rows";
    }
    for (int i = 0; i < 4; ++i) {
        child<QPushButton>(panel, "add_row")->click();
    }
    const QList<CurvePlot*> plots = panel->findChildren<CurvePlot*>();

    ASSERT_EQ(plots.size(), 2);
    EXPECT_EQ(plots[0]->curves().size() + plots[1]->curves().size(), 5U);
}

TEST_F(LabMountingTest, GridOfLinesIsDrawnOverThePicture) {
    QImage picture(1280, 720, QImage::Format_RGB32);
    picture.fill(Qt::gray);
    const QImage before = picture;
    QPainter painter(&picture);
    step<TableStep>()->paintOver(painter, QTransform());
    painter.end();

    EXPECT_NE(picture.pixel(643 + 30, 100), before.pixel(643 + 30, 100));  // a line, 30 px beside the principal point
    EXPECT_EQ(picture.pixel(643 + 45, 100 + 3), before.pixel(643 + 45, 100 + 3));
}

}  // namespace
}  // namespace pmts::gui
