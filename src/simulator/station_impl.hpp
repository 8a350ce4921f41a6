#pragma once

#include "command_line.hpp"
#include "distance_meter.hpp"
#include "fault_box.hpp"
#include "file_store.hpp"
#include "label_store.hpp"
#include "paced_line.hpp"
#include "pmts/simulator/station.hpp"
#include "servo.hpp"

#include <QDateTime>

#include <deque>
#include <random>

namespace pmts::simulator {

/// Info codes the station gives by itself (protocol page 2.10).
namespace info {
inline constexpr int kTilted = 1, kWrongFace = 2, kOldDistance = 3, kNothingToRecord = 4, kNoDistance = 7,
                     kBatteryLow = 8, kWrongDevice = 22, kTimeOut = 23, kNotInThisState = 24, kNoData = 28,
                     kSyntax = 30, kMemoryLost = 51, kHorizontalOverload = 151, kVerticalOverload = 152,
                     kEndSwitch = 153, kHorizontalResidual = 155, kVerticalResidual = 156,
                     kBothResiduals = 157, kTargetNotFound = 158, kTargetLost = 161, kDistanceJump = 175,
                     kUserBreak = 190, kBusy = 197, kTooManyCommands = 207, kUnterminated = 217,
                     kTooLong = 218, kWrongProcess = 242, kNoSignal = 300, kSignal = 301;
}

/// What a command answers: an info code, lines, and the end mark.
struct Answer {
    std::optional<std::string> status;
    std::vector<std::string> lines;
};

/// Circles and distance at one moment, as the display would show them.
struct Reading {
    geometry::Pointing shown;
    std::optional<double> sd_m;
};

/// How an item of data is written: S, N, D or V.
using ReadForm = char;

class Station::Impl {
public:
    Impl(Station& outside, StationSettings settings, std::shared_ptr<const Scene> scene,
         std::shared_ptr<TruePointing> pointing, core::Clock& clock);

    void receive(std::string_view bytes);
    core::Result<void> injectFault(const QString& text);
    [[nodiscard]] int timesStruck(const QString& fault) const { return faults_.timesStruck(fault); }
    void pressRegKey();
    void receiveBreak();
    [[nodiscard]] bool isOn() const { return power_ != Power::kOff; }

private:
    enum class Power { kOff, kAsking, kAskingToCalibrate, kCalibrating, kReady };
    struct Load {
        char directory = 'M';
        std::string name;
        std::string partial;
        std::vector<std::string> lines;
    };
    struct PositionOrder {
        std::optional<core::Angle> ha_tolerance, va_tolerance;
    };

    // station.cpp: bytes to command lines, one command at a time, answers to bytes.
    void hear(std::string_view bytes);
    void hearCommandByte(char byte);
    void takeLine(std::string line);
    void execute(const std::string& line);
    void dispatch(const CommandLine& command);
    void answer(Answer answer);
    void answerStatus(int code) { answer({statusText(code), {}}); }
    void answerDone(int code = kAccepted);  ///< nothing but the end mark when accepted
    void transmit(const std::string& bytes);
    void commandDone();
    void emitBlock(const Answer& unsolicited);
    void abortCurrent();
    void watchLine();
    void watchIdle();
    [[nodiscard]] std::string block(const Answer& answer) const;
    [[nodiscard]] std::string statusText(int code) const;
    void setPace(double baud);

    // station_power.cpp
    void switchOff();
    void switchOn(bool keep_values);
    void answerContinue(const std::string& line);
    void startCalibration();
    void answerCalibration(const std::string& line);
    void calibrate();
    void calibrateSecondFace(const geometry::Pointing& home);

    // station_reading.cpp
    void read(const CommandLine& command);
    void readOneLabel(const CommandLine& command, ReadForm form);
    void signalTest();
    [[nodiscard]] Answer measurementBlock(ReadForm form, bool with_status, bool marks_recorded);
    [[nodiscard]] Answer refusedMeasurement(const Reading& now, ReadForm form, const QString& how,
                                            bool with_status) const;
    [[nodiscard]] std::vector<int> blockLabels(bool with_distance, const Reading& now) const;
    [[nodiscard]] std::vector<std::string> items(const std::vector<int>& labels, const Reading& now,
                                                 ReadForm form) const;
    [[nodiscard]] std::vector<std::string> item(int label, const std::string& text, ReadForm form) const;
    [[nodiscard]] std::optional<std::string> labelText(int label, const Reading& now) const;
    [[nodiscard]] std::optional<std::string> angleLabel(int label, const Reading& now) const;
    [[nodiscard]] std::optional<double> distanceLabel(int label, const Reading& now) const;
    [[nodiscard]] std::optional<int> readingRefused();
    [[nodiscard]] Reading takeReading();
    [[nodiscard]] std::optional<Reading> faceTwoOf(const Reading& now) const;
    [[nodiscard]] bool targetMoved() const;
    [[nodiscard]] std::optional<double> lightWay() const;

    // station_commands.cpp
    void write(const CommandLine& command);
    int writeLabel(const CommandLine& command);
    void applyWritten(int label);
    void trigger(const CommandLine& command);
    void distanceArrived();
    void measuringEnded();
    void runProcess(const CommandLine& command);
    void position(const CommandLine& command);
    void startPositioning(const PositionOrder& order);
    void goTo(const geometry::Pointing& true_target, int status_at_end);
    [[nodiscard]] static std::optional<PositionOrder> positionOrder(const std::string& data);
    [[nodiscard]] std::pair<core::Angle, bool> residual(core::Angle tolerance, const char* fault);
    [[nodiscard]] bool isFaceTwo() const;
    [[nodiscard]] bool compensated() const;
    [[nodiscard]] bool struckBy(const char* lasting_fault) const;  ///< asked where it has its effect
    [[nodiscard]] bool withoutControlUnit() const;
    [[nodiscard]] LabelStore& storeOf(char unit, int label);

    // station_files.cpp
    void handOut(const CommandLine& command);
    void startLoad(const CommandLine& command);
    void hearFileByte(char byte);
    void keepLoadedLine();
    void endLoad(int code);
    void erase(const CommandLine& command);
    void freeMemory(const CommandLine& command);

    // station_faults.cpp
    void applyAtOnce(const Fault& fault);
    void applyLasting(const Fault& fault);
    [[nodiscard]] bool refusedByFault(const std::string& line);
    [[nodiscard]] std::string withFaults(std::string bytes);
    [[nodiscard]] core::Duration scaled(double seconds) const;
    void unplug(core::Duration span);
    void repeatInfo23();

    Station& outside_;
    const StationSettings settings_;
    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<TruePointing> pointing_;
    core::Clock& clock_;
    std::mt19937 random_;
    mutable FaultBox faults_;  ///< counts what struck, also in a question
    LabelStore labels_;
    LabelStore cu_labels_;  ///< the control unit keeps its own temperature, pressure and humidity
    FileStore files_;
    DistanceMeter meter_;
    Servo servo_;
    PacedLine heard_;
    PacedLine said_;

    Power power_ = Power::kReady;
    core::Duration switched_off_at_{0};
    std::string line_;
    bool after_cr_ = false;
    bool busy_ = false;
    bool waits_for_distance_ = false;  ///< a TG whose EOT comes at the end
    std::string current_;              ///< the command being carried out
    std::deque<std::string> queue_;
    std::optional<Load> load_;
    int end_mark_ = '>';  ///< 0: none
    std::optional<int> pending_reading_status_;
    std::optional<int> forced_motion_status_;
    core::Angle orientation_;   ///< shown HA minus circle HA
    bool shows_point_ = false;  ///< labels 37-39 show the measured point, not the station
    std::optional<Reading> face_two_;
    geometry::Pointing measured_at_;  ///< true pointing of the distance
    qint64 clock_offset_s_ = 0;
    bool unplugged_ = false;
    bool deaf_ = false;
    bool panel_busy_ = false;

    core::Timer line_timer_, idle_timer_, late_timer_, calibration_timer_, load_timer_;
    core::Timer unplug_timer_, deaf_timer_, panel_timer_, power_timer_, info_23_timer_;
};

}  // namespace pmts::simulator
