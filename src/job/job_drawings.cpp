// Rows that may be changed and removed: planned points and marks in photos.
#include "job_impl.hpp"
#include "pmts/job/job.hpp"
#include "rows.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pmts::job {
namespace {

QString tr(const char* sentence) { return QCoreApplication::translate("pmts::job", sentence); }

core::Result<void> checkRows(OGRLayer& rows, const char* what, const std::vector<qint64>& row_ids) {
    for (const qint64 row_id : row_ids) {
        if (!OGRFeatureUniquePtr(rows.GetFeature(row_id))) {
            return unknownRow(what, row_id);
        }
    }
    return {};
}

}  // namespace

core::Result<std::vector<survey::PlannedPoint>> Job::addPlanned(
    const std::vector<survey::PlannedPoint>& points) {
    for (const survey::PlannedPoint& point : points) {
        if (!std::isfinite(point.e_m + point.n_m + point.h_m)) {
            return core::fail(
                core::ErrorKind::kBadInput,
                tr("Planned point %1 was not stored: its coordinates are not numbers.").arg(point.id));
        }
    }
    std::vector<survey::PlannedPoint> stored = points;
    PMTS_TRY(impl_->durably([&] {
        const bool added = std::all_of(stored.begin(), stored.end(), [&](survey::PlannedPoint& point) {
            const auto row_id =
                impl_->addRow(kPlannedPoints, [&](OGRFeature& row) { fillPlanned(row, point); });
            point.row_id = row_id.value_or(0);
            return row_id.has_value();
        });
        return added && writePlannedExtent(*impl_->file.dataset);
    }));
    return stored;
}

core::Result<void> Job::removePlanned(const std::vector<qint64>& row_ids) {
    PMTS_TRY(checkRows(impl_->layer(kPlannedPoints), "planned point", row_ids));
    return impl_->durably([&] {
        return impl_->removeRows(kPlannedPoints, row_ids) && writePlannedExtent(*impl_->file.dataset);
    });
}

core::Result<std::vector<survey::PlannedPoint>> Job::planned() const {
    return impl_->allRows(kPlannedPoints, plannedOf);
}

core::Result<ImageMark> Job::addMark(const ImageMark& mark) {
    PMTS_TRY(checkRows(impl_->layer(kPhotos), "photo", {mark.photo_row}));
    ImageMark added = mark;
    PMTS_TRY(impl_->durably([&] {
        const auto row_id = impl_->addRow(kImageMarks, [&](OGRFeature& row) { fillMark(row, mark); });
        added.row_id = row_id.value_or(0);
        return row_id.has_value();
    }));
    return added;
}

core::Result<void> Job::updateMark(const ImageMark& mark) {
    OGRLayer& rows = impl_->layer(kImageMarks);
    const OGRFeatureUniquePtr row(rows.GetFeature(mark.row_id));
    if (!row) {
        return unknownRow("mark", mark.row_id);
    }
    fillMark(*row, mark);
    return impl_->durably([&] { return rows.SetFeature(row.get()) == OGRERR_NONE; });
}

core::Result<void> Job::removeMark(qint64 row_id) {
    PMTS_TRY(checkRows(impl_->layer(kImageMarks), "mark", {row_id}));
    return impl_->durably([&] { return impl_->removeRows(kImageMarks, {row_id}); });
}

core::Result<std::vector<ImageMark>> Job::marksOf(qint64 photo_row) const {
    auto marks = impl_->allRows(kImageMarks, markOf);
    if (marks) {
        std::erase_if(*marks, [photo_row](const ImageMark& mark) { return mark.photo_row != photo_row; });
    }
    return marks;
}

}  // namespace pmts::job
