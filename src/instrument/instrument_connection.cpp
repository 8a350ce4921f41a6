#include "pmts/instrument/instrument_connection.hpp"

#include "line_control.hpp"
#include "pmts/core/logging.hpp"
#include "relay_link.hpp"

#include <algorithm>

namespace pmts::instrument {
namespace {

constexpr core::Duration kEndingTurn = std::chrono::milliseconds(10);

core::Error otherInstrument(const Identity& found, const Identity& wanted) {
    return {.kind = core::ErrorKind::kUnsupported,
            .happened = QObject::tr("Another instrument answers here (number %1 instead of %2).")
                            .arg(found.serial_number, wanted.serial_number),
            .remedy = QObject::tr("Connect to it by hand if it is meant."),
            .info_code = std::nullopt,
            .detail = {}};
}

/// A file goes in line by line at the pace of the wire.
GeodimeterSettings profileOf(const ConnectionSettings& settings) {
    GeodimeterSettings profile = settings.profile;
    if (settings.byte_time > core::Duration::zero()) {
        profile.file_byte_time = settings.byte_time;
    }
    return profile;
}

bool isSameInstrument(const Identity& a, const Identity& b) {
    return a.serial_number.isEmpty() || b.serial_number.isEmpty() || a.serial_number == b.serial_number;
}

}  // namespace

class InstrumentConnection::Impl : public std::enable_shared_from_this<Impl> {
public:
    using Self = std::shared_ptr<Impl>;

    Impl(LinkFactory make, core::Clock& the_clock, core::VideoGate& gate, ConnectionSettings the_settings)
        : make_link(std::move(make)),
          clock(the_clock),
          settings(std::move(the_settings)),
          arbiter(relay, clock, settings.dialect == LineDialect::kBus ? scheduler::ArbiterSettings::forBus() : settings.arbiter),
          line(arbiter, clock, gate),
          driver(line, clock, profileOf(settings)),
          poller(driver, clock, settings.poller),
          control(arbiter, line, relay, clock, settings) {
        line.setByteTime(settings.byte_time);
        if (settings.dialect == LineDialect::kBus) {
            bus.emplace(line, clock, settings.bus);  // from here on the line's callbacks are its own
        }
    }

    void attach(InstrumentConnection& connection) {
        owner = &connection;
        relay.on_gone = [weak = weak_from_this()](const core::Error& error) { weak.lock()->gone(error); };
        poller.on_silence = [weak = weak_from_this()](const core::Error& error) { weak.lock()->gone(error); };
        if (bus) {
            bus->on_silence = [weak = weak_from_this()](const core::Error& error) { weak.lock()->busFellSilent(error); };
        }
        control.on_returned = [weak = weak_from_this()] { weak.lock()->askAgain(); };
        control.on_changed = [this](const ControlStatus& status) {
            if (owner != nullptr && owner->on_control) {
                owner->on_control(status);
            }
        };
        arbiter.on_panel_command = [weak = weak_from_this()](std::string_view command) {
            weak.lock()->panelSent(command);
        };
        arbiter.on_panel_turn = [this](const scheduler::TransactionRecord& record) {
            if (bus && !record.received.empty()) {
                bus->noteForeignTurn();
            }
            if (owner != nullptr && owner->on_panel_turn) {
                owner->on_panel_turn(record);
            }
        };
    }

    void shutDown() {
        owner = nullptr;
        relay.on_gone = nullptr;
        control.panel().close();
        close(core::cancelled().value());
    }

    /// From here on nothing of the last attempt counts: its waiters end, its coroutines see their token
    /// stopped.
    void close(const core::Error& reason) {
        attempt.request_stop();
        attempt = std::stop_source();
        poller.stop();
        if (bus) {
            bus->forget();
        }
        relay.close();
        line.reset(reason);
        arbiter.reset();
        control.endWaiting(reason);
    }

    void setState(ConnectionState now, const QString& sentence) {
        state = now;
        if (owner != nullptr && owner->on_state) {
            owner->on_state(now, sentence);
        }
    }

    void gone(const core::Error& error) {
        if (state != ConnectionState::kConnected) {
            control.endWaiting(error);
            return;  // while connecting, the question that waits fails by itself
        }
        close(error);
        setState(ConnectionState::kLost, error.sentence());
        if (settings.reconnects && owner != nullptr) {
            [[maybe_unused]] const auto running = reconnect(shared_from_this(), attempt.get_token());
        }
    }

    /// While the panel has the line it may have suspended the stream, and closing the port would cut it off.
    void busFellSilent(const core::Error& error) {
        if (control.mayAsk() && arbiter.owner() != scheduler::LineOwner::kPanel) {
            gone(error);
        } else {
            bus->noteForeignTurn();
        }
    }

    void setControlMode(scheduler::ControlMode mode) {
        if (mode == scheduler::ControlMode::kPanel) {
            poller.stop();
        }
        control.setMode(mode);
    }

    void panelSent(std::string_view command) {
        if (!bus && driver.noteForeignCommand(command)) {
            askAgain();
        }
    }

    /// What PMTS knows of the instrument may be old: units, block end, mode.
    void askAgain() {
        ask_again = true;
        if (!asking_again && owner != nullptr && state == ConnectionState::kConnected) {
            [[maybe_unused]] const auto running = askAgain(shared_from_this(), attempt.get_token());
        }
    }

    static core::Task<void> askAgain(Self self, std::stop_token stop) {
        self->asking_again = true;
        self->poller.stop();
        while (std::exchange(self->ask_again, false)) {
            auto waiting = untilDriverIsIdle(self, stop);
            const auto waited = co_await waiting;
            if (!waited) {
                break;
            }
            auto asking = self->speaker().connectTo(stop);
            const auto who = co_await asking;
            if (stop.stop_requested()) {
                break;
            }
            if (who) {
                self->identity = *who;
            } else if (self->control.mayAsk()) {
                self->gone(who.error());
            }
        }
        self->asking_again = false;
        if (self->ask_again) {
            self->askAgain();
        } else if (!stop.stop_requested() && self->control.mayAsk()) {
            self->poll();
        }
    }

    static core::Task<core::Result<void>> untilDriverIsIdle(Self self, std::stop_token stop) {
        while (self->bus ? self->bus->isBusy() : self->driver.isBusy()) {
            auto pausing = core::sleepFor(self->clock, kEndingTurn, stop);
            PMTS_CO_TRY(co_await pausing);
        }
        co_return {};
    }

    /// Opens a port and asks nothing before PMTS may.
    static core::Task<core::Result<void>> untilMayAsk(Self self) {
        while (!self->control.mayAsk()) {
            self->setState(self->state, panelHasControl().sentence());
            const auto returned = self->control.returned();
            auto answer = returned.answer();
            PMTS_CO_TRY(co_await answer);
        }
        co_return {};
    }

    [[nodiscard]] TotalStation& speaker() { return bus ? static_cast<TotalStation&>(*bus) : driver; }

    /// The bus says its angles by itself.
    void poll() {
        if (!bus) {
            poller.start();
        }
    }

    void connected(const Identity& who) {
        identity = who;
        ask_again = false;
        if (control.mayAsk()) {
            poll();
        }
        setState(ConnectionState::kConnected,
                 QObject::tr("Connected: %1 on %2.").arg(QString(who.model + u' ' + who.serial_number).trimmed(), address));
        if (owner != nullptr && owner->on_identity) {
            owner->on_identity(who);
        }
    }

    /// Opens one port and asks who is there. `wanted`: only this instrument will do.
    static core::Task<core::Result<Identity>> tryAddress(Self self, QString where,
                                                         std::optional<Identity> wanted,
                                                         std::stop_token stop) {
        // What ran on the last link has been told that it is over; it ends in the next turns of the event
        // loop.
        auto ending = untilDriverIsIdle(self, stop);
        PMTS_CO_TRY(co_await ending);
        self->relay.replace(self->make_link(where));
        if (auto opened = self->relay.open(); !opened) {
            co_return tl::unexpected(std::move(opened).error());
        }
        self->control.setLines();
        auto waiting = untilMayAsk(self);
        PMTS_CO_TRY(co_await waiting);
        if (std::exchange(self->switches_on, false)) {
            auto switching = switchOn(self->relay, self->clock, *self->settings.switch_on, stop);
            PMTS_CO_TRY(co_await switching);
        }
        auto asking = self->speaker().connectTo(stop);
        auto who = co_await asking;
        if (who && wanted && !isSameInstrument(*who, *wanted)) {
            who = tl::unexpected(otherInstrument(*who, *wanted));
        }
        if (!who && !stop.stop_requested()) {
            self->relay.close();
        }
        if (who) {
            self->address = where;
        }
        co_return who;
    }

    static core::Task<core::Result<Identity>> connectOnce(Self self, QString where) {
        self->close(core::cancelled().value());
        self->control.panel().open();
        const auto stop = self->attempt.get_token();
        self->address = where;
        self->identity.reset();
        self->setState(ConnectionState::kConnecting, QObject::tr("Connecting to %1.").arg(where));
        self->switches_on = self->settings.switch_on.has_value();
        auto trying = tryAddress(self, where, std::nullopt, stop);
        auto who = co_await trying;
        if (stop.stop_requested()) {
            co_return core::cancelled();
        }
        if (who) {
            self->connected(*who);
        } else {
            self->setState(ConnectionState::kDisconnected, who.error().sentence());
        }
        co_return who;
    }

    static core::Task<void> reconnect(Self self, std::stop_token stop) {
        const auto wanted = self->identity;
        const QString lost_address = self->address;
        for (core::Duration pause = self->settings.first_retry;;
             pause = std::min(2 * pause, self->settings.longest_retry)) {
            auto pausing = core::sleepFor(self->clock, pause, stop);
            if (const auto paused = co_await pausing; !paused) {
                co_return;
            }
            for (const QString& where : self->candidates(lost_address)) {
                auto trying = tryAddress(self, where, wanted, stop);
                const auto who = co_await trying;
                if (stop.stop_requested()) {
                    co_return;
                }
                if (who) {
                    self->connected(*who);
                    co_return;
                }
                qCDebug(core::logInstrument) << "not back on" << where << who.error().happened;
            }
        }
    }

    [[nodiscard]] std::vector<QString> candidates(const QString& lost_address) const {
        std::vector<QString> all;
        if (owner != nullptr && owner->find_again) {
            all = owner->find_again(lost_address);
        }
        if (std::ranges::find(all, lost_address) == all.end()) {
            all.push_back(lost_address);
        }
        return all;
    }

    LinkFactory make_link;
    core::Clock& clock;
    ConnectionSettings settings;
    RelayLink relay;
    scheduler::Arbiter arbiter;
    scheduler::Scheduler line;
    GeodimeterDriver driver;
    PointingPoller poller;
    std::optional<BusDriver> bus;
    LineControl control;
    bool switches_on = false;  ///< before the next question
    bool ask_again = false;
    bool asking_again = false;
    InstrumentConnection* owner = nullptr;
    ConnectionState state = ConnectionState::kDisconnected;
    std::optional<Identity> identity;
    QString address;
    std::stop_source attempt;  ///< of the current connectTo() or reconnect loop
};

InstrumentConnection::InstrumentConnection(LinkFactory make_link, core::Clock& clock, core::VideoGate& gate,
                                           ConnectionSettings settings)
    : impl_(std::make_shared<Impl>(std::move(make_link), clock, gate, std::move(settings))) {
    impl_->attach(*this);
}

InstrumentConnection::~InstrumentConnection() { impl_->shutDown(); }

core::Task<core::Result<Identity>> InstrumentConnection::connectTo(QString address) {
    return Impl::connectOnce(impl_, std::move(address));
}

void InstrumentConnection::disconnect() {
    impl_->control.panel().close();
    impl_->close(core::cancelled().value());
    impl_->setState(ConnectionState::kDisconnected, QObject::tr("Disconnected."));
}

void InstrumentConnection::usePanel(std::function<std::unique_ptr<transport::ByteLink>()> make_link) {
    impl_->control.panel().use(std::move(make_link));
}

void InstrumentConnection::setControlMode(scheduler::ControlMode mode) { impl_->setControlMode(mode); }
void InstrumentConnection::setPathSwitch(const PathSwitch& path_switch) { impl_->control.setSwitch(path_switch); }
ControlStatus InstrumentConnection::control() const { return impl_->control.status(); }

ConnectionState InstrumentConnection::state() const { return impl_->state; }
const std::optional<Identity>& InstrumentConnection::identity() const { return impl_->identity; }
QString InstrumentConnection::address() const { return impl_->address; }
GeodimeterDriver& InstrumentConnection::station() { return impl_->driver; }
BusDriver* InstrumentConnection::bus() { return impl_->bus ? &*impl_->bus : nullptr; }
TotalStation& InstrumentConnection::speaker() { return impl_->speaker(); }
scheduler::Scheduler& InstrumentConnection::line() { return impl_->line; }
PointingPoller& InstrumentConnection::poller() { return impl_->poller; }

}  // namespace pmts::instrument
