#include "pmts/protocol/command.hpp"

#include <algorithm>
#include <stdexcept>

namespace pmts::protocol {
namespace {

constexpr int kHighestLabelNumber = 999;
constexpr std::size_t kLongestFileName = 15;

template <class... Ts>
struct Overloaded : Ts... {
    using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

void require(bool condition, const char* what) {
    if (!condition) {
        throw std::logic_error(what);
    }
}

bool isPlainText(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return c >= 0x20 && c <= 0x7E; });
}

std::string unitLetter(Device device) { return device == Device::kStation ? "G" : "R"; }

std::string formLetter(ReadForm form) {
    switch (form) {
        case ReadForm::kStandard:
            return "";
        case ReadForm::kNames:
            return "N";
        case ReadForm::kDataOnly:
            return "D";
        case ReadForm::kSeparate:
            return "V";
    }
    throw std::logic_error("unknown form");
}

std::string directoryLetter(Directory directory) {
    switch (directory) {
        case Directory::kJob:
            return "M";
        case Directory::kArea:
            return "I";
        case Directory::kUserSequence:
            return "U";
        case Directory::kGeodatProtocol:
            return "D";
        case Directory::kAll:
            return "*";
    }
    throw std::logic_error("unknown directory");
}

std::string labelText(int label) {
    require(label >= 0 && label <= kHighestLabelNumber, "no instrument has this label");
    return std::to_string(label);
}

std::string axisTolerance(char axis, int tolerance_cc) {
    require(tolerance_cc >= 0 && tolerance_cc <= 99, "the tolerance of WS is 0 to 99 cc");
    return {axis, static_cast<char>('0' + tolerance_cc / 10), static_cast<char>('0' + tolerance_cc % 10)};
}

std::string fileArgument(const std::string& name) {
    require(!name.empty() && name.size() <= kLongestFileName && isPlainText(name),
            "not a file name of the instrument");
    return "=" + name;
}

/// `OM=NAME`, `OM3=NAME`, `OD`: the recorder's protocol directory is one file without a name.
template <class Transfer>
std::string transfer(char verb, const Transfer& command) {
    require(command.directory != Directory::kAll, "one file at a time is transferred");
    const std::string start = verb + directoryLetter(command.directory);
    if (command.directory == Directory::kGeodatProtocol) {
        return start;
    }
    return start + (command.via_protocol ? std::to_string(*command.via_protocol) : "") +
           fileArgument(command.name);
}

std::string position(const Position& command) {
    require(command.ha_tolerance_cc || command.va_tolerance_cc, "WS moves at least one axis");
    std::string line = "WS=P";
    if (command.ha_tolerance_cc) {
        line += axisTolerance('H', *command.ha_tolerance_cc);
    }
    if (command.va_tolerance_cc) {
        line += axisTolerance('V', *command.va_tolerance_cc);
    }
    return line;
}

std::string trigger(TriggerRange range) {
    switch (range) {
        case TriggerRange::kNormal:
            return "TG";
        case TriggerRange::kShort:
            return "TG<";
        case TriggerRange::kLong:
            return "TG>";
    }
    throw std::logic_error("unknown range");
}

std::string writeLabel(const WriteLabel& command) {
    require(isPlainText(command.data), "label data is one line of 7-bit text");
    return "W" + unitLetter(command.device) + "," + labelText(command.label) + "=" + command.data;
}

std::string erase(const EraseFile& command) {
    const std::string start = "K" + directoryLetter(command.directory);
    return command.directory == Directory::kAll ? start : start + fileArgument(command.name);
}

}  // namespace

std::string encode(const Command& command) {
    const auto line = std::visit(
        Overloaded{
            [](const ReadMeasurement& c) { return "R" + unitLetter(c.device) + formLetter(c.form); },
            [](const ReadLabel& c) {
                return "R" + unitLetter(c.device) + formLetter(c.form) + "," + labelText(c.label);
            },
            [](const SignalTest&) { return std::string("RGT"); },
            [](const WriteLabel& c) { return writeLabel(c); },
            [](const Trigger& c) { return trigger(c.range); },
            [](const Position& c) { return position(c); },
            [](const SetMode& c) { return "PG,3=" + std::to_string(static_cast<int>(c.mode)); },
            [](const ListFiles& c) { return "O" + directoryLetter(c.directory) + "C"; },
            [](const OutputFile& c) { return transfer('O', c); },
            [](const LoadFile& c) { return transfer('L', c); },
            [](const FreeMemory& c) { return "M" + unitLetter(c.device); },
            [](const EraseFile& c) { return erase(c); },
            [](const CalibrateCompensator&) { return std::string("PV,20"); },
            [](const SwitchOff&) { return std::string("PV,21"); },
        },
        command);
    return line + '\r';
}

}  // namespace pmts::protocol
