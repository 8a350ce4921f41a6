#pragma once

#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/app/field/station_presenter.hpp"

#include <QObject>
#include <QStringList>

namespace pmts::app {

/// The aiming page as texts, in the current units.
struct AimingForm {
    int method = 0;  ///< in the order of methodNames()
    bool recentre = true;
    bool click_turns = false;
    QString tolerance_px, tolerance;
    QString highest, lowest;
    bool face_two_allowed = true;
    bool has_sector = false;
    QString sector_from, sector_to;
    bool avoids_sun = false;
    QString latitude, longitude, sun_cone;
    bool watches_cable = false;
    QString turns;  ///< to either side
};

enum class AimingField { kTolerancePx, kTolerance, kHighest, kLowest, kSectorFrom, kSectorTo, kLatitude, kLongitude,
                         kSunCone, kTurns };

/// How clicks become pointings, and what the instrument must not point at.
class AimingPresenter : public QObject {
    Q_OBJECT
public:
    AimingPresenter(Preferences& preferences, InstrumentDesk& instrument, const StationPresenter& station,
                    const core::Clock& clock, QObject* parent = nullptr);

    [[nodiscard]] AimingForm form() const;
    [[nodiscard]] static QStringList methodNames();
    [[nodiscard]] static QString methodError(int method);  ///< its known error
    [[nodiscard]] QString summary() const;    ///< `Rigorous, re-centred`
    [[nodiscard]] QString sunText() const;    ///< where it stands, or why it is not watched
    [[nodiscard]] QString cableText() const;  ///< `wound 0.35 turns to the right`

public Q_SLOTS:
    /// Reads all fields; nothing changes when one cannot be read, fieldRejected() says which.
    void apply(const pmts::app::AimingForm& form);
    void cableHangsFree();

Q_SIGNALS:
    void changed();
    void applied(const QString& sentence);
    void fieldRejected(pmts::app::AimingField field, const pmts::core::Error& error);

private:
    struct Reading;

    Preferences& preferences_;
    InstrumentDesk& instrument_;
    const StationPresenter& station_;
    const core::Clock& clock_;
};

}  // namespace pmts::app
