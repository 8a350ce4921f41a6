#pragma once

#include "pmts/app/settings/preferences.hpp"
#include "pmts/targeting/target_list.hpp"

#include <QAbstractTableModel>
#include <QList>

#include <vector>

namespace pmts::app {

/// The targets of a method report as a table, in the current units. All of them were clicked in one photo.
class TargetListModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kName, kDistance, kHa, kVa, kColumn, kRow, kColumnCount };

    explicit TargetListModel(const Preferences& preferences, QObject* parent = nullptr);

    [[nodiscard]] const std::vector<targeting::ListedTarget>& targets() const { return targets_; }
    /// Where they come from: the name of a file or of a still.
    [[nodiscard]] QString source() const { return source_; }
    [[nodiscard]] bool isEmpty() const { return targets_.empty(); }

    void setTargets(std::vector<targeting::ListedTarget> targets, const QString& source);
    /// A target of this name takes the old one's place.
    void put(const targeting::ListedTarget& target, const QString& source);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

public Q_SLOTS:
    void removeTargets(const QList<int>& rows);
    void clear();

Q_SIGNALS:
    void targetsChanged();

private:
    [[nodiscard]] QString text(const targeting::ListedTarget& target, int column) const;

    const Preferences& preferences_;
    std::vector<targeting::ListedTarget> targets_;
    QString source_;
};

}  // namespace pmts::app
