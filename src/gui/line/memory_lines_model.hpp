#pragma once

#include "pmts/app/line/memory_presenter.hpp"

#include <QAbstractTableModel>

namespace pmts::gui {

/// The lines of the file in sight and what became of each. Words are made when they are looked at: a file may have
/// hundreds of thousands of lines.
class MemoryLinesModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kNumber, kLabel, kMeaning, kData, kFate, kColumns };

    explicit MemoryLinesModel(const app::MemoryPresenter& memory, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    void showDocument();  ///< it is another one, or its lines have another fate

private:
    const app::MemoryPresenter& memory_;
};

}  // namespace pmts::gui
