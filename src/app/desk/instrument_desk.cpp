#include "pmts/app/desk/instrument_desk.hpp"

#include "instrument_worker.hpp"
#include "pmts/core/prompt_thread.hpp"

namespace pmts::app {

InstrumentDesk::InstrumentDesk(core::VideoGate& gate, InstrumentWiring wiring, QObject* parent)
    : QObject(parent), sentence_(tr("No instrument is connected.")) {
    const Threading threading = wiring.threading;
    worker_ = std::make_shared<Worker>(*this, gate, std::move(wiring));
    if (threading == Threading::kOwnThread) {
        thread_.setObjectName(QStringLiteral("instrument"));
        worker_->moveToThread(&thread_);
        thread_.start(QThread::HighPriority);
        QMetaObject::invokeMethod(worker_.get(), [] { core::makeThisThreadPrompt(); }, Qt::QueuedConnection);
    }
}

InstrumentDesk::~InstrumentDesk() {
    if (!thread_.isRunning()) {
        worker_->leaveDesk();
        return;
    }
    QMetaObject::invokeMethod(
        worker_.get(), [this] { worker_->shutDown([this] { thread_.quit(); }); }, Qt::QueuedConnection);
    thread_.wait();
}

Ticket InstrumentDesk::turnTo(geometry::Pointing target, core::Angle tolerance) {
    return request(
        [worker = worker_.get(), target, tolerance](instrument::TotalStation& station, std::stop_token stop) {
            return Worker::turn(worker->shared_from_this(), station, target, tolerance, std::move(stop));
        },
        [](InstrumentDesk& desk, Ticket ticket, const geometry::Pointing& arrived) { Q_EMIT desk.turned(ticket, arrived); });
}

Ticket InstrumentDesk::recentre(const RecentringOrder& order) {
    return request(
        [worker = worker_.get(), order, ticket = last_ticket_ + 1](instrument::TotalStation& station, std::stop_token stop) {
            return Worker::recentre(worker->shared_from_this(), station, order, ticket, std::move(stop));
        },
        [](InstrumentDesk& desk, Ticket ticket, const targeting::Recentred& proof) { Q_EMIT desk.recentred(ticket, proof); });
}

Ticket InstrumentDesk::sweep(const SweepOrder& order) {
    return request(
        [worker = worker_.get(), order, ticket = last_ticket_ + 1](instrument::TotalStation& station, std::stop_token stop) {
            return Worker::sweep(worker->shared_from_this(), station, order, ticket, std::move(stop));
        },
        [](InstrumentDesk& desk, Ticket ticket, const targeting::SweepOutcome& outcome) { Q_EMIT desk.swept(ticket, outcome); });
}

Ticket InstrumentDesk::measureDistance() {
    return request(
        [](instrument::TotalStation& station, std::stop_token stop) { return station.measureDistance(std::move(stop)); },
        [](InstrumentDesk& desk, Ticket ticket, const instrument::DistanceShot& shot) {
            Q_EMIT desk.distanceMeasured(ticket, shot);
        });
}

Ticket InstrumentDesk::setMode(instrument::EdmMode mode) {
    return request([mode](instrument::TotalStation& station, const std::stop_token&) { return station.setMode(mode); },
                   [mode](InstrumentDesk& desk, Ticket ticket) { Q_EMIT desk.modeSet(ticket, mode); });
}

Ticket InstrumentDesk::testSignal() {
    return request(
        [](instrument::TotalStation& station, std::stop_token stop) { return station.testSignal(std::move(stop)); },
        [](InstrumentDesk& desk, Ticket ticket, bool signal) { Q_EMIT desk.signalTested(ticket, signal); });
}

Ticket InstrumentDesk::readLabel(int label) {
    return request(
        [label](instrument::TotalStation& station, std::stop_token stop) { return station.get(label, std::move(stop)); },
        [label](InstrumentDesk& desk, Ticket ticket, const QString& data) { Q_EMIT desk.labelRead(ticket, label, data); });
}

Ticket InstrumentDesk::writeLabel(int label, const QString& data) {
    return request(
        [label, data](instrument::TotalStation& station, std::stop_token stop) {
            return station.set(label, data, std::move(stop));
        },
        [label](InstrumentDesk& desk, Ticket ticket) { Q_EMIT desk.labelWritten(ticket, label); });
}

Ticket InstrumentDesk::runRoutine(const protocol::TableRoutine& routine, const std::map<std::string, double>& numbers) {
    return request(
        [worker = worker_.get(), routine, numbers, ticket = last_ticket_ + 1](instrument::TotalStation& /*station*/,
                                                                              std::stop_token stop) {
            return Worker::runRoutine(worker->shared_from_this(), routine, numbers, ticket, std::move(stop));
        },
        [](InstrumentDesk& desk, Ticket ticket, const instrument::RoutineOutcome& outcome) {
            Q_EMIT desk.routineRan(ticket, outcome);
        });
}

void InstrumentDesk::connectSerial(const SerialChoice& choice) {
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get(), choice] { worker->connectTo(choice, FirstAct::kAsk); }, Qt::QueuedConnection);
}

void InstrumentDesk::switchOnSerial(const SerialChoice& choice) {
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get(), choice] { worker->connectTo(choice, FirstAct::kSwitchOn); }, Qt::QueuedConnection);
}

void InstrumentDesk::offerAddress(const QString& path) {
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get(), path] { worker->offerAddress(path); }, Qt::QueuedConnection);
}

void InstrumentDesk::disconnectInstrument() {
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get()] { worker->disconnectInstrument(); }, Qt::QueuedConnection);
}

void InstrumentDesk::setControl(const ControlSettings& control) {
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get(), control] { worker->setControl(control); }, Qt::QueuedConnection);
}

void InstrumentDesk::setGuard(const targeting::PointingGuardSettings& settings) {
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get(), settings] { worker->setGuard(settings); }, Qt::QueuedConnection);
}

void InstrumentDesk::cableHangsFree() {
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get()] { worker->cableHangsFree(); }, Qt::QueuedConnection);
}

void InstrumentDesk::stop() {
    QMetaObject::invokeMethod(worker_.get(), [worker = worker_.get()] { worker->stop(); }, Qt::QueuedConnection);
}

void InstrumentDesk::cancel(Ticket ticket) {
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get(), ticket] { worker->cancel(ticket); }, Qt::QueuedConnection);
}

void InstrumentDesk::showConnection(ConnectionState state, const QString& sentence) {
    state_ = state;
    sentence_ = sentence;
    if (state != ConnectionState::kConnected) {
        track_.clear();  // where it points now is not known
        showProgress({});
    }
    if (state == ConnectionState::kDisconnected || state == ConnectionState::kConnecting) {
        identity_.reset();
    }
    Q_EMIT connectionChanged(state, sentence);
}

void InstrumentDesk::showIdentity(const instrument::Identity& identity) {
    identity_ = identity;
    Q_EMIT identityChanged(identity);
}

void InstrumentDesk::showPointing(const TimedPointing& reading) {
    track_.add(reading);
    Q_EMIT pointingChanged(reading);
}

void InstrumentDesk::showProgress(const instrument::Progress& progress) {
    progress_ = progress;
    Q_EMIT progressChanged(progress);
}

void InstrumentDesk::showWound(core::Angle wound) {
    wound_ = wound;
    Q_EMIT woundChanged();
}

}  // namespace pmts::app
