#pragma once

#include "pmts/geometry/polar.hpp"

#include <Eigen/Core>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace pmts::test {

/// One object of the thesis's tables 6.1-6.4: sighted with the telescope, clicked in one photo.
struct IcsmRow {
    geometry::PolarPoint observed;
    Eigen::Vector2d px;
    geometry::Pointing apa, tpa, oatpa;  ///< as printed
};

/// Readings of the photo's centre.
inline geometry::Pointing icsmPhoto() {
    return {core::Angle::fromGon(199.3587), core::Angle::fromGon(105.9808)};
}

inline std::vector<IcsmRow> icsmTable() {
    std::ifstream file(PMTS_TEST_DATA "/icsm.csv");
    std::vector<IcsmRow> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.front() < '0' || line.front() > '9') {
            continue;
        }
        std::vector<double> cells;
        std::stringstream text(line);
        for (std::string cell; std::getline(text, cell, ',');) {
            cells.push_back(std::stod(cell));
        }
        const auto pointing = [&cells](std::size_t first) {
            return geometry::Pointing{core::Angle::fromGon(cells.at(first)),
                                      core::Angle::fromGon(cells.at(first + 1))};
        };
        rows.push_back({.observed = {pointing(2), cells.at(1)},
                        .px = {cells.at(4), cells.at(5)},
                        .apa = pointing(6),
                        .tpa = pointing(8),
                        .oatpa = pointing(10)});
    }
    if (rows.size() != 11) {
        throw std::logic_error("icsm.csv has 11 objects");
    }
    return rows;
}

}  // namespace pmts::test
