#include "pmts/simulator/bus_station.hpp"

#include "bus_processes.hpp"
#include "command_line.hpp"
#include "fault_box.hpp"
#include "paced_line.hpp"

#include <QCoreApplication>

#include <array>
#include <cmath>
#include <cstdio>
#include <deque>
#include <random>
#include <stdexcept>
#include <utility>

namespace pmts::simulator {
namespace {

constexpr int kVaLabel = 166, kHaLabel = 165, kBracketLabel = 102;
constexpr int kSwitchOffProcess = 21;
constexpr double kBitsPerByte = 10.0;
constexpr char kEot = '\x04';

QString tr(const char* text) { return QCoreApplication::translate("SimulatedBus", text); }

/// All times as they are on the clock: the rest knows nothing of the time scale.
BusStationSettings onTheClock(BusStationSettings settings) {
    if (const auto checked = checkSettings(settings); !checked) {
        throw std::logic_error(checked.error().sentence().toStdString());
    }
    for (core::Duration* span : {&settings.stream_interval, &settings.turn_around, &settings.process_time,
                                 &settings.calibration_time, &settings.start_up.step_time, &settings.start_up.patience}) {
        *span = std::chrono::duration_cast<core::Duration>(*span / settings.time_scale);
    }
    return settings;
}

/// It does not know the label, the unit, the syntax or the process.
bool isRefusal(std::string_view reply) {
    return reply.starts_with("20.") || reply == "22.8" || reply == "30.8" || reply == "242.8";
}

}  // namespace

core::Result<void> checkSettings(const BusStationSettings& settings) {
    const auto refuse = [](const QString& happened) { return core::fail(core::ErrorKind::kBadInput, happened); };
    const auto isShare = [](double value) { return value >= 0.0 && value <= 1.0; };
    if (!(settings.time_scale > 0.0) || settings.time_scale > 1e5) {
        return refuse(tr("The time scale must be above 0 and at most 100000."));
    }
    if (!(settings.baud >= 0.0) || settings.baud > 1e6) {
        return refuse(tr("The baud rate must be 0 (no pace) or up to 1000000."));
    }
    if (settings.stream_interval <= core::Duration::zero()) {
        return refuse(tr("The stream needs an interval."));
    }
    if (settings.reply_end.find(kEot) == std::string::npos) {
        return refuse(tr("A reply of the bus ends with EOT."));
    }
    if (settings.start_up.steps < 1 || !isShare(settings.start_up.failure_per_frame) ||
        settings.start_up.failure_per_late_second < 0.0) {
        return refuse(tr("The start-up needs a step and probabilities from 0 to 1."));
    }
    return {};
}

class BusStation::Impl {
public:
    Impl(BusStation& outside, BusStationSettings settings, std::shared_ptr<const TruePointing> pointing, core::Clock& clock)
        : outside_(outside),
          settings_(onTheClock(std::move(settings))),
          pointing_(std::move(pointing)),
          clock_(clock),
          random_(settings_.seed),
          faults_(settings_.seed),
          processes_(settings_),
          heard_(clock, [this](std::string_view bytes) { hear(bytes); }),
          said_(clock, [this](std::string_view bytes) { deliver(bytes); }),
          streaming_(settings_.streams_at_start) {
        if (settings_.baud > 0.0) {
            const auto per_byte = std::chrono::duration_cast<core::Duration>(
                std::chrono::duration<double>(kBitsPerByte / (settings_.baud * settings_.time_scale)));
            heard_.setByteTime(per_byte);
            said_.setByteTime(per_byte);
        }
        nextBlock();
    }

    void receive(std::string_view bytes) {
        if (unplugged_ || !on_) {
            return;
        }
        const std::string arriving = faults_.throughBadLine(bytes);
        if (!arriving.empty()) {
            heard_.put(arriving);
        }
    }

    core::Result<void> injectFault(const QString& text) {
        if (text.trimmed() == u"none") {
            faults_.clear();
            return {};
        }
        const auto fault = parseFault(text);
        if (!fault) {
            return tl::unexpected(fault.error());
        }
        if (!faultNames().contains(fault->name)) {
            return core::fail(core::ErrorKind::kBadInput, tr("The bus has no fault \"%1\".").arg(fault->name),
                              tr("It knows: %1.").arg(faultNames().join(QStringLiteral(", "))));
        }
        if (fault->name == u"unplug") {
            unplug(scaled(fault->value));
        } else if (fault->name == u"power_off") {
            switchOff(fault->value);
        } else {
            faults_.add(*fault);
        }
        return {};
    }

    [[nodiscard]] const BusProcesses& processes() const { return processes_; }
    [[nodiscard]] bool isOn() const { return on_; }

private:
    // The stream.
    void nextBlock() {
        stream_timer_ = clock_.callAfter(settings_.stream_interval, [this] {
            if (on_ && streaming_) {
                said_.put(streamBlock());
            }
            nextBlock();
        });
    }

    std::string streamBlock() {
        const auto pointing = pointing_->at(clock_.now());
        return "A,166=" + angleText(pointing.va) + "\rA,165=" + angleText(pointing.ha) + kEot;
    }

    std::string angleText(core::Angle truth) {
        const double noise = std::normal_distribution(0.0, 1.0)(random_) * settings_.angle_sigma.gon();
        double gon = core::normalized(truth + core::Angle::fromGon(noise)).gon();
        gon = std::round(gon * 1e5) / 1e5;
        std::array<char, 16> text{};
        const int length = std::snprintf(text.data(), text.size(), "%.5f", gon >= 400.0 ? 0.0 : gon);
        return {text.data(), static_cast<std::size_t>(length)};
    }

    // Commands, one at a time.
    void hear(std::string_view bytes) {
        for (const char byte : bytes) {
            if (byte == '\r' || byte == kEot) {
                takeLine(std::exchange(line_, {}));
            } else if (byte != '\n' && line_.size() <= static_cast<std::size_t>(settings_.max_command_length)) {
                line_ += byte;
            }
        }
    }

    void takeLine(std::string line) {
        if (line.empty()) {
            return;
        }
        if (busy_ && waiting_.size() >= static_cast<std::size_t>(settings_.queue_limit)) {
            said_.put("207.8" + settings_.reply_end);
            return;
        }
        waiting_.push_back(std::move(line));
        startNext();
    }

    void startNext() {
        if (busy_ || waiting_.empty()) {
            return;
        }
        busy_ = true;
        const std::string line = std::exchange(waiting_.front(), {});
        waiting_.pop_front();
        if (const auto code = faults_.take("info", line)) {
            answerAfter(settings_.turn_around, line, std::to_string(static_cast<int>(*code)) + ".8");
            return;
        }
        execute(line);
    }

    void execute(const std::string& line) {
        const auto command = parseCommandLine(line);
        if (line.size() > static_cast<std::size_t>(settings_.max_command_length)) {
            answerAfter(settings_.turn_around, line, "218.8");
        } else if (!command || !command->arguments.empty() || !command->number) {
            answerAfter(settings_.turn_around, line, "30.8");
        } else if (command->unit != 'V' && command->unit != 'A') {
            answerAfter(settings_.turn_around, line, "22.8");
        } else if (command->verb == 'P' && command->unit == 'V') {
            runProcess(line, *command);
        } else if (command->verb == 'W' || command->verb == 'R') {
            answerAfter(settings_.turn_around, line, command->verb == 'W' ? written(*command) : read(*command));
        } else {
            answerAfter(settings_.turn_around, line, "30.8");
        }
    }

    std::string written(const CommandLine& command) {
        const std::string device = command.unit == 'A' ? ".15" : ".8";
        if (command.unit == 'A' || command.number != kBracketLabel) {
            return "20" + device;
        }
        if (command.data != "0" && command.data != "1") {
            return "35" + device;
        }
        bracket_ = *command.data == "1";
        processes_.setBracket(!bracket_);
        if (settings_.label_102 == Label102::kSuspendsStream) {
            streaming_ = bracket_;
        }
        return "0" + device;
    }

    std::string read(const CommandLine& command) {
        const auto item = [&](const std::string& data) {
            return std::to_string(*command.number) + "=" + data;
        };
        const auto pointing = pointing_->at(clock_.now());
        if (command.unit == 'V' && command.number == kBracketLabel) {
            return item(bracket_ ? "1" : "0");
        }
        if (command.unit == 'A' && command.number == kVaLabel) {
            return item(angleText(pointing.va));
        }
        if (command.unit == 'A' && command.number == kHaLabel) {
            return item(angleText(pointing.ha));
        }
        return command.unit == 'A' ? "20.15" : "20.8";
    }

    void runProcess(const std::string& line, const CommandLine& command) {
        if (command.number == kSwitchOffProcess) {
            switchOff(0.0);
            return;
        }
        const auto frames = [this] { return outside_.frames_of_host ? outside_.frames_of_host() : 0; };
        const auto run = processes_.begin(command, clock_.now(), frames());
        process_timer_ = clock_.callAfter(run.takes, [this, line, run, frames] {
            const auto reply = processes_.end(run, frames());
            reply ? answerAfter(core::Duration::zero(), line, *reply) : done();
        });
    }

    // Replies.
    void answerAfter(core::Duration span, const std::string& line, const std::string& own_reply) {
        const auto late_s = faults_.take("late", line);
        const auto more = settings_.more_replies.find(line);
        const bool is_known = !isRefusal(own_reply) || more == settings_.more_replies.end();
        const std::string reply = is_known ? own_reply : more->second;
        reply_timer_ = clock_.callAfter(span + (late_s ? scaled(*late_s) : core::Duration::zero()),
                                        [this, line, reply] { answer(line, reply); });
    }

    void answer(const std::string& line, const std::string& reply) {
        if (faults_.take("silent", line) || reply.empty()) {
            done();
            return;
        }
        std::string bytes = reply;
        if (faults_.take("garble", line)) {
            bytes = faults_.garbled(bytes);
        }
        bytes += settings_.reply_end;
        if (faults_.take("half_block", line)) {
            bytes.resize(reply.size() / 2);
        }
        if (faults_.take("missing_eot", line)) {
            std::erase(bytes, kEot);
        }
        if (faults_.take("twice", line)) {
            bytes += bytes;
        }
        said_.put(bytes, {}, [this] { done(); });
    }

    void done() {
        processes_.setReplied(clock_.now());
        busy_ = false;
        startNext();
    }

    void deliver(std::string_view bytes) {
        const std::string arriving = faults_.throughBadLine(bytes);
        if (!unplugged_ && outside_.send && !arriving.empty()) {
            outside_.send(arriving);
        }
    }

    // Power and cable.
    void switchOff(double seconds) {
        on_ = false;
        forget();
        processes_ = BusProcesses(settings_);
        if (seconds > 0.0) {
            power_timer_ = clock_.callAfter(scaled(seconds), [this] {
                on_ = true;
                streaming_ = settings_.streams_at_start;
            });
        }
    }

    void unplug(core::Duration span) {
        unplugged_ = true;
        heard_.clear();
        line_.clear();
        unplug_timer_ = clock_.callAfter(span, [this] { unplugged_ = false; });
        if (outside_.on_unplug) {
            outside_.on_unplug(span);
        }
    }

    void forget() {
        for (core::Timer* timer : {&process_timer_, &reply_timer_}) {
            timer->cancel();
        }
        heard_.clear();
        said_.clear();
        line_.clear();
        waiting_.clear();
        busy_ = false;
    }

    [[nodiscard]] core::Duration scaled(double seconds) const {
        return std::chrono::duration_cast<core::Duration>(std::chrono::duration<double>(seconds / settings_.time_scale));
    }

    BusStation& outside_;
    BusStationSettings settings_;
    std::shared_ptr<const TruePointing> pointing_;
    core::Clock& clock_;
    std::mt19937 random_;
    FaultBox faults_;
    BusProcesses processes_;
    PacedLine heard_, said_;
    std::string line_;
    std::deque<std::string> waiting_;
    bool busy_ = false;
    bool streaming_;
    bool bracket_ = true;  ///< label 102
    bool on_ = true;
    bool unplugged_ = false;
    core::Timer stream_timer_, process_timer_, reply_timer_, power_timer_, unplug_timer_;
};

BusStation::BusStation(BusStationSettings settings, std::shared_ptr<const TruePointing> pointing, core::Clock& clock)
    : impl_(std::make_unique<Impl>(*this, std::move(settings), std::move(pointing), clock)) {}
BusStation::~BusStation() = default;

void BusStation::receive(std::string_view bytes) { impl_->receive(bytes); }
core::Result<void> BusStation::injectFault(const QString& fault) { return impl_->injectFault(fault); }
bool BusStation::isLaserOn() const { return impl_->processes().isLaserOn(); }
int BusStation::mode() const { return impl_->processes().mode(); }
bool BusStation::isStarted() const { return impl_->processes().isStarted(); }
bool BusStation::isOn() const { return impl_->isOn(); }

const QStringList& BusStation::faultNames() {
    static const QStringList names = [] {
        QStringList all;
        for (const char* name : {"silent", "late", "twice", "garble", "half_block", "missing_eot", "info", "drop", "unplug",
                                 "power_off"}) {
            all << QString::fromLatin1(name);
        }
        return all;
    }();
    return names;
}

}  // namespace pmts::simulator
