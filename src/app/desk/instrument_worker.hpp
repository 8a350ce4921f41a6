#pragma once

#include "pmts/app/desk/instrument_desk.hpp"

#include <deque>
#include <stop_token>

namespace pmts::app {

/// What is done first on a port that was opened.
enum class FirstAct { kAsk, kSwitchOn };

/// The instrument thread's side of the desk: owns clock, connection and driver, runs the requests one after another.
/// Routines hold it by shared_ptr, so that one that is suspended when the desk goes still finds its own things.
class InstrumentDesk::Worker : public QObject, public std::enable_shared_from_this<Worker> {
public:
    Worker(InstrumentDesk& desk, core::VideoGate& gate, InstrumentWiring wiring);
    ~Worker() override;

    void connectTo(const SerialChoice& choice, FirstAct first);
    void offerAddress(const QString& path) { offered_address_ = path; }
    void disconnectInstrument();
    void stop();
    void cancel(Ticket ticket);
    void setControl(const ControlSettings& control);
    void setGuard(const targeting::PointingGuardSettings& settings) { guard_.setSettings(settings); }
    void cableHangsFree();
    void answerInstrument(bool yes);
    void setTargetTest(const instrument::TargetTest& test);
    /// Tells the desk how far a transfer is.
    [[nodiscard]] instrument::OnTransfer transferOf(Ticket ticket);
    /// The instrument waits for yes or no until the desk has answered.
    [[nodiscard]] core::Completion<bool> question(Ticket ticket);
    /// A move that the guard allows.
    static core::Task<core::Result<geometry::Pointing>> turn(std::shared_ptr<Worker> self, instrument::TotalStation& station,
                                                             geometry::Pointing target, core::Angle tolerance,
                                                             std::stop_token stop);
    static core::Task<core::Result<targeting::Recentred>> recentre(std::shared_ptr<Worker> self,
                                                                   instrument::TotalStation& station,
                                                                   RecentringOrder order, Ticket ticket,
                                                                   std::stop_token stop);
    static core::Task<core::Result<targeting::SweepOutcome>> sweep(std::shared_ptr<Worker> self,
                                                                   instrument::TotalStation& station, SweepOrder order,
                                                                   Ticket ticket, std::stop_token stop);
    static core::Task<core::Result<instrument::RoutineOutcome>> runRoutine(std::shared_ptr<Worker> self,
                                                                           protocol::TableRoutine routine,
                                                                           std::map<std::string, double> numbers,
                                                                           Ticket ticket, std::stop_token stop);
    /// Ends everything; `done` runs when the last routine has ended.
    void shutDown(std::function<void()> done);
    /// The desk goes away on this very thread: nothing is told any more, and what is quiet is closed at once.
    void leaveDesk();

    /// Queues a routine; `start` makes its task when its turn has come.
    template <class Start, class Report>
    void enqueue(Ticket ticket, Start start, Report report) {
        waiting_.push_back({ticket, [ticket, start = std::move(start), report = std::move(report)](Worker& worker) {
                                worker.perform(worker.shared_from_this(), ticket, start, report);
                            }});
        startNext();
    }

private:
    struct Request {
        Ticket ticket = 0;
        std::function<void(Worker&)> start;
    };

    template <class Words>
    void say(Words words) {
        if (desk_) {
            QMetaObject::invokeMethod(desk_, [desk = desk_, words = std::move(words)] { words(*desk); }, Qt::QueuedConnection);
        }
    }

    /// Memory, labels and compensator are of the external interface: those routines take its driver.
    template <class Start>
    static constexpr bool kOnAnyLine = std::is_invocable_v<Start&, instrument::TotalStation&, std::stop_token>;

    template <class Start>
    auto begin(Start& start) {
        if constexpr (kOnAnyLine<Start>) {
            return start(connection_->speaker(), stop_.get_token());
        } else {
            return start(connection_->station(), stop_.get_token());
        }
    }

    template <class Start, class Report>
    static core::Task<void> perform(std::shared_ptr<Worker> self, Ticket ticket, Start start, Report report) {
        if (!kOnAnyLine<Start> && self->connection_->bus() != nullptr) {
            self->running_ = 0;
            self->fail(ticket, notOnTheBus());
            self->startNext();
            co_return;
        }
        auto routine = self->begin(start);
        auto outcome = co_await routine;
        self->running_ = 0;
        if (!outcome) {
            self->fail(ticket, outcome.error());
        } else if constexpr (std::is_void_v<typename decltype(outcome)::value_type>) {
            self->say([ticket, report](InstrumentDesk& desk) { report(desk, ticket); });
        } else {
            self->say([ticket, report, value = *outcome](InstrumentDesk& desk) { report(desk, ticket, value); });
        }
        self->startNext();
    }

    static core::Task<void> open(std::shared_ptr<Worker> self, QString address);

    [[nodiscard]] static core::Error notOnTheBus();
    void startNext();
    void stopRunning();
    void fail(Ticket ticket, const core::Error& error);
    void failWaiting(const core::Error& error);
    void wireConnection();
    void takeReading(const geometry::Pointing& pointing, core::Duration at);
    void showWound();
    void watchSun(const geometry::Pointing& pointing, core::Duration at);
    [[nodiscard]] static targeting::FrameAfter framesOf(const std::shared_ptr<Worker>& self,
                                                        const std::shared_ptr<FrameFeed>& frames);
    [[nodiscard]] core::Result<void> mayTurn(const geometry::Pointing& target) const;
    void showState(instrument::ConnectionState state, const QString& sentence);
    void endIfQuiet();
    [[nodiscard]] std::unique_ptr<transport::ByteLink> makeLink(const QString& address) const;
    [[nodiscard]] std::unique_ptr<transport::ByteLink> linkTo(const SerialChoice& choice) const;
    void usePanel();
    [[nodiscard]] std::unique_ptr<transport::ByteLink> makePanelLink() const;
    [[nodiscard]] std::vector<transport::PortInfo> portsFor(const SerialChoice& choice) const;
    [[nodiscard]] std::vector<QString> addressesNow() const;

    InstrumentDesk* desk_;
    core::VideoGate& gate_;
    InstrumentWiring wiring_;
    std::unique_ptr<core::Clock> own_clock_;
    core::Clock& clock_;
    targeting::PointingGuard guard_;
    std::optional<geometry::Pointing> last_reading_;
    core::Angle told_wound_;
    core::Duration sun_looked_at_{-1};
    bool is_in_sun_ = false;
    std::unique_ptr<instrument::InstrumentConnection> connection_;
    SerialChoice choice_;
    ControlSettings control_;
    instrument::TargetTest target_test_;
    std::optional<core::Completion<bool>> question_;
    QString offered_address_;
    std::deque<Request> waiting_;
    Ticket running_ = 0;
    bool opening_ = false;
    std::optional<std::pair<SerialChoice, FirstAct>> next_choice_;  ///< asked for while the last one was still being opened
    std::stop_source stop_;
    std::function<void()> on_quiet_;
};

template <class Start, class Report>
Ticket InstrumentDesk::request(Start start, Report report) {
    const Ticket ticket = ++last_ticket_;
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get(), ticket, start, report] { worker->enqueue(ticket, start, report); },
        Qt::QueuedConnection);
    return ticket;
}

}  // namespace pmts::app
