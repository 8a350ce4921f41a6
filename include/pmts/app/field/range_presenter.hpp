#pragma once

#include "pmts/app/settings/preferences.hpp"
#include "pmts/app/field/range_keeper.hpp"

#include <QObject>

namespace pmts::app {

/// The range assumption and the ends of the parallax curve, as texts in the surveyor's unit.
class RangePresenter : public QObject {
    Q_OBJECT
public:
    enum class Field { kAssumed, kNear, kFar };

    RangePresenter(RangeKeeper& range, Preferences& preferences, QObject* parent = nullptr);

    [[nodiscard]] QString text(Field field) const;
    /// What is in use now and why: `23.418 m (last shot)`.
    [[nodiscard]] QString inUseText() const;
    [[nodiscard]] bool hasShot() const;

public Q_SLOTS:
    /// All three at once; refused as a whole with rejected().
    void setTexts(const QString& assumed, const QString& near_end, const QString& far_end);
    /// The assumed range is used until the next shot.
    void forgetShot();
    /// 0 to kDepthSteps, logarithmic; the first near step and the last far step mean no limit.
    void setDepthSteps(int near_step, int far_step);

public:
    static constexpr int kDepthSteps = 120;
    [[nodiscard]] int nearStep() const;
    [[nodiscard]] int farStep() const;
    [[nodiscard]] QString nearText() const;  ///< `from 2.5 m`, `from the instrument`
    [[nodiscard]] QString farText() const;   ///< `to 80 m`, `no end`

Q_SIGNALS:
    void rejected(pmts::app::RangePresenter::Field field, const pmts::core::Error& error);
    void accepted();
    void changed();

private:
    [[nodiscard]] core::Result<double> rangeFrom(const QString& text) const;

    RangeKeeper& range_;
    Preferences& preferences_;
};

}  // namespace pmts::app
