#pragma once

#include "pmts/core/result.hpp"
#include "pmts/protocol/reply.hpp"

namespace pmts::protocol {

/// What the driver does with an info code (protocol page 2.10, column "driver class").
enum class InfoClass {
    kOk, kOperator, kRemeasure, kConfiguration, kPower, kComm, kProtocol, kState, kService, kMotion, kMotionSoft, kTarget,
    kRetry, kAbort, kData, kUnknown
};

struct InfoCode {
    int code = 0;
    InfoClass info_class = InfoClass::kUnknown;
    QString happened;  ///< for the surveyor
    QString remedy;
};

/// Meaning of a code; an unlisted one is kUnknown with a sentence that names the number.
[[nodiscard]] InfoCode infoCode(int code);
/// Codes that say something about the instrument and nothing against the data or command they come with: battery low
/// (8, 9), clock disturbed (25), backup battery old (26).
[[nodiscard]] bool isWarning(int code);
/// Name of the device behind a suffix: `distance meter` for .7; the bit sum for code 21; the knob for 164.
[[nodiscard]] QString suffixMeaning(const Status& status);
/// The status as an Error of kind kDevice (kNotReached for 155-157) with code, sentences and device.
[[nodiscard]] core::Error errorFromStatus(const Status& status);

}  // namespace pmts::protocol
