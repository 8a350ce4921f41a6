#include "instrument_worker.hpp"

#include "adapter_port.hpp"
#include "serial_settings.hpp"

#include <QCoreApplication>

#include <utility>

namespace pmts::app {

namespace {

constexpr core::Angle kWindingStep = core::Angle::fromGon(40);
constexpr core::Duration kSunInterval = std::chrono::seconds(10);
constexpr double kBitsPerByte = 10.0;  ///< start, eight data, stop

ConnectionState stateOf(instrument::ConnectionState state) {
    switch (state) {
        case instrument::ConnectionState::kDisconnected: return ConnectionState::kDisconnected;
        case instrument::ConnectionState::kConnecting: return ConnectionState::kConnecting;
        case instrument::ConnectionState::kConnected: return ConnectionState::kConnected;
        case instrument::ConnectionState::kLost: return ConnectionState::kReconnecting;
    }
    return ConnectionState::kDisconnected;
}

core::Error notConnected() {
    return {.kind = core::ErrorKind::kNotConnected,
            .happened = QCoreApplication::translate("InstrumentDesk", "No instrument is connected."),
            .remedy = QCoreApplication::translate("InstrumentDesk", "Connect it on the connection page."),
            .info_code = std::nullopt,
            .detail = {}};
}

}  // namespace

InstrumentDesk::Worker::Worker(InstrumentDesk& desk, core::VideoGate& gate, InstrumentWiring wiring)
    : desk_(&desk), gate_(gate), wiring_(std::move(wiring)),
      own_clock_(wiring_.clock ? nullptr : std::make_unique<core::SystemClock>()),
      clock_(wiring_.clock ? *wiring_.clock : *own_clock_), guard_(clock_) {}

InstrumentDesk::Worker::~Worker() = default;

std::unique_ptr<transport::ByteLink> InstrumentDesk::Worker::makeLink(const QString& address) const {
    SerialChoice choice = choice_;
    choice.path = address;
    return linkTo(choice);
}

std::unique_ptr<transport::ByteLink> InstrumentDesk::Worker::linkTo(const SerialChoice& choice) const {
    if (isAnothersPort(choice, portsFor(choice))) {
        return anothersPort(choice.path);
    }
    return wiring_.make_link ? wiring_.make_link(choice)
                             : std::make_unique<transport::SerialLink>(serialSettings(choice));
}

/// Only a USB adapter can be told from another one.
std::vector<transport::PortInfo> InstrumentDesk::Worker::portsFor(const SerialChoice& choice) const {
    return choice.adapter.usb_vendor ? wiring_.list_ports() : std::vector<transport::PortInfo>();
}

std::vector<QString> InstrumentDesk::Worker::addressesNow() const {
    std::vector<QString> addresses{pathNow(choice_, portsFor(choice_))};
    if (!offered_address_.isEmpty()) {
        addresses.push_back(offered_address_);
    }
    return addresses;
}

void InstrumentDesk::Worker::connectTo(const SerialChoice& choice, FirstAct first) {
    if (opening_ || running_ != 0) {
        next_choice_.emplace(choice, first);
        question_.reset();
        stop_.request_stop();
        stop_ = {};
        failWaiting(core::cancelled().value());
        connection_->disconnect();
        return;
    }
    choice_ = choice;
    choice_.path = pathNow(choice, portsFor(choice));
    offered_address_.clear();
    instrument::ConnectionSettings settings = wiring_.connection;
    const auto byte_s = std::chrono::duration<double>(kBitsPerByte / choice.baud);
    settings.profile.file_byte_time = std::chrono::duration_cast<core::Duration>(byte_s);
    if (choice.adapter.usb_vendor) {  // a pty has no pace of its own
        settings.byte_time = settings.profile.file_byte_time;
    }
    settings.control_mode = control_.mode;
    settings.dialect = choice.dialect;
    if (first == FirstAct::kSwitchOn) {
        settings.switch_on.emplace();
    }
    settings.path_switch = control_.path_switch;
    settings.profile.target_test = target_test_;
    connection_ = std::make_unique<instrument::InstrumentConnection>(
        [this](const QString& address) { return makeLink(address); }, clock_, gate_, settings);
    wireConnection();
    usePanel();
    open(shared_from_this(), choice_.path);
}

core::Task<void> InstrumentDesk::Worker::open(std::shared_ptr<Worker> self, QString address) {
    self->opening_ = true;
    auto opening = self->connection_->connectTo(address);
    const auto identity = co_await opening;
    self->opening_ = false;
    if (!identity && identity.error().kind != core::ErrorKind::kCancelled) {
        self->say([error = identity.error()](InstrumentDesk& desk) { Q_EMIT desk.connectFailed(error); });
    }
    self->endIfQuiet();
}

void InstrumentDesk::Worker::wireConnection() {
    connection_->on_state = [this](instrument::ConnectionState state, const QString& sentence) { showState(state, sentence); };
    connection_->on_identity = [this](const instrument::Identity& identity) {
        say([identity](InstrumentDesk& desk) { desk.showIdentity(identity); });
    };
    connection_->find_again = [this](const QString&) { return addressesNow(); };
    instrument::TotalStation& station = connection_->speaker();
    station.on_pointing = [this](const geometry::Pointing& pointing, core::Duration at) { takeReading(pointing, at); };
    station.on_progress = [this](const instrument::Progress& progress) {
        say([progress](InstrumentDesk& desk) { desk.showProgress(progress); });
    };
    station.on_unsolicited = [this](const instrument::UnsolicitedBlock& block) {
        say([block](InstrumentDesk& desk) { Q_EMIT desk.unsolicitedBlock(block); });
    };
    station.on_warnings = [this](const std::vector<core::Error>& standing) {
        say([standing](InstrumentDesk& desk) { Q_EMIT desk.warningsChanged(standing); });
    };
    const auto finished = [this](const scheduler::TransactionRecord& record) {
        say([record](InstrumentDesk& desk) { Q_EMIT desk.transactionFinished(record); });
    };
    connection_->line().on_finished = finished;
    connection_->line().on_stray = [this](const scheduler::Stray& stray) {
        say([stray](InstrumentDesk& desk) { Q_EMIT desk.strayCame(stray); });
    };
    connection_->on_panel_turn = finished;
    connection_->on_control = [this](const instrument::ControlStatus& status) {
        say([status](InstrumentDesk& desk) { Q_EMIT desk.controlChanged(status); });
    };
}

void InstrumentDesk::Worker::takeReading(const geometry::Pointing& pointing, core::Duration at) {
    last_reading_ = pointing;
    guard_.follow(pointing);
    if (core::abs(*guard_.wound() - told_wound_) >= kWindingStep) {
        showWound();
    }
    watchSun(pointing, at);
    say([pointing, at](InstrumentDesk& desk) { desk.showPointing({.pointing = pointing, .at = at}); });
}

void InstrumentDesk::Worker::showWound() {
    told_wound_ = guard_.wound().value_or(core::Angle());
    say([wound = told_wound_](InstrumentDesk& desk) { desk.showWound(wound); });
}

void InstrumentDesk::Worker::cableHangsFree() {
    guard_.unwound();
    showWound();
}

void InstrumentDesk::Worker::watchSun(const geometry::Pointing& pointing, core::Duration at) {
    if (sun_looked_at_.count() >= 0 && at - sun_looked_at_ < kSunInterval) {
        return;
    }
    sun_looked_at_ = at;
    const auto standing = guard_.checkStanding(pointing);
    if (standing.has_value() != is_in_sun_) {
        return;
    }
    is_in_sun_ = !standing;
    const core::Error error = standing ? core::Error() : standing.error();
    say([error](InstrumentDesk& desk) { Q_EMIT desk.sunCame(error.happened, error.remedy); });
}

core::Result<void> InstrumentDesk::Worker::mayTurn(const geometry::Pointing& target) const {
    return guard_.check(last_reading_.value_or(target), target);
}

core::Task<core::Result<geometry::Pointing>> InstrumentDesk::Worker::turn(std::shared_ptr<Worker> self,
                                                                          instrument::TotalStation& station,
                                                                          geometry::Pointing target, core::Angle tolerance,
                                                                          std::stop_token stop) {
    PMTS_CO_TRY(self->mayTurn(target));
    auto turning = station.turnTo(target, tolerance, std::move(stop));
    co_return co_await turning;
}

targeting::FrameAfter InstrumentDesk::Worker::framesOf(const std::shared_ptr<Worker>& self,
                                                       const std::shared_ptr<FrameFeed>& frames) {
    return [self, frames](core::Duration since, std::stop_token ended) {
        return FrameFeed::after(frames, since, self->clock_, std::move(ended));
    };
}

core::Task<core::Result<targeting::Recentred>> InstrumentDesk::Worker::recentre(std::shared_ptr<Worker> self,
                                                                                instrument::TotalStation& station,
                                                                                RecentringOrder order, Ticket ticket,
                                                                                std::stop_token stop) {
    targeting::Recentring routine(station, framesOf(self, order.frames), self->wiring_.find_patch, order.model, self->clock_, order.settings);
    routine.may_turn = [self](const geometry::Pointing& target) { return self->mayTurn(target); };
    routine.on_step = [self, ticket](const targeting::RecentringStep& step) {
        self->say([ticket, step](InstrumentDesk& desk) { Q_EMIT desk.recentringStepped(ticket, step); });
    };
    auto aiming = routine.turnTo(order.click, std::move(stop));
    co_return co_await aiming;
}

core::Task<core::Result<targeting::SweepOutcome>> InstrumentDesk::Worker::sweep(std::shared_ptr<Worker> self,
                                                                                instrument::TotalStation& station,
                                                                                SweepOrder order, Ticket ticket,
                                                                                std::stop_token stop) {
    targeting::SpotSweep routine(station, framesOf(self, order.frames), self->wiring_.find_patch, order.model, self->clock_,
                                 order.settings);
    routine.seen_before = order.seen_before;
    routine.may_turn = [self](const geometry::Pointing& target) { return self->mayTurn(target); };
    routine.on_step = [self, ticket](const targeting::SweepStep& step) {
        self->say([ticket, step](InstrumentDesk& desk) { Q_EMIT desk.sweepStepped(ticket, step); });
    };
    auto sweeping = routine.run(order.click, order.pointings, std::move(stop));
    co_return co_await sweeping;
}

void InstrumentDesk::Worker::showState(instrument::ConnectionState state, const QString& sentence) {
    if (state != instrument::ConnectionState::kConnected) {
        question_.reset();  // whoever asked has gone
    }
    say([state = stateOf(state), sentence, choice = choice_](InstrumentDesk& desk) {
        desk.choice_ = choice;
        desk.showConnection(state, sentence);
    });
}

void InstrumentDesk::Worker::disconnectInstrument() {
    question_.reset();
    failWaiting(notConnected());
    next_choice_.reset();
    if (connection_) {
        connection_->disconnect();
    }
}

void InstrumentDesk::Worker::stop() {
    failWaiting(core::cancelled().value());
    stopRunning();
}

void InstrumentDesk::Worker::cancel(Ticket ticket) {
    if (ticket == 0) {
        return;
    }
    if (ticket == running_) {
        stopRunning();
    } else if (std::erase_if(waiting_, [ticket](const Request& request) { return request.ticket == ticket; }) > 0) {
        fail(ticket, core::cancelled().value());
    }
}

void InstrumentDesk::Worker::stopRunning() {
    question_.reset();  // nobody answers any more
    stop_.request_stop();
    stop_ = {};
    if (connection_) {
        connection_->speaker().stop();
    }
}

void InstrumentDesk::Worker::shutDown(std::function<void()> done) {
    on_quiet_ = std::move(done);
    stop();
    disconnectInstrument();
    endIfQuiet();
}

void InstrumentDesk::Worker::leaveDesk() {
    desk_ = nullptr;
    stop();
    disconnectInstrument();
    if (!opening_ && running_ == 0) {
        connection_.reset();
    }
}

void InstrumentDesk::Worker::endIfQuiet() {
    if (opening_ || running_ != 0) {
        return;
    }
    if (on_quiet_) {
        // One turn of the loop before and after: what the connection cancels must still run to its end.
        core::post([self = shared_from_this(), done = std::exchange(on_quiet_, {})] {
            self->connection_.reset();
            core::post(done);
        });
    } else if (next_choice_) {
        const auto next = *std::exchange(next_choice_, std::nullopt);
        connectTo(next.first, next.second);
    }
}

core::Error InstrumentDesk::Worker::notOnTheBus() {
    return {.kind = core::ErrorKind::kUnsupported,
            .happened = InstrumentDesk::tr("The bus under the panel does not know this."),
            .remedy = InstrumentDesk::tr("Use the external interface on the instrument's foot."),
            .info_code = std::nullopt,
            .detail = {}};
}

void InstrumentDesk::Worker::startNext() {
    while (running_ == 0 && !waiting_.empty()) {
        Request request = std::move(waiting_.front());
        waiting_.pop_front();
        if (!connection_ || connection_->state() != instrument::ConnectionState::kConnected) {
            fail(request.ticket, notConnected());
            continue;
        }
        running_ = request.ticket;
        request.start(*this);
    }
    endIfQuiet();
}

void InstrumentDesk::Worker::fail(Ticket ticket, const core::Error& error) {
    say([ticket, error](InstrumentDesk& desk) { Q_EMIT desk.requestFailed(ticket, error); });
}

void InstrumentDesk::Worker::failWaiting(const core::Error& error) {
    for (const Request& request : std::exchange(waiting_, {})) {
        fail(request.ticket, error);
    }
}

}  // namespace pmts::app
