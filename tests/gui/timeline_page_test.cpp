#include "line/timeline_page.hpp"

#include "line/timeline_view.hpp"

#include "pmts/core/virtual_clock.hpp"
#include "pmts/gui/theme.hpp"

#include <QCheckBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

using namespace std::chrono_literals;

class TimelinePageTest : public testing::Test {
protected:
    TimelinePageTest() {
        clock.advance(10s);
        timeline.setUnits(protocol::WireUnits());
        for (int i = 0; i < 8; ++i) {
            add(1s * i, "RG,7\r", "7=10.2345\r\n");
        }
        auto lost = exchange(8s, "RG,8\r", "", 1s);
        lost.outcome = scheduler::Outcome::kTimedOut;
        timeline.addTransaction(lost);
        page.resize(1100, 640);
        page.show();
        page.entered();
    }
    static scheduler::TransactionRecord exchange(core::Duration at, std::string sent, std::string received, core::Duration took) {
        scheduler::TransactionRecord record;
        record.sent = std::move(sent);
        record.received = std::move(received);
        record.queued_at = at;
        record.sent_at = at + 100ms;
        record.finished_at = at + 100ms + took;
        return record;
    }
    void add(core::Duration at, const std::string& sent, const std::string& received) {
        timeline.addTransaction(exchange(at, sent, received, 300ms));
    }
    template <class Widget>
    Widget& part(const char* name) {
        return *page.findChild<Widget*>(QLatin1String(name));
    }
    /// The middle of an event's bar in a lane.
    QPoint placeOf(Lane lane, core::Duration at) {
        const TimelineLayout layout = view.layoutNow();
        return QPointF(layout.x(at), layout.lane(lane).center().y()).toPoint();
    }
    QString csv() {
        return QString::fromUtf8(saved(QStringLiteral("t.csv")));
    }
    QByteArray saved(const QString& name) {
        const QString path = folder.filePath(name);
        page.save(path);
        QCoreApplication::processEvents();  // the end is told by the loop
        EXPECT_TRUE(part<QLabel>("timeline_said").text().endsWith(QStringLiteral("is written.")));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    }

    core::VirtualClock clock;
    app::Timeline timeline{clock};
    QTemporaryDir folder;
    TimelinePage page{timeline, nullptr, app::Threading::kCallersThread};
    TimelineView& view = part<TimelineView>("timeline_view");
};

TEST_F(TimelinePageTest, AClickOnABarSaysEverythingAboutIt) {
    view.showAll();
    QTest::mouseClick(&view, Qt::LeftButton, {}, placeOf(Lane::kPmts, 3250ms));

    const QString said = part<QLabel>("timeline_details").text();
    for (const char* words : {"read HA", "HA 10.2345 gon", "Waited 100 ms", "300 ms on the wire", "RG,7<CR>", "7=10.2345<CR><LF>"}) {
        EXPECT_TRUE(said.contains(QLatin1String(words))) << words << " in " << said.toStdString();
    }
    EXPECT_EQ(part<QTableView>("timeline_table").currentIndex().row(), 3);
}

TEST_F(TimelinePageTest, AWaitIsAnEventOfItsOwnLane) {
    view.showAll();
    ASSERT_NE(view.eventAt(placeOf(Lane::kWait, 3050ms)), nullptr);
    EXPECT_EQ(view.eventAt(placeOf(Lane::kWait, 3050ms))->began, core::Duration(3s));
    EXPECT_EQ(view.eventAt(placeOf(Lane::kWait, 3250ms)), nullptr);
    EXPECT_EQ(view.eventAt(placeOf(Lane::kPanel, 3250ms)), nullptr);
}

TEST_F(TimelinePageTest, ALineOfTheTableIsShownInTheLanes) {
    view.setFollowing(false);
    view.zoomBy(50.0);
    part<QTableView>("timeline_table").setCurrentIndex(part<QTableView>("timeline_table").model()->index(2, 0));

    EXPECT_EQ(view.chosen(), 2U);
    EXPECT_LT(view.shownFrom(), core::Duration(2100ms));
    EXPECT_GT(view.shownTo(), core::Duration(2100ms));
}

TEST_F(TimelinePageTest, TheKeyLPausesAndFollowsAndTheNewestStaysAtTheEdge) {
    EXPECT_TRUE(view.isFollowing());
    EXPECT_GT(view.shownTo(), clock.now());
    page.activateWindow();
    QApplication::setActiveWindow(&page);
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_L);
    EXPECT_FALSE(view.isFollowing());
    const core::Duration stands = view.shownFrom();
    clock.advance(5s);
    EXPECT_EQ(view.shownFrom(), stands);
    QTest::keyClick(&view, Qt::Key_L);
    EXPECT_TRUE(view.isFollowing());
    EXPECT_GT(view.shownTo(), clock.now());
}

TEST_F(TimelinePageTest, KeysPanAndZoomInsteadOfTurningTheInstrument) {
    view.setFollowing(false);
    const core::Duration before = view.shownFrom();
    QTest::keyClick(&view, Qt::Key_Left);
    EXPECT_LT(view.shownFrom(), before);
    const auto span = view.shownTo() - view.shownFrom();
    QTest::keyClick(&view, Qt::Key_Plus);
    EXPECT_LT(view.shownTo() - view.shownFrom(), span);
    QKeyEvent override(QEvent::ShortcutOverride, Qt::Key_Up, Qt::NoModifier);
    override.ignore();
    QCoreApplication::sendEvent(&view, &override);
    EXPECT_TRUE(override.isAccepted());
}

TEST_F(TimelinePageTest, TheWheelHoldsWhatIsUnderThePointerAndADragPans) {
    view.showAll();
    const QPoint at = placeOf(Lane::kPmts, 3s);
    QWheelEvent wheel(at, view.mapToGlobal(at), {}, {0, 360}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &wheel);
    EXPECT_NEAR(placeOf(Lane::kPmts, 3s).x(), at.x(), 1);
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    QTest::mouseMove(&view, at + QPoint(60, 0));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at + QPoint(60, 0));
    EXPECT_NEAR(placeOf(Lane::kPmts, 3s).x(), at.x() + 60, 2);
}

TEST_F(TimelinePageTest, OnlyProblemsOrOnlyATextAreListed) {
    auto& table = part<QTableView>("timeline_table");
    EXPECT_EQ(table.model()->rowCount(), 9);
    part<QCheckBox>("timeline_problems").setChecked(true);
    ASSERT_EQ(table.model()->rowCount(), 1);
    EXPECT_EQ(table.model()->index(0, app::Timeline::kWhat).data().toString(), QStringLiteral("read VA"));
    part<QCheckBox>("timeline_problems").setChecked(false);
    part<QLineEdit>("timeline_filter").setText(QStringLiteral("10.2345 GON"));
    EXPECT_EQ(table.model()->rowCount(), 8);
}

TEST_F(TimelinePageTest, TheTableIsWrittenWithBytesAndMilliseconds) {
    part<QCheckBox>("timeline_problems").setChecked(true);
    const QStringList lines = csv().trimmed().split(u'\n');
    ASSERT_EQ(lines.size(), 2);
    EXPECT_TRUE(lines[1].contains(QStringLiteral(",100.000,1000.000,0,"))) << lines[1].toStdString();
    EXPECT_TRUE(lines[1].contains(QStringLiteral("RG,8<CR>")));
}

TEST_F(TimelinePageTest, TheLanesAreWrittenAsPictureAndDrawing) {
    view.showAll();
    EXPECT_EQ(QImage::fromData(saved(QStringLiteral("t.png"))).width(), 1600);
    EXPECT_TRUE(saved(QStringLiteral("t.svg")).contains("Video pauses")) << "texts stay texts";
}

TEST_F(TimelinePageTest, WhyAFileCouldNotBeWrittenIsSaid) {
    page.save(QStringLiteral("/proc/none/t.png"));
    QCoreApplication::processEvents();
    const QString said = part<QLabel>("timeline_said").text();
    EXPECT_TRUE(said.contains(QStringLiteral("t.png"))) << said.toStdString();
    EXPECT_FALSE(said.contains(QStringLiteral("is written")));
}

TEST_F(TimelinePageTest, WhatCameUnaskedHasALaneIsListedAndIsWritten) {
    timeline.addUnasked({.bytes = "7=10.0000\r\n8=99.0000\r\n", .at = 9200ms});
    timeline.addStreamReading({.ha = core::Angle::fromGon(177.56115), .va = core::Angle::fromGon(96.16838)}, 9400ms);
    timeline.addAir(18.5, std::nullopt, 9600ms);
    view.showAll();

    const app::LineEvent* const block = view.eventAt(placeOf(Lane::kUnasked, 9200ms));
    ASSERT_NE(block, nullptr);
    EXPECT_EQ(block->kind, app::LineEvent::Kind::kUnasked);
    EXPECT_EQ(view.eventAt(placeOf(Lane::kPmts, 9400ms)), nullptr);
    part<QLineEdit>("timeline_filter").setText(QStringLiteral("177.56115"));
    EXPECT_EQ(part<QTableView>("timeline_table").model()->rowCount(), 1);
    part<QLineEdit>("timeline_filter").clear();
    const QString table = csv();
    EXPECT_TRUE(table.contains(QStringLiteral("\"7=10.0000<CR><LF>8=99.0000<CR><LF>\",unasked\n"))) << table.right(400).toStdString();
    EXPECT_TRUE(table.contains(QStringLiteral("HA 177.56115 gon, VA 96.16838 gon")));
    EXPECT_TRUE(table.contains(QStringLiteral("Air: 18.5 °C.")));
}

TEST_F(TimelinePageTest, MissingRecordsAreMarkedThroughAllLanes) {
    view.showAll();
    const auto columnOf = [this](core::Duration at) {
        const QImage picture = view.grab().toImage();
        const int x = placeOf(Lane::kPmts, at).x();
        return picture.copy(x, static_cast<int>(view.layoutNow().axisHeight()), 12, picture.height());
    };
    const QImage before = columnOf(9300ms);
    timeline.addMissing(5, 9200ms, 9600ms);
    const QImage after = columnOf(9300ms);
    for (const Lane lane : {Lane::kPanel, Lane::kUnasked, Lane::kPicture}) {
        const int y = static_cast<int>(view.layoutNow().lane(lane).top() - view.layoutNow().axisHeight());
        EXPECT_NE(before.copy(0, y, 12, 15), after.copy(0, y, 12, 15)) << static_cast<int>(lane);
    }
}

TEST_F(TimelinePageTest, AFailureHasAShapeOfItsOwnNotOnlyAColour) {
    const auto ink = [this](core::Duration at) {
        view.showAll();
        const QImage picture = view.grab().toImage();
        const QPoint middle = placeOf(Lane::kPmts, at);
        const QImage grey = picture.copy(QRect(middle.x() - 4, middle.y() - 7, 22, 14)).convertToFormat(QImage::Format_Grayscale8);
        int edges = 0;
        for (int y = 0; y < grey.height(); ++y) {
            for (int x = 1; x < grey.width(); ++x) {
                edges += std::abs(qGray(grey.pixel(x, y)) - qGray(grey.pixel(x - 1, y))) > 60 ? 1 : 0;
            }
        }
        return edges;
    };
    EXPECT_GT(ink(8100ms), ink(3100ms) + 10) << "seen without colours";
}

TEST_F(TimelinePageTest, WhatFallsIntoOnePixelIsPaintedOnceHoweverManyThereAre) {  // bench/gui holds the time of it
    for (int i = 0; i < 20000; ++i) {
        add(10s + 50ms * i, "RG,7\r", "7=1.0\r\n");
        timeline.addFrame(10s + 33ms * i, static_cast<std::uint64_t>(i + 1), 0);
    }
    clock.advance(1000s);
    view.showAll();
    const QByteArray drawing = view.drawing();
    const auto elements = drawing.count("<rect") + drawing.count("<path") + drawing.count("<polyline");
    EXPECT_GT(elements, 500) << "something is shown";
    EXPECT_LT(elements, 4 * 2 * 1600) << "two marks a pixel in each of four lanes, not 80 000";
}

}  // namespace
}  // namespace pmts::gui
