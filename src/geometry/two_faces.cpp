#include "pmts/geometry/two_faces.hpp"

#include "pmts/geometry/polar.hpp"

#include <Eigen/Dense>
#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pmts::geometry {
namespace {

using core::Angle;

constexpr double kLeastSpread = 0.3;                   ///< of cot VA
constexpr Angle kLeastZenith = Angle::fromGon(5);

QString tr(const char* sentence) { return QCoreApplication::translate("pmts::geometry", sentence); }

struct Equations {
    Eigen::MatrixXd design;
    Eigen::VectorXd half_ha_rad, half_va_rad;
};

Equations equationsOf(const std::vector<FacePair>& pairs) {
    const auto rows = static_cast<Eigen::Index>(pairs.size());
    Equations equations{Eigen::MatrixXd(rows, 2), Eigen::VectorXd(rows), Eigen::VectorXd(rows)};
    for (Eigen::Index row = 0; row < rows; ++row) {
        const FacePair& pair = pairs[static_cast<std::size_t>(row)];
        const Angle va = meanOfFaces(pair).va;
        const FaceDifference difference = faceDifference(pair);
        equations.design.row(row) << 1.0 / core::sin(va), core::cos(va) / core::sin(va);
        equations.half_ha_rad(row) = difference.ha.rad() / 2;
        equations.half_va_rad(row) = difference.va.rad() / 2;
    }
    return equations;
}

AxisError meanOf(const Eigen::VectorXd& values_rad) {
    const double mean = values_rad.mean();
    const auto n = static_cast<double>(values_rad.size());
    AxisError error{.value = Angle::fromRad(mean), .sigma = std::nullopt};
    if (n > 1) {
        error.sigma = Angle::fromRad(std::sqrt((values_rad.array() - mean).square().sum() / (n - 1) / n));
    }
    return error;
}

}  // namespace

Pointing meanOfFaces(const FacePair& pair) {
    const FaceDifference difference = faceDifference(pair);
    return {.ha = core::normalized(pair.face_one.ha - difference.ha / 2), .va = pair.face_one.va - difference.va / 2};
}

FaceDifference faceDifference(const FacePair& pair) {
    const Pointing turned = otherFace(pair.face_two);
    return {.ha = core::normalizedSigned(pair.face_one.ha - turned.ha), .va = core::normalizedSigned(pair.face_one.va - turned.va)};
}

core::Result<AxisErrors> axisErrorsFrom(const std::vector<FacePair>& pairs) {
    if (pairs.empty()) {
        return core::fail(core::ErrorKind::kBadInput, tr("There is no pointing in both faces yet."));
    }
    const auto at_zenith = [](const FacePair& pair) { return core::abs(meanOfFaces(pair).va) < kLeastZenith; };
    if (std::ranges::any_of(pairs, at_zenith)) {
        return core::fail(core::ErrorKind::kUndefined, tr("The target is too close to the zenith."),
                          tr("Choose a target near the horizon."));
    }
    const Equations equations = equationsOf(pairs);
    const auto cot = equations.design.col(1);
    const bool solves_tilting = pairs.size() > 2 && cot.maxCoeff() - cot.minCoeff() > kLeastSpread;
    const Eigen::Index unknowns = solves_tilting ? 2 : 1;
    const Eigen::MatrixXd design = equations.design.leftCols(unknowns);
    const Eigen::MatrixXd inverse = (design.transpose() * design).inverse();
    const Eigen::VectorXd solved = inverse * design.transpose() * equations.half_ha_rad;
    const Eigen::VectorXd residuals = design * solved - equations.half_ha_rad;
    const auto redundancy = static_cast<double>(residuals.size() - unknowns);
    const auto errorAt = [&](Eigen::Index i) {
        AxisError error{.value = Angle::fromRad(solved(i)), .sigma = std::nullopt};
        if (redundancy > 0) {
            error.sigma = Angle::fromRad(std::sqrt(residuals.squaredNorm() / redundancy * inverse(i, i)));
        }
        return error;
    };
    return AxisErrors{.collimation = errorAt(0),
                      .index = meanOf(equations.half_va_rad),
                      .tilting = solves_tilting ? std::optional(errorAt(1)) : std::nullopt,
                      .pairs = static_cast<int>(pairs.size())};
}

}  // namespace pmts::geometry
