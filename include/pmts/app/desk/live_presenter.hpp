#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/desk/frame_feed.hpp"
#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/desk/job_desk.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/field/parallax_curve.hpp"
#include "pmts/app/field/points_model.hpp"
#include "pmts/app/field/range_keeper.hpp"
#include "pmts/app/field/station_presenter.hpp"
#include "pmts/camera/frame.hpp"
#include "pmts/core/video_gate.hpp"
#include "pmts/survey/planned_point.hpp"
#include "pmts/targeting/pixel_to_pointing.hpp"
#include "pmts/video/video_source.hpp"

#include <QObject>
#include <QPointF>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace pmts::app {

/// How a move stands; drawn at the target in the image.
enum class MoveState { kNone, kAimed, kQueued, kTurning, kRecentring, kArrived, kLost };

/// The two pictures of the field workspace.
enum class Picture { kLive, kStill };

enum class OverlayKind { kPoint, kPlanned, kMark, kTarget };

/// Somewhere that is drawn over every picture that sees it, station frame.
struct OverlayPlace {
    OverlayKind kind = OverlayKind::kMark;
    Eigen::Vector3d p_station = Eigen::Vector3d::Zero();
    QString label;
    QString code;
    qint64 row_id = 0;
};

/// Something drawn over the picture at its true place, pixels of the frame.
struct OverlayItem {
    OverlayKind kind = OverlayKind::kPoint;
    QPointF px;
    QString label;
    QString code;
    qint64 row_id = 0;                  ///< of a point, planned point or mark
    MoveState move = MoveState::kNone;  ///< of a target
};

/// A frozen frame with its circle readings.
struct Still {
    int number = 0;
    camera::FramePtr frame;
    geometry::Pointing pointing;
    QString ha_text, va_text;
    QDateTime utc;
    qint64 photo_row_id = 0;  ///< 0 until the job has it
};

/// Everything the live view draws. Cheap to copy.
struct LiveScene {
    camera::FramePtr frame;
    std::optional<geometry::Pointing> pointing;  ///< at the frame's time
    bool moving = false;
    std::optional<QPointF> reticle_px;
    RangeAssumption range;
    QString range_text;  ///< `23.418 m (measured)`
    std::vector<OverlayItem> overlay;
    ParallaxCurve parallax;
};

struct LiveStatistics {
    double rate_hz = 0.0;
    std::uint64_t delivered = 0;
    std::uint64_t lost = 0;
    double age_ms = 0.0;             ///< capture to arrival of the newest frame
    double paint_latency_ms = 0.0;   ///< capture to paint, median of the last second
    core::VideoGate::Statistics gate;
    QString text;                    ///< `1280x720 30 fps`
};

/// `23.418 m (measured)`, `25.000 m (assumed)`.
[[nodiscard]] QString rangeText(const RangeAssumption& range, const UnitFormat& units);

/// The live view: newest frame, reticle, overlay, stills.
class LivePresenter : public QObject {
    Q_OBJECT
public:
    LivePresenter(InstrumentDesk& instrument, const PointsModel& points, const StationPresenter& station, RangeKeeper& range,
                  JobDesk& job, const Preferences& preferences, MessageCentre& messages, core::VideoGate& gate,
                  const core::Clock& clock, QObject* parent = nullptr);
    ~LivePresenter() override;

    /// Takes the source over and starts it; the old one is stopped.
    void setSource(std::unique_ptr<video::VideoSource> source);
    [[nodiscard]] const video::VideoSource* source() const { return source_.get(); }
    [[nodiscard]] video::VideoSource* camera() { return source_.get(); }  ///< for the camera page: pause, controls
    /// Starts the camera again in the mode and with the controls kept for it.
    void startCamera();
    /// A mode with more pixels than the live one; absent when the camera has none.
    [[nodiscard]] std::optional<video::VideoFormat> largestMode() const;
    /// The camera as it stands: mode, and focus and zoom when they are set by hand.
    [[nodiscard]] CameraUse cameraUse() const;
    /// The profile that model() was made from, and how well it suits.
    [[nodiscard]] const RigChoice& rigChoice() const { return rig_choice_; }
    [[nodiscard]] const LiveScene& scene() const { return scene_; }
    [[nodiscard]] const LiveStatistics& statistics() const { return statistics_; }
    [[nodiscard]] const StatusItem& cameraStatus() const { return status_; }
    [[nodiscard]] const std::optional<Still>& still() const { return still_; }
    [[nodiscard]] bool isCapturing() const { return capture_pending_; }
    /// Overlay of the points for a still: its own pointing, not the live one.
    [[nodiscard]] std::vector<OverlayItem> overlayFor(const geometry::Pointing& pointing) const;
    [[nodiscard]] const targeting::PixelToPointing& model() const { return model_; }  ///< of the rig of the camera in use
    /// Every picture as it comes, for a routine on another thread.
    [[nodiscard]] const std::shared_ptr<FrameFeed>& feed() const { return feed_; }
    /// Range for the reticle of a picture taken at this pointing.
    [[nodiscard]] RangeAssumption rangeFor(const geometry::Pointing& pointing) const;
    /// Reticle in a picture taken at this pointing.
    [[nodiscard]] std::optional<QPointF> reticleFor(const geometry::Pointing& pointing) const;
    /// Where the telescope's axis meets a picture taken at this pointing, from near to far.
    [[nodiscard]] ParallaxCurve parallaxFor(const geometry::Pointing& pointing) const;
    /// Points to find, drawn like recorded ones with their own symbol; replaces the ones before.
    void setPlannedPoints(std::vector<survey::PlannedPoint> planned);
    /// Places that do not depend on the station's coordinates (marks); replaces the ones before.
    void setExtraPlaces(std::vector<OverlayPlace> extra);
    /// Where a drawn point, planned point or mark is; absent when it is gone.
    [[nodiscard]] std::optional<OverlayPlace> placeOf(OverlayKind kind, qint64 row_id) const;
    /// The target's place in the image; TargetingPresenter sets it.
    void setTarget(const std::optional<geometry::Pointing>& target, double slope_distance_m, MoveState state);

public Q_SLOTS:
    /// Freezes the next frame taken while the telescope stands still.
    void capture();
    void cancelCapture();
    /// The widget painted this frame just now: counts the latency.
    void framePainted(pmts::core::Duration captured_at);
    void updateStatistics();  ///< once a second, by itself

Q_SIGNALS:
    void sourceChanged();  ///< another camera, or none
    void rigChoiceChanged();
    void sceneChanged();  ///< take scene(): a new frame, reticle or overlay
    void placesChanged();  ///< what is drawn over a still is no longer the same
    void statisticsChanged(const pmts::app::LiveStatistics& statistics);
    void cameraStatusChanged(const pmts::app::StatusItem& status);
    void stillCaptured(const pmts::app::Still& still);
    void captureWaiting(const QString& reason);  ///< empty when it no longer waits

private:
    void takeFrame();
    void placePoints();
    void placeGround(OverlayPlace place, double e_m, double n_m, double h_m, double target_height_m);
    void refreshPlaces();
    void refreshScene();
    void tryCapture();
    [[nodiscard]] bool awaitsFullStill();
    void takeFullStill(const video::FullStill& still);
    void doWithoutFullStill(const core::Error& error);
    void finishCapture(const camera::FramePtr& frame, const geometry::Pointing& pointing);
    void keepPhoto(const Still& still);
    void waitFor(const QString& reason);
    void showState(video::SourceState state);
    [[nodiscard]] QString troubleOr(const QString& usual) const;
    void setStatus(DeviceState state, const QString& text, const QString& details);
    [[nodiscard]] bool isInPicture(const Eigen::Vector2d& px) const;
    void followPreferences();

    InstrumentDesk& instrument_;
    const PointsModel& points_;
    const StationPresenter& station_;
    RangeKeeper& range_;
    JobDesk& job_;
    const Preferences& preferences_;
    MessageCentre& messages_;
    core::VideoGate& gate_;
    const core::Clock& clock_;
    std::unique_ptr<video::VideoSource> source_;
    std::shared_ptr<FrameFeed> feed_ = std::make_shared<FrameFeed>();
    LiveScene scene_;
    LiveStatistics statistics_;
    StatusItem status_;
    QString camera_trouble_;  ///< what the camera said last, until it runs
    std::optional<Still> still_;
    RigChoice rig_choice_;
    targeting::PixelToPointing model_;
    std::vector<survey::PlannedPoint> planned_;
    std::vector<OverlayPlace> extra_;
    std::vector<OverlayPlace> placed_;  ///< recorded and planned points
    bool capture_pending_ = false;
    camera::FramePtr candidate_;  ///< the frame that becomes the still once a reading after it says that nothing moved
    std::optional<video::VideoFormat> full_mode_;  ///< the photo under way is to be taken in this mode
    bool full_asked_ = false;
    camera::FramePtr full_;  ///< the candidate in all its pixels
    QString waiting_reason_;
    Ticket photo_ticket_ = 0;
    int stills_taken_ = 0;
    std::vector<double> paint_latencies_ms_;
    QTimer second_;
    std::optional<geometry::Pointing> target_;
    double target_range_m_ = 0.0;
    MoveState target_state_ = MoveState::kNone;
};

}  // namespace pmts::app
