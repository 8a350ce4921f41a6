#include "pmts/app/line/bug_report_presenter.hpp"

#include "field_fixture.hpp"
#include "pmts/blackbox/recording.hpp"
#include "support/run_until.hpp"

#include <QFile>
#include <QThreadPool>
#include <gmock/gmock.h>

#include <future>

namespace pmts::app {
namespace {

using blackbox::Kind;

class BugReportTest : public FieldTest {
protected:
    BugReportTest() {
        report.names = {.home = QStringLiteral("/home/meier"), .user = QStringLiteral("meier"), .host = QStringLiteral("tripod-7"),
                        .job_folder = {}, .data_folder = {}};
        QFile file(logPath());
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("2026-06-01T06:00:00.000Z info pmts.job opened /home/meier/jobs/a.gpkg on tripod-7\n");
        Settings settings = preferences.settings();
        settings.last_job = QStringLiteral("/media/stick/Anna Beispiel/wall.gpkg");
        settings.camera.location = QStringLiteral("rtsp://meier:secret@192.168.1.4/live");
        preferences.set(settings);
    }
    [[nodiscard]] QString logPath() const { return folder.filePath(QStringLiteral("pmts.log")); }

    void startBox() {
        black_box.start();
        black_box.noteAction(QStringLiteral("Open /home/meier/jobs/a.gpkg"), QStringLiteral("by Meier on TRIPOD-7"));
        black_box.noteAction(QStringLiteral("Export to /media/stick/Anna Beispiel/out.csv"), QStringLiteral("action"));
        black_box.noteAction(QStringLiteral("Job in %1").arg(jobPath()), QStringLiteral("action"));
        messages.toast(QStringLiteral("Saved to %1").arg(logPath()));
        black_box.waitUntilWritten();
    }
    bool prepare(const BugReportOrder& order = {}) {
        report.prepare(order);
        EXPECT_TRUE(report.isBusy());
        EXPECT_TRUE(test::runUntil([this] { return !report.isBusy(); }));
        return report.report().has_value();
    }
    core::Result<void> write(const QString& path) {
        std::optional<core::Error> error;
        const auto failure = QObject::connect(&report, &BugReportPresenter::failed, [&](const core::Error& why) { error = why; });
        report.write(path);
        EXPECT_TRUE(test::runUntil([this] { return !report.isBusy(); }));
        QObject::disconnect(failure);
        return error ? core::Result<void>(tl::unexpected(*error)) : core::Result<void>();
    }
    [[nodiscard]] QByteArray written() {
        const QString path = folder.filePath(QStringLiteral("report.zip"));
        EXPECT_TRUE(write(path).has_value());
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    }

    BlackBoxPresenter black_box{folder.filePath(QStringLiteral("box")), preferences, messages, clock};
    BugReportPresenter report{black_box, preferences, job_desk, logPath(), clock};
};

TEST_F(BugReportTest, NoHomeNoUserNoHostNoFolderAndNoPasswordIsInTheArchive) {
    openJob();
    startBox();
    ASSERT_TRUE(prepare({.minutes = 10, .pictures = true, .words = QStringLiteral("meier saw it in /home/meier/x")}));

    const QByteArray archive = written().toLower();
    const QByteArray folder_name = folder.path().toUtf8().toLower();
    for (const QByteArray& secret : {QByteArray("meier"), QByteArray("tripod-7"), QByteArray("anna beispiel"),
                                     QByteArray("/media/stick"), QByteArray("secret"), folder_name}) {
        EXPECT_FALSE(archive.contains(secret)) << secret.toStdString();
    }
    for (const char* kept : {"<home>/jobs/a.gpkg", "<job folder>/wall.gpkg", "<job folder>/out.csv", "<user>", "<host>", "192.168.1.4/live"}) {
        EXPECT_TRUE(archive.contains(kept)) << kept;
    }
}

TEST_F(BugReportTest, NeitherLoginsNorFoldersOfOthersAreInTheRecording) {
    const QString address = QStringLiteral("rtsp://berta:geheim@192.168.1.9/live");
    const QString place = QStringLiteral("/mnt/Vermessung Berta/plan.csv");
    LogModel log{QString()};
    black_box.watch(log);
    black_box.start();
    log.append({.utc = clock.utcNow(), .level = QtWarningMsg, .category = {}, .text = QStringLiteral("%1 and %2").arg(address, place)});
    messages.toast(QStringLiteral("The camera %1 is gone; %2 is read.").arg(address, place));
    messages.warn(QStringLiteral("No picture from %1.").arg(address), QStringLiteral("Look at %1.").arg(place));
    black_box.noteAction(place, address);
    black_box.waitUntilWritten();
    ASSERT_TRUE(prepare());

    const QByteArray box = report.report()->files.back().bytes;
    const QString path = folder.filePath(QStringLiteral("last.pmtsbox"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(box);
    file.close();
    const auto opened = blackbox::Recording::open(path);
    ASSERT_TRUE(opened.has_value());
    int cameras = 0, plans = 0;
    for (const blackbox::Entry& entry : (*opened)->entries()) {
        const QByteArray body = (*opened)->bodyBytes(entry);
        EXPECT_FALSE(body.contains("geheim") || body.contains("berta") || body.contains("Berta")) << body.toStdString();
        cameras += static_cast<int>(body.count("rtsp://<login>@192.168.1.9/live"));
        plans += static_cast<int>(body.count("<folder>/plan.csv"));
    }
    EXPECT_GE(cameras, 4) << "log, toast, bar and action are there";
    EXPECT_GE(plans, 4);
}

TEST_F(BugReportTest, ItIsShownBeforeItIsWritten) {
    startBox();
    EXPECT_FALSE(write(folder.filePath(QStringLiteral("early.zip"))).has_value());
    ASSERT_TRUE(prepare({.minutes = 10, .pictures = true, .words = QStringLiteral("It stood still.")}));

    ASSERT_EQ(report.report()->inside.size(), 4);
    EXPECT_TRUE(report.report()->files[1].bytes.contains("black_box/on = true")) << "the settings are readable";
    EXPECT_TRUE(report.report()->inside[0].startsWith(QStringLiteral("report.txt")));
    EXPECT_TRUE(report.report()->overview.contains(QStringLiteral("It stood still.")));
    EXPECT_TRUE(report.report()->overview.contains(QStringLiteral("3 clicks and actions")));
    report.forget();
    EXPECT_FALSE(report.report().has_value());
}

TEST_F(BugReportTest, TheRecordingInItOpensAsABlackBox) {
    startBox();
    ASSERT_TRUE(prepare());
    const QString path = folder.filePath(QStringLiteral("last.pmtsbox"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(report.report()->files.back().bytes);
    file.close();

    const auto opened = blackbox::Recording::open(path);
    ASSERT_TRUE(opened.has_value());
    EXPECT_EQ((*opened)->entries().front().kind, Kind::kSession);
    EXPECT_TRUE((*opened)->damages().empty());
}

TEST_F(BugReportTest, AClockThatWasSetLeavesNoFileOfTheRunOut) {
    black_box.start();
    int file_number = 0;
    for (const std::chrono::hours jump : {std::chrono::hours(0), std::chrono::hours(-30 * 24), std::chrono::hours(60 * 24)}) {
        clock.setTimeOfDayBy(jump);
        black_box.startAgain();
        black_box.noteAction(QStringLiteral("action %1").arg(++file_number), {});
        black_box.waitUntilWritten();
        clock.advance(10s);
    }
    ASSERT_TRUE(prepare());
    const QByteArray box = report.report()->files.back().bytes;
    qsizetype last = -1;
    for (int i = 1; i <= file_number; ++i) {
        const qsizetype at = box.indexOf("action " + QByteArray::number(i));
        EXPECT_GT(at, last) << i;
        last = at;
    }
}

TEST_F(BugReportTest, WithoutARecordingItSaysSo) {
    EXPECT_FALSE(prepare());
    EXPECT_FALSE(report.isBusy());
}

TEST_F(BugReportTest, ACancelledOneIsNotShown) {
    startBox();
    report.prepare({});
    report.cancel();
    EXPECT_FALSE(report.isBusy());
    ASSERT_TRUE(prepare({.minutes = 5, .pictures = false, .words = QStringLiteral("second")}));
    EXPECT_TRUE(report.report()->overview.contains(QStringLiteral("second")));
}

TEST_F(BugReportTest, ItIsWrittenBesideTheWorkAndACancelledOneLeavesNoFile) {
    startBox();
    ASSERT_TRUE(prepare());
    const QString path = folder.filePath(QStringLiteral("report.zip"));
    QThreadPool& pool = *QThreadPool::globalInstance();
    const int threads = pool.maxThreadCount();
    pool.setMaxThreadCount(1);
    std::promise<void> release;
    pool.start([released = release.get_future().share()] { released.wait(); });
    report.write(path);
    EXPECT_TRUE(report.isWriting()) << "not on this thread";
    report.cancel();
    EXPECT_FALSE(report.isBusy());
    release.set_value();
    pool.setMaxThreadCount(threads);
    bool is_told = false;
    QObject::connect(&report, &BugReportPresenter::written, [&is_told] { is_told = true; });
    ASSERT_TRUE(test::runUntil([] { return QThreadPool::globalInstance()->activeThreadCount() == 0; }));
    core::deliverQueuedEvents();
    EXPECT_FALSE(is_told);
    EXPECT_FALSE(QFile::exists(path));
    EXPECT_TRUE(report.report().has_value()) << "what was shown stays";
    EXPECT_FALSE(written().isEmpty());
}

TEST_F(BugReportTest, AFolderThatCannotBeWrittenIsSaid) {
    startBox();
    ASSERT_TRUE(prepare());
    const auto outcome = write(QStringLiteral("/proc/none/report.zip"));
    ASSERT_FALSE(outcome.has_value());
    EXPECT_FALSE(outcome.error().remedy.isEmpty());
}

TEST(PersonalNamesTest, OfThisComputerAreFound) {
    const PersonalNames names = PersonalNames::ofThisComputer();
    EXPECT_FALSE(names.home.isEmpty());
    EXPECT_FALSE(names.user.isEmpty());
    EXPECT_FALSE(names.host.isEmpty());
}

}  // namespace
}  // namespace pmts::app
