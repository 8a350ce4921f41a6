#pragma once

#include "pmts/app/desk/job_desk.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/survey/point.hpp"

#include <QAbstractTableModel>
#include <QHash>
#include <QList>
#include <QMap>
#include <QSet>
#include <QUndoStack>

#include <vector>

namespace pmts::app {

/// True when the point has a place: its shot had a distance.
[[nodiscard]] bool hasCoordinates(const survey::Point& point);

/// The recorded points of the open job, in order of recording; sort with a proxy on kSortRole. ID, code and remark are
/// editable; edits, recording and striking out are steps of the one undo stack. Changes are shown at once and taken
/// back with a message when the job file refuses them, and their undo step goes.
class PointsModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kId, kCode, kEasting, kNorthing, kHeight, kPrecision, kHa, kVa, kSd, kTargetHeight, kMode, kRemark, kTime,
                  kStation, kNote, kColumnCount };
    enum Role { kSortRole = Qt::UserRole, kRowIdRole, kStruckOutRole, kDuplicateRole, kAbsurdRole };

    PointsModel(JobDesk& job, const Preferences& preferences, MessageCentre& messages, QUndoStack& undo,
                QObject* parent = nullptr);

    [[nodiscard]] const std::vector<survey::Point>& points() const { return points_; }
    [[nodiscard]] const survey::Point* find(qint64 row_id) const;
    /// Null when no point that is not struck out has this ID; the newest one of several.
    [[nodiscard]] const survey::Point* findId(const QString& id) const;
    /// Whether any point has this ID, struck out or not: one that is struck out may be restored.
    [[nodiscard]] bool isIdUsed(const QString& id) const { return used_ids_.contains(id); }
    [[nodiscard]] int rowOf(qint64 row_id) const;  ///< -1 when absent
    /// Codes in use, most used first.
    [[nodiscard]] QStringList codes() const;

    /// A point the job has committed: appended, with an undo step whose undo strikes it out.
    void addRecorded(const survey::Point& point);
    /// One undo step: these points changed (ID, code, remark, struck out).
    void change(const std::vector<survey::Point>& changed, const QString& text);
    /// New coordinates without an undo step of their own: the station's step calls it.
    void replaceCoordinates(const std::vector<survey::Point>& recomputed);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

public Q_SLOTS:
    void strikeOut(const QList<qint64>& row_ids);
    void restore(const QList<qint64>& row_ids);
    /// Edits by `P`: one undo step. An empty ID is refused with a message.
    void edit(qint64 row_id, const QString& id, const QString& code, const QString& remark);

Q_SIGNALS:
    void pointsChanged();

private:
    class ChangeStep;
    void reset(std::vector<survey::Point> points);
    Ticket apply(const std::vector<survey::Point>& changed);
    void show(const std::vector<survey::Point>& changed);
    void setStruckOut(const QList<qint64>& row_ids, bool struck_out, const QString& text);
    void countIds();
    void onRequestFailed(Ticket ticket, const core::Error& error);
    bool leaveToLaterChange(Ticket ticket, const survey::Point& refused_from);
    [[nodiscard]] QString displayText(const survey::Point& point, int column) const;
    [[nodiscard]] QVariant sortValue(const survey::Point& point, int column) const;
    [[nodiscard]] QString noteText(const survey::Point& point) const;
    [[nodiscard]] bool isDuplicate(const survey::Point& point) const;

    JobDesk& job_;
    const Preferences& preferences_;
    MessageCentre& messages_;
    QUndoStack& undo_;
    std::vector<survey::Point> points_;
    QMap<Ticket, std::vector<survey::Point>> before_;  ///< to take a refused change back
    QHash<qint64, int> row_of_;
    QHash<QString, int> id_count_;  ///< of points that are not struck out
    QSet<QString> used_ids_;         ///< of all points
};

}  // namespace pmts::app
