#pragma once

#include "pmts/core/video_gate.hpp"
#include "pmts/instrument/geodimeter_driver.hpp"
#include "pmts/instrument/pointing_poller.hpp"
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
};

/// One instrument on one line, from the port to the driver: opens, asks, watches, opens again. The station,
/// the scheduler and the poller stay the same objects over every reconnect. Lives on the instrument thread.
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

    [[nodiscard]] ConnectionState state() const;
    [[nodiscard]] const std::optional<Identity>& identity() const;
    [[nodiscard]] QString address() const;  ///< of the last port that answered or was tried
    [[nodiscard]] GeodimeterDriver& station();
    [[nodiscard]] scheduler::Scheduler& line();
    [[nodiscard]] PointingPoller& poller();

    /// The sentence says why: for the status bar.
    std::function<void(ConnectionState, const QString& sentence)> on_state;
    /// The instrument answered, at connect and after each loss.
    std::function<void(const Identity&)> on_identity;
    /// Other names under which the device may be back: `findAgain` of the USB identity. Tried after the old
    /// address; an instrument with another serial number is not taken.
    std::function<std::vector<QString>(const QString& lost_address)> find_again;

private:
    class Impl;
    std::shared_ptr<Impl> impl_;
};

}  // namespace pmts::instrument
