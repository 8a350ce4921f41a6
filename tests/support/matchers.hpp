#pragma once

#include "pmts/core/angle.hpp"
#include "pmts/core/result.hpp"

#include <gmock/gmock.h>

namespace pmts::core {

inline void PrintTo(const Angle& angle, std::ostream* out) { *out << angle.gon() << " gon"; }
inline void PrintTo(const Error& error, std::ostream* out) {
    *out << "error " << static_cast<int>(error.kind) << ": " << error.sentence().toStdString() << " ["
         << error.detail.toStdString() << ']';
}

}  // namespace pmts::core

namespace pmts::test {

/// Same direction within a tolerance: 399.9999 gon is near 0 gon.
MATCHER_P2(IsNearAngle, expected, tolerance, "") {
    const core::Angle off = core::normalizedSigned(arg - expected);
    *result_listener << "off by " << off.cc() << " cc";
    return core::abs(off) <= tolerance;
}

/// A Result that failed with this kind.
MATCHER_P(FailedWith, kind, "") { return !arg.has_value() && arg.error().kind == kind; }

}  // namespace pmts::test
