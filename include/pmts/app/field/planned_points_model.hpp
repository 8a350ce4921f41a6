#pragma once

#include "pmts/app/desk/job_desk.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/survey/planned_point.hpp"

#include <QAbstractTableModel>
#include <QList>
#include <QSet>
#include <QUndoStack>

#include <vector>

namespace pmts::app {

/// The design's points of the open job: to be found, staked out, drawn. It always shows what the file holds;
/// an import and a removal are steps of the one undo stack.
class PlannedPointsModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kId, kCode, kEasting, kNorthing, kHeight, kRemark, kColumnCount };
    enum Role { kSortRole = Qt::UserRole, kRowIdRole };

    PlannedPointsModel(JobDesk& job, const Preferences& preferences, MessageCentre& messages,
                       QUndoStack& undo, QObject* parent = nullptr);

    [[nodiscard]] const std::vector<survey::PlannedPoint>& points() const { return points_; }
    [[nodiscard]] const survey::PlannedPoint* find(qint64 row_id) const;
    [[nodiscard]] int rowOf(qint64 row_id) const;  ///< -1 when absent
    [[nodiscard]] static QString importFilter();   ///< for a file dialog

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

public Q_SLOTS:
    /// All points of a CSV, JOB or ARE file or none; a file that cannot be read is refused with the line in the message.
    void importFrom(const QString& path);
    /// All of them or none, as one step; `from` is named in the message.
    void add(const std::vector<pmts::survey::PlannedPoint>& points, const QString& from);
    void remove(const QList<qint64>& row_ids);

Q_SIGNALS:
    void plannedChanged();

private:
    class PresenceStep;
    void reset(std::vector<survey::PlannedPoint> points);
    void onAdded(Ticket ticket, const std::vector<survey::PlannedPoint>& added);
    void onRemoved(const std::vector<qint64>& row_ids);
    void onRequestFailed(Ticket ticket, const core::Error& error);
    Ticket put(const std::vector<survey::PlannedPoint>& points, bool present);
    [[nodiscard]] QString displayText(const survey::PlannedPoint& point, int column) const;
    [[nodiscard]] QVariant sortValue(const survey::PlannedPoint& point, int column) const;

    JobDesk& job_;
    const Preferences& preferences_;
    MessageCentre& messages_;
    QUndoStack& undo_;
    std::vector<survey::PlannedPoint> points_;  ///< by row number
    Ticket import_ticket_ = 0;
    QString import_name_;
    QSet<Ticket> under_way_;
};

}  // namespace pmts::app
