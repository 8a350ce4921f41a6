#pragma once

#include "pmts/core/result.hpp"
#include "pmts/geometry/pointing.hpp"

#include <Eigen/Core>
#include <QString>
#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace pmts::simulator {

/// A textured rectangle in the simulator's station frame (x east, y north, z up, metres, origin: optical centre).
struct Panel {
    QString name;
    Eigen::Vector3d origin_m;  ///< its lower left corner seen from the front
    Eigen::Vector3d right_m;   ///< along its lower edge, length = width
    Eigen::Vector3d up_m;      ///< along its left edge, length = height
    cv::Mat texture;           ///< 8-bit BGR, row 0 at the top
    bool absorbing = false;    ///< the EDM gets no echo from it
};

/// A target mark whose centre is known: black and white quadrants, or a prism.
struct Mark {
    QString name;
    Eigen::Vector3d p_station_m;
};

/// What the beam hits.
struct Echo {
    double distance_m = 0.0;
    QString panel;
};

/// The world around the instrument, as data (JSON file, or the built-in town square).
class Scene {
public:
    /// Facades with natural texture at 8 to 60 m, marks, a ground, a black absorbing panel, sky. Deterministic for a seed.
    [[nodiscard]] static Scene townSquare(unsigned seed);
    [[nodiscard]] static core::Result<Scene> fromFile(const QString& path);

    [[nodiscard]] const std::vector<Panel>& panels() const { return panels_; }
    [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }
    /// First surface along the line of sight; nullopt for sky and absorbing surfaces (no signal).
    [[nodiscard]] std::optional<Echo> echo(const geometry::Pointing& line_of_sight) const;

private:
    std::vector<Panel> panels_;
    std::vector<Mark> marks_;
};

}  // namespace pmts::simulator
