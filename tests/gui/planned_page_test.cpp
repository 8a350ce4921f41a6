#include "field/planned_page.hpp"

#include "pmts/core/virtual_clock.hpp"

#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

class PlannedPageTest : public testing::Test {
protected:
    PlannedPageTest() {
        page.resize(500, 300);
        page.show();
        job.create(folder.filePath(QStringLiteral("wall.gpkg")));
        job.addPlanned({planned(QStringLiteral("P10"), 1030), planned(QStringLiteral("P2"), 1005)});
        core::deliverQueuedEvents();
    }
    ~PlannedPageTest() override { core::deliverQueuedEvents(); }

    static survey::PlannedPoint planned(const QString& id, double e_m) {
        survey::PlannedPoint point;
        point.id = id;
        point.e_m = e_m;
        return point;
    }
    [[nodiscard]] QTableView* table() const { return page.findChild<QTableView*>(); }
    [[nodiscard]] QToolButton* button(const char* name) const {
        return page.findChild<QToolButton*>(QLatin1String(name));
    }
    void clickRow(int row) const {
        const QModelIndex index = table()->model()->index(row, 0);
        QTest::mouseClick(table()->viewport(), Qt::LeftButton, {}, table()->visualRect(index).center());
    }

    QTemporaryDir folder;
    QUndoStack undo;
    app::Preferences preferences{QString()};
    app::MessageCentre messages;
    app::JobDesk job{app::Threading::kCallersThread};
    app::PlannedPointsModel model{job, preferences, messages, undo};
    PlannedPage page{model};
};

TEST_F(PlannedPageTest, DoubleClickTurnsToThePointAlsoWhenSorted) {
    QSignalSpy turn(&page, &PlannedPage::turnRequested);
    table()->sortByColumn(app::PlannedPointsModel::kEasting, Qt::AscendingOrder);
    clickRow(0);
    QTest::mouseDClick(table()->viewport(), Qt::LeftButton, {},
                       table()->visualRect(table()->model()->index(0, 0)).center());
    ASSERT_GE(turn.count(), 1);
    EXPECT_EQ(model.find(turn.first().first().toLongLong())->id, QStringLiteral("P2"));
}

TEST_F(PlannedPageTest, RemoveTakesTheSelectedOneAndUndoBringsItBack) {
    clickRow(0);
    QTest::mouseClick(button("remove"), Qt::LeftButton);
    core::deliverQueuedEvents();
    ASSERT_EQ(model.points().size(), 1U);
    EXPECT_EQ(model.points()[0].id, QStringLiteral("P2"));
    EXPECT_FALSE(button("turn")->isEnabled()) << "nothing is selected any more";
    undo.undo();
    core::deliverQueuedEvents();
    EXPECT_EQ(model.points().size(), 2U);
}

TEST_F(PlannedPageTest, SelectionIsToldForThePlan) {
    QSignalSpy selected(&page, &PlannedPage::pointSelected);
    page.selectPoint(model.points()[1].row_id);
    ASSERT_EQ(selected.count(), 1);
    EXPECT_EQ(page.selectedPoint(), model.points()[1].row_id);
}

TEST_F(PlannedPageTest, ImportAsksForAFile) {
    QSignalSpy import(&page, &PlannedPage::importRequested);
    QTest::mouseClick(button("import"), Qt::LeftButton);
    EXPECT_EQ(import.count(), 1);
}

}  // namespace
}  // namespace pmts::gui
