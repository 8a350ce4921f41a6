#pragma once

#include "pmts/geometry/pointing.hpp"

#include <QMetaType>
#include <QObject>
#include <QString>

#include <optional>

namespace pmts::app {

/// Where a range comes from: a click's pointing depends on it, so it is always told.
enum class RangeSource {
    kMeasured,  ///< shot at this very pointing
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

    /// kMeasured when the last shot was made within 50 mgon of `pointing`.
    [[nodiscard]] RangeAssumption rangeAt(const std::optional<geometry::Pointing>& pointing) const;
    void setAssumed(double range_m);
    [[nodiscard]] double assumed() const { return assumed_m_; }
    void addShot(const geometry::Pointing& pointing, double slope_distance_m);
    void forgetShots();

Q_SIGNALS:
    void changed();

private:
    struct Shot {
        geometry::Pointing pointing;
        double slope_distance_m = 0.0;
    };

    double assumed_m_;
    std::optional<Shot> last_shot_;
};

}  // namespace pmts::app
