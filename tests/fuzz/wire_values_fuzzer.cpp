#include "fuzz_input.hpp"

#include "pmts/protocol/labels.hpp"
#include "pmts/protocol/reply.hpp"
#include "pmts/protocol/units.hpp"

#include <cmath>

using namespace pmts::protocol;
using pmts::fuzz::demand;

namespace {

void checkAngles(std::string_view text) {
    constexpr double kFullCircle_gon = 400.0;
    for (const auto unit : {WireAngleUnit::kGon, WireAngleUnit::kDms, WireAngleUnit::kDegree, WireAngleUnit::kMil}) {
        if (const auto angle = angleFromWire(text, unit)) {
            demand(std::isfinite(angle->gon()) && std::abs(angle->gon()) <= kFullCircle_gon * (1 + 1e-12),
                   "an angle is a number within the circle");
            demand(angleFromWire(wireAngle(*angle, unit, 4), unit).has_value(), "what is written can be read");
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = pmts::fuzz::textOf(data, size);
    checkAngles(text);
    if (const auto number = numberFromWire(text)) {
        demand(std::isfinite(*number), "a number is finite");
        demand(text.find_first_not_of("+-.0123456789 ") == std::string_view::npos, "a number has digits, a sign, a point");
    }
    if (const auto units = parseUnitStatus(text)) {
        demand(parseUnitStatus(unitStatusText(*units)).value() == *units, "unit status there and back");
    }
    if (const auto line = parseLineParameters(text)) {
        demand(parseLineParameters(lineParametersText(*line)).value() == *line, "line parameters there and back");
    }
    if (const auto mark = endMarkFromLabel(text)) {
        demand(endMarkFromLabel(endMarkText(*mark)).value() == *mark, "end mark there and back");
    }
    for (const Label& label : allLabels()) {
        (void)checkLabelData(label.number, text);
    }
    return 0;
}
