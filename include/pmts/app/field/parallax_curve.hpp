#pragma once

#include "pmts/app/field/range_keeper.hpp"
#include "pmts/app/settings/unit_format.hpp"
#include "pmts/targeting/pixel_to_pointing.hpp"

#include <QPointF>
#include <QString>

#include <vector>

namespace pmts::app {

/// Where the telescope's axis meets the view, from near to far: the reticle lies on it for every range.
struct ParallaxCurve {
    enum class MarkKind { kNear, kFar, kInUse };
    struct Mark {
        MarkKind kind = MarkKind::kInUse;
        QPointF px;
        QString label;  ///< `2 m`
    };

    std::vector<QPointF> px;  ///< ranges spaced evenly in 1/d, as parallax is
    std::vector<Mark> marks;
};

/// Of a picture taken at this pointing. Ranges the camera cannot see are left out; empty when it sees none.
[[nodiscard]] ParallaxCurve parallaxCurve(const targeting::PixelToPointing& model, const geometry::Pointing& at,
                                          double near_m, double far_m, double in_use_m, const UnitFormat& units);

/// A range to read at a glance: `2.5 m`, `25 m`, `82 ft`.
[[nodiscard]] QString shortRangeText(double range_m, const UnitFormat& units);

}  // namespace pmts::app
