#pragma once

#include "pmts/core/result.hpp"

#include <string_view>
#include <vector>

namespace pmts::protocol {

enum class LabelKind { kText, kDecimal, kInteger };
enum class LabelAccess { kSet, kMeasured, kCalculated, kRead, kUnknown };
enum class LabelUnit { kNone, kLength, kArea, kVolume, kAngle, kPercent, kPpm, kTemperature, kPressure };

/// One row of the label table (protocol page 3.1), labels 0-109.
struct Label {
    int number = 0;
    std::string_view prompt;   ///< as the instrument shows it: `HA`
    std::string_view meaning;  ///< plain words: `horizontal angle`
    LabelKind kind = LabelKind::kText;
    LabelUnit unit = LabelUnit::kNone;
    LabelAccess access = LabelAccess::kUnknown;
};

[[nodiscard]] const std::vector<Label>& allLabels();
[[nodiscard]] const Label* findLabel(int number);

/// What `WG,label=data` may carry: a label that can be set, at most 9 digits (sign and point not counted) or 16
/// characters of 7-bit text, not empty. Fails with kBadInput and the reason.
[[nodiscard]] core::Result<void> checkLabelData(int label, std::string_view data);

// The labels the driver and the simulator name.
inline constexpr int kPointCode = 4, kPointNumber = 5, kTargetHeight = 6, kHa = 7, kVa = 8, kSd = 9, kOffset = 20, kHaRef = 21,
                     kCompensator = 22, kUnits = 23, kTargetVa = 26, kTargetHa = 27, kPpm = 30, kPrismConstant = 33,
                     kNorthing = 37, kEasting = 38, kElevation = 39, kJobName = 50, kSerialNumber = 55, kTemperature = 56,
                     kPressure = 74, kLineParameters = 78, kEndMark = 79;

}  // namespace pmts::protocol
