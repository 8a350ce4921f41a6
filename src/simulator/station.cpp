#include "pmts/simulator/station.hpp"

#include "station_impl.hpp"

#include <stdexcept>

namespace pmts::simulator {
namespace {

constexpr char kCr = '\r', kLf = '\n';

/// All times and speeds as they are on the clock: the rest of the station knows nothing of the time scale.
StationSettings onTheClock(StationSettings settings) {
    if (const auto checked = checkSettings(settings); !checked) {
        throw std::logic_error(checked.error().sentence().toStdString());
    }
    const double scale = settings.time_scale;
    const auto faster = [scale](core::Duration& span) {
        span = std::chrono::duration_cast<core::Duration>(span / scale);
    };
    for (core::Duration* span :
         {&settings.settle, &settings.std_time, &settings.fast_std_time, &settings.trk_interval,
          &settings.d_bar_first, &settings.d_bar_interval, &settings.long_range_extra,
          &settings.retry_interval, &settings.dr_time, &settings.dr_time_per_m, &settings.turn_around,
          &settings.unterminated_after, &settings.load_time_out, &settings.values_kept,
          &settings.switch_off_when_idle, &settings.calibration_per_face}) {
        faster(*span);
    }
    settings.speed_gon_s *= scale;
    settings.acceleration_gon_s2 *= scale * scale;
    return settings;
}

UnitDigits unitsOf(const StationSettings& settings) {
    return unitDigits(settings.unit_status.toStdString(), settings.mbar_digit).value();
}

}  // namespace

Station::Impl::Impl(Station& outside, StationSettings settings, std::shared_ptr<const Scene> scene,
                    std::shared_ptr<TruePointing> pointing, core::Clock& clock)
    : outside_(outside),
      settings_(onTheClock(std::move(settings))),
      scene_(std::move(scene)),
      pointing_(std::move(pointing)),
      clock_(clock),
      random_(settings_.seed),
      faults_(settings_.seed),
      labels_(settings_, unitsOf(settings_)),
      cu_labels_(settings_, unitsOf(settings_)),
      files_(settings_.memory_bytes),
      meter_(settings_, clock, [this] { return lightWay(); }),
      servo_(settings_, clock, pointing_),
      heard_(clock, [this](std::string_view bytes) { hear(bytes); }),
      said_(clock,
            [this](std::string_view bytes) {
                const std::string arriving = faults_.throughBadLine(bytes);
                if (!unplugged_ && outside_.send && !arriving.empty()) {
                    outside_.send(arriving);
                }
            }),
      power_(settings_.starts_switched_off ? Power::kOff : Power::kReady),
      end_mark_(settings_.end_mark) {
    switched_off_at_ = clock.now() - settings_.values_kept;
    meter_.on_distance = [this] { distanceArrived(); };
    meter_.on_end = [this] { measuringEnded(); };
    meter_.is_turning = [this] { return servo_.isTurning(); };
    setPace(settings_.baud);
    watchIdle();
}

void Station::Impl::setPace(double baud) {
    const auto per_byte = baud > 0.0 ? std::chrono::duration<double>(10.0 / (baud * settings_.time_scale))
                                     : std::chrono::duration<double>(0.0);
    heard_.setByteTime(std::chrono::duration_cast<core::Duration>(per_byte));
    said_.setByteTime(std::chrono::duration_cast<core::Duration>(per_byte));
}

void Station::Impl::receive(std::string_view bytes) {
    if (deaf_) {
        faults_.strike(QStringLiteral("initialising"));
    }
    if (unplugged_ || deaf_ || power_ == Power::kOff) {
        return;
    }
    const std::string arriving = faults_.throughBadLine(bytes);
    if (!arriving.empty()) {
        heard_.put(arriving);
    }
}

void Station::Impl::hear(std::string_view bytes) {
    for (const char byte : bytes) {
        if (load_) {
            hearFileByte(byte);
        } else {
            hearCommandByte(byte);
        }
    }
    watchLine();
}

void Station::Impl::hearCommandByte(char byte) {
    const bool end_of_cr_lf = byte == kLf && after_cr_;
    after_cr_ = byte == kCr;
    if (end_of_cr_lf) {
        return;
    }
    if (byte == kCr) {
        takeLine(std::exchange(line_, {}));
    } else if (line_.size() <= static_cast<std::size_t>(settings_.max_command_length)) {
        line_ += byte;  // one more than allowed is kept, so that the length is known to be too much
    }
}

/// A command that never ends is answered by itself.
void Station::Impl::watchLine() {
    if (line_.empty()) {
        line_timer_.cancel();
        return;
    }
    line_timer_ = clock_.callAfter(settings_.unterminated_after, [this] {
        line_.clear();
        if (settings_.unterminated_status != 0) {
            emitBlock({statusText(settings_.unterminated_status), {}});
        }
    });
}

void Station::Impl::watchIdle() {
    const auto fault_s = faults_.value("auto_power_off");
    const auto limit = fault_s ? scaled(*fault_s) : settings_.switch_off_when_idle;
    if (limit > core::Duration{0}) {
        idle_timer_ = clock_.callAfter(limit, [this] {
            (void)struckBy("auto_power_off");
            switchOff();
        });
    } else {
        idle_timer_.cancel();
    }
}

void Station::Impl::takeLine(std::string line) {
    watchIdle();
    if (line.empty()) {
        return;  // a bare CR carries no command
    }
    if (power_ == Power::kAsking) {
        answerContinue(line);
        return;
    }
    if (power_ == Power::kAskingToCalibrate) {
        answerCalibration(line);
        return;
    }
    if (!busy_) {
        execute(line);
        return;
    }
    const bool stops = settings_.mode_command_stops_motion && line.starts_with("PG,3=") &&
                       ((servo_.isTurning() && current_.starts_with("WS")) || waits_for_distance_);
    if (stops) {
        queue_.push_front(std::move(line));
        abortCurrent();
    } else if (queue_.size() >= static_cast<std::size_t>(settings_.queue_limit)) {
        emitBlock({statusText(info::kTooManyCommands), {}});
    } else {
        queue_.push_back(std::move(line));
    }
}

void Station::Impl::abortCurrent() {
    servo_.stop();
    waits_for_distance_ = false;
    answerStatus(info::kUserBreak);
}

void Station::Impl::execute(const std::string& line) {
    busy_ = true;
    current_ = line;
    if (refusedByFault(line)) {
        return;
    }
    if (line.size() > static_cast<std::size_t>(settings_.max_command_length)) {
        answerStatus(info::kTooLong);
        return;
    }
    const auto command = parseCommandLine(line);
    if (!command) {
        answerStatus(info::kSyntax);
        return;
    }
    dispatch(*command);
}

void Station::Impl::dispatch(const CommandLine& command) {
    switch (command.verb) {
        case 'R':
            return read(command);
        case 'W':
            return command.unit == 'S' ? position(command) : write(command);
        case 'T':
            return trigger(command);
        case 'P':
            return runProcess(command);
        case 'O':
            return handOut(command);
        case 'L':
            return startLoad(command);
        case 'K':
            return erase(command);
        default:
            return freeMemory(command);
    }
}

std::string Station::Impl::statusText(int code) const {
    const bool bare = code == 0 || code >= info::kNoSignal || !settings_.status_suffix;
    return bare ? std::to_string(code)
                : std::to_string(code) + '.' + std::to_string(*settings_.status_suffix);
}

std::string Station::Impl::block(const Answer& answer) const {
    std::string bytes;
    if (answer.status) {
        bytes += *answer.status + "\r\n";
    }
    for (const std::string& line : answer.lines) {
        bytes += line + "\r\n";
    }
    if (end_mark_ != 0) {
        bytes += static_cast<char>(end_mark_);
    }
    return bytes;
}

void Station::Impl::answerDone(int code) {
    if (code != kAccepted) {
        answerStatus(code);
        return;
    }
    const bool writes = current_.starts_with("WG") || current_.starts_with("WR");
    answer({withoutControlUnit() && writes ? std::optional<std::string>("0.0") : std::nullopt, {}});
}

void Station::Impl::answer(Answer answer) {
    const std::string bytes = withFaults(block(answer));
    if (faults_.take("silent", current_)) {
        commandDone();
        return;
    }
    const auto late_s = faults_.take("late", current_);
    const auto delay = settings_.turn_around + (late_s ? scaled(*late_s) : core::Duration{0});
    if (delay > core::Duration{0}) {
        late_timer_ = clock_.callAfter(delay, [this, bytes] { transmit(bytes); });
    } else {
        transmit(bytes);
    }
}

void Station::Impl::transmit(const std::string& bytes) {
    said_.put(bytes, {}, [this] { commandDone(); });
}

void Station::Impl::commandDone() {
    busy_ = false;
    end_mark_ = static_cast<int>(labels_.number(protocol::kEndMark));
    if (!queue_.empty() && power_ == Power::kReady) {
        const std::string next = std::move(queue_.front());
        queue_.pop_front();
        execute(next);
    }
}

void Station::Impl::emitBlock(const Answer& unsolicited) {
    if (power_ != Power::kOff) {
        said_.put(block(unsolicited));
    }
}

Station::Station(StationSettings settings, std::shared_ptr<const Scene> scene,
                 std::shared_ptr<TruePointing> pointing, core::Clock& clock)
    : impl_(
          std::make_unique<Impl>(*this, std::move(settings), std::move(scene), std::move(pointing), clock)) {}

Station::~Station() = default;

void Station::receive(std::string_view bytes) { impl_->receive(bytes); }
core::Result<void> Station::injectFault(const QString& fault) { return impl_->injectFault(fault); }
int Station::timesStruck(const QString& fault) const { return impl_->timesStruck(fault); }
void Station::pressRegKey() { impl_->pressRegKey(); }
void Station::receiveBreak() { impl_->receiveBreak(); }
bool Station::isOn() const { return impl_->isOn(); }

}  // namespace pmts::simulator
