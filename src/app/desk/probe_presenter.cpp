#include "pmts/app/desk/probe_presenter.hpp"

#include "probe_verdict.hpp"
#include "pmts/transport/serial_link.hpp"

#include <algorithm>
#include <stop_token>
#include <utility>

namespace pmts::app {

namespace {

static_assert(static_cast<int>(Parity::kNone) == static_cast<int>(transport::Parity::kNone));
static_assert(static_cast<int>(Parity::kOdd) == static_cast<int>(transport::Parity::kOdd));
static_assert(static_cast<int>(Parity::kEven) == static_cast<int>(transport::Parity::kEven));

std::unique_ptr<transport::ByteLink> serialLink(const transport::SerialSettings& line) {
    return std::make_unique<transport::SerialLink>(line);
}

}  // namespace

/// The side of the thread on which ports are opened.
class ProbePresenter::Worker : public QObject, public std::enable_shared_from_this<Worker> {
public:
    Worker(ProbePresenter& presenter, ProbeWiring wiring)
        : presenter_(&presenter), own_clock_(wiring.clock ? nullptr : std::make_unique<core::SystemClock>()),
          probe_(wiring.make_link ? wiring.make_link : serialLink, wiring.clock ? *wiring.clock : *own_clock_) {
        probe_.on_step = [this](const instrument::ProbeStep& step) {
            say([step](ProbePresenter& to) { to.showStep(step); });
        };
    }

    void start(const QStringList& paths) {
        stop_ = {};
        is_running_ = true;
        look(shared_from_this(), {paths.begin(), paths.end()}, stop_.get_token());
    }
    void cancel() { stop_.request_stop(); }
    /// `done` runs when nothing runs any more.
    void shutDown(std::function<void()> done) {
        presenter_ = nullptr;
        on_quiet_ = std::move(done);
        stop_.request_stop();
        endIfQuiet();
    }

private:
    static core::Task<void> look(std::shared_ptr<Worker> self, std::vector<QString> ports, std::stop_token stop) {
        auto looking = self->probe_.run(std::move(ports), stop);
        const auto outcome = co_await looking;
        self->is_running_ = false;
        self->say([outcome](ProbePresenter& to) { to.finish(outcome); });
        self->endIfQuiet();
    }

    void endIfQuiet() {
        if (!is_running_ && on_quiet_) {
            core::post(std::exchange(on_quiet_, {}));
        }
    }

    template <class Words>
    void say(Words words) {
        if (presenter_) {
            QMetaObject::invokeMethod(presenter_, [to = presenter_, words = std::move(words)] { words(*to); },
                                      Qt::QueuedConnection);
        }
    }

    ProbePresenter* presenter_;
    std::unique_ptr<core::Clock> own_clock_;
    instrument::LineProbe probe_;
    std::stop_source stop_;
    bool is_running_ = false;
    std::function<void()> on_quiet_;
};

ProbePresenter::ProbePresenter(ConnectionPresenter& connection, InstrumentDesk& instrument, SimulationDesk& simulation,
                               ProbeWiring wiring, QObject* parent)
    : QObject(parent), connection_(connection), instrument_(instrument), simulation_(simulation) {
    const Threading threading = wiring.threading;
    worker_ = std::make_shared<Worker>(*this, std::move(wiring));
    if (threading == Threading::kOwnThread) {
        thread_.setObjectName(QStringLiteral("probe"));
        worker_->moveToThread(&thread_);
        thread_.start();
    }
    connect(&instrument_, &InstrumentDesk::connectionChanged, this, [this](ConnectionState state) {
        if (state == ConnectionState::kDisconnected && std::exchange(waits_for_port_, false)) {
            begin();
        }
        Q_EMIT changed();
    });
}

ProbePresenter::~ProbePresenter() {
    if (!thread_.isRunning()) {
        worker_->shutDown({});
        return;
    }
    QMetaObject::invokeMethod(
        worker_.get(), [this] { worker_->shutDown([this] { thread_.quit(); }); }, Qt::QueuedConnection);
    thread_.wait();
}

std::vector<PortChoice> ProbePresenter::ports() const {
    std::vector<PortChoice> ports = connection_.ports();
    if (simulation_.isRunning()) {
        ports.push_back({.path = simulation_.portPath(),
                         .name = tr("Simulated instrument (%1)").arg(simulation_.portPath()),
                         .adapter = {},
                         .used_last = false});
    }
    return ports;
}

QString ProbePresenter::refusal() const {
    return instrument_.connectionState() == ConnectionState::kConnected
               ? tr("The instrument answers: there is nothing to look for. Disconnect it first.")
               : QString();
}

void ProbePresenter::start(const QStringList& paths) {
    if (is_running_ || !refusal().isEmpty()) {
        return;
    }
    found_.reset();
    fraction_ = 0.0;
    step_text_.clear();
    paths_ = paths;
    paths_.removeAll(QString());
    if (paths_.isEmpty()) {
        verdict_ = {.state = DeviceState::kWarning, .text = tr("No port is chosen."), .details = tr("Tick the ports to look at.")};
        Q_EMIT changed();
        return;
    }
    verdict_ = {};
    is_running_ = true;
    waits_for_port_ = instrument_.connectionState() != ConnectionState::kDisconnected;
    Q_EMIT changed();
    if (waits_for_port_) {
        connection_.disconnectInstrument();
    } else {
        begin();
    }
}

void ProbePresenter::begin() {
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get(), paths = paths_] { worker->start(paths); }, Qt::QueuedConnection);
}

void ProbePresenter::cancel() {
    if (std::exchange(waits_for_port_, false)) {
        finish(core::cancelled());
        return;
    }
    QMetaObject::invokeMethod(worker_.get(), [worker = worker_.get()] { worker->cancel(); }, Qt::QueuedConnection);
}

void ProbePresenter::showStep(const instrument::ProbeStep& step) {
    step_text_ = tr("%1 at %2 (%3 of %4)").arg(step.line.port_name, step.line.lineText()).arg(step.done + 1).arg(step.of);
    fraction_ = static_cast<double>(step.done) / std::max(1, step.of);
    Q_EMIT changed();
}

void ProbePresenter::finish(const core::Result<instrument::ProbeOutcome>& outcome) {
    is_running_ = false;
    step_text_.clear();
    if (outcome) {
        judge(*outcome);
    } else {
        verdict_ = {.state = DeviceState::kIdle, .text = tr("The search was ended."), .details = {}};
    }
    Q_EMIT changed();
}

void ProbePresenter::judge(const instrument::ProbeOutcome& outcome) {
    verdict_ = probeVerdict(outcome);
    if (!outcome.found) {
        return;
    }
    const transport::SerialSettings& line = outcome.found->line;
    SerialChoice choice{.path = line.port_name,
                        .adapter = {},
                        .baud = line.baud,
                        .data_bits = line.data_bits,
                        .parity = static_cast<Parity>(line.parity),
                        .stop_bits = line.stop_bits,
                        .dialect = outcome.found->evidence.symptom == instrument::LineSymptom::kBusStream
                                       ? instrument::LineDialect::kBus
                                       : instrument::LineDialect::kExternal};
    const auto all = ports();
    const auto port = std::ranges::find(all, choice.path, &PortChoice::path);
    if (port != all.end()) {
        choice.adapter = port->adapter;
    }
    found_ = choice;
}

void ProbePresenter::useFound() {
    if (found_) {
        connection_.connectFound(*found_);
    }
}

}  // namespace pmts::app
