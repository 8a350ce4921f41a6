#pragma once

#include "pmts/geometry/plane.hpp"
#include "pmts/geometry/pointing.hpp"

#include <QMetaType>
#include <QObject>
#include <QString>

#include <optional>

namespace pmts::app {

/// Where a range comes from: a click's pointing depends on it, so it is always told.
enum class RangeSource {
    kMeasured,  ///< shot at this very pointing
    kPlane,     ///< where the line of sight meets the plane of recorded points
    kPlanned,   ///< to a planned point: from its coordinates
    kLastShot,  ///< the last shot, made elsewhere
    kAssumed,   ///< nothing measured yet: the setting
};

struct RangeAssumption {
    double slope_distance_m = 0.0;
    RangeSource source = RangeSource::kAssumed;
};

/// The distance to use for a reticle or a click.
class RangeKeeper : public QObject {
    Q_OBJECT
public:
    explicit RangeKeeper(double assumed_m, QObject* parent = nullptr);

    /// kMeasured when the last shot was made within 50 mgon of `pointing`, then kPlane where the plane is met.
    [[nodiscard]] RangeAssumption rangeAt(const std::optional<geometry::Pointing>& pointing) const;
    /// Of what a camera sees along this ray: on the plane, else as at `pointing`.
    [[nodiscard]] RangeAssumption rangeAlong(const geometry::Ray& ray,
                                             const std::optional<geometry::Pointing>& pointing) const;
    void setPlane(const std::optional<geometry::Plane>& plane);  ///< station frame
    [[nodiscard]] const std::optional<geometry::Plane>& plane() const { return plane_; }
    void setAssumed(double range_m);
    [[nodiscard]] double assumed() const { return assumed_m_; }
    void addShot(const geometry::Pointing& pointing, double slope_distance_m);
    /// Back to the assumed range: neither the last shot nor the plane counts.
    void forgetAll();

Q_SIGNALS:
    void changed();

private:
    struct Shot {
        geometry::Pointing pointing;
        double slope_distance_m = 0.0;
    };

    [[nodiscard]] RangeAssumption usual() const;

    double assumed_m_;
    std::optional<Shot> last_shot_;
    std::optional<geometry::Plane> plane_;
};

}  // namespace pmts::app
