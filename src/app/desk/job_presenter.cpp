#include "pmts/app/desk/job_presenter.hpp"

#include <QFileInfo>

namespace pmts::app {

namespace {
constexpr int kRecentJobs = 8;
const QString kTopic = QStringLiteral("job");
}  // namespace

JobPresenter::JobPresenter(JobDesk& job, Preferences& preferences, MessageCentre& messages, QObject* parent)
    : QObject(parent), job_(job), preferences_(preferences), messages_(messages) {
    connect(&job_, &JobDesk::opened, this, &JobPresenter::onOpened);
    connect(&job_, &JobDesk::closed, this, &JobPresenter::jobChanged);
    connect(&job_, &JobDesk::openFailed, this, [this](const QString&, const core::Error& error) {
        messages_.report(error, MessageAction::kOpenJob, kTopic);
        messages_.cue(Cue::kFailed);
    });
    connect(&job_, &JobDesk::exported, this, [this](Ticket, const QString& path) {
        messages_.solve(QStringLiteral("export"));
        messages_.toast(tr("Points exported to %1.").arg(QFileInfo(path).fileName()));
        Q_EMIT exported(path);
    });
    connect(&job_, &JobDesk::requestFailed, this, [this](Ticket ticket, const core::Error& error) {
        if (ticket == export_ticket_) {
            messages_.report(error, MessageAction::kNone, QStringLiteral("export"));
        }
    });
}

QStringList JobPresenter::recentJobs() const { return preferences_.settings().recent_jobs; }

QString JobPresenter::exportFilter() {
    return tr("Comma separated values (*.csv);;GeoJSON (*.geojson);;Drawing exchange (*.dxf)");
}

void JobPresenter::createJob(const QString& path) { job_.create(path); }

void JobPresenter::openJob(const QString& path) { job_.open(path); }

void JobPresenter::closeJob() { job_.close(); }

void JobPresenter::exportTo(const QString& path) { export_ticket_ = job_.exportPoints(path); }

void JobPresenter::onOpened(const JobContents& contents) {
    Settings next = preferences_.settings();
    next.last_job = contents.path;
    next.recent_jobs.removeAll(contents.path);
    next.recent_jobs.prepend(contents.path);
    next.recent_jobs = next.recent_jobs.mid(0, kRecentJobs);
    preferences_.set(next);
    messages_.solve(kTopic);
    Q_EMIT jobChanged();
}

}  // namespace pmts::app
