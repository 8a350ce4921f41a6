#include "radial_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace pmts::camera::radial_table {
namespace {

using Row = RadialTableLens::Row;

double secant(const Row& a, const Row& b) {
    return (b.angle_rad - a.angle_rad) / (b.radius_px - a.radius_px);
}

/// Slope at the middle of three rows: the weighted harmonic mean of the two secants.
double innerSlope(const Row& before, const Row& at, const Row& after) {
    const double h0 = at.radius_px - before.radius_px;
    const double h1 = after.radius_px - at.radius_px;
    const double w0 = 2 * h1 + h0;
    const double w1 = h1 + 2 * h0;
    return (w0 + w1) / (w0 / secant(before, at) + w1 / secant(at, after));
}

/// Slope at the last row: three-point formula, held within [0, 3 secants] so that the piece stays monotone.
double outerSlope(const Row& before, const Row& last_but_one, const Row& last) {
    const double h0 = last.radius_px - last_but_one.radius_px;
    const double h1 = last_but_one.radius_px - before.radius_px;
    const double s0 = secant(last_but_one, last);
    const double s1 = secant(before, last_but_one);
    return std::clamp(((2 * h0 + h1) * s0 - h0 * s1) / (h0 + h1), 0.0, 3 * s0);
}

/// The cubic Hermite piece that starts at row i, at t in [0, 1] of its width.
double piece(const std::vector<Row>& rows, const std::vector<double>& slopes, std::size_t i, double t) {
    const double width_px = rows[i + 1].radius_px - rows[i].radius_px;
    const double rise = rows[i + 1].angle_rad - rows[i].angle_rad;
    const double d0 = slopes[i] * width_px;
    const double d1 = slopes[i + 1] * width_px;
    return rows[i].angle_rad + t * (d0 + t * (3 * rise - 2 * d0 - d1 + t * (d0 + d1 - 2 * rise)));
}

template <class Column>
std::optional<std::size_t> pieceHolding(const std::vector<Row>& rows, Column column, double value) {
    constexpr double kRounding = 1e-12;  // the last row itself, after a trip through a pixel, is still inside
    if (!(value >= 0.0) || value > rows.back().*column * (1 + kRounding)) {
        return std::nullopt;
    }
    const auto after = std::upper_bound(rows.begin(), rows.end(), value,
                                        [column](double v, const Row& row) { return v < row.*column; });
    const auto index = static_cast<std::size_t>(after - rows.begin());
    return std::min(index, rows.size() - 1) - 1;
}

}  // namespace

void requireMonotone(const RadialTableLens& lens) {
    const auto rises = [](const Row& a, const Row& b) {
        return b.radius_px > a.radius_px && b.angle_rad > a.angle_rad;
    };
    const std::vector<Row>& rows = lens.rows;
    bool good = rows.size() >= 2 && rows.front() == Row{} && rows.back().angle_rad < std::numbers::pi &&
                std::isfinite(rows.back().radius_px);
    for (std::size_t i = 1; good && i < rows.size(); ++i) {
        good = rises(rows[i - 1], rows[i]);
    }
    if (!good) {
        throw std::logic_error("a radial table starts at (0, 0) and rises strictly in radius and angle");
    }
}

std::vector<double> slopes(const std::vector<Row>& rows) {
    const std::size_t n = rows.size();
    std::vector<double> result(n);
    // The table goes on as an odd function on the other side of the axis, so both secants there are the first
    // one.
    result[0] = secant(rows[0], rows[1]);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        result[i] = innerSlope(rows[i - 1], rows[i], rows[i + 1]);
    }
    const Row before = n > 2 ? rows[n - 3] : Row{-rows[1].radius_px, -rows[1].angle_rad};
    result[n - 1] = outerSlope(before, rows[n - 2], rows[n - 1]);
    return result;
}

std::optional<double> angleAtRadius(const std::vector<Row>& rows, const std::vector<double>& slopes,
                                    double radius_px) {
    const auto i = pieceHolding(rows, &Row::radius_px, radius_px);
    if (!i) {
        return std::nullopt;
    }
    const double t = (radius_px - rows[*i].radius_px) / (rows[*i + 1].radius_px - rows[*i].radius_px);
    return piece(rows, slopes, *i, t);
}

std::optional<double> radiusAtAngle(const std::vector<Row>& rows, const std::vector<double>& slopes,
                                    double angle_rad) {
    const auto i = pieceHolding(rows, &Row::angle_rad, angle_rad);
    if (!i) {
        return std::nullopt;
    }
    double low = 0;
    double high = 1;
    for (int k = 0; k < 60; ++k) {  // 60 halvings: below 1e-15 of the piece
        const double middle = 0.5 * (low + high);
        (piece(rows, slopes, *i, middle) < angle_rad ? low : high) = middle;
    }
    return rows[*i].radius_px + 0.5 * (low + high) * (rows[*i + 1].radius_px - rows[*i].radius_px);
}

}  // namespace pmts::camera::radial_table
