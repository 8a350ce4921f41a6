#include "line/line_workspace.hpp"

#include "bench_fixture.hpp"
#include "window/listed_page.hpp"
#include "window/message_area.hpp"

#include <QApplication>
#include <QLabel>
#include <QListWidget>
#include <QTest>

namespace pmts::gui {
namespace {

class LineWorkspaceTest : public test::WindowFixture {
protected:
    LineWorkspaceTest()
        : line(*window->findChild<LineWorkspace*>()), pages(*line.findChild<QListWidget*>(QStringLiteral("line_pages"))) {
        window->resize(1280, 800);
        window->show();
        window->activateWindow();
        QApplication::setActiveWindow(&*window);
    }

    void openLine() { QTest::keyClick(&*window, Qt::Key_5, Qt::ControlModifier); }

    LineWorkspace& line;
    QListWidget& pages;
};

TEST_F(LineWorkspaceTest, ControlFiveShowsTheLine) {
    EXPECT_FALSE(line.isVisible());
    openLine();
    EXPECT_TRUE(line.isVisible());
}

TEST_F(LineWorkspaceTest, EachPageOpensByItsNameAndHasARowForAGlovedFinger) {
    openLine();
    for (int row = 0; row < pages.count(); ++row) {
        pages.setCurrentRow(row);
        ListedPage* const page = line.current();
        ASSERT_NE(page, nullptr);
        EXPECT_TRUE(page->isVisible()) << page->title().toStdString();
        EXPECT_EQ(pages.item(row)->text(), page->title());
        EXPECT_GE(pages.item(row)->sizeHint().height(), 44);
        EXPECT_LE(pages.fontMetrics().horizontalAdvance(page->title()), pages.width() - 40);
        line.openPage(page->objectName());
        EXPECT_EQ(pages.currentRow(), row);
    }
}

TEST_F(LineWorkspaceTest, NoPageMakesTheWindowWiderThanATablet) {
    openLine();
    for (int row = 0; row < pages.count(); ++row) {
        pages.setCurrentRow(row);
        QCoreApplication::processEvents();
        EXPECT_LE(window->width(), 1280) << pages.item(row)->text().toStdString();
        EXPECT_LE(window->height(), 800) << pages.item(row)->text().toStdString();
    }
}

TEST_F(LineWorkspaceTest, GoodNewsIsSeenWhereNoLiveViewIs) {
    openLine();
    bench->messages.toast(QStringLiteral("2 planned points imported from DEMO1."));
    const auto* const toast = line.findChild<Toast*>();
    ASSERT_NE(toast, nullptr);
    EXPECT_TRUE(toast->isVisible());
    EXPECT_EQ(toast->findChild<QLabel*>()->text(), QStringLiteral("2 planned points imported from DEMO1."));
}

}  // namespace
}  // namespace pmts::gui
