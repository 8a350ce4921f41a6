#pragma once

#include "pmts/app/line/axis_test_presenter.hpp"

namespace pmts::app {

[[nodiscard]] bool isBeyondLimit(const InstrumentCareSettings& care, const geometry::AxisErrors& errors);
/// `20 °C`, or that it is not known.
[[nodiscard]] QString degcText(const std::optional<double>& degc);

}  // namespace pmts::app
