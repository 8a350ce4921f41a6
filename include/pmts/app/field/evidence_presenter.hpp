#pragma once

#include "pmts/app/desk/job_desk.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/field/points_model.hpp"
#include "pmts/app/settings/preferences.hpp"

#include <QImage>
#include <QObject>
#include <QPointF>

#include <optional>
#include <vector>

namespace pmts::app {

struct EvidenceLine {
    QString label;
    QString value;
};

/// A picture of the aiming with what to draw into it: pixels of the image, pixel centre of its first one is
/// (0, 0).
struct EvidenceThumbnail {
    QString caption;
    QImage image;  ///< null: none was kept
    std::optional<QPointF> spot_px;
    std::optional<QPointF> reticle_px;
};

/// The evidence of one point as a page shows it, texts in the current units.
struct EvidenceSheet {
    qint64 point_row = 0;
    QString job_name;
    QString point_id;
    QString subtitle;  ///< code, remark, station
    QString verdict;   ///< one sentence: how well it was aimed
    std::vector<EvidenceLine> place;
    std::vector<EvidenceLine> observation;
    std::vector<EvidenceLine> aiming;
    EvidenceThumbnail before;
    EvidenceThumbnail after;
};

/// Loads how a recorded point was aimed by image, and says it in words.
class EvidencePresenter : public QObject {
    Q_OBJECT
public:
    EvidencePresenter(JobDesk& job, const PointsModel& points, const Preferences& preferences,
                      MessageCentre& messages, QObject* parent = nullptr);

    /// Absent until a point with evidence was loaded, and after its job was closed.
    [[nodiscard]] std::optional<EvidenceSheet> sheet() const;
    /// What is known of a method's error beforehand; empty for a method nobody has measured.
    [[nodiscard]] static QString knownError(const QString& method);

public Q_SLOTS:
    /// Ends in loaded(), or in a message when the point was not aimed by image.
    void load(qint64 point_row);

Q_SIGNALS:
    void loaded();
    void sheetChanged();  ///< also when units or names change: take sheet()

private:
    void onLoaded(Ticket ticket, qint64 point_row, const std::optional<job::Evidence>& evidence);
    void forget();

    JobDesk& job_;
    const PointsModel& points_;
    const Preferences& preferences_;
    MessageCentre& messages_;
    Ticket ticket_ = 0;
    std::optional<job::Evidence> evidence_;
};

}  // namespace pmts::app
