#include "label_store.hpp"

#include <QDateTime>

#include <algorithm>
#include <array>

namespace pmts::simulator {
namespace {

using protocol::Label;
using protocol::LabelAccess;
using protocol::LabelKind;
using protocol::LabelUnit;

constexpr std::ptrdiff_t kMostDigits = 9;
constexpr std::size_t kLongestText = 16;
constexpr int kBlank = 57;

struct Range {
    int label;
    double least, greatest;
};
constexpr std::array kRanges{
    Range{protocol::kOffset, -1.0, 1.0},
    Range{protocol::kPpm, -60.0, 195.0},
    Range{protocol::kCompensator, 0, 1},
    Range{protocol::kEndMark, 0, 255},
    Range{65, 0, 100},
    Range{protocol::kPressure, 0, 2000},
    Range{protocol::kTemperature, -100, 100},
};

bool inRange(int label, double value) {
    return std::ranges::none_of(kRanges, [&](const Range& range) {
        return range.label == label && (value < range.least || value > range.greatest);
    });
}

QString textOf(std::string_view data) {
    return QString::fromLatin1(data.data(), static_cast<qsizetype>(data.size()));
}

/// stop.data.parity.baud, e.g. 1.8.0.9600.
bool isLineSetting(std::string_view data) {
    if (data.size() < 8 || data[1] != '.' || data[3] != '.' || data[5] != '.') {
        return false;
    }
    const auto baud = plainNumber(data.substr(6));
    const auto one_of = [](char c, std::string_view allowed) {
        return allowed.find(c) != std::string_view::npos;
    };
    return one_of(data[0], "12") && one_of(data[2], "78") && one_of(data[4], "012") && baud && *baud >= 50 &&
           *baud <= 19200;
}

bool textFits(int label, std::string_view data) {
    switch (label) {
        case kDate:
            return QDate::fromString(textOf(data), kDateFormat).isValid();
        case kTime:
            return QTime::fromString(textOf(data), kTimeFormat).isValid();
        case protocol::kLineParameters:
            return isLineSetting(data);
        default:
            return data.size() <= kLongestText;
    }
}

}  // namespace

double makersPpm(double pressure_mbar, double temperature_degc) {
    return 275.0 - 79.55 * pressure_mbar / (273.0 + temperature_degc);
}

LabelStore::LabelStore(const StationSettings& settings, UnitDigits units)
    : settings_(settings), units_(std::move(units)) {
    reset();
}

void LabelStore::reset() {
    numbers_ = {{protocol::kTemperature, settings_.air_temperature_degc},
                {protocol::kPressure, settings_.air_pressure_mbar},
                {protocol::kTargetVa, 100.0},
                {protocol::kCompensator, 1.0},
                {protocol::kEndMark, settings_.end_mark},
                {58, 6372000.0}};
    texts_ = {{protocol::kCompensator, "1"},
              {protocol::kUnits, units_.text},
              {protocol::kJobName, "0"},
              {15, "0"},
              {43, "1.0"},
              {59, "0.142"},
              {protocol::kSerialNumber, settings_.serial_number.toStdString()},
              {protocol::kLineParameters, "1.8.0.9600"},
              {protocol::kEndMark, std::to_string(settings_.end_mark)}};
    setNumber(protocol::kPpm, makersPpm(settings_.air_pressure_mbar, settings_.air_temperature_degc));
}

int LabelStore::write(int number, std::string_view data) {
    const Label* label = protocol::findLabel(number);
    if (label == nullptr || number == kBlank) {
        return kLabelUnknown;
    }
    if (label->access != LabelAccess::kSet && label->access != LabelAccess::kUnknown) {
        return settings_.read_only_status;
    }
    if (data.empty()) {
        return kBadData;
    }
    if (label->kind != LabelKind::kText) {
        return writeNumber(*label, data);
    }
    if (!textFits(number, data)) {
        return kBadData;
    }
    texts_[number] = std::string(data);
    return kAccepted;
}

bool LabelStore::digitsFit(std::string_view data) const {
    const auto counts = [this](char c) { return settings_.sign_and_point_count || (c >= '0' && c <= '9'); };
    return std::ranges::count_if(data, counts) <= kMostDigits;
}

int LabelStore::writeNumber(const Label& label, std::string_view data) {
    const auto value = meant(label, data);
    const bool whole = data.find('.') == std::string_view::npos;
    if (!value || !digitsFit(data) || (label.kind == LabelKind::kInteger && !whole) ||
        !inRange(label.number, *value)) {
        return kBadData;
    }
    setNumber(label.number, *value);
    texts_[label.number] = std::string(data);
    const bool air = label.number == protocol::kTemperature || label.number == protocol::kPressure;
    if (air) {
        setNumber(protocol::kPpm,
                  makersPpm(this->number(protocol::kPressure), this->number(protocol::kTemperature)));
    }
    return kAccepted;
}

std::optional<double> LabelStore::meant(const Label& label, std::string_view data) const {
    const auto value = plainNumber(data);
    if (!value) {
        return std::nullopt;
    }
    switch (label.unit) {
        case LabelUnit::kAngle: {
            const auto angle = angleFrom(data, units_.angle);
            return angle ? std::optional(angle->gon()) : std::nullopt;
        }
        case LabelUnit::kLength:
            return *value / lengthFactor(units_.length);
        case LabelUnit::kTemperature:
            return temperatureMeant(*value, units_.temperature);
        case LabelUnit::kPressure:
            return pressureMeant(*value, units_.pressure);
        default:
            return value;
    }
}

std::string LabelStore::shown(const Label& label, double value) const {
    switch (label.unit) {
        case LabelUnit::kAngle:
            return angleText(core::Angle::fromGon(value), units_.angle, settings_.angle_decimals);
        case LabelUnit::kLength:
            return fixedText(value * lengthFactor(units_.length), settings_.length_decimals);
        case LabelUnit::kTemperature:
            return fixedText(temperatureShown(value, units_.temperature), 1);
        case LabelUnit::kPressure:
            return fixedText(pressureShown(value, units_.pressure),
                             units_.pressure == PressureText::kInHg ? 2 : 1);
        default:
            return fixedText(value, label.unit == LabelUnit::kPpm ? 2 : settings_.length_decimals);
    }
}

std::optional<std::string> LabelStore::text(int number) const {
    const Label* label = protocol::findLabel(number);
    if (label == nullptr || number == kBlank) {
        return std::nullopt;
    }
    const bool has_unit = label->unit == LabelUnit::kAngle || label->unit == LabelUnit::kLength ||
                          label->unit == LabelUnit::kTemperature || label->unit == LabelUnit::kPressure;
    const bool as_written = label->kind != LabelKind::kDecimal || (!has_unit && texts_.contains(number));
    return as_written ? raw(number) : shown(*label, this->number(number));
}

double LabelStore::number(int label) const {
    const auto found = numbers_.find(label);
    return found == numbers_.end() ? 0.0 : found->second;
}

const std::string& LabelStore::raw(int label) const {
    static const std::string empty;
    const auto found = texts_.find(label);
    return found == texts_.end() ? empty : found->second;
}

void LabelStore::setNumber(int label, double value) {
    numbers_[label] = value;
    texts_.erase(label);
}

void LabelStore::setRaw(int label, std::string text) { texts_[label] = std::move(text); }

}  // namespace pmts::simulator
