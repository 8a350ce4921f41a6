#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/lab/lab_calibration.hpp"
#include "pmts/app/desk/standing_frames.hpp"
#include "pmts/calibration/mount_check.hpp"

#include <QObject>

#include <optional>

namespace pmts::app {

/// Finds out what the camera is strapped to: tilts the telescope, looks what the picture does, and tilts it back.
class MountPresenter : public QObject {
    Q_OBJECT
public:
    MountPresenter(LivePresenter& live, InstrumentDesk& instrument, Preferences& preferences, MessageCentre& messages,
                   Threading threading = Threading::kOwnThread, QObject* parent = nullptr);

    [[nodiscard]] bool isBusy() const { return phase_ != Phase::kIdle; }
    [[nodiscard]] DeviceState state() const;
    [[nodiscard]] QString step() const;         ///< what to do next, or what is being done: one sentence
    [[nodiscard]] QString verdict() const;      ///< `The camera is on the telescope.`; empty before a check
    [[nodiscard]] QString evidence() const;     ///< the numbers behind it
    [[nodiscard]] QString profileText() const;  ///< what the rig in use says
    [[nodiscard]] core::Angle tilt() const { return tilt_; }
    [[nodiscard]] const std::optional<calibration::MountCheck>& check() const { return check_; }
    [[nodiscard]] camera::MountKind kindInUse() const { return live_.model().rig().mount.kind; }

public Q_SLOTS:
    void setTilt(pmts::core::Angle tilt);  ///< held between 0.5 and 20 gon
    void start();                          ///< turns the instrument; refused with a sentence without it or a picture
    void cancel();
    /// The user knows better, or takes what the check found.
    void accept(pmts::camera::MountKind kind);

Q_SIGNALS:
    void changed();

private:
    enum class Phase { kIdle, kBefore, kTurning, kAfter, kComparing, kBack };

    void takeFrame(const camera::FramePtr& frame);
    void turn(const geometry::Pointing& target, Phase phase);
    void onTurned(Ticket ticket);
    void compare();
    void finish(const core::Result<calibration::MountCheck>& check);
    void fail(const QString& sentence);
    void enter(Phase phase);

    LivePresenter& live_;
    InstrumentDesk& instrument_;
    Preferences& preferences_;
    MessageCentre& messages_;
    Threading threading_;
    StandingFrames frames_;
    core::Angle tilt_ = core::Angle::fromGon(4);
    Phase phase_ = Phase::kIdle;
    Ticket ticket_ = 0;
    camera::FramePtr before_, after_;
    std::optional<calibration::MountCheck> check_;
    QString failure_;
};

}  // namespace pmts::app
