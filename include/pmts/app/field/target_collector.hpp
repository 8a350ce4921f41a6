#pragma once

#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/field/target_list_model.hpp"

#include <QObject>
#include <QPointF>
#include <QStringList>

#include <optional>
#include <vector>

namespace pmts::app {

/// A photo that targets can be clicked in.
struct CollectibleStill {
    QString name;             ///< `Photo 3, 10:31:22`
    camera::FramePtr frame;   ///< null until the job has given it
    geometry::Pointing pointing;
    QString station_name;
    camera::Rig rig;
    QDateTime utc;
    qint64 photo_row_id = 0;  ///< 0: not in the job yet
};

/// A recorded point that lies in the chosen still.
struct CollectiblePoint {
    QString id, code, distance_text;
    QPointF expected_px;             ///< where the rig says it is
    std::optional<QPointF> clicked;  ///< where somebody clicked it
    geometry::PolarPoint observed;
};

/// Makes a list of targets from the user's own work: a still, the points recorded at its station, one click each.
class TargetCollector : public QObject {
    Q_OBJECT
public:
    TargetCollector(TargetListModel& targets, LivePresenter& live, JobDesk& job, const PointsModel& points,
                    const StationPresenter& station, const Preferences& preferences, QObject* parent = nullptr);

    [[nodiscard]] QStringList stillNames() const;
    [[nodiscard]] int chosenStill() const { return chosen_; }  ///< -1: none
    [[nodiscard]] const CollectibleStill* still() const;       ///< null when none is chosen
    [[nodiscard]] const std::vector<CollectiblePoint>& points() const { return shown_; }
    [[nodiscard]] int pickedPoint() const { return picked_; }  ///< -1: none

public Q_SLOTS:
    void capture();  ///< a new still of the live view; it is chosen when it is there
    void chooseStill(int index);
    void pickPoint(int index);
    /// The picked point is here in the chosen still; the next one that was not clicked is picked.
    void click(const QPointF& still_px);

Q_SIGNALS:
    void stillsChanged();
    void stillChosen();    ///< take still(): its frame may come later
    void pointsChanged();  ///< points(), pickedPoint()
    void said(const QString& sentence);
    void problemReported(const pmts::core::Error& error);

private:
    void onOpened(const JobContents& contents);
    void onStill(const Still& still);
    void onPhotoAdded(const job::Photo& photo);
    void onPhotoLoaded(Ticket ticket, const QImage& image);
    void listPoints();
    void pickNext();
    [[nodiscard]] CollectibleStill stillOf(const job::Photo& photo) const;

    TargetListModel& targets_;
    LivePresenter& live_;
    JobDesk& job_;
    const PointsModel& points_;
    const StationPresenter& station_;
    const Preferences& preferences_;
    std::vector<CollectibleStill> stills_;
    std::vector<CollectiblePoint> shown_;
    int chosen_ = -1;
    int picked_ = -1;
    Ticket load_ticket_ = 0;
    bool choose_next_ = false;  ///< the capture was asked for here
};

}  // namespace pmts::app
