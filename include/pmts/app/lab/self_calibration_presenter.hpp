#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/lab/self_calibration_view.hpp"
#include "pmts/app/desk/threading.hpp"

#include <QFutureWatcher>
#include <QObject>
#include <QPointF>

#include <optional>

namespace pmts::app {

enum class SelfCalibrationPhase {
    kPick,       ///< a spot is wanted
    kReady,      ///< a spot is picked
    kSweeping,   ///< the instrument turns, scouting included
    kMeasuring,  ///< turns to the spot and measures its distance
    kSolving,    ///< in the pool
    kSolved,     ///< a result waits to be accepted or rejected
};

/// How far the sweep is.
struct SelfCalibrationProgress {
    int done = 0;
    int of = 0;
    int missed = 0;
    int seconds_left = 0;
    QString sentence;  ///< `Pointing 12 of 56, about 1 min 20 s left`
};

/// Self-calibration from a spot clicked in the live view: the instrument sweeps it over the picture, first near the
/// middle to learn the camera roughly, then everywhere; measures its distance when asked; solves; compares.
class SelfCalibrationPresenter : public QObject {
    Q_OBJECT
public:
    SelfCalibrationPresenter(LivePresenter& live, InstrumentDesk& instrument, Preferences& preferences,
                             MessageCentre& messages, Threading threading = Threading::kOwnThread,
                             QObject* parent = nullptr);
    ~SelfCalibrationPresenter() override;  ///< a running solution is cancelled and waited for

    [[nodiscard]] SelfCalibrationPhase phase() const { return phase_; }
    [[nodiscard]] DeviceState state() const;
    [[nodiscard]] bool isBusy() const;
    [[nodiscard]] QString step() const;  ///< what to do next, one sentence
    [[nodiscard]] const SelfCalibrationProgress& progress() const { return progress_; }
    /// The picked spot where the newest picture shows it.
    [[nodiscard]] std::optional<QPointF> spotPx() const;
    [[nodiscard]] bool canCalibrate() const { return phase_ == SelfCalibrationPhase::kReady; }
    [[nodiscard]] int spots() const { return static_cast<int>(spots_.size()); }  ///< swept so far
    /// One calibration takes 60 pointings at the most, whatever the number of its spots.
    [[nodiscard]] bool hasRoomForASpot() const;
    [[nodiscard]] bool measuresRange() const { return measures_range_; }
    [[nodiscard]] bool isSighted() const { return is_sighted_; }
    [[nodiscard]] bool onHandle() const { return on_handle_; }
    [[nodiscard]] const std::optional<SelfCalibrationView>& view() const { return view_; }
    [[nodiscard]] QString comparedWith() const;  ///< `the rig in use`, `the rig before that`
    [[nodiscard]] bool canCompareWithBefore() const;

public Q_SLOTS:
    /// False when the click is not taken: busy, no picture, the telescope moves.
    bool pickSpot(const QPointF& frame_px);
    void setMeasuresRange(bool on);
    void setSighted(bool on);  ///< the cross-hair of the telescope is on the spot
    void setOnHandle(bool on);
    /// Sweeps the picked spot; alone, or together with the spots swept before when `further`.
    void calibrate(bool further = false);
    void cancel();
    void accept();
    void reject();
    void compareWithBefore(bool before);

Q_SIGNALS:
    void changed();  ///< take everything
    void progressChanged();
    void refused(const QString& sentence);
    void accepted(const QString& profile);

private:
    using Solved = core::Result<calibration::SelfCalibration>;
    struct Picked {
        targeting::Click click;
        geometry::Pointing cross_hair;
    };

    void setPhase(SelfCalibrationPhase phase);
    void refuse(const QString& sentence);
    void fail(const core::Error& error);
    void sweepStage();
    void onStep(Ticket ticket, const targeting::SweepStep& step);
    void onSwept(Ticket ticket, const targeting::SweepOutcome& outcome);
    void afterSweep();
    void keepSpot();
    void onTurned(Ticket ticket);
    void onShot(Ticket ticket, double slope_distance_m);
    void onFailed(Ticket ticket, const core::Error& error);
    void solve();
    void finishSolving();
    void show();
    void tellProgress(int done_in_stage, double seconds_each);
    [[nodiscard]] camera::Rig startRig() const;
    [[nodiscard]] geometry::PolarPoint believedPlace() const;

    LivePresenter& live_;
    InstrumentDesk& instrument_;
    Preferences& preferences_;
    MessageCentre& messages_;
    Threading threading_;
    SelfCalibrationPhase phase_ = SelfCalibrationPhase::kPick;
    SelfCalibrationProgress progress_;
    std::optional<Picked> picked_;
    bool measures_range_ = true;
    bool is_sighted_ = false;
    bool on_handle_ = false;
    bool before_ = false;
    Ticket ticket_ = 0;
    int stage_ = 0;
    int pointings_left_ = 0;    ///< of this spot
    int pointings_used_ = 0;    ///< by the spots swept so far
    int done_before_ = 0;       ///< pointings of the stages before this one
    double seconds_each_ = 2.0;
    camera::Rig start_;         ///< what was known before the first spot
    camera::Rig rough_;         ///< what is known now
    calibration::SweptSpot sweeping_;
    std::vector<targeting::SpotSighting> seen_;  ///< of this spot, by the stages before this one
    std::vector<calibration::SweptSpot> spots_;
    std::optional<calibration::SelfCalibration> found_;
    std::optional<SelfCalibrationView> view_;
    QFutureWatcher<Solved> watcher_;
};

}  // namespace pmts::app
