#include "memory_lines_model.hpp"

#include "parts/state_lamp.hpp"

namespace pmts::gui {
namespace {

app::DeviceState stateOf(app::LineFate fate) {
    switch (fate) {
        case app::LineFate::kRead:
            return app::DeviceState::kIdle;
        case app::LineFate::kBad:
            return app::DeviceState::kFailed;
        case app::LineFate::kSent:
            return app::DeviceState::kBusy;
        case app::LineFate::kKept:
            return app::DeviceState::kGood;
        case app::LineFate::kChanged:
        case app::LineFate::kLost:
            return app::DeviceState::kWarning;
    }
    return app::DeviceState::kIdle;
}

QString wordOf(const app::MemoryRow& row) {
    if (!row.remark.isEmpty()) {
        return row.remark;
    }
    switch (row.fate) {
        case app::LineFate::kRead:
            return {};
        case app::LineFate::kBad:
            return MemoryLinesModel::tr("bad line");
        case app::LineFate::kSent:
            return MemoryLinesModel::tr("sent");
        case app::LineFate::kKept:
            return MemoryLinesModel::tr("in the instrument");
        case app::LineFate::kChanged:
            return MemoryLinesModel::tr("changed");
        case app::LineFate::kLost:
            return MemoryLinesModel::tr("not in the instrument");
    }
    return {};
}

QString textOf(const app::MemoryRow& row, int column) {
    switch (column) {
        case MemoryLinesModel::kNumber:
            return QString::number(row.number);
        case MemoryLinesModel::kLabel:
            return row.label;
        case MemoryLinesModel::kMeaning:
            return row.meaning;
        case MemoryLinesModel::kData:
            return row.data;
        case MemoryLinesModel::kFate:
            return wordOf(row);
        default:
            return {};
    }
}

}  // namespace

MemoryLinesModel::MemoryLinesModel(const app::MemoryPresenter& memory, QObject* parent)
    : QAbstractTableModel(parent), memory_(memory) {}

int MemoryLinesModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(memory_.document().rows().size());
}

int MemoryLinesModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant MemoryLinesModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const app::MemoryRow& row = memory_.document().rows()[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
        case Qt::ToolTipRole:
            return textOf(row, index.column());
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(Qt::AlignVCenter | (index.column() <= kLabel ? Qt::AlignRight : Qt::AlignLeft));
        case Qt::DecorationRole:
            return index.column() == kFate && row.fate != app::LineFate::kRead ? QVariant(lampIcon(stateOf(row.fate)))
                                                                                : QVariant();
        default:
            return {};
    }
}

QVariant MemoryLinesModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    const QStringList names{tr("Line"), tr("Label"), tr("Meaning"), tr("Data"), tr("What became of it")};
    return names.value(section);
}

void MemoryLinesModel::showDocument() {
    beginResetModel();
    endResetModel();
}

}  // namespace pmts::gui
