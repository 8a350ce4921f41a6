#include "pmts/app/field/points_model.hpp"

#include "desk/job_step.hpp"

#include <algorithm>
#include <utility>

namespace pmts::app {

bool hasCoordinates(const survey::Point& point) { return point.observation.slope_distance_m.has_value(); }

/// One step of the undo stack: what a person calls the points, and whether they count.
class PointsModel::ChangeStep : public JobStep {
public:
    ChangeStep(PointsModel& model, std::vector<survey::Point> before, std::vector<survey::Point> after, const QString& text,
               bool already_done)
        : JobStep(text, already_done), model_(model), before_(std::move(before)), after_(std::move(after)) {}

private:
    Ticket write(bool forward) override { return model_.apply(forward ? after_ : before_); }

    PointsModel& model_;
    std::vector<survey::Point> before_;
    std::vector<survey::Point> after_;
};

PointsModel::PointsModel(JobDesk& job, const Preferences& preferences, MessageCentre& messages, QUndoStack& undo,
                         QObject* parent)
    : QAbstractTableModel(parent), job_(job), preferences_(preferences), messages_(messages), undo_(undo) {
    connect(&job_, &JobDesk::opened, this, [this](const JobContents& contents) { reset(contents.points); });
    connect(&job_, &JobDesk::closed, this, [this] { reset({}); });
    connect(&job_, &JobDesk::updated, this, [this](Ticket ticket) { before_.remove(ticket); });
    connect(&job_, &JobDesk::requestFailed, this, &PointsModel::onRequestFailed);
    connect(&preferences_, &Preferences::unitsChanged, this, [this] {
        Q_EMIT headerDataChanged(Qt::Horizontal, 0, kColumnCount - 1);
        if (!points_.empty()) {
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumnCount - 1));
        }
    });
}

void PointsModel::reset(std::vector<survey::Point> points) {
    beginResetModel();
    points_ = std::move(points);
    before_.clear();
    row_of_.clear();
    for (std::size_t row = 0; row < points_.size(); ++row) {
        row_of_.insert(points_[row].row_id, static_cast<int>(row));
    }
    countIds();
    undo_.clear();  // its steps speak of the other job
    endResetModel();
    Q_EMIT pointsChanged();
}

void PointsModel::countIds() {
    id_count_.clear();
    used_ids_.clear();
    for (const survey::Point& point : points_) {
        used_ids_.insert(point.id);
        if (!point.struck_out) {
            ++id_count_[point.id];
        }
    }
}

const survey::Point* PointsModel::find(qint64 row_id) const {
    const int row = rowOf(row_id);
    return row < 0 ? nullptr : &points_[static_cast<std::size_t>(row)];
}

const survey::Point* PointsModel::findId(const QString& id) const {
    const auto found = std::find_if(points_.rbegin(), points_.rend(),
                                    [&id](const survey::Point& point) { return !point.struck_out && point.id == id; });
    return found == points_.rend() ? nullptr : &*found;
}

int PointsModel::rowOf(qint64 row_id) const { return row_of_.value(row_id, -1); }

QStringList PointsModel::codes() const {
    QHash<QString, int> count;
    for (const survey::Point& point : points_) {
        if (!point.code.isEmpty() && !point.struck_out) {
            ++count[point.code];
        }
    }
    QStringList codes = count.keys();
    std::sort(codes.begin(), codes.end(), [&count](const QString& a, const QString& b) {
        return std::pair(-count[a], a) < std::pair(-count[b], b);
    });
    return codes;
}

void PointsModel::addRecorded(const survey::Point& point) {
    const int row = rowCount();
    beginInsertRows({}, row, row);
    points_.push_back(point);
    row_of_.insert(point.row_id, row);
    ++id_count_[point.id];
    used_ids_.insert(point.id);
    endInsertRows();
    survey::Point struck = point;
    struck.struck_out = true;
    undo_.push(new ChangeStep(*this, {struck}, {point}, tr("Record %1").arg(point.id), true));
    Q_EMIT pointsChanged();
}

void PointsModel::change(const std::vector<survey::Point>& changed, const QString& text) {
    std::vector<survey::Point> before;
    for (const survey::Point& point : changed) {
        if (const survey::Point* old = find(point.row_id)) {
            before.push_back(*old);
        }
    }
    if (!before.empty()) {
        undo_.push(new ChangeStep(*this, std::move(before), changed, text, false));
    }
}

Ticket PointsModel::apply(const std::vector<survey::Point>& changed) {
    std::vector<survey::Point> before;
    std::vector<survey::Point> after;
    for (const survey::Point& wanted : changed) {
        if (const survey::Point* old = find(wanted.row_id)) {
            before.push_back(*old);
            after.push_back(*old);  // only what a person writes changes: coordinates may have been recomputed since
            after.back().id = wanted.id;
            after.back().code = wanted.code;
            after.back().remark = wanted.remark;
            after.back().struck_out = wanted.struck_out;
        }
    }
    show(after);
    const Ticket ticket = job_.update(after);
    before_.insert(ticket, before);
    return ticket;
}

void PointsModel::show(const std::vector<survey::Point>& changed) {
    for (const survey::Point& point : changed) {
        if (const int row = rowOf(point.row_id); row >= 0) {
            points_[static_cast<std::size_t>(row)] = point;
        }
    }
    countIds();
    if (!points_.empty()) {  // another row's duplicate flag may have changed too
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumnCount - 1));
    }
    Q_EMIT pointsChanged();
}

void PointsModel::replaceCoordinates(const std::vector<survey::Point>& recomputed) {
    std::vector<survey::Point> changed;
    for (const survey::Point& point : recomputed) {
        if (const survey::Point* old = find(point.row_id)) {
            changed.push_back(*old);
            changed.back().coordinates = point.coordinates;
        }
    }
    show(changed);
}

void PointsModel::onRequestFailed(Ticket ticket, const core::Error& error) {
    if (!before_.contains(ticket)) {
        return;
    }
    std::vector<survey::Point> taken_back;
    for (const survey::Point& point : before_.take(ticket)) {
        if (!leaveToLaterChange(ticket, point)) {
            taken_back.push_back(point);
        }
    }
    show(taken_back);
    takeBackRefused(undo_, ticket);
    messages_.report(error, MessageAction::kOpenJob, QStringLiteral("points"));
}

/// A later change of the same point is under way: it stays on screen, and what it would be taken back to is corrected.
bool PointsModel::leaveToLaterChange(Ticket ticket, const survey::Point& refused_from) {
    for (auto later = before_.upperBound(ticket); later != before_.end(); ++later) {
        for (survey::Point& point : later.value()) {
            if (point.row_id == refused_from.row_id) {
                point = refused_from;
                return true;
            }
        }
    }
    return false;
}

void PointsModel::strikeOut(const QList<qint64>& row_ids) { setStruckOut(row_ids, true, tr("Strike out")); }

void PointsModel::restore(const QList<qint64>& row_ids) { setStruckOut(row_ids, false, tr("Restore")); }

void PointsModel::setStruckOut(const QList<qint64>& row_ids, bool struck_out, const QString& text) {
    std::vector<survey::Point> changed;
    for (const qint64 row_id : row_ids) {
        if (const survey::Point* point = find(row_id); point && point->struck_out != struck_out) {
            changed.push_back(*point);
            changed.back().struck_out = struck_out;
        }
    }
    change(changed, changed.size() == 1 ? text + u' ' + changed.front().id : text);
}

void PointsModel::edit(qint64 row_id, const QString& id, const QString& code, const QString& remark) {
    const survey::Point* point = find(row_id);
    if (!point) {
        return;
    }
    if (id.trimmed().isEmpty()) {
        messages_.warn(tr("A point needs an ID."), tr("Type one; the old ID was kept."), MessageAction::kNone,
                       QStringLiteral("point_id"));
        return;
    }
    survey::Point changed = *point;
    changed.id = id.trimmed();
    changed.code = code.trimmed();
    changed.remark = remark;
    if (changed.id == point->id && changed.code == point->code && changed.remark == point->remark) {
        return;
    }
    messages_.solve(QStringLiteral("point_id"));
    change({changed}, tr("Edit %1").arg(changed.id));
}

bool PointsModel::isDuplicate(const survey::Point& point) const {
    return !point.struck_out && id_count_.value(point.id) > 1;
}

int PointsModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(points_.size()); }

int PointsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumnCount; }

QVariant PointsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const survey::Point& point = points_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole: return displayText(point, index.column());
        case Qt::ToolTipRole: return noteText(point);
        case Qt::TextAlignmentRole:
            return index.column() >= kEasting && index.column() <= kTargetHeight
                       ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                       : QVariant(Qt::AlignLeft | Qt::AlignVCenter);
        case kSortRole: return sortValue(point, index.column());
        case kRowIdRole: return point.row_id;
        case kStruckOutRole: return point.struck_out;
        case kDuplicateRole: return isDuplicate(point);
        case kAbsurdRole: return !point.observation.absurd_reason.isEmpty();
        default: return {};
    }
}

QString PointsModel::displayText(const survey::Point& point, int column) const {
    const UnitFormat& units = preferences_.units();
    const auto placed = [&](double metres) { return hasCoordinates(point) ? units.lengthNumber(metres) : QString(); };
    switch (column) {
        case kId: return point.id;
        case kCode: return point.code;
        case kEasting: return placed(point.coordinates.e_m);
        case kNorthing: return placed(point.coordinates.n_m);
        case kHeight: return placed(point.coordinates.h_m);
        case kPrecision: return hasCoordinates(point) ? units.precision(point.coordinates.sigma3dM()) : QString();
        case kHa: return units.directionNumber(point.observation.pointing.ha);
        case kVa: return units.angleNumber(point.observation.pointing.va);
        case kSd: return hasCoordinates(point) ? units.lengthNumber(*point.observation.slope_distance_m) : QString();
        case kTargetHeight: return units.lengthNumber(point.observation.target_height_m);
        case kMode: return point.observation.edm_mode;
        case kRemark: return point.remark;
        case kTime: return point.observation.utc.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
        case kStation: return point.station_name;
        case kNote: return noteText(point);
        default: return {};
    }
}

QString PointsModel::noteText(const survey::Point& point) const {
    QStringList notes;
    if (point.struck_out) {
        notes.append(tr("struck out"));
    }
    if (isDuplicate(point)) {
        notes.append(tr("ID used twice"));
    }
    if (!point.observation.absurd_reason.isEmpty()) {
        notes.append(tr("absurd: %1").arg(point.observation.absurd_reason));
    }
    if (point.observation.source == QLatin1String("two_faces")) {
        notes.append(tr("mean of both faces"));
    } else if (point.observation.source != QLatin1String("pmts")) {
        notes.append(tr("registered at the instrument"));
    }
    return notes.join(QStringLiteral("; "));
}

QVariant PointsModel::sortValue(const survey::Point& point, int column) const {
    const auto placed = [&](double metres) { return hasCoordinates(point) ? QVariant(metres) : QVariant(); };
    switch (column) {
        case kEasting: return placed(point.coordinates.e_m);
        case kNorthing: return placed(point.coordinates.n_m);
        case kHeight: return placed(point.coordinates.h_m);
        case kPrecision: return placed(point.coordinates.sigma3dM());
        case kHa: return core::normalized(point.observation.pointing.ha).gon();
        case kVa: return point.observation.pointing.va.gon();
        case kSd: return placed(point.observation.slope_distance_m.value_or(0.0));
        case kTargetHeight: return point.observation.target_height_m;
        case kTime: return point.observation.utc;
        default: return displayText(point, column);
    }
}

QVariant PointsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    const QString length = QStringLiteral(" (%1)").arg(preferences_.units().lengthUnitSign());
    const QString angle = QStringLiteral(" (%1)").arg(preferences_.units().angleUnitSign());
    switch (section) {
        case kId: return tr("Point");
        case kCode: return tr("Code");
        case kEasting: return tr("E") + length;
        case kNorthing: return tr("N") + length;
        case kHeight: return tr("H") + length;
        case kPrecision: return tr("Precision");
        case kHa: return tr("HA") + angle;
        case kVa: return tr("VA") + angle;
        case kSd: return tr("SD") + length;
        case kTargetHeight: return tr("Target height") + length;
        case kMode: return tr("Mode");
        case kRemark: return tr("Remark");
        case kTime: return tr("Time");
        case kStation: return tr("Station");
        case kNote: return tr("Note");
        default: return {};
    }
}

bool PointsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable)) {
        return false;
    }
    const survey::Point& point = points_[static_cast<std::size_t>(index.row())];
    const QString text = value.toString();
    edit(point.row_id, index.column() == kId ? text : point.id, index.column() == kCode ? text : point.code,
         index.column() == kRemark ? text : point.remark);
    return true;
}

Qt::ItemFlags PointsModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
    const int column = index.column();
    return column == kId || column == kCode || column == kRemark ? usual | Qt::ItemIsEditable : usual;
}

}  // namespace pmts::app
