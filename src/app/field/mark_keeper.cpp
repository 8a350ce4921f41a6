#include "pmts/app/field/mark_keeper.hpp"

#include "pmts/geometry/polar.hpp"

#include <QScopedValueRollback>

namespace pmts::app {

namespace {

job::ImageMark rowOf(const ImageMark& mark) {
    return {.row_id = 0, .photo_row = mark.photo_row_id, .x_px = mark.photo_px.x(), .y_px = mark.photo_px.y(),
            .label = mark.label};
}

bool isSame(const job::ImageMark& a, const job::ImageMark& b) {
    return a.photo_row == b.photo_row && a.x_px == b.x_px && a.y_px == b.y_px && a.label == b.label;
}

}  // namespace

MarkKeeper::MarkKeeper(ImageMarks& marks, JobDesk& job, const LivePresenter& live, MessageCentre& messages, QObject* parent)
    : QObject(parent), marks_(marks), job_(job), live_(live), messages_(messages) {
    connect(&marks_, &ImageMarks::added, this, &MarkKeeper::store);
    connect(&marks_, &ImageMarks::edited, this, &MarkKeeper::storeAgain);
    connect(&marks_, &ImageMarks::removed, this, &MarkKeeper::drop);
    connect(&job_, &JobDesk::opened, this, &MarkKeeper::readJob);
    connect(&job_, &JobDesk::marksLoaded, this, &MarkKeeper::takeLoaded);
    connect(&job_, &JobDesk::markAdded, this, &MarkKeeper::takeAdded);
    connect(&job_, &JobDesk::requestFailed, this, [this](Ticket ticket, const core::Error& error) {
        if (being_added_.remove(ticket) + being_loaded_.remove(ticket) + qsizetype{being_changed_.remove(ticket)} != 0) {
            messages_.report(error, MessageAction::kOpenJob, QStringLiteral("mark"));
        }
    });
}

void MarkKeeper::readJob(const JobContents& contents) {
    const QScopedValueRollback reading(reading_, true);
    marks_.clear();
    photos_.clear();
    stored_.clear();
    being_added_.clear();
    being_loaded_.clear();
    for (const job::Photo& photo : contents.photos) {
        photos_.insert(photo.row_id, photo);
        being_loaded_.insert(job_.loadMarks(photo.row_id), photo.row_id);
    }
}

void MarkKeeper::takeLoaded(Ticket ticket, qint64 photo_row, const std::vector<job::ImageMark>& stored) {
    if (being_loaded_.remove(ticket) == 0) {
        return;
    }
    const QScopedValueRollback reading(reading_, true);
    const geometry::Pointing taken_at = photos_.value(photo_row).pointing;
    const double range_m = live_.scene().range.slope_distance_m;
    for (const job::ImageMark& row : stored) {
        const auto pointing = live_.model().pointingForPixel({row.x_px, row.y_px}, taken_at, range_m);
        if (!pointing) {
            continue;  // another camera now: it cannot be drawn, and stays in the job
        }
        ImageMark mark;
        mark.label = row.label;
        mark.pointing = *pointing;
        mark.slope_distance_m = range_m;
        mark.photo_row_id = row.photo_row;
        mark.photo_px = {row.x_px, row.y_px};
        stored_.insert(marks_.add(mark), row);
    }
}

void MarkKeeper::store(const ImageMark& mark) {
    if (!reading_ && mark.photo_row_id != 0 && job_.isOpen()) {
        being_added_.insert(job_.addMark(rowOf(mark)), mark.id);
    }
}

void MarkKeeper::takeAdded(Ticket ticket, const job::ImageMark& stored) {
    const auto added = being_added_.constFind(ticket);
    if (added == being_added_.constEnd()) {
        return;
    }
    const qint64 id = *added;
    being_added_.erase(added);
    stored_.insert(id, stored);
    if (const ImageMark* const mark = marks_.find(id)) {
        storeAgain(*mark);  // it may have been renamed or moved since
    } else {
        drop(id);
    }
}

void MarkKeeper::storeAgain(const ImageMark& mark) {
    if (reading_ || being_added_.values().contains(mark.id)) {
        return;  // takeAdded() looks again
    }
    const auto stored = stored_.constFind(mark.id);
    if (stored == stored_.constEnd()) {
        return store(mark);
    }
    job::ImageMark next = rowOf(mark);
    next.row_id = stored->row_id;
    if (mark.photo_row_id != stored->photo_row) {  // moved in another picture
        drop(mark.id);
        store(mark);
    } else if (!isSame(next, *stored)) {
        stored_.insert(mark.id, next);
        being_changed_.insert(job_.updateMark(next));
    }
}

void MarkKeeper::drop(qint64 id) {
    if (!reading_ && stored_.contains(id)) {
        being_changed_.insert(job_.removeMark(stored_.take(id).row_id));
    }
}

}  // namespace pmts::app
