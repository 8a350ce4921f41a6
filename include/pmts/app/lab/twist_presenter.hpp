#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/lab/lab_calibration.hpp"
#include "pmts/app/desk/standing_frames.hpp"
#include "pmts/calibration/plumb_line.hpp"

#include <QObject>
#include <QPointF>

#include <deque>
#include <optional>
#include <vector>

namespace pmts::app {

/// Twist removal with a plumb line: measures the twist in every picture while the step is open, says which way to turn the
/// camera, and proves the result.
class TwistPresenter : public QObject {
    Q_OBJECT
public:
    static constexpr int kProofs = 8;  ///< pictures that verify

    TwistPresenter(LivePresenter& live, InstrumentDesk& instrument, Preferences& preferences, MessageCentre& messages,
                   Threading threading = Threading::kOwnThread, QObject* parent = nullptr);

    void setActive(bool active);  ///< the step is open: look at the pictures
    [[nodiscard]] DeviceState state() const;
    [[nodiscard]] QString step() const;           ///< what to do next, one sentence
    [[nodiscard]] QString twistText() const;      ///< `+812 mgon`, or a dash
    [[nodiscard]] QString qualityText() const;    ///< `± 0.3 mgon, line straight to 0.02 px`
    [[nodiscard]] QString proofText() const;      ///< outcome of verify()
    [[nodiscard]] const std::optional<core::Angle>& twist() const { return twist_; }
    [[nodiscard]] core::Angle tolerance() const { return tolerance_; }
    [[nodiscard]] bool isVerifying() const { return is_verifying_; }
    /// The line as it was found, pixels of the frame; empty without one.
    [[nodiscard]] const std::vector<QPointF>& line() const { return line_; }

public Q_SLOTS:
    void setTolerance(pmts::core::Angle tolerance);  ///< held between 1 mgon and 1 gon
    void click(const QPointF& frame_px);  ///< the plumb line is here
    void forgetClick();
    void verify();  ///< the mean of the next pictures against the tolerance
    void accept();  ///< takes the twist into the rig instead of out of the camera

Q_SIGNALS:
    void changed();

private:
    struct Measured {
        calibration::PictureLine line;
        calibration::TwistFromLine twist;
    };

    void look(const camera::FramePtr& frame);
    void show(const core::Result<Measured>& measured);
    void addProof(core::Angle twist);
    [[nodiscard]] bool isUpright() const;  ///< or its twist is known to the rig

    LivePresenter& live_;
    InstrumentDesk& instrument_;
    Preferences& preferences_;
    MessageCentre& messages_;
    Threading threading_;
    StandingFrames frames_;
    core::Angle tolerance_ = core::Angle::fromMgon(10);
    bool is_active_ = false;
    bool is_looking_ = false;
    bool is_verifying_ = false;
    std::optional<Eigen::Vector2d> clicked_px_;
    std::optional<core::Angle> twist_;
    std::optional<calibration::TwistFromLine> newest_;
    std::deque<double> recent_gon_;  ///< the last pictures: their median is shown
    std::vector<double> proofs_gon_;
    QString proof_text_;
    bool is_proved_ = false;
    bool is_known_ = false;  ///< the rig has this twist: nothing to remove
    QString trouble_;
    std::vector<QPointF> line_;
};

}  // namespace pmts::app
