#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/simulator/scene.hpp"
#include "pmts/simulator/station_settings.hpp"
#include "pmts/simulator/world.hpp"

#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace pmts::simulator {

/// One kind of trouble that can be ordered by name.
struct FaultKind {
    enum class Lasts { kOnce, kUntilOff, kAtOnce };

    QString name;
    Lasts lasts = Lasts::kOnce;
    std::optional<double> usual_value;  ///< what a missing `=value` means; absent: it takes none
    QString unit;                       ///< of the value
    QString sentence;
};

/// The simulated instrument: bytes in, bytes out, time from the clock. Written from the protocol page alone.
/// One thread, the one whose clock it is given.
class Station {
public:
    Station(StationSettings settings, std::shared_ptr<const Scene> scene,
            std::shared_ptr<TruePointing> pointing, core::Clock& clock);
    ~Station();
    Station(const Station&) = delete;
    Station& operator=(const Station&) = delete;

    void receive(std::string_view bytes);
    std::function<void(std::string_view)> send;
    /// The fault `unplug`: whoever holds the link takes it away for this long. Without a handler the line is
    /// just dead.
    std::function<void(core::Duration)> on_unplug;

    /// Faults on demand: `NAME[=VALUE][,on=COMMAND][,times=N][,seed=N]`, e.g. `silent`, `late=3`,
    /// `drop=0.05,seed=7`, `info=156,on=WS`. `NAME=off` ends a lasting one, `none` ends all. Fails with
    /// kBadInput naming what it did not know.
    [[nodiscard]] core::Result<void> injectFault(const QString& fault);
    /// How often a fault had an effect: on the wire, an answer, the motors or the distance meter.
    [[nodiscard]] int timesStruck(const QString& fault) const;
    [[nodiscard]] static QStringList faultNames();
    [[nodiscard]] static const std::vector<FaultKind>& faultKinds();

    /// What the operator does: REG is pressed with output "REG key" chosen: a block without request, and a
    /// record in the current job of the instrument.
    void pressRegKey();
    void receiveBreak();  ///< the serial BREAK condition: switches on
    [[nodiscard]] bool isOn() const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace pmts::simulator
