#include "field/points_page.hpp"

#include "bench_fixture.hpp"

#include <QApplication>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolButton>

namespace pmts::gui {
namespace {

using app::PointsModel;

survey::Point point(qint64 row_id, const char* id, double e_m) {
    survey::Point made;
    made.row_id = row_id;
    made.id = QString::fromLatin1(id);
    made.code = QStringLiteral("WALL");
    made.observation.slope_distance_m = 23.418;
    made.coordinates = {
        .e_m = e_m, .n_m = 1000.0, .h_m = 100.0, .sigma_e_m = 0.002, .sigma_n_m = 0.002, .sigma_h_m = 0.002};
    return made;
}

class PointsPageTest : public test::WindowFixture {
protected:
    PointsPageTest() : page(bench->points, bench->undo) {
        page.resize(600, 300);
        page.show();
        for (const auto& recorded :
             {point(11, "104", 1003.0), point(12, "9", 1001.0), point(13, "20", 1002.0)}) {
            bench->points.addRecorded(recorded);
        }
    }

    [[nodiscard]] QTableView* table() const { return page.findChild<QTableView*>(); }
    [[nodiscard]] QString idInRow(int row) const {
        return table()->model()->index(row, PointsModel::kId).data().toString();
    }
    [[nodiscard]] QPoint placeOf(int row, int column) const {
        return table()->visualRect(table()->model()->index(row, column)).center();
    }
    void clickRow(int row) const {
        QTest::mouseClick(table()->viewport(), Qt::LeftButton, {}, placeOf(row, PointsModel::kId));
    }

    PointsPage page;
};

TEST_F(PointsPageTest, ShowsPointsInOrderOfRecording) {
    EXPECT_EQ(idInRow(0), QStringLiteral("104"));
    EXPECT_EQ(idInRow(2), QStringLiteral("20"));
}

TEST_F(PointsPageTest, SortsCoordinatesAsNumbers) {
    table()->sortByColumn(PointsModel::kEasting, Qt::AscendingOrder);
    EXPECT_EQ(idInRow(0), QStringLiteral("9"));
    EXPECT_EQ(idInRow(2), QStringLiteral("104"));
}

TEST_F(PointsPageTest, DoubleClickTurnsToThePointAlsoWhenSorted) {
    QSignalSpy turn(&page, &PointsPage::turnRequested);
    table()->sortByColumn(PointsModel::kEasting, Qt::AscendingOrder);
    clickRow(0);
    QTest::mouseDClick(table()->viewport(), Qt::LeftButton, {}, placeOf(0, PointsModel::kId));
    ASSERT_GE(turn.count(), 1);
    EXPECT_EQ(turn.first().first().toLongLong(), 12);
}

TEST_F(PointsPageTest, EditedIdIsKeptAndUndone) {
    clickRow(1);
    QTest::mouseClick(page.findChild<QToolButton*>(QStringLiteral("edit")), Qt::LeftButton);
    auto* const editor = table()->findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("9a"));
    QTest::keyClick(editor, Qt::Key_Return);
    QCoreApplication::sendPostedEvents();  // the delegate commits through the event loop
    EXPECT_EQ(bench->points.find(12)->id, QStringLiteral("9a"));
    bench->undo.undo();
    EXPECT_EQ(bench->points.find(12)->id, QStringLiteral("9"));
}

TEST_F(PointsPageTest, StrikingOutIsOneStepAndCanBeTakenBack) {
    clickRow(0);
    QTest::mouseClick(page.findChild<QToolButton*>(QStringLiteral("strike")), Qt::LeftButton);
    EXPECT_TRUE(bench->points.find(11)->struck_out);
    QTest::mouseClick(page.findChild<QToolButton*>(QStringLiteral("undo")), Qt::LeftButton);
    EXPECT_FALSE(bench->points.find(11)->struck_out);
}

TEST_F(PointsPageTest, NothingSelectedMeansNothingToTurnTo) {
    table()->clearSelection();
    EXPECT_FALSE(page.findChild<QToolButton*>(QStringLiteral("turn"))->isEnabled());
}

TEST_F(PointsPageTest, SelectionIsToldForPlanAndPicture) {
    QSignalSpy selected(&page, &PointsPage::pointSelected);
    page.selectPoint(13);
    ASSERT_EQ(selected.count(), 1);
    EXPECT_EQ(selected.first().first().toLongLong(), 13);
}

}  // namespace
}  // namespace pmts::gui
