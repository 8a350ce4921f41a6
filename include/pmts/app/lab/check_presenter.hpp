#pragma once

#include "pmts/app/lab/profiles_presenter.hpp"

#include <QObject>
#include <QPointF>

#include <optional>
#include <vector>

namespace pmts::app {

/// A place in the station frame that is known without the camera.
struct KnownPlace {
    Eigen::Vector3d p_station = Eigen::Vector3d::Zero();
    QString name;  ///< `point 104`, `the spot under the telescope`
};

enum class CheckStage { kIdle, kReady, kRunning, kDone };

/// The one-minute check: a known place is seen in the middle and towards the corners of the picture, and where it is seen is
/// held against where the rig puts it.
class CheckPresenter : public QObject {
    Q_OBJECT
public:
    CheckPresenter(LivePresenter& live, InstrumentDesk& instrument, const PointsModel& points, Preferences& preferences,
                   ProfilesPresenter& profiles, const core::Clock& clock, QObject* parent = nullptr);

    [[nodiscard]] CheckStage stage() const { return stage_; }
    [[nodiscard]] QString step() const;  ///< what to do now, one sentence
    [[nodiscard]] const std::optional<KnownPlace>& place() const { return place_; }
    [[nodiscard]] const std::optional<QPointF>& clicked() const { return clicked_px_; }
    [[nodiscard]] std::size_t done() const { return done_; }
    [[nodiscard]] std::size_t of() const { return pointings_.size(); }
    [[nodiscard]] const std::optional<RigCheck>& result() const { return result_; }
    [[nodiscard]] QString verdict() const;
    [[nodiscard]] const QString& trouble() const { return trouble_; }
    /// Where the spot is wanted in the picture, px: the middle, then towards the corners.
    [[nodiscard]] std::vector<Eigen::Vector2d> placesInPicture() const;

public Q_SLOTS:
    void usePoint(qint64 row_id);       ///< a recorded point
    void useTelescope();                ///< what the telescope points at, at the measured range
    void click(const QPointF& live_px); ///< there it is seen, or at the corner or mark within 8 px of there
    void run();
    void takeByHand();                  ///< adds what was clicked last at the present pointing instead of turning
    void cancel();

Q_SIGNALS:
    void changed();
    void finished(const pmts::app::RigCheck& check);

private:
    void setTrouble(const QString& sentence);
    void add(const geometry::Pointing& at, const Eigen::Vector2d& px);
    void judge();
    [[nodiscard]] bool standsStill() const;

    LivePresenter& live_;
    InstrumentDesk& instrument_;
    const PointsModel& points_;
    Preferences& preferences_;
    ProfilesPresenter& profiles_;
    const core::Clock& clock_;
    CheckStage stage_ = CheckStage::kIdle;
    std::optional<KnownPlace> place_;
    std::optional<QPointF> clicked_px_;
    bool is_snapped_ = false;
    camera::FramePtr clicked_frame_;
    std::optional<geometry::Pointing> clicked_at_;
    std::vector<geometry::Pointing> pointings_;
    std::size_t done_ = 0;
    Ticket ticket_ = 0;
    std::optional<RigCheck> result_;
    std::vector<core::Angle> angles_;
    RigCheck running_;
    QString trouble_;
};

}  // namespace pmts::app
