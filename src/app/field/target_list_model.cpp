#include "pmts/app/field/target_list_model.hpp"

#include <algorithm>

namespace pmts::app {

using targeting::ListedTarget;

TargetListModel::TargetListModel(const Preferences& preferences, QObject* parent)
    : QAbstractTableModel(parent), preferences_(preferences) {
    connect(&preferences_, &Preferences::unitsChanged, this, [this] {
        Q_EMIT headerDataChanged(Qt::Horizontal, 0, kColumnCount - 1);
        if (!targets_.empty()) {
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumnCount - 1));
        }
    });
}

void TargetListModel::setTargets(std::vector<ListedTarget> targets, const QString& source) {
    beginResetModel();
    targets_ = std::move(targets);
    source_ = source;
    endResetModel();
    Q_EMIT targetsChanged();
}

void TargetListModel::put(const ListedTarget& target, const QString& source) {
    source_ = source;
    const auto old = std::ranges::find(targets_, target.name, &ListedTarget::name);
    if (old != targets_.end()) {
        *old = target;
        const int row = static_cast<int>(old - targets_.begin());
        Q_EMIT dataChanged(index(row, 0), index(row, kColumnCount - 1));
    } else {
        beginInsertRows({}, rowCount(), rowCount());
        targets_.push_back(target);
        endInsertRows();
    }
    Q_EMIT targetsChanged();
}

void TargetListModel::removeTargets(const QList<int>& rows) {
    QList<int> last_first = rows;
    std::ranges::sort(last_first, std::greater<>());
    for (const int row : last_first) {
        beginRemoveRows({}, row, row);
        targets_.erase(targets_.begin() + row);
        endRemoveRows();
    }
    Q_EMIT targetsChanged();
}

void TargetListModel::clear() { setTargets({}, {}); }

int TargetListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(targets_.size());
}

int TargetListModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumnCount; }

QString TargetListModel::text(const ListedTarget& target, int column) const {
    const UnitFormat& units = preferences_.units();
    switch (column) {
        case kName: return target.name;
        case kDistance: return units.lengthNumber(target.observed.slope_distance_m);
        case kHa: return units.directionNumber(target.observed.pointing.ha);
        case kVa: return units.angleNumber(target.observed.pointing.va);
        case kColumn: return QString::number(target.px.x(), 'f', 1);
        case kRow: return QString::number(target.px.y(), 'f', 1);
        default: return {};
    }
}

QVariant TargetListModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant::fromValue(Qt::Alignment(Qt::AlignVCenter | (index.column() == kName ? Qt::AlignLeft : Qt::AlignRight)));
    }
    return role == Qt::DisplayRole ? text(targets_[static_cast<std::size_t>(index.row())], index.column()) : QVariant();
}

QVariant TargetListModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole || orientation != Qt::Horizontal) {
        return {};
    }
    const UnitFormat& units = preferences_.units();
    switch (section) {
        case kName: return tr("Target");
        case kDistance: return tr("SD %1").arg(units.lengthUnitSign());
        case kHa: return tr("HA %1").arg(units.angleUnitSign());
        case kVa: return tr("VA %1").arg(units.angleUnitSign());
        case kColumn: return tr("Column px");
        case kRow: return tr("Row px");
        default: return {};
    }
}

}  // namespace pmts::app
