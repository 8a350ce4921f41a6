#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/desk/live_presenter.hpp"

#include <QObject>
#include <QPointF>

#include <array>
#include <optional>

namespace pmts::app {

/// The outermost objects of a photo, in the order they are measured.
enum class Extreme { kLeft, kRight, kUpper, kLower };
inline constexpr int kExtremes = 4;

/// What is known of one of them.
struct ApaObject {
    QString name;                    ///< `Left`
    std::optional<QPointF> px;       ///< clicked in the still
    std::optional<geometry::Pointing> reading;
    QString px_text, reading_text;   ///< the column or row, the HA or VA
};

/// Angle of a pixel in one direction, as far as it is known.
struct ApaResult {
    QString angle, pixels;       ///< between the two objects
    QString per_pixel;
    QString expected;            ///< what the rig says of the same two pixels
    QString judgement;           ///< `0.3 % more than the rig says`
    DeviceState state = DeviceState::kIdle;  ///< kWarning when it is more than 5 % off, kFailed when it has none
};

/// The thesis's measurement of the average pixel angle: a still, then the extreme objects, each clicked in the still and
/// sighted with the telescope.
class ApaPresenter : public QObject {
    Q_OBJECT
public:
    /// Further from the rig's own angle a measurement is not plausible: a wrong object, or another camera.
    static constexpr double kPlausible = 0.05;

    ApaPresenter(LivePresenter& live, const InstrumentDesk& instrument, Preferences& preferences, MessageCentre& messages,
                 QObject* parent = nullptr);

    [[nodiscard]] const std::optional<Still>& still() const { return still_; }
    [[nodiscard]] QString stillText() const;
    [[nodiscard]] ApaObject object(Extreme which) const;
    [[nodiscard]] Extreme current() const { return current_; }
    [[nodiscard]] ApaResult across() const { return across_; }
    [[nodiscard]] ApaResult down() const { return down_; }
    [[nodiscard]] QString step() const;  ///< what to do next, one sentence
    [[nodiscard]] bool canStore() const { return measured_.has_value(); }
    [[nodiscard]] QString storedText() const;  ///< what the chosen rig has now

public Q_SLOTS:
    void capture();  ///< a new still; what was measured in the old one is forgotten
    void choose(pmts::app::Extreme which);
    void click(const QPointF& still_px);  ///< the current object is here
    void takeReading();  ///< the telescope is on the current object; refused while it moves
    void store();        ///< keeps it with the chosen rig

Q_SIGNALS:
    void changed();  ///< take everything
    void said(const QString& sentence);
    void refused(const QString& sentence);
    void stored();

private:
    struct Sight {
        std::optional<QPointF> px;
        std::optional<geometry::Pointing> reading;
    };

    void onStill(const Still& still);
    void goOn();
    void compute();
    [[nodiscard]] Sight& sight(Extreme which) { return sights_[static_cast<std::size_t>(which)]; }
    [[nodiscard]] const Sight& sight(Extreme which) const { return sights_[static_cast<std::size_t>(which)]; }
    [[nodiscard]] std::optional<core::Angle> measure(bool horizontal, ApaResult& result) const;
    void judge(bool horizontal, core::Angle per_pixel, ApaResult& result) const;

    LivePresenter& live_;
    const InstrumentDesk& instrument_;
    Preferences& preferences_;
    MessageCentre& messages_;
    std::optional<Still> still_;
    bool capturing_ = false;
    std::array<Sight, kExtremes> sights_;
    Extreme current_ = Extreme::kLeft;
    ApaResult across_, down_;
    std::optional<targeting::AveragePixelAngle> measured_;
};

}  // namespace pmts::app
