#include "pmts/app/field/parallax_curve.hpp"

#include <cmath>

namespace pmts::app {

namespace {

constexpr int kSpans = 32;

std::optional<QPointF> reticleAt(const targeting::PixelToPointing& model, const geometry::Pointing& at, double range_m) {
    const auto px = model.reticlePixel(at, range_m);
    return px ? std::optional(QPointF(px->x(), px->y())) : std::nullopt;
}

}  // namespace

QString shortRangeText(double range_m, const UnitFormat& units) {
    UnitFormat rounded = units;
    const double shown = units.length_unit == LengthUnit::kFoot ? range_m / core::kMetresPerFoot : range_m;
    const bool is_whole = std::abs(shown - std::round(shown)) < 0.05;
    rounded.length_decimals = shown < 10.0 && !is_whole ? 1 : 0;
    return rounded.length(range_m);
}

ParallaxCurve parallaxCurve(const targeting::PixelToPointing& model, const geometry::Pointing& at, double near_m,
                            double far_m, double in_use_m, const UnitFormat& units) {
    ParallaxCurve curve;
    for (int i = 0; i <= kSpans; ++i) {
        const double part = static_cast<double>(i) / kSpans;
        if (const auto px = reticleAt(model, at, 1.0 / ((1.0 - part) / near_m + part / far_m))) {
            curve.px.push_back(*px);
        }
    }
    using Kind = ParallaxCurve::MarkKind;
    for (const auto& [kind, range_m] :
         {std::pair(Kind::kNear, near_m), std::pair(Kind::kFar, far_m), std::pair(Kind::kInUse, in_use_m)}) {
        if (const auto px = reticleAt(model, at, range_m)) {
            curve.marks.push_back({.kind = kind, .px = *px, .label = shortRangeText(range_m, units)});
        }
    }
    return curve;
}

}  // namespace pmts::app
