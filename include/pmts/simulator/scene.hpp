#pragma once

#include "pmts/core/result.hpp"
#include "pmts/geometry/pointing.hpp"

#include <Eigen/Core>
#include <QString>
#include <QStringList>
#include <opencv2/core/mat.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace pmts::simulator {

class TextureAtlas;

/// A textured rectangle in the simulator's station frame (x east, y north, z up, metres, origin: optical
/// centre).
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

/// The world around the instrument, as data (JSON file, or the built-in town square). A value; copies share
/// the textures.
class Scene {
public:
    /// A world of these panels under a cloudy sky; panels may share one cv::Mat as texture.
    explicit Scene(std::vector<Panel> panels, std::vector<Mark> marks = {}, unsigned sky_seed = 1);

    /// Facades with natural texture at 8 to 60 m, marks, a ground, a black absorbing panel, sky.
    /// Deterministic for a seed.
    [[nodiscard]] static Scene townSquare(unsigned seed);
    /// A scene file (docs/scene-format.md). kBadInput names the place in the file, kFile the file or image
    /// that cannot be read.
    [[nodiscard]] static core::Result<Scene> fromFile(const QString& path);
    /// One of builtInNames(), or a scene file; empty is the town square.
    [[nodiscard]] static core::Result<Scene> named(const QString& name_or_path, unsigned seed);
    /// `town-square`, `laboratory`: a room with a plumb line, boards at 4 and 8 m and targets at 5.333, 9.999 and 15.003 m.
    [[nodiscard]] static QStringList builtInNames();

    [[nodiscard]] const std::vector<Panel>& panels() const { return panels_; }
    [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }
    /// First surface along the line of sight; nullopt for sky and absorbing surfaces (no signal).
    [[nodiscard]] std::optional<Echo> echo(const geometry::Pointing& line_of_sight) const;

    /// The six faces of a cube around the camera that carry the sky: only their directions count.
    [[nodiscard]] const std::vector<Panel>& sky() const { return sky_; }
    /// Every texture in one image, in the order of panels(), then sky(); for the camera that draws them.
    [[nodiscard]] const TextureAtlas& atlas() const { return *atlas_; }

private:
    std::vector<Panel> panels_;
    std::vector<Mark> marks_;
    std::vector<Panel> sky_;
    std::shared_ptr<const TextureAtlas> atlas_;
};

}  // namespace pmts::simulator
