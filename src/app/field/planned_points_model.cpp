#include "pmts/app/field/planned_points_model.hpp"

#include "desk/job_step.hpp"
#include "line/memory_import.hpp"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace pmts::app {

namespace {

const QString kTopic = QStringLiteral("planned");

bool isBefore(const survey::PlannedPoint& a, const survey::PlannedPoint& b) { return a.row_id < b.row_id; }

std::vector<qint64> rowsOf(const std::vector<survey::PlannedPoint>& points) {
    std::vector<qint64> row_ids;
    std::ranges::transform(points, std::back_inserter(row_ids), &survey::PlannedPoint::row_id);
    return row_ids;
}

}  // namespace

/// These points come, or go; undo is the other way round. Their row numbers stay.
class PlannedPointsModel::PresenceStep : public JobStep {
public:
    PresenceStep(PlannedPointsModel& model, std::vector<survey::PlannedPoint> points, bool come,
                 const QString& text, bool already_done)
        : JobStep(text, already_done), model_(model), points_(std::move(points)), come_(come) {}

private:
    Ticket write(bool forward) override { return model_.put(points_, forward == come_); }

    PlannedPointsModel& model_;
    std::vector<survey::PlannedPoint> points_;
    bool come_;
};

PlannedPointsModel::PlannedPointsModel(JobDesk& job, const Preferences& preferences, MessageCentre& messages,
                                       QUndoStack& undo, QObject* parent)
    : QAbstractTableModel(parent), job_(job), preferences_(preferences), messages_(messages), undo_(undo) {
    connect(&job_, &JobDesk::opened, this, [this](const JobContents& contents) { reset(contents.planned); });
    connect(&job_, &JobDesk::closed, this, [this] { reset({}); });
    connect(&job_, &JobDesk::plannedAdded, this, &PlannedPointsModel::onAdded);
    connect(&job_, &JobDesk::plannedRemoved, this, [this](Ticket ticket, const std::vector<qint64>& row_ids) {
        under_way_.remove(ticket);
        onRemoved(row_ids);
    });
    connect(&job_, &JobDesk::requestFailed, this, &PlannedPointsModel::onRequestFailed);
    connect(&preferences_, &Preferences::unitsChanged, this, [this] {
        Q_EMIT headerDataChanged(Qt::Horizontal, 0, kColumnCount - 1);
        if (!points_.empty()) {
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumnCount - 1));
        }
    });
}

QString PlannedPointsModel::importFilter() {
    return tr("Tables of points (*.csv *.txt *.asc);;Job and area files (*.job *.JOB *.are *.ARE);;All files (*)");
}

const survey::PlannedPoint* PlannedPointsModel::find(qint64 row_id) const {
    const int row = rowOf(row_id);
    return row < 0 ? nullptr : &points_[static_cast<std::size_t>(row)];
}

int PlannedPointsModel::rowOf(qint64 row_id) const {
    const auto found = std::ranges::lower_bound(points_, row_id, {}, &survey::PlannedPoint::row_id);
    return found != points_.end() && found->row_id == row_id ? static_cast<int>(found - points_.begin()) : -1;
}

void PlannedPointsModel::importFrom(const QString& path) {
    if (isMemoryFile(path)) {
        const auto points = plannedFromMemoryFile(path);
        if (points) {
            add(*points, QFileInfo(path).fileName());
        } else {
            messages_.report(points.error(), MessageAction::kNone, kTopic);
        }
        return;
    }
    import_name_ = QFileInfo(path).fileName();
    import_ticket_ = job_.importPlanned(path);
    under_way_.insert(import_ticket_);
}

void PlannedPointsModel::add(const std::vector<survey::PlannedPoint>& points, const QString& from) {
    import_name_ = from;
    import_ticket_ = job_.addPlanned(points);
    under_way_.insert(import_ticket_);
}

void PlannedPointsModel::remove(const QList<qint64>& row_ids) {
    std::vector<survey::PlannedPoint> gone;
    for (const qint64 row_id : row_ids) {
        if (const survey::PlannedPoint* point = find(row_id)) {
            gone.push_back(*point);
        }
    }
    if (!gone.empty()) {
        const QString text = gone.size() == 1 ? tr("Remove planned point %1").arg(gone.front().id)
                                              : tr("Remove %1 planned points").arg(gone.size());
        undo_.push(new PresenceStep(*this, std::move(gone), false, text, false));
    }
}

Ticket PlannedPointsModel::put(const std::vector<survey::PlannedPoint>& points, bool present) {
    const Ticket ticket = present ? job_.addPlanned(points) : job_.removePlanned(rowsOf(points));
    under_way_.insert(ticket);
    return ticket;
}

void PlannedPointsModel::reset(std::vector<survey::PlannedPoint> points) {
    beginResetModel();
    points_ = std::move(points);
    std::ranges::sort(points_, isBefore);
    import_ticket_ = 0;
    under_way_.clear();
    endResetModel();
    Q_EMIT plannedChanged();
}

void PlannedPointsModel::onAdded(Ticket ticket, const std::vector<survey::PlannedPoint>& added) {
    under_way_.remove(ticket);
    beginResetModel();
    points_.insert(points_.end(), added.begin(), added.end());
    std::ranges::sort(points_, isBefore);
    endResetModel();
    Q_EMIT plannedChanged();
    if (ticket == import_ticket_) {
        import_ticket_ = 0;
        messages_.solve(kTopic);
        messages_.toast(added.size() == 1
                            ? tr("One planned point imported from %1.").arg(import_name_)
                            : tr("%1 planned points imported from %2.").arg(added.size()).arg(import_name_));
        undo_.push(new PresenceStep(*this, added, true, tr("Import planned points"), true));
    }
}

void PlannedPointsModel::onRemoved(const std::vector<qint64>& row_ids) {
    beginResetModel();
    const QSet<qint64> gone(row_ids.begin(), row_ids.end());
    std::erase_if(points_,
                  [&gone](const survey::PlannedPoint& point) { return gone.contains(point.row_id); });
    endResetModel();
    Q_EMIT plannedChanged();
}

void PlannedPointsModel::onRequestFailed(Ticket ticket, const core::Error& error) {
    if (under_way_.remove(ticket)) {
        takeBackRefused(undo_, ticket);
        messages_.report(error, job_.isOpen() ? MessageAction::kNone : MessageAction::kOpenJob, kTopic);
    }
}

int PlannedPointsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(points_.size());
}

int PlannedPointsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumnCount;
}

QVariant PlannedPointsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const survey::PlannedPoint& point = points_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
            return displayText(point, index.column());
        case Qt::ToolTipRole:
            return point.remark;
        case Qt::TextAlignmentRole:
            return index.column() >= kEasting && index.column() <= kHeight
                       ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                       : QVariant(Qt::AlignLeft | Qt::AlignVCenter);
        case kSortRole:
            return sortValue(point, index.column());
        case kRowIdRole:
            return point.row_id;
        default:
            return {};
    }
}

QString PlannedPointsModel::displayText(const survey::PlannedPoint& point, int column) const {
    const UnitFormat& units = preferences_.units();
    switch (column) {
        case kId:
            return point.id;
        case kCode:
            return point.code;
        case kEasting:
            return units.lengthNumber(point.e_m);
        case kNorthing:
            return units.lengthNumber(point.n_m);
        case kHeight:
            return units.lengthNumber(point.h_m);
        case kRemark:
            return point.remark;
        default:
            return {};
    }
}

QVariant PlannedPointsModel::sortValue(const survey::PlannedPoint& point, int column) const {
    switch (column) {
        case kEasting:
            return point.e_m;
        case kNorthing:
            return point.n_m;
        case kHeight:
            return point.h_m;
        default:
            return displayText(point, column);
    }
}

QVariant PlannedPointsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    const QString length = QStringLiteral(" (%1)").arg(preferences_.units().lengthUnitSign());
    switch (section) {
        case kId:
            return tr("Point");
        case kCode:
            return tr("Code");
        case kEasting:
            return tr("E") + length;
        case kNorthing:
            return tr("N") + length;
        case kHeight:
            return tr("H") + length;
        case kRemark:
            return tr("Remark");
        default:
            return {};
    }
}

}  // namespace pmts::app
