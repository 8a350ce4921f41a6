#include "info_code_table.hpp"

#include <QtGlobal>

#include <array>

namespace pmts::protocol {
namespace {

using enum InfoClass;

#define T(text) QT_TRANSLATE_NOOP("InfoCode", text)

constexpr const char* kNothing = "";
constexpr const char* kCheckCable = T("Check the cable and the line settings, then repeat the action.");
constexpr const char* kRepeat = T("Repeat the action.");
constexpr const char* kSendLog = T("Repeat the action; when it stays, keep the log and tell the supplier.");
constexpr const char* kServiceIfItStays =
    T("Switch the instrument off and on; when it stays, it needs service.");
constexpr const char* kNeedsService = T("The instrument needs service.");
constexpr const char* kMeasureAgain = T("Aim and measure again.");
constexpr const char* kCheckRadio = T("Check the radio, its channel and its aerial, then repeat the action.");
constexpr const char* kFreeAxis = T("Make sure that the instrument turns freely, then repeat the motion.");
constexpr const char* kWait = T("Wait for the instrument to finish, then repeat the action.");
constexpr const char* kOffAndOn = T("Switch the instrument off and on, then repeat the action.");

// clang-format off
constexpr std::array kRows{
    InfoRow{  0,   0, kOk,            T("Everything that was asked for is valid."), kNothing},
    InfoRow{  1,   1, kOperator,      T("The instrument is tilted beyond the range of its compensator."), T("Level it, then repeat the action.")},
    InfoRow{  2,   2, kOperator,      T("The instrument is in the wrong face or not aimed as needed."), T("Turn it to face I, aim, then repeat the action.")},
    InfoRow{  3,   3, kRemeasure,     T("This distance has already been recorded."), T("Measure the distance again.")},
    InfoRow{  4,   4, kRemeasure,     T("The measurement is not valid, there is nothing to record."), kMeasureAgain},
    InfoRow{  5,   5, kConfiguration, T("The instrument has no output table for this measuring mode."), T("Choose another mode, or set the output table on the control unit.")},
    InfoRow{  6,   6, kOperator,      T("The vertical angle is within 15 gon of the horizon."), T("Aim higher or lower for the tilt-axis test.")},
    InfoRow{  7,   7, kRemeasure,     T("There is no distance yet, and the record needs one."), T("Measure the distance first.")},
    InfoRow{  8,   8, kPower,         T("The battery of the instrument is low."), T("Change it soon; the instrument switches itself off.")},
    InfoRow{  9,   9, kPower,         T("The battery of the external unit is low."), T("Change it soon.")},
    InfoRow{ 10,  10, kConfiguration, T("No memory is switched on in the instrument."), T("Switch one on in the control unit.")},
    InfoRow{ 16,  16, kConfiguration, T("This is not possible in remote mode."), T("Leave remote mode on the control unit.")},
    InfoRow{ 17,  17, kConfiguration, T("This is not possible while Autolock is on."), T("Switch Autolock off on the control unit.")},
    InfoRow{ 18,  18, kConfiguration, T("The control unit is not on the instrument."), T("Put it on, then repeat the action.")},
    InfoRow{ 19,  19, kComm,          T("A transfer was disturbed."), kCheckCable},
    InfoRow{ 20,  20, kProtocol,      T("The instrument does not accept this label."), T("Check the label number.")},
    InfoRow{ 21,  21, kComm,          T("The serial line was disturbed."), kCheckCable},
    InfoRow{ 22,  22, kComm,          T("No device, or the wrong one, is connected to the instrument."), kCheckCable},
    InfoRow{ 23,  23, kComm,          T("The instrument waited in vain for the rest of a message."), T("Check the cable and the line settings; a plug that touches the three bus pins of a 400, 500 or 4000 does this too.")},
    InfoRow{ 24,  24, kState,         T("The instrument cannot do this in its present state."), T("Turn it to face I, leave any menu or program on the control unit, then repeat the action.")},
    InfoRow{ 25,  25, kService,       T("The clock of the instrument is disturbed."), T("Set date and time; when it comes back, the instrument needs service.")},
    InfoRow{ 26,  26, kService,       T("The backup battery of the instrument is old."), T("Save its files and have the backup battery changed.")},
    InfoRow{ 27,  27, kConfiguration, T("The instrument does not have the option that this needs."), T("Ask the supplier about the option.")},
    InfoRow{ 28,  28, kRemeasure,     T("The instrument holds no data to hand out."), kMeasureAgain},
    InfoRow{ 30,  30, kProtocol,      T("The instrument did not understand the command."), kSendLog},
    InfoRow{ 31,  31, kProtocol,      T("A number in the command is out of range."), T("Check the value.")},
    InfoRow{ 32,  32, kProtocol,      T("The instrument has no file, point or program of this name."), T("Check the name; capital and small letters differ.")},
    InfoRow{ 33,  33, kProtocol,      T("The instrument already has a record of this name."), T("Choose another name.")},
    InfoRow{ 34,  34, kProtocol,      T("The instrument stumbled over a separator in the data."), kSendLog},
    InfoRow{ 35,  35, kProtocol,      T("The instrument does not accept this value."), T("Check the value and its range.")},
    InfoRow{ 36,  36, kComm,          T("The memory of the instrument is full."), T("Save files to the computer and erase them on the control unit.")},
    InfoRow{ 37,  37, kComm,          T("The transfer did not follow the protocol."), kCheckCable},
    InfoRow{ 39,  39, kComm,          T("Data came too fast, or there are too many road offsets."), kRepeat},
    InfoRow{ 40,  40, kState,         T("A process in the instrument took too long and was ended."), kRepeat},
    InfoRow{ 41,  41, kProtocol,      T("This label holds another kind of value."), T("Check the label number and the value.")},
    InfoRow{ 42,  42, kProtocol,      T("The memory for user sequences is full."), T("Erase a user sequence on the control unit.")},
    InfoRow{ 43,  44, kState,         T("The instrument could not finish a calculation."), T("Check the station and target data, then repeat the action.")},
    InfoRow{ 45,  45, kComm,          T("The connected device does not fit the instrument."), T("Connect the right device.")},
    InfoRow{ 46,  46, kComm,          T("The instrument cannot be switched on by radio."), T("Switch it on by hand.")},
    InfoRow{ 48,  48, kOperator,      T("The station data changed, or no station is established."), T("Establish the station again.")},
    InfoRow{ 49,  49, kComm,          T("No instrument is connected to the control unit."), kCheckCable},
    InfoRow{ 50,  50, kService,       T("The configuration of the instrument is damaged."), kNeedsService},
    InfoRow{ 51,  51, kService,       T("A check sum in the instrument's memory is wrong, data may be lost."), T("Check units, prism constant and ppm on the instrument and save its files; it needs service.")},
    InfoRow{ 53,  53, kService,       T("The angle system is over its range."), kServiceIfItStays},
    InfoRow{ 54,  54, kService,       T("The instrument has lost its memory."), T("Set units, prism constant and ppm anew on the instrument, and have its backup battery checked.")},
    InfoRow{103, 103, kComm,          T("The radio finds no carrier."), kCheckRadio},
    InfoRow{107, 107, kComm,          T("The radio channel is busy."), T("Wait, or choose another channel.")},
    InfoRow{122, 122, kComm,          T("The radio is not connected."), kCheckRadio},
    InfoRow{123, 123, kComm,          T("The radio got no answer in time."), kCheckRadio},
    InfoRow{125, 125, kComm,          T("The radio channel is not usable."), T("Choose another channel.")},
    InfoRow{100, 137, kComm,          T("The radio link is disturbed."), kCheckRadio},
    InfoRow{150, 150, kOk,            T("The motion is finished."), kNothing},
    InfoRow{151, 151, kMotion,        T("The horizontal motor is overloaded."), kFreeAxis},
    InfoRow{152, 152, kMotion,        T("The vertical motor is overloaded."), kFreeAxis},
    InfoRow{153, 153, kMotion,        T("The telescope has reached its end switch."), T("Choose a direction inside the motion limits.")},
    InfoRow{154, 154, kMotion,        T("Servo and tracker do not understand each other."), kOffAndOn},
    InfoRow{155, 155, kMotionSoft,    T("The horizontal motion ended outside its tolerance."), T("Shield the instrument from wind and shaking, or allow a wider tolerance.")},
    InfoRow{156, 156, kMotionSoft,    T("The vertical motion ended outside its tolerance."), T("Shield the instrument from wind and shaking, or allow a wider tolerance.")},
    InfoRow{157, 157, kMotionSoft,    T("Both motions ended outside their tolerance."), T("Shield the instrument from wind and shaking, or allow a wider tolerance.")},
    InfoRow{158, 158, kTarget,        T("The target was not found."), T("Aim nearer to it, then search again.")},
    InfoRow{159, 159, kOk,            T("The instrument is locked on the target."), kNothing},
    InfoRow{160, 160, kMotion,        T("The instrument cannot turn to this angle."), T("Choose a direction inside the motion limits.")},
    InfoRow{161, 161, kTarget,        T("The target was lost."), T("Aim at it again.")},
    InfoRow{162, 163, kProtocol,      T("The servo did not understand its order."), kSendLog},
    InfoRow{164, 164, kService,       T("The servo cannot start."), T("Keep the knobs still and switch the instrument off and on; when it stays, it needs service.")},
    InfoRow{166, 166, kTarget,        T("There is no distance: no signal came back."), T("Aim at a prism or at a surface that reflects.")},
    InfoRow{167, 167, kOperator,      T("The collimation error of the tracker is too large."), T("Calibrate the tracker on the control unit.")},
    InfoRow{168, 168, kOperator,      T("The target is nearer than 100 m."), T("Use a target farther away for the tracker calibration.")},
    InfoRow{171, 173, kRemeasure,     T("The distance could not be computed."), kMeasureAgain},
    InfoRow{174, 174, kRemeasure,     T("The distance meter lost its internal reference."), T("Measure again; when it stays, the instrument needs service.")},
    InfoRow{175, 175, kRemeasure,     T("The distance came out above 32 km, often after a jump between targets."), kMeasureAgain},
    InfoRow{190, 190, kAbort,         T("The process in the instrument was stopped."), kNothing},
    InfoRow{191, 191, kState,         T("The upper part of the instrument could not carry out the command."), kRepeat},
    InfoRow{197, 197, kRetry,         T("A channel inside the instrument is busy."), kWait},
    InfoRow{199, 200, kService,       T("The program of the instrument has an internal error."), kServiceIfItStays},
    InfoRow{201, 201, kState,         T("The instrument could not finish a calculation."), T("Check the station and target data, then repeat the action.")},
    InfoRow{203, 206, kService,       T("The program of the instrument has an internal error."), kServiceIfItStays},
    InfoRow{207, 207, kComm,          T("The instrument got more commands than it can keep."), kWait},
    InfoRow{210, 213, kService,       T("The program of the instrument has an internal error."), kServiceIfItStays},
    InfoRow{217, 217, kComm,          T("A buffer of the instrument overflowed; the end of a command was missing."), kCheckCable},
    InfoRow{218, 218, kComm,          T("The command is too long for the instrument."), kSendLog},
    InfoRow{219, 219, kService,       T("The program of the instrument has an internal error."), kServiceIfItStays},
    InfoRow{221, 234, kService,       T("The angle system of the instrument reports an error."), kServiceIfItStays},
    InfoRow{240, 240, kOk,            T("The process in the instrument is finished."), kNothing},
    InfoRow{241, 241, kState,         T("No process is active in the instrument."), T("Initialise the instrument, then repeat the action.")},
    InfoRow{242, 242, kProtocol,      T("The instrument does not have this process."), kSendLog},
    InfoRow{243, 243, kState,         T("The instrument cannot keep another process."), kWait},
    InfoRow{244, 244, kState,         T("A unit inside the instrument is not active."), kOffAndOn},
    InfoRow{245, 245, kState,         T("This process is already running in the instrument."), kWait},
    InfoRow{246, 246, kState,         T("A process in the instrument ended with a general error."), kRepeat},
    InfoRow{247, 247, kState,         T("A process in the instrument took too long."), kRepeat},
    InfoRow{248, 248, kState,         T("A process in the instrument failed."), kRepeat},
    InfoRow{255, 255, kService,       T("The program of the instrument has an internal error."), kServiceIfItStays},
    InfoRow{300, 300, kData,          T("No signal comes back to the distance meter."), T("Aim at a prism or at a surface that reflects.")},
    InfoRow{301, 301, kData,          T("A signal comes back to the distance meter."), kNothing},
};
// clang-format on

#undef T

}  // namespace

std::span<const InfoRow> infoTable() { return kRows; }

}  // namespace pmts::protocol
