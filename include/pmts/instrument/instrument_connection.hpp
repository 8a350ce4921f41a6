#pragma once

#include "pmts/core/video_gate.hpp"
#include "pmts/instrument/bus_driver.hpp"
#include "pmts/instrument/control_settings.hpp"
#include "pmts/instrument/geodimeter_driver.hpp"
#include "pmts/instrument/line_dialect.hpp"
#include "pmts/instrument/pointing_poller.hpp"
#include "pmts/instrument/switching_on.hpp"
#include "pmts/scheduler/arbiter.hpp"
#include "pmts/scheduler/scheduler.hpp"
#include "pmts/transport/byte_link.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace pmts::instrument {

enum class ConnectionState {
    kDisconnected,
    kConnecting,  ///< the port is being opened and the instrument asked who it is
    kConnected,   ///< it answers: never said for an open port alone
    kLost,        ///< it went away; tried again until it is back or disconnect()
};

struct ConnectionSettings {
    GeodimeterSettings profile;
    PollerSettings poller;
    bool reconnects = true;
    core::Duration first_retry = std::chrono::milliseconds(500);  ///< doubled after each failure
    core::Duration longest_retry = std::chrono::seconds(5);
    core::Duration byte_time{
        0};  ///< see Scheduler::setByteTime(); 0 where the line has no pace (pty, memory)
    scheduler::ArbiterSettings arbiter{};
    scheduler::ControlMode control_mode = scheduler::ControlMode::kShared;
    PathSwitch path_switch{};
    LineDialect dialect = LineDialect::kExternal;  ///< on the bus the arbiter's settings are forBus()
    BusSettings bus{};
    std::optional<SwitchingOn> switch_on{};  ///< connectTo() switches the instrument on before it asks; a reconnect does not
};

/// One instrument on one line, from the port to the driver: opens, asks, watches, opens again. The station,
/// the scheduler and the poller stay the same objects over every reconnect. Lives on the instrument thread.
/// A panel on a second port shares the line by transaction; while it has control PMTS asks nothing, connecting waits, and
/// when control is back the instrument is asked again who it is and how it talks, before anything is read.
class InstrumentConnection {
public:
    using LinkFactory = std::function<std::unique_ptr<transport::ByteLink>(const QString& address)>;

    /// Clock and gate outlive the connection.
    InstrumentConnection(LinkFactory make_link, core::Clock& clock, core::VideoGate& gate,
                         ConnectionSettings settings = {});
    ~InstrumentConnection();
    InstrumentConnection(const InstrumentConnection&) = delete;
    InstrumentConnection& operator=(const InstrumentConnection&) = delete;

    /// Ends with the identity, or with the sentence for the connection page; then the port is closed again.
    [[nodiscard]] core::Task<core::Result<Identity>> connectTo(QString address);
    void disconnect();

    /// The panel's port; empty: one port. Open while the connection is used; tried again when it went away.
    void usePanel(std::function<std::unique_ptr<transport::ByteLink>()> make_link);
    /// What runs on the line is finished first.
    void setControlMode(scheduler::ControlMode mode);
    void setPathSwitch(const PathSwitch& path_switch);
    [[nodiscard]] ControlStatus control() const;

    [[nodiscard]] ConnectionState state() const;
    [[nodiscard]] const std::optional<Identity>& identity() const;
    [[nodiscard]] QString address() const;  ///< of the last port that answered or was tried
    [[nodiscard]] GeodimeterDriver& station();
    /// Null where the line is the external interface.
    [[nodiscard]] BusDriver* bus();
    /// Whichever of the two speaks on this line.
    [[nodiscard]] TotalStation& speaker();
    [[nodiscard]] scheduler::Scheduler& line();
    [[nodiscard]] PointingPoller& poller();

    /// The sentence says why: for the status bar.
    std::function<void(ConnectionState, const QString& sentence)> on_state;
    /// The instrument answered, at connect and after each loss.
    std::function<void(const Identity&)> on_identity;
    /// Mode, owner, counters or panel port changed. Often: twice a transaction.
    std::function<void(const ControlStatus&)> on_control;
    /// What the panel sent and got, and what of it was swallowed: for the log.
    std::function<void(const scheduler::TransactionRecord&)> on_panel_turn;
    /// Names under which the device may be back, the likeliest first: `findAgain` of the USB identity. Tried before the
    /// old address, which may be another device's by then; an instrument with another serial number is not taken.
    std::function<std::vector<QString>(const QString& lost_address)> find_again;

private:
    class Impl;
    std::shared_ptr<Impl> impl_;
};

}  // namespace pmts::instrument
