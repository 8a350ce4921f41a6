#include "pmts/app/line/bug_report_presenter.hpp"

#include "pmts/app/desk/whole_file.hpp"
#include "pmts/blackbox/run.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QPointer>
#include <QSettings>
#include <QSysInfo>
#include <QTemporaryDir>
#include <QThreadPool>

namespace pmts::app {

namespace {

constexpr qint64 kLogTail = 256 * 1024;

QString say(const char* text) { return QCoreApplication::translate("BugReport", text); }

/// What the pool needs: values only.
struct Work {
    QString newest;  ///< black box file
    QString folder;
    QString log_path;
    Settings settings;
    blackbox::Scrubber scrubber;
    BugReportOrder order;
    QDateTime utc;
    QString version;
};

/// The newest file and those of the same run before it: they share a clock.
core::Result<std::vector<std::shared_ptr<const blackbox::Recording>>> recordingsOf(const Work& work) {
    const QStringList paths = blackbox::recordingsIn(work.folder);
    const QString newest = work.newest.isEmpty() && !paths.isEmpty() ? paths.back() : work.newest;
    std::vector<std::shared_ptr<const blackbox::Recording>> recordings;
    for (const QString& path : blackbox::filesOfRun(newest)) {
        const auto opened = blackbox::Recording::open(path);
        if (!opened && path == newest) {
            return tl::unexpected(opened.error());
        }
        if (opened) {
            recordings.push_back(*opened);
        }
    }
    return recordings;
}

QByteArray settingsText(const Work& work) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("settings.ini"));
    if (!work.settings.save(path)) {
        return {};
    }
    const QSettings file(path, QSettings::IniFormat);
    QString text;
    for (const QString& name : file.allKeys()) {
        if (!name.startsWith(QLatin1String("job/")) && !name.startsWith(QLatin1String("window/"))) {
            const QVariant value = file.value(name);
            const bool is_list = value.typeId() == QMetaType::QStringList;
            const QString shown = is_list ? value.toStringList().join(QStringLiteral(", ")) : value.toString();
            text += name + QStringLiteral(" = ") + work.scrubber.scrubbed(shown) + u'\n';
        }
    }
    return text.toUtf8();
}

QByteArray logText(const Work& work) {
    QFile file(work.log_path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    if (file.size() > kLogTail) {
        file.seek(file.size() - kLogTail);
        file.readLine();
    }
    return work.scrubber.scrubbed(QString::fromUtf8(file.readAll())).toUtf8();
}

QString kindName(blackbox::Kind kind) {
    using enum blackbox::Kind;
    switch (kind) {
        case kSession: return say("begin of the program");
        case kBytes: return say("pieces of traffic, byte by byte");
        case kTransaction: return say("commands with their answers");
        case kFrame: return say("pictures of the live view, reduced");
        case kAction: return say("clicks and actions");
        case kAir: return say("air temperatures");
        case kLog: return say("lines of the log");
        case kControl: return say("changes of control");
        case kMessage: return say("messages");
        case kReading: return say("readings of circles and distances");
        case kConnection: return say("changes of the connection");
        case kTick: return say("times of pictures");
        case kLost: return say("notes of lost records");
        case kEnd: return say("end of the recording");
    }
    return say("other records");
}

QString sizeText(qsizetype bytes) {
    return bytes < 100000 ? say("%1 kB").arg(static_cast<double>(bytes) / 1e3, 0, 'f', 1)
                          : say("%1 MB").arg(static_cast<double>(bytes) / 1e6, 0, 'f', 1);
}

QString overviewText(const Work& work, const blackbox::Excerpt& excerpt) {
    QString text = say("Bug report of PMTS %1").arg(work.version) + u'\n';
    text += say("System: %1, %2 %3, Qt %4")
                .arg(QSysInfo::prettyProductName(), QSysInfo::kernelVersion(), QSysInfo::currentCpuArchitecture(),
                     QString::fromLatin1(qVersion())) + u'\n';
    text += say("From %1 to %2 (UTC)").arg(excerpt.from_utc.toString(Qt::ISODate), excerpt.to_utc.toString(Qt::ISODate)) + u'\n';
    for (const auto& [kind, count] : excerpt.records) {
        text += QStringLiteral("  %1 %2\n").arg(count, 7).arg(kindName(kind));
    }
    text += u'\n' + (work.order.words.isEmpty() ? say("Nothing was written about it.") : work.order.words) + u'\n';
    return work.scrubber.scrubbed(text);
}

core::Result<BugReport> putTogether(const Work& work) {
    const auto recordings = recordingsOf(work);
    PMTS_TRY(recordings);
    const blackbox::Excerpt excerpt = blackbox::excerptOf(
        *recordings, {.last = std::chrono::minutes(work.order.minutes), .pictures = work.order.pictures, .scrubber = work.scrubber});
    BugReport report;
    report.overview = overviewText(work, excerpt);
    report.files = {{QStringLiteral("report.txt"), report.overview.toUtf8()},
                    {QStringLiteral("settings.txt"), settingsText(work)},
                    {QStringLiteral("log.txt"), logText(work)},
                    {QStringLiteral("last-minutes.pmtsbox"), excerpt.bytes}};
    for (const blackbox::ZipEntry& file : report.files) {
        report.inside.append(say("%1, %2").arg(file.name, sizeText(file.bytes.size())));
    }
    return report;
}

}  // namespace

PersonalNames PersonalNames::ofThisComputer() {
    PersonalNames names;
    names.home = QDir::homePath();
    names.user = qEnvironmentVariable("USER", qEnvironmentVariable("LOGNAME", QDir(names.home).dirName()));
    names.host = QSysInfo::machineHostName();
    return names;
}

blackbox::Scrubber PersonalNames::scrubber() const {
    blackbox::Scrubber scrubber;
    scrubber.hide(home, QStringLiteral("<home>"));
    scrubber.hide(job_folder, QStringLiteral("<job folder>"));
    scrubber.hide(data_folder, QStringLiteral("<data folder>"));
    scrubber.hideWord(user, QStringLiteral("<user>"));
    scrubber.hideWord(host, QStringLiteral("<host>"));
    return scrubber;
}

BugReportPresenter::BugReportPresenter(BlackBoxPresenter& black_box, const Preferences& preferences, const JobDesk& job,
                                       QString log_path, const core::Clock& clock, QObject* parent)
    : QObject(parent), black_box_(black_box), preferences_(preferences), job_(job), log_path_(std::move(log_path)), clock_(clock) {}

BugReportPresenter::~BugReportPresenter() = default;

void BugReportPresenter::prepare(const BugReportOrder& order) {
    PersonalNames hidden = names;
    hidden.job_folder = job_.path().isEmpty() ? QString() : QFileInfo(job_.path()).absolutePath();
    hidden.data_folder = QFileInfo(log_path_).absolutePath();
    blackbox::Scrubber scrubber = hidden.scrubber();
    for (const QString& path : preferences_.settings().recent_jobs + QStringList(preferences_.settings().last_job)) {
        if (!path.isEmpty()) {
            scrubber.hide(QFileInfo(path).absolutePath(), QStringLiteral("<job folder>"));
        }
    }
    Work work{.newest = black_box_.path(), .folder = black_box_.folder(), .log_path = log_path_,
              .settings = preferences_.settings(), .scrubber = std::move(scrubber), .order = order, .utc = clock_.utcNow(),
              .version = QCoreApplication::applicationVersion()};
    const int number = ++wanted_;
    Q_EMIT busyChanged(true);
    QThreadPool::globalInstance()->start([self = QPointer(this), number, work = std::move(work)] {
        const auto outcome = putTogether(work);
        QMetaObject::invokeMethod(
            qApp, [self, number, outcome] {
                if (self) {
                    self->take(number, outcome);
                }
            },
            Qt::QueuedConnection);
    });
}

void BugReportPresenter::take(int number, const core::Result<BugReport>& outcome) {
    if (number != wanted_) {
        return;  // another order has overtaken it
    }
    done_ = number;
    report_.reset();
    if (outcome) {
        report_ = *outcome;
        Q_EMIT prepared();
    } else {
        Q_EMIT failed(outcome.error());
    }
    Q_EMIT busyChanged(false);
}

QString BugReportPresenter::usualName(const QDateTime& utc) {
    return QStringLiteral("pmts-report-%1.zip").arg(utc.toString(QStringLiteral("yyyyMMdd-HHmm")));
}

void BugReportPresenter::write(const QString& path) {
    if (!report_ || isBusy()) {
        const auto refused = core::fail(core::ErrorKind::kFile, tr("There is no report yet."), tr("Put it together first."));
        Q_EMIT failed(refused.value());
        return;
    }
    writing_ = std::make_shared<std::atomic<bool>>(false);
    Q_EMIT busyChanged(true);
    const auto onGuiThread = [self = QPointer(this)](auto action) {
        QMetaObject::invokeMethod(
            qApp,
            [self, action] {
                if (self) {
                    action(*self);
                }
            },
            Qt::QueuedConnection);
    };
    QThreadPool::globalInstance()->start([onGuiThread, stop = writing_, path, files = report_->files, utc = clock_.utcNow()] {
        const auto tell = [&](double done) {
            onGuiThread([stop, done](BugReportPresenter& self) {
                if (self.writing_ == stop) {
                    Q_EMIT self.writingProgressed(done);
                }
            });
            return !stop->load();
        };
        const auto outcome =
            writeWhole(path, [&](QIODevice& file) { return blackbox::writeZip(file, files, utc, tell); });
        onGuiThread([stop, path, outcome](BugReportPresenter& self) { self.endWriting(stop, path, outcome); });
    });
}

void BugReportPresenter::endWriting(const Stop& stop, const QString& path, const core::Result<void>& outcome) {
    if (writing_ != stop) {
        return;  // cancelled
    }
    writing_.reset();
    if (outcome) {
        Q_EMIT written(path);
    } else {
        Q_EMIT failed(outcome.error());
    }
    Q_EMIT busyChanged(isBusy());
}

void BugReportPresenter::cancel() {
    if (writing_) {
        writing_->store(true);
        writing_.reset();
    }
    done_ = ++wanted_;
    Q_EMIT busyChanged(false);
}

void BugReportPresenter::forget() {
    if (report_) {
        report_.reset();
        Q_EMIT busyChanged(isBusy());
    }
}

}  // namespace pmts::app
