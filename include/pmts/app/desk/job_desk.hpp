#pragma once

#include "pmts/app/field/evidence_shots.hpp"
#include "pmts/app/desk/threading.hpp"
#include "pmts/job/job.hpp"
#include "pmts/survey/point.hpp"
#include "pmts/survey/station.hpp"

#include <QImage>
#include <QMap>
#include <QObject>
#include <QThread>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace pmts::app {

/// What is in a job when it is opened.
struct JobContents {
    QString path;
    QString name;
    std::vector<survey::Point> points;
    survey::Station station;
    std::vector<job::Photo> photos;  ///< without image bytes
    std::vector<survey::PlannedPoint> planned;
    QMap<QString, QString> meta;
};

/// The job file as the GUI thread sees it. The file is used on the job thread only; every call returns at once.
/// recorded() comes only after the commit: what was acknowledged survives a kill. Each request ends in exactly one
/// outcome signal; with no job open that is requestFailed() with kFile.
class JobDesk : public QObject {
    Q_OBJECT
public:
    explicit JobDesk(Threading threading = Threading::kOwnThread, QObject* parent = nullptr);
    ~JobDesk() override;  ///< everything queued is written first

    [[nodiscard]] bool isOpen() const { return !path_.isEmpty(); }
    [[nodiscard]] QString path() const { return path_; }
    [[nodiscard]] QString name() const { return name_; }
    /// Of the newest request.
    [[nodiscard]] Ticket lastTicket() const { return last_ticket_; }

    /// With evidence of its aiming: both are written, or neither. Its pictures are encoded on the job thread.
    Ticket record(const survey::Point& point, std::optional<EvidenceShots> evidence = std::nullopt);
    Ticket loadEvidence(qint64 point_row);
    Ticket update(const std::vector<survey::Point>& points);
    Ticket updateCoordinates(const std::vector<survey::Point>& points);
    /// A station and the points that moved with it; points may be empty.
    Ticket setStation(const survey::Station& station, const std::vector<survey::Point>& recomputed = {});
    /// The image is encoded as JPEG on the job thread.
    Ticket addPhoto(const job::Photo& photo, const QImage& image);
    Ticket addMark(const job::ImageMark& mark);
    Ticket updateMark(const job::ImageMark& mark);
    Ticket removeMark(qint64 row_id);
    Ticket loadMarks(qint64 photo_row);
    /// Reads a CSV file (job/planned_import.hpp) and adds what is in it: all its points or none.
    Ticket importPlanned(const QString& path);
    Ticket addPlanned(const std::vector<survey::PlannedPoint>& points);
    Ticket removePlanned(const std::vector<qint64>& row_ids);
    /// The picture of a stored photo: photoLoaded().
    Ticket loadPhoto(qint64 row_id);
    Ticket exportPoints(const QString& path);
    /// All photos without their pictures: photosListed().
    Ticket listPhotos();
    /// One stored photo into this folder, with EXIF, XMP and sidecar. One at a time: a record never waits for a whole
    /// export. kCancelled when another job is open by the time it is its turn.
    Ticket exportPhoto(const job::Photo& photo, const QString& folder);
    void setMeta(const QString& key, const QString& value);
    void log(const job::LogEntry& entry);

public Q_SLOTS:
    void create(const QString& path);
    void open(const QString& path);
    void openOrCreate(const QString& path);
    void close();

Q_SIGNALS:
    void opened(const pmts::app::JobContents& contents);
    void openFailed(const QString& path, const pmts::core::Error& error);
    void closed();
    void recorded(pmts::app::Ticket ticket, const pmts::survey::Point& point);
    void updated(pmts::app::Ticket ticket, const std::vector<pmts::survey::Point>& points);
    void stationStored(pmts::app::Ticket ticket, const pmts::survey::Station& station);
    void photoAdded(pmts::app::Ticket ticket, const pmts::job::Photo& photo);
    void evidenceLoaded(pmts::app::Ticket ticket, qint64 point_row, const std::optional<pmts::job::Evidence>& evidence);
    void markAdded(pmts::app::Ticket ticket, const pmts::job::ImageMark& mark);
    void markUpdated(pmts::app::Ticket ticket, const pmts::job::ImageMark& mark);
    void markRemoved(pmts::app::Ticket ticket, qint64 row_id);
    void marksLoaded(pmts::app::Ticket ticket, qint64 photo_row, const std::vector<pmts::job::ImageMark>& marks);
    void plannedAdded(pmts::app::Ticket ticket, const std::vector<pmts::survey::PlannedPoint>& points);
    void plannedRemoved(pmts::app::Ticket ticket, const std::vector<qint64>& row_ids);
    void photoLoaded(pmts::app::Ticket ticket, const QImage& image);
    void photosListed(pmts::app::Ticket ticket, const std::vector<pmts::job::Photo>& photos);
    void photoExported(pmts::app::Ticket ticket);
    void exported(pmts::app::Ticket ticket, const QString& path);
    void requestFailed(pmts::app::Ticket ticket, const pmts::core::Error& error);

private:
    class Worker;
    Ticket post(std::function<void(Worker&, Ticket)> request);
    void showOpened(const JobContents& contents);
    void showFailedOpen(const QString& path, const core::Error& error);
    void showClosed();

    QThread thread_;
    std::unique_ptr<Worker> worker_;
    Ticket last_ticket_ = 0;
    QString path_;
    QString name_;
};

}  // namespace pmts::app
