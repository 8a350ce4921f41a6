#include "radial_roots.hpp"

#include <cstddef>
#include <limits>

namespace pmts::camera {
namespace {

double valueAt(const std::vector<double>& coefficients, double s) {
    double value = 0;
    for (std::size_t i = coefficients.size(); i-- > 0;) {
        value = value * s + coefficients[i];
    }
    return value;
}

/// The last place before the sign changes, so that nothing past a fold is ever called unfolded.
double bisected(const std::vector<double>& coefficients, double before, double after) {
    const bool positive = valueAt(coefficients, before) > 0;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (before + after);
        if (middle <= before || middle >= after) {
            break;
        }
        ((valueAt(coefficients, middle) > 0) == positive ? before : after) = middle;
    }
    return before;
}

}  // namespace

std::vector<double> crossings(const std::vector<double>& coefficients, double last) {
    if (coefficients.size() < 2) {
        return {};
    }
    std::vector<double> slope;
    for (std::size_t i = 1; i < coefficients.size(); ++i) {
        slope.push_back(static_cast<double>(i) * coefficients[i]);
    }
    std::vector<double> probes = crossings(slope, last);
    probes.push_back(last);
    std::vector<double> found;
    double before = 0;
    for (const double probe : probes) {
        if ((valueAt(coefficients, before) > 0) != (valueAt(coefficients, probe) > 0)) {
            found.push_back(bisected(coefficients, before, probe));
        }
        before = probe;
    }
    return found;
}

double firstCrossing(const std::vector<double>& coefficients, double last) {
    const std::vector<double> all = crossings(coefficients, last);
    return all.empty() ? std::numeric_limits<double>::infinity() : all.front();
}

}  // namespace pmts::camera
