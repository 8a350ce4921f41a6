#include "line/workbench_page.hpp"

#include "bench_fixture.hpp"
#include "line/line_workspace.hpp"
#include "pmts/protocol/instruction_table.hpp"
#include "window/progress_overlay.hpp"
#include "protocol/sampled_line.hpp"
#include "line/signal_view.hpp"
#include "support/run_until.hpp"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QInputDialog>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTableWidget>
#include <QTest>
#include <QUrl>

namespace pmts::gui {
namespace {

class WorkbenchPageTest : public test::WindowFixture {
protected:
    WorkbenchPageTest() : line(*window->findChild<LineWorkspace*>()), page(*window->findChild<WorkbenchPage*>()) {
        window->setWindowState(Qt::WindowNoState);
        window->resize(1280, 800);
        window->show();
        window->activateWindow();
        QApplication::setActiveWindow(&*window);
        QTest::keyClick(&*window, Qt::Key_5, Qt::ControlModifier);
        line.openPage(QStringLiteral("workbench_page"));
        QCoreApplication::processEvents();
    }
    template <class T>
    [[nodiscard]] T& part(const char* name) const {
        return *page.findChild<T*>(QLatin1String(name));
    }
    [[nodiscard]] app::LineBenchPresenter& lab() { return bench->line_bench; }
    /// Ends with the work in the pool, by its signal.
    void finish() {
        EXPECT_TRUE(test::runUntil([this] { return !lab().isBusy(); }));
        QCoreApplication::processEvents();
    }
    void importThesis() {
        lab().import(QStringLiteral(PMTS_TEST_DATA "/bus-capture.txt"));
        finish();
    }
    QString write(const char* name, const std::string& bytes) {
        QFile file(folder.filePath(QLatin1String(name)));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes.data(), static_cast<qint64>(bytes.size()));
        return file.fileName();
    }
    [[nodiscard]] std::string text(int row, int column) const {
        return part<QTableView>("bench_talk").model()->index(row, column).data().toString().toStdString();
    }

    LineWorkspace& line;
    WorkbenchPage& page;
};

TEST_F(WorkbenchPageTest, DroppedCaptureShowsPinsFramingTextAndBytes) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QStringLiteral(PMTS_TEST_DATA "/bus-capture.txt"))});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&page, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&page, &drop);
    finish();
    auto& pins = part<QTableWidget>("bench_pins");
    ASSERT_EQ(pins.rowCount(), 5);
    EXPECT_EQ(pins.currentRow(), 4);
    EXPECT_THAT(pins.item(4, 1)->text().toStdString(), testing::HasSubstr("data"));
    EXPECT_THAT(part<QComboBox>("bench_scores").currentText().toStdString(), testing::HasSubstr("8N1"));
    EXPECT_EQ(text(0, app::TalkModel::kText), "A,166=96.16838<CR>");
    EXPECT_THAT(text(0, app::TalkModel::kHex), testing::StartsWith("41 2C 31"));
}

TEST_F(WorkbenchPageTest, EnterInThePanelsFieldListsCandidatesAndTheChosenOneIsNamed) {
    importThesis();
    auto& panel = part<QLineEdit>("bench_panel");
    panel.setFocus();
    QTest::keyClicks(&panel, QStringLiteral("86.33.06"));
    QTest::keyClick(&panel, Qt::Key_Return);
    finish();
    auto& matches = part<QTableWidget>("bench_matches");
    ASSERT_GT(matches.rowCount(), 0);
    EXPECT_EQ(matches.item(0, 0)->text(), QStringLiteral("A,166"));
    EXPECT_EQ(matches.item(0, 1)->text(), QStringLiteral("86.33.06"));
    part<QLineEdit>("bench_name").setText(QStringLiteral("VA"));
    QTest::mouseClick(&part<QPushButton>("bench_keep_name"), Qt::LeftButton);
    EXPECT_EQ(lab().names().of(QStringLiteral("A,166")), QStringLiteral("VA"));
    EXPECT_THAT(matches.item(0, 0)->text().toStdString(), testing::HasSubstr("VA"));
}

TEST_F(WorkbenchPageTest, ControlFAndEnterFindTheNextPlaceAndTheTimeLineFollows) {
    importThesis();
    QTest::keyClick(&page, Qt::Key_F, Qt::ControlModifier);
    auto& search = part<QLineEdit>("bench_search");
    ASSERT_TRUE(search.hasFocus());
    QTest::keyClicks(&search, QStringLiteral("165="));
    QTest::keyClick(&search, Qt::Key_Return);
    EXPECT_EQ(part<QTableView>("bench_talk").currentIndex().row(), 1);
    auto& signal = part<SignalView>("bench_signal");
    const double shown = signal.width() * signal.samplesPerPixel();
    EXPECT_LT(shown, 1000) << "of 2857 samples";
    QTest::keyClicks(&search, QStringLiteral("9"));
    QTest::keyClick(&page, Qt::Key_F3);
    EXPECT_THAT(part<QLabel>("bench_search_sentence").text().toStdString(), testing::HasSubstr("165=9"));
}

TEST_F(WorkbenchPageTest, FramingIsChangedByHandAndFoundAgain) {
    importThesis();
    auto& order = part<QComboBox>("bench_order");
    order.setCurrentIndex(1);
    Q_EMIT order.activated(1);
    finish();
    EXPECT_NE(text(0, app::TalkModel::kText), "A,166=96.16838<CR>");
    auto& scores = part<QComboBox>("bench_scores");
    scores.setCurrentIndex(0);
    Q_EMIT scores.activated(0);
    finish();
    EXPECT_EQ(text(0, app::TalkModel::kText), "A,166=96.16838<CR>");
    EXPECT_EQ(order.currentIndex(), 0);
}

TEST_F(WorkbenchPageTest, DoubtfulCharactersHaveMarksInTextBytesAndColumn) {
    std::string said;
    for (int i = 0; i < 40; ++i) {
        said += "A,166=96.16838\rA,165=177.56115\x04";
    }
    lab().import(write("noisy.bin", protocol::test::samplesOf(said, {.samples_per_bit = 5.0, .flipped = 0.02})));
    finish();
    int doubtful = 0;
    for (int row = 0; row < lab().talk().rowCount(); ++row) {
        if (!text(row, app::TalkModel::kDoubt).empty()) {
            ++doubtful;
            EXPECT_THAT(text(row, app::TalkModel::kText), testing::HasSubstr("[?"));
            EXPECT_THAT(text(row, app::TalkModel::kHex), testing::HasSubstr("?"));
        }
    }
    EXPECT_GT(doubtful, 0);
    EXPECT_THAT(part<QLabel>("bench_summary").text().toStdString(), testing::HasSubstr("not sure"));
}

TEST_F(WorkbenchPageTest, ReadingShowsItsReasonAndCanBeCancelled) {
    importThesis();
    auto& progress = *page.findChild<ProgressOverlay*>();
    EXPECT_FALSE(progress.isVisible());
    lab().import(write("line.bin", protocol::test::samplesOf("A,166=96.16838\r", {})));
    EXPECT_TRUE(progress.isVisible());
    EXPECT_THAT(progress.findChild<QLabel*>(QStringLiteral("text"))->text().toStdString(), testing::HasSubstr("line.bin"));
    EXPECT_FALSE(part<QPushButton>("bench_import").isEnabled());
    QTest::mouseClick(progress.findChild<QPushButton*>(QStringLiteral("cancel")), Qt::LeftButton);
    finish();
    EXPECT_FALSE(progress.isVisible());
    EXPECT_EQ(text(0, app::TalkModel::kText), "A,166=96.16838<CR>");
    EXPECT_EQ(lab().talk().rowCount(), 2) << "the thesis's block is still there";
}

/// The first bytes mislead; the second guess is the person's.
TEST_F(WorkbenchPageTest, AFileThatWasTakenForAnotherKindIsReadAgainAsWhatItIs) {
    importThesis();
    lab().import(write("looks_like.zip", "PK" + protocol::test::samplesOf("A,166=96.16838\rA,165=177.56115\x04", {})));
    finish();
    ASSERT_EQ(lab().state(), app::DeviceState::kFailed);
    auto& format = part<QComboBox>("bench_format");
    auto& rate = part<QLineEdit>("bench_rate");
    ASSERT_TRUE(format.isEnabled() && rate.isEnabled());
    format.setCurrentIndex(1 + static_cast<int>(protocol::CaptureFormat::kSamples));
    rate.setFocus();
    QTest::keyClicks(&rate, QStringLiteral("1,5 MHz"));
    QTest::keyClick(&rate, Qt::Key_Return);
    finish();
    ASSERT_NE(lab().state(), app::DeviceState::kFailed);
    EXPECT_TRUE(lab().findings()->recording->path.endsWith(QStringLiteral("looks_like.zip")));
    EXPECT_EQ(lab().findings()->recording->samples_per_s, 1.5e6);
}

TEST_F(WorkbenchPageTest, ARateThatIsNoneGivesASentenceAndReadsNothing) {
    importThesis();
    const auto shown = lab().findings();
    QSignalSpy toasts(&bench->messages, &app::MessageCentre::toastShown);
    auto& rate = part<QLineEdit>("bench_rate");
    rate.setFocus();
    QTest::keyClicks(&rate, QStringLiteral("fast"));
    QTest::keyClick(&rate, Qt::Key_Return);
    finish();
    ASSERT_EQ(toasts.count(), 1);
    EXPECT_THAT(toasts[0][0].value<app::Message>().happened.toStdString(), testing::HasSubstr("1 MHz"));
    EXPECT_EQ(lab().findings(), shown);
}

TEST_F(WorkbenchPageTest, WithoutARecordingThereIsNothingToCompareOrReadAgain) {
    EXPECT_FALSE(part<QPushButton>("bench_compare").isEnabled());
    EXPECT_FALSE(part<QLineEdit>("bench_panel").isEnabled());
    EXPECT_FALSE(part<QComboBox>("bench_format").isEnabled());
    importThesis();
    EXPECT_TRUE(part<QPushButton>("bench_compare").isEnabled());
    EXPECT_TRUE(part<QComboBox>("bench_format").isEnabled());
}

/// Answers the dialogs that the page opens one after the other: a name, then a file.
class DialogAnswers : public QObject {
public:
    DialogAnswers(QString name, QString file) : name_(std::move(name)), file_(std::move(file)) { startTimer(10); }

protected:
    void timerEvent(QTimerEvent*) override {
        auto* const dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (auto* const name = qobject_cast<QInputDialog*>(dialog)) {
            name->setTextValue(name_);
            dialog->accept();
        } else if (auto* const file = qobject_cast<QFileDialog*>(dialog)) {
            file->selectFile(file_);
            dialog->accept();
        }
    }

private:
    QString name_, file_;
};

TEST_F(WorkbenchPageTest, SaveAsTableAsksForANameAndAPlaceAndWritesATableThatIsAccepted) {
    lab().import(write("session.log", "# PMTS session log 1\n@ 2026-06-01T06:00:00.000Z /dev/ttyUSB0 at 9600 8N1\n"
                                      "       0.000 > WV,102=0\\r\n      52.083 < 0.8\\r\\x04\n"));
    finish();
    const QString target = folder.filePath(QStringLiteral("seen.txt"));
    {
        const DialogAnswers answers(QStringLiteral("laser_seen"), target);
        QTest::mouseClick(&part<QPushButton>("bench_save"), Qt::LeftButton);
    }
    finish();
    QFile file(target);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const auto table = protocol::readInstructionTable(file.readAll().toStdString());
    EXPECT_TRUE(table.problems.empty());
    ASSERT_NE(table.find("laser_seen"), nullptr);
    EXPECT_EQ(table.find("laser_seen")->steps.at(0).text, "WV,102=0");
}

TEST_F(WorkbenchPageTest, BadFileGivesASentence) {
    lab().import(write("photo.zip", "PK\x03\x04 something else"));
    finish();
    ASSERT_FALSE(bench->messages.bars().empty());
    EXPECT_THAT(bench->messages.bars().back().happened.toStdString(), testing::HasSubstr("no sigrok session"));
    EXPECT_EQ(lab().state(), app::DeviceState::kFailed);
}

TEST_F(WorkbenchPageTest, TimeLineZoomsAboutTheWheelPansAndFits) {
    importThesis();
    auto& signal = part<SignalView>("bench_signal");
    const double whole = signal.samplesPerPixel();
    const double under = signal.firstSample() + 300 * whole;
    QWheelEvent wheel(QPointF(300, 40), signal.mapToGlobal(QPointF(300, 40)), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&signal, &wheel);
    EXPECT_LT(signal.samplesPerPixel(), whole);
    EXPECT_NEAR(signal.firstSample() + 300 * signal.samplesPerPixel(), under, 1.0);
    signal.setFocus();
    const double first = signal.firstSample();
    QTest::keyClick(&signal, Qt::Key_Right);
    EXPECT_GT(signal.firstSample(), first);
    QTest::keyClick(&signal, Qt::Key_Home);
    EXPECT_DOUBLE_EQ(signal.samplesPerPixel(), whole);
}

TEST_F(WorkbenchPageTest, ClickInTheTimeLineChoosesTheLineThatWasSaidThere) {
    importThesis();
    auto& signal = part<SignalView>("bench_signal");
    const auto& second = lab().findings()->characters[15];
    const double x = (static_cast<double>(second.sample) + 20 - signal.firstSample()) / signal.samplesPerPixel();
    QTest::mouseClick(&signal, Qt::LeftButton, {}, QPoint(static_cast<int>(x), 40));
    EXPECT_EQ(part<QTableView>("bench_talk").currentIndex().row(), 1);
}

TEST_F(WorkbenchPageTest, MainButtonsAreLargeEnoughForGloves) {
    for (const char* name : {"bench_import", "bench_save", "bench_previous", "bench_next", "bench_compare", "bench_keep_name"}) {
        EXPECT_GE(part<QPushButton>(name).height(), 44) << name;
    }
}

}  // namespace
}  // namespace pmts::gui
