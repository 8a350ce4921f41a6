#include "bus_processes.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace pmts::simulator {
namespace {

constexpr int kModeProcess = 3, kSecondLaserProcess = 4, kLaserProcess = 8, kCalibrationProcess = 20;
constexpr int kLaser = 9;
constexpr int kLastMode = 4;
constexpr const char* kDone = "240.8";
constexpr const char* kWrongProcess = "242.8";
constexpr const char* kFailed = "248.8";
constexpr const char* kBadData = "35.8";

std::optional<int> numberIn(const std::optional<std::string>& data) {
    int number = 0;
    const std::string text = data.value_or("0");
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

}  // namespace

BusProcesses::BusProcesses(const BusStationSettings& settings) : settings_(&settings), random_(settings.seed) {}

std::optional<std::string> BusProcesses::refusal(const CommandLine& command, int argument) const {
    const bool of_start_up = command.number == settings_->start_up.process;
    switch (*command.number) {
        case kModeProcess:
        case kSecondLaserProcess:
        case kLaserProcess:
        case kCalibrationProcess: break;
        default:
            if (!of_start_up) {
                return kWrongProcess;
            }
    }
    if (!numberIn(command.data) || (command.number == kModeProcess && (argument < 0 || argument > kLastMode))) {
        return kBadData;
    }
    if (settings_->label_102 == Label102::kTakesControl && !inside_bracket_ && !of_start_up) {
        return kFailed;
    }
    return std::nullopt;
}

BusProcesses::Run BusProcesses::begin(const CommandLine& command, core::Duration at, std::uint64_t frames_of_host) {
    Run run{.number = *command.number,
            .argument = numberIn(command.data).value_or(0),
            .refusal = {},
            .takes = settings_->process_time,
            .frames = frames_of_host};
    run.refusal = refusal(command, run.argument);
    if (run.refusal) {
        run.takes = settings_->turn_around;
    } else if (run.number == kCalibrationProcess) {
        run.takes = settings_->calibration_time;
    } else if (run.number == settings_->start_up.process) {
        run.takes = settings_->start_up.step_time;
        run.late = run.argument == 1 ? core::Duration::zero()
                                     : std::max(core::Duration::zero(), at - replied_at_ - settings_->start_up.patience);
    }
    return run;
}

std::optional<std::string> BusProcesses::end(const Run& run, std::uint64_t frames_of_host) {
    if (run.refusal) {
        return run.refusal;
    }
    if (run.number == settings_->start_up.process) {
        return startUpStep(run, frames_of_host);
    }
    if (run.number == kModeProcess) {
        mode_ = run.argument;
    } else if (run.number == kLaserProcess) {
        laser_prepared_ = run.argument == kLaser;
    } else if (run.number == kSecondLaserProcess) {
        laser_on_ = laser_on_ || (laser_prepared_ && run.argument == 0);
        return settings_->third_reply_missing ? std::nullopt : std::optional<std::string>(kDone);
    }
    return kDone;
}

/// Any step out of its order, and any that the host disturbs, makes it begin anew.
std::string BusProcesses::startUpStep(const Run& run, std::uint64_t frames_of_host) {
    const BusStartUp& start_up = settings_->start_up;
    const auto frames = static_cast<double>(frames_of_host - run.frames);
    const double late_s = std::chrono::duration<double>(run.late).count();
    const double goes_well = std::pow(1.0 - start_up.failure_per_frame, frames) *
                             std::max(0.0, 1.0 - start_up.failure_per_late_second * late_s);
    const bool in_order = run.argument == 1 || run.argument == next_step_;
    if (!in_order || std::uniform_real_distribution(0.0, 1.0)(random_) > goes_well) {
        next_step_ = 1;
        started_ = false;
        return kFailed;
    }
    next_step_ = run.argument + 1;
    started_ = run.argument == start_up.steps;
    return kDone;
}

}  // namespace pmts::simulator
