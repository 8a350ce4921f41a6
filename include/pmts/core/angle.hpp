#pragma once

#include <cmath>
#include <compare>
#include <numbers>

namespace pmts::core {

/// A plane angle. Kept in gon, the instrument's own unit: its decimals stay exact, a full turn is 400 gon.
class Angle {
public:
    constexpr Angle() = default;

    [[nodiscard]] static constexpr Angle fromGon(double gon) { return Angle(gon); }
    /// 1 cc = 0.0001 gon.
    [[nodiscard]] static constexpr Angle fromCc(double cc) { return Angle(cc * 1e-4); }
    [[nodiscard]] static constexpr Angle fromMgon(double mgon) { return Angle(mgon * 1e-3); }
    [[nodiscard]] static constexpr Angle fromDeg(double deg) { return Angle(deg / 0.9); }
    [[nodiscard]] static constexpr Angle fromArcsec(double arcsec) { return fromDeg(arcsec / 3600.0); }
    [[nodiscard]] static constexpr Angle fromRad(double rad) { return Angle(rad * 200.0 / std::numbers::pi); }
    /// The instrument's mil: 6400 to the circle.
    [[nodiscard]] static constexpr Angle fromMil(double mil) { return Angle(mil / 16.0); }

    [[nodiscard]] constexpr double gon() const { return gon_; }
    [[nodiscard]] constexpr double cc() const { return gon_ * 1e4; }
    [[nodiscard]] constexpr double mgon() const { return gon_ * 1e3; }
    [[nodiscard]] constexpr double deg() const { return gon_ * 0.9; }
    [[nodiscard]] constexpr double arcsec() const { return gon_ * 3240.0; }
    [[nodiscard]] constexpr double rad() const { return gon_ * std::numbers::pi / 200.0; }
    [[nodiscard]] constexpr double mil() const { return gon_ * 16.0; }

    [[nodiscard]] constexpr auto operator<=>(const Angle&) const = default;
    [[nodiscard]] constexpr Angle operator-() const { return Angle(-gon_); }
    constexpr Angle& operator+=(Angle other) { return *this = Angle(gon_ + other.gon_); }
    constexpr Angle& operator-=(Angle other) { return *this = Angle(gon_ - other.gon_); }
    [[nodiscard]] friend constexpr Angle operator+(Angle a, Angle b) { return Angle(a.gon_ + b.gon_); }
    [[nodiscard]] friend constexpr Angle operator-(Angle a, Angle b) { return Angle(a.gon_ - b.gon_); }
    [[nodiscard]] friend constexpr Angle operator*(Angle a, double factor) { return Angle(a.gon_ * factor); }
    [[nodiscard]] friend constexpr Angle operator*(double factor, Angle a) { return Angle(a.gon_ * factor); }
    [[nodiscard]] friend constexpr Angle operator/(Angle a, double divisor) { return Angle(a.gon_ / divisor); }
    [[nodiscard]] friend constexpr double operator/(Angle a, Angle b) { return a.gon_ / b.gon_; }

private:
    explicit constexpr Angle(double gon) : gon_(gon) {}

    double gon_ = 0.0;
};

/// The same direction in [0, 400) gon.
[[nodiscard]] inline Angle normalized(Angle angle) {
    const double gon = std::fmod(angle.gon(), 400.0);
    const double positive = gon < 0.0 ? gon + 400.0 : gon;
    return Angle::fromGon(positive >= 400.0 ? 0.0 : positive);  // -1e-20 + 400 rounds to 400
}

/// The same direction in (-200, 200] gon: the short way round, as for HA differences.
[[nodiscard]] inline Angle normalizedSigned(Angle angle) {
    const Angle turn = normalized(angle);
    return turn.gon() > 200.0 ? Angle::fromGon(turn.gon() - 400.0) : turn;
}

[[nodiscard]] inline Angle abs(Angle angle) { return Angle::fromGon(std::abs(angle.gon())); }
[[nodiscard]] inline double sin(Angle angle) { return std::sin(angle.rad()); }
[[nodiscard]] inline double cos(Angle angle) { return std::cos(angle.rad()); }
[[nodiscard]] inline double tan(Angle angle) { return std::tan(angle.rad()); }

}  // namespace pmts::core
