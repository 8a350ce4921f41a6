#include "pmts/app/desk/job_desk.hpp"

#include "pmts/app/desk/frame_image.hpp"
#include "pmts/app/field/photo_export.hpp"
#include "pmts/job/export.hpp"
#include "pmts/job/planned_import.hpp"

#include <QCoreApplication>
#include <QFileInfo>

namespace pmts::app {

namespace {

const char* const kMetaKeys[] = {"next_point_id", "last_code"};

core::Result<JobContents> contentsOf(const job::Job& job) {
    JobContents contents{.path = job.path(), .name = job.name(), .points = {}, .station = {}, .photos = {}, .planned = {}, .meta = {}};
    auto points = job.points();
    auto station = job.station();
    auto photos = job.photos();
    auto planned = job.planned();
    PMTS_TRY(points);
    PMTS_TRY(station);
    PMTS_TRY(photos);
    PMTS_TRY(planned);
    contents.points = *std::move(points);
    contents.station = *std::move(station);
    contents.photos = *std::move(photos);
    contents.planned = *std::move(planned);
    for (const char* key : kMetaKeys) {
        if (const auto value = job.meta(QLatin1String(key)); value && !value->isEmpty()) {
            contents.meta.insert(QLatin1String(key), *value);
        }
    }
    return contents;
}

job::Evidence encodedEvidence(const EvidenceShots& shots) {
    job::Evidence evidence = shots.evidence;
    evidence.before.encoded_image = encodedImage(shots.before, "JPG");
    evidence.after.encoded_image = encodedImage(shots.after, "JPG");
    return evidence;
}

core::Error noJob() {
    return {.kind = core::ErrorKind::kFile,
            .happened = QCoreApplication::translate("JobDesk", "No job is open."),
            .remedy = QCoreApplication::translate("JobDesk", "Open a job or create one."),
            .info_code = std::nullopt,
            .detail = {}};
}

}  // namespace

/// Owns the job file on the job thread. Outcomes go back to the desk through its event loop.
class JobDesk::Worker : public QObject {
public:
    explicit Worker(JobDesk& desk) : desk_(desk) {}

    void open(const QString& path, bool may_create, bool must_create) {
        job_.reset();  // the lock of the old file goes first: it may be the same file
        const bool create = must_create || (may_create && !QFileInfo::exists(path));
        auto job = create ? job::Job::create(path) : job::Job::open(path);
        auto contents = job ? contentsOf(**job) : core::Result<JobContents>(tl::unexpected(job.error()));
        if (!contents) {
            return say([path, error = contents.error()](JobDesk& desk) { desk.showFailedOpen(path, error); });
        }
        job_ = *std::move(job);
        say([contents = *std::move(contents)](JobDesk& desk) { desk.showOpened(contents); });
    }

    void close() {
        job_.reset();
        say([](JobDesk& desk) { desk.showClosed(); });
    }

    /// Runs a request on the open job and reports its value, or its error.
    template <class Request, class Report>
    void run(Ticket ticket, Request request, Report report) {
        auto outcome = job_ ? request(*job_) : decltype(request(*job_))(tl::unexpected(noJob()));
        if (!outcome) {
            return say([ticket, error = outcome.error()](JobDesk& desk) { Q_EMIT desk.requestFailed(ticket, error); });
        }
        if constexpr (std::is_void_v<typename decltype(outcome)::value_type>) {
            say(std::move(report));
        } else {
            say([report = std::move(report), value = *std::move(outcome)](JobDesk& desk) { report(desk, value); });
        }
    }

private:
    template <class Words>
    void say(Words words) {
        QMetaObject::invokeMethod(&desk_, [&desk = desk_, words = std::move(words)] { words(desk); }, Qt::QueuedConnection);
    }

    JobDesk& desk_;
    std::unique_ptr<job::Job> job_;
};

JobDesk::JobDesk(Threading threading, QObject* parent) : QObject(parent), worker_(std::make_unique<Worker>(*this)) {
    if (threading == Threading::kOwnThread) {
        thread_.setObjectName(QStringLiteral("job"));
        worker_->moveToThread(&thread_);
        thread_.start();
    }
}

JobDesk::~JobDesk() {
    if (thread_.isRunning()) {
        // Behind everything that is queued: the last records are written before the thread ends.
        QMetaObject::invokeMethod(worker_.get(), [this] { thread_.quit(); }, Qt::QueuedConnection);
        thread_.wait();
    }
}

Ticket JobDesk::post(std::function<void(Worker&, Ticket)> request) {
    const Ticket ticket = ++last_ticket_;
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get(), ticket, request = std::move(request)] { request(*worker, ticket); },
        Qt::QueuedConnection);
    return ticket;
}

Ticket JobDesk::record(const survey::Point& point, std::optional<EvidenceShots> evidence) {
    return post([point, evidence = std::move(evidence)](Worker& worker, Ticket ticket) {
        const auto store = [&](job::Job& job) {
            return job.record(point, evidence ? std::optional(encodedEvidence(*evidence)) : std::nullopt);
        };
        worker.run(ticket, store,
                   [ticket](JobDesk& desk, const survey::Point& stored) { Q_EMIT desk.recorded(ticket, stored); });
    });
}

Ticket JobDesk::update(const std::vector<survey::Point>& points) {
    return post([points](Worker& worker, Ticket ticket) {
        worker.run(ticket, [&points](job::Job& job) { return job.update(points); },
                   [ticket, points](JobDesk& desk) { Q_EMIT desk.updated(ticket, points); });
    });
}

Ticket JobDesk::setStation(const survey::Station& station, const std::vector<survey::Point>& recomputed) {
    return post([station, recomputed](Worker& worker, Ticket ticket) {
        worker.run(ticket, [&](job::Job& job) { return job.setStation(station, recomputed); },
                   [ticket, station](JobDesk& desk) { Q_EMIT desk.stationStored(ticket, station); });
    });
}

Ticket JobDesk::updateCoordinates(const std::vector<survey::Point>& points) {
    return post([points](Worker& worker, Ticket ticket) {
        worker.run(ticket, [&points](job::Job& job) { return job.updateCoordinates(points); },
                   [ticket, points](JobDesk& desk) { Q_EMIT desk.updated(ticket, points); });
    });
}

Ticket JobDesk::addPhoto(const job::Photo& photo, const QImage& image) {
    return post([photo, image](Worker& worker, Ticket ticket) {
        const auto add = [&](job::Job& job) {
            job::Photo encoded = photo;
            encoded.encoded_image = encodedImage(image, "JPG");
            return job.addPhoto(encoded);
        };
        worker.run(ticket, add, [ticket](JobDesk& desk, const job::Photo& stored) { Q_EMIT desk.photoAdded(ticket, stored); });
    });
}

Ticket JobDesk::loadEvidence(qint64 point_row) {
    return post([point_row](Worker& worker, Ticket ticket) {
        worker.run(ticket, [=](job::Job& job) { return job.evidenceOf(point_row); },
                   [=](JobDesk& desk, const std::optional<job::Evidence>& evidence) {
                       Q_EMIT desk.evidenceLoaded(ticket, point_row, evidence);
                   });
    });
}

Ticket JobDesk::addMark(const job::ImageMark& mark) {
    return post([mark](Worker& worker, Ticket ticket) {
        worker.run(ticket, [&mark](job::Job& job) { return job.addMark(mark); },
                   [ticket](JobDesk& desk, const job::ImageMark& stored) { Q_EMIT desk.markAdded(ticket, stored); });
    });
}

Ticket JobDesk::updateMark(const job::ImageMark& mark) {
    return post([mark](Worker& worker, Ticket ticket) {
        worker.run(ticket, [&mark](job::Job& job) { return job.updateMark(mark); },
                   [ticket, mark](JobDesk& desk) { Q_EMIT desk.markUpdated(ticket, mark); });
    });
}

Ticket JobDesk::removeMark(qint64 row_id) {
    return post([row_id](Worker& worker, Ticket ticket) {
        worker.run(ticket, [row_id](job::Job& job) { return job.removeMark(row_id); },
                   [ticket, row_id](JobDesk& desk) { Q_EMIT desk.markRemoved(ticket, row_id); });
    });
}

Ticket JobDesk::loadMarks(qint64 photo_row) {
    return post([photo_row](Worker& worker, Ticket ticket) {
        worker.run(ticket, [photo_row](job::Job& job) { return job.marksOf(photo_row); },
                   [=](JobDesk& desk, const std::vector<job::ImageMark>& marks) {
                       Q_EMIT desk.marksLoaded(ticket, photo_row, marks);
                   });
    });
}

Ticket JobDesk::importPlanned(const QString& path) {
    return post([path](Worker& worker, Ticket ticket) {
        const auto import = [&path](job::Job& job) -> core::Result<std::vector<survey::PlannedPoint>> {
            const auto points = job::plannedFromFile(path);
            PMTS_TRY(points);
            return job.addPlanned(*points);
        };
        worker.run(ticket, import, [ticket](JobDesk& desk, const std::vector<survey::PlannedPoint>& stored) {
            Q_EMIT desk.plannedAdded(ticket, stored);
        });
    });
}

Ticket JobDesk::addPlanned(const std::vector<survey::PlannedPoint>& points) {
    return post([points](Worker& worker, Ticket ticket) {
        worker.run(ticket, [&points](job::Job& job) { return job.addPlanned(points); },
                   [ticket](JobDesk& desk, const std::vector<survey::PlannedPoint>& stored) {
                       Q_EMIT desk.plannedAdded(ticket, stored);
                   });
    });
}

Ticket JobDesk::removePlanned(const std::vector<qint64>& row_ids) {
    return post([row_ids](Worker& worker, Ticket ticket) {
        worker.run(ticket, [&row_ids](job::Job& job) { return job.removePlanned(row_ids); },
                   [ticket, row_ids](JobDesk& desk) { Q_EMIT desk.plannedRemoved(ticket, row_ids); });
    });
}

Ticket JobDesk::loadPhoto(qint64 row_id) {
    return post([row_id](Worker& worker, Ticket ticket) {
        const auto load = [row_id](job::Job& job) -> core::Result<QImage> {
            const auto bytes = job.photoImage(row_id);
            PMTS_TRY(bytes);
            const QImage image = QImage::fromData(*bytes);
            if (image.isNull()) {
                return core::fail(core::ErrorKind::kFile, QCoreApplication::translate("JobDesk", "The photo is damaged."),
                                  QCoreApplication::translate("JobDesk", "Choose another one."));
            }
            return image;
        };
        worker.run(ticket, load, [ticket](JobDesk& desk, const QImage& image) { Q_EMIT desk.photoLoaded(ticket, image); });
    });
}

Ticket JobDesk::exportPoints(const QString& path) {
    return post([path](Worker& worker, Ticket ticket) {
        const auto write = [&path](job::Job& job) -> core::Result<void> {
            const auto format = job::exportFormatFromPath(path);
            PMTS_TRY(format);
            const auto points = job.points();
            PMTS_TRY(points);
            return job::exportPoints(*points, path, *format);
        };
        worker.run(ticket, write, [ticket, path](JobDesk& desk) { Q_EMIT desk.exported(ticket, path); });
    });
}

Ticket JobDesk::listPhotos() {
    return post([](Worker& worker, Ticket ticket) {
        worker.run(ticket, [](job::Job& job) { return job.photos(); },
                   [ticket](JobDesk& desk, const std::vector<job::Photo>& photos) { Q_EMIT desk.photosListed(ticket, photos); });
    });
}

Ticket JobDesk::exportPhoto(const job::Photo& photo, const QString& folder) {
    return post([photo, folder, path = path_](Worker& worker, Ticket ticket) {
        const auto write = [&](job::Job& job) -> core::Result<void> {
            if (job.path() != path) {  // another job by now: the row number is not of its photos
                return core::cancelled();
            }
            auto bytes = job.photoImage(photo.row_id);
            PMTS_TRY(bytes);
            job::Photo whole = photo;
            whole.encoded_image = *std::move(bytes);
            PMTS_TRY(job::writePhotoFile(photoFileOf(whole), folder));
            return {};
        };
        worker.run(ticket, write, [ticket](JobDesk& desk) { Q_EMIT desk.photoExported(ticket); });
    });
}

void JobDesk::setMeta(const QString& key, const QString& value) {
    post([key, value](Worker& worker, Ticket ticket) {
        worker.run(ticket, [&](job::Job& job) { return job.setMeta(key, value); }, [](JobDesk&) {});
    });
}

void JobDesk::log(const job::LogEntry& entry) {
    post([entry](Worker& worker, Ticket ticket) {
        worker.run(ticket, [&](job::Job& job) { return job.log(entry); }, [](JobDesk&) {});
    });
}

void JobDesk::create(const QString& path) {
    post([path](Worker& worker, Ticket) { worker.open(path, true, true); });
}

void JobDesk::open(const QString& path) {
    post([path](Worker& worker, Ticket) { worker.open(path, false, false); });
}

void JobDesk::openOrCreate(const QString& path) {
    post([path](Worker& worker, Ticket) { worker.open(path, true, false); });
}

void JobDesk::close() {
    post([](Worker& worker, Ticket) { worker.close(); });
}

void JobDesk::showOpened(const JobContents& contents) {
    path_ = contents.path;
    name_ = contents.name;
    Q_EMIT opened(contents);
}

void JobDesk::showFailedOpen(const QString& path, const core::Error& error) {
    showClosed();
    Q_EMIT openFailed(path, error);
}

void JobDesk::showClosed() {
    if (isOpen()) {
        path_.clear();
        name_.clear();
        Q_EMIT closed();
    }
}

}  // namespace pmts::app
