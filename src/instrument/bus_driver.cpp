#include "pmts/instrument/bus_driver.hpp"

#include "bus_stream.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace pmts::instrument {
namespace {

constexpr const char* kStreamHead = "A,";

core::Error noStream(const std::string& heard) {
    return {.kind = core::ErrorKind::kTimeOut,
            .happened = heard.empty() ? QObject::tr("Nothing comes from the bus.")
                                      : QObject::tr("What comes is not the angle stream of the bus."),
            .remedy = QObject::tr("Check that the base is on, the contacts, and that this line is the bus under the panel."),
            .info_code = std::nullopt,
            .detail = QString::fromLatin1(QByteArray::fromStdString(heard))};
}

struct BusReading {
    geometry::Pointing pointing;
    core::Duration at{0};
};

core::Error staleStream(core::Duration limit) {
    return {.kind = core::ErrorKind::kTimeOut,
            .happened = QObject::tr("The angle stream has been silent for more than %1 s.")
                            .arg(std::chrono::duration<double>(limit).count()),
            .remedy = QObject::tr("A routine may have suspended it (label 102), or the base is off."),
            .info_code = std::nullopt,
            .detail = {}};
}

core::Error notOnTheBus(const QString& what) {
    return {.kind = core::ErrorKind::kUnsupported,
            .happened = QObject::tr("%1 is not known on the bus under the panel.").arg(what),
            .remedy = QObject::tr("Use the external interface, or add a routine to the instruction table."),
            .info_code = std::nullopt,
            .detail = {}};
}

template <class T>
core::Task<core::Result<T>> refuse(QString what) {
    co_return tl::unexpected(notOnTheBus(what));
}

}  // namespace

class BusDriver::Impl : public std::enable_shared_from_this<Impl> {
public:
    using Self = std::shared_ptr<Impl>;

    Impl(scheduler::Scheduler& the_line, core::Clock& the_clock, BusSettings the_settings)
        : line(the_line), clock(the_clock), settings(the_settings), runner(the_line, the_clock) {}

    void attach(BusDriver& driver) {
        owner = &driver;
        line.setEndMark(protocol::kBusBlockEnd);
        line.setStreamHead(kStreamHead);
        line.on_stream = [this](std::string_view block) { takeStream(block); };
        line.on_unsolicited = [this](const protocol::Reply& reply) { takeUnasked(reply); };
        line.on_lost = [this](const core::Error& error) { lost(error); };
        runner.on_begin = [this](std::size_t index) {
            if (owner != nullptr && owner->on_begin) {
                owner->on_begin(index);
            }
        };
        runner.on_step = [this](const StepOutcome& step) {
            if (owner != nullptr && owner->on_step) {
                owner->on_step(step);
            }
        };
    }

    void detach() {
        owner = nullptr;
        silence.cancel();
        line.on_stream = nullptr;
        line.on_unsolicited = nullptr;
        line.on_lost = nullptr;
        stop.request_stop();
        endWaiting(core::cancelled());
    }

    void takeStream(std::string_view block) {
        heard = std::string(block);
        const auto pointing = stream.take(block, clock.now());
        if (!pointing) {
            return;
        }
        latest = BusReading{.pointing = *pointing, .at = clock.now()};
        watch();
        endWaiting(*pointing);
        if (owner != nullptr && owner->on_pointing) {
            owner->on_pointing(*pointing, latest->at);
        }
    }

    /// The next silence counts from now.
    void watch() {
        silence = clock.callAfter(settings.stream_limit, [this] { fellSilent(); });
    }

    void fellSilent() {
        if (!busy && owner != nullptr && owner->on_silence) {
            const auto tell = owner->on_silence;
            tell(staleStream(settings.stream_limit));
        }
    }

    void forget() {
        silence.cancel();
        latest.reset();
    }

    void takeUnasked(const protocol::Reply& reply) {
        heard = reply.raw;
        if (owner != nullptr && owner->on_unsolicited) {
            UnsolicitedBlock block;
            block.raw = QString::fromLatin1(QByteArray::fromStdString(reply.raw));
            owner->on_unsolicited(block);
        }
    }

    void lost(const core::Error& error) {
        silence.cancel();
        endWaiting(tl::unexpected(error));
        if (owner != nullptr && owner->on_lost) {
            owner->on_lost(error);
        }
    }

    void endWaiting(const core::Result<geometry::Pointing>& outcome) {
        for (const auto& waiting : std::exchange(waiting_, {})) {
            waiting.complete(outcome);
        }
    }

    [[nodiscard]] bool isStale() const { return !latest || clock.now() - latest->at > settings.stale_after; }

    /// The next reading that is believed.
    static core::Task<core::Result<geometry::Pointing>> next(Self self, core::Duration limit, std::stop_token stop) {
        const core::Completion<geometry::Pointing> arrival;
        self->waiting_.push_back(arrival);
        const auto too_long = self->clock.callAfter(limit, [arrival, self, limit] {
            arrival.complete(tl::unexpected(staleStream(std::max(limit, self->settings.stale_after))));
        });
        const std::stop_callback on_stop(stop, [arrival] { arrival.complete(core::cancelled()); });
        auto answer = arrival.answer();
        auto outcome = co_await answer;
        std::erase_if(self->waiting_, [](const auto& waiting) { return waiting.isComplete(); });
        co_return outcome;
    }

    static core::Task<core::Result<Identity>> connect(Self self, std::stop_token stop) {
        self->stream.forget();
        self->forget();
        self->heard.clear();
        auto waiting = next(self, self->settings.stream_limit, stop);
        const auto first = co_await waiting;
        if (!first && first.error().kind == core::ErrorKind::kTimeOut) {
            co_return tl::unexpected(noStream(self->heard));
        }
        PMTS_CO_TRY(first);
        Identity who;
        who.model = QObject::tr("Robotic base (bus)");
        who.end_mark = protocol::kBusBlockEnd;
        co_return who;
    }

    static core::Task<core::Result<geometry::Pointing>> read(Self self, std::stop_token stop) {
        if (!self->isStale()) {
            co_return self->latest->pointing;
        }
        auto waiting = next(self, self->settings.stale_after, stop);
        co_return co_await waiting;
    }

    static core::Task<core::Result<RoutineOutcome>> run(Self self, protocol::TableRoutine routine,
                                                        std::map<std::string, double> numbers, std::stop_token asked_to_stop) {
        if (std::exchange(self->busy, true)) {
            co_return core::fail(core::ErrorKind::kRefused, QObject::tr("Another routine is running on the bus."),
                                 QObject::tr("Wait for its end, or cancel it."));
        }
        self->stop = {};
        const std::stop_callback on_stop(asked_to_stop, [self] { self->stop.request_stop(); });
        auto running = self->runner.run(std::move(routine), std::move(numbers), self->stop.get_token());
        auto outcome = co_await running;
        self->busy = false;
        if (self->latest) {
            self->watch();
        }
        co_return outcome;
    }

    scheduler::Scheduler& line;
    core::Clock& clock;
    BusSettings settings;
    InstructionRunner runner;
    BusDriver* owner = nullptr;
    BusStream stream;
    std::optional<BusReading> latest;
    std::string heard;  ///< the last block of any kind, for the sentence of a failed connect
    core::Timer silence;  ///< from the last sign of life
    bool busy = false;
    std::stop_source stop;

private:
    std::vector<core::Completion<geometry::Pointing>> waiting_;
};

BusDriver::BusDriver(scheduler::Scheduler& line, core::Clock& clock, BusSettings settings)
    : impl_(std::make_shared<Impl>(line, clock, settings)) {
    impl_->attach(*this);
}

BusDriver::~BusDriver() { impl_->detach(); }

bool BusDriver::isBusy() const { return impl_->busy; }
void BusDriver::stop() { impl_->stop.request_stop(); }
void BusDriver::forget() { impl_->forget(); }

void BusDriver::noteForeignTurn() {
    if (impl_->latest) {
        impl_->watch();
    }
}

core::Task<core::Result<RoutineOutcome>> BusDriver::run(protocol::TableRoutine routine, std::map<std::string, double> numbers,
                                                        std::stop_token stop) {
    return Impl::run(impl_, std::move(routine), std::move(numbers), std::move(stop));
}

core::Task<core::Result<Identity>> BusDriver::connectTo(std::stop_token stop) { return Impl::connect(impl_, std::move(stop)); }

core::Task<core::Result<geometry::Pointing>> BusDriver::readPointing(std::stop_token stop) {
    return Impl::read(impl_, std::move(stop));
}

core::Task<core::Result<geometry::Pointing>> BusDriver::turnTo(geometry::Pointing /*target*/, core::Angle /*tolerance*/,
                                                               std::stop_token /*stop*/) {
    return refuse<geometry::Pointing>(QObject::tr("Turning"));
}

core::Task<core::Result<geometry::Pointing>> BusDriver::turnHorizontal(core::Angle /*ha*/, core::Angle /*tolerance*/,
                                                                       std::stop_token /*stop*/) {
    return refuse<geometry::Pointing>(QObject::tr("Turning"));
}

core::Task<core::Result<geometry::Pointing>> BusDriver::turnVertical(core::Angle /*va*/, core::Angle /*tolerance*/,
                                                                     std::stop_token /*stop*/) {
    return refuse<geometry::Pointing>(QObject::tr("Turning"));
}

core::Task<core::Result<DistanceShot>> BusDriver::measureDistance(std::stop_token /*stop*/) {
    return refuse<DistanceShot>(QObject::tr("Measuring a distance"));
}

core::Task<core::Result<void>> BusDriver::setMode(EdmMode /*mode*/) { return refuse<void>(QObject::tr("Choosing the mode")); }
EdmMode BusDriver::mode() const { return EdmMode::kStd; }

core::Task<core::Result<bool>> BusDriver::testSignal(std::stop_token /*stop*/) {
    return refuse<bool>(QObject::tr("The signal test"));
}

core::Task<core::Result<QString>> BusDriver::get(int label, std::stop_token /*stop*/) {
    return refuse<QString>(QObject::tr("Reading label %1").arg(label));
}

core::Task<core::Result<void>> BusDriver::set(int label, QString /*data*/, std::stop_token /*stop*/) {
    return refuse<void>(QObject::tr("Writing label %1").arg(label));
}

}  // namespace pmts::instrument
