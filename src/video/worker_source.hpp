#pragma once

#include "worker_run.hpp"

#include <QTimer>

#include <vector>

namespace pmts::video {

/// Every source: a device on a worker, the slot for its newest frame, and the watchdog over both.
class WorkerSource final : public VideoSource {
    Q_OBJECT
public:
    WorkerSource(SourceAddress address, DeviceFactory make_device, core::VideoGate& gate,
                 WorkerTimes times = {});
    ~WorkerSource() override;

    void start(const VideoFormat& wanted) override;
    void stop() override;
    void pause() override;
    void resume() override;
    void setControls(const std::vector<ControlValue>& wishes) override;
    void takeStill(const VideoFormat& mode) override;
    [[nodiscard]] DeviceReport report() const override { return report_; }
    [[nodiscard]] SourceAddress address() const override { return address_; }
    [[nodiscard]] SourceState state() const override { return state_; }
    [[nodiscard]] SourceStatistics statistics() const override { return slot_->statistics(now()); }
    [[nodiscard]] camera::FramePtr newestFrame() const override { return slot_->take(); }

private:
    void startRun();
    [[nodiscard]] WorkerRun::Notices notices();
    void retireRun();
    void watch();
    void enter(SourceState state);
    void tellProblem(const core::Error& error);
    [[nodiscard]] core::Error silence() const;

    const SourceAddress address_;
    const DeviceFactory make_device_;
    core::VideoGate& gate_;
    const WorkerTimes times_;
    const std::shared_ptr<FrameSlot> slot_ = std::make_shared<FrameSlot>();
    const std::shared_ptr<Outlet> outlet_;
    VideoFormat wanted_;
    std::vector<ControlValue> wishes_;
    DeviceReport report_;
    bool paused_ = false;
    SourceState state_ = SourceState::kStopped;
    std::shared_ptr<WorkerRun> run_;
    std::vector<std::shared_ptr<WorkerRun>> retired_;
    QString last_problem_;  ///< one report for one trouble, not one for each attempt
    core::Duration asked_to_reopen_at_{0};
    QTimer watchdog_;
};

}  // namespace pmts::video
