#include "pmts/routines/instrument.hpp"

#include "pmts/instrument/bus_driver.hpp"
#include "pmts/instrument/geodimeter_driver.hpp"
#include "pmts/protocol/command.hpp"

#include <algorithm>
#include <utility>

namespace pmts::routines {
namespace {

using core::ErrorKind;
using core::Result;
using core::Task;
using geometry::Pointing;

constexpr std::size_t kLongestInstruction = 80;

/// The command letters of file transfers: they talk on after their first block.
bool isTransfer(std::string_view instruction) { return instruction.starts_with('L') || instruction.starts_with('O'); }

Result<void> checkInstruction(std::string_view instruction) {
    PMTS_TRY(protocol::checkDenyList(instruction));
    const bool plain = std::ranges::all_of(instruction, [](char c) { return c > ' ' && c < 0x7f; });
    if (instruction.empty() || instruction.size() > kLongestInstruction || !plain) {
        return core::fail(ErrorKind::kBadInput, QObject::tr("This is not one instruction."),
                          QObject::tr("Write it as the manual does, without blanks and line ends: RG,7"));
    }
    if (isTransfer(instruction)) {
        return core::fail(ErrorKind::kUnsupported, QObject::tr("A file transfer is more than one instruction."),
                          QObject::tr("Use the page for the instrument's memory."));
    }
    return {};
}

Result<void> checkTable(const InstrumentSettings& settings) {
    if (settings.dialect == Dialect::kBus && !settings.instructions.problems.empty()) {
        const protocol::TableProblem& first = settings.instructions.problems.front();
        return core::fail(ErrorKind::kBadInput, QObject::tr("The instruction table is wrong in line %1.").arg(first.line),
                          first.sentence);
    }
    return {};
}

}  // namespace

/// Link, scheduler and driver, and who is told.
class Instrument::Impl : public std::enable_shared_from_this<Impl> {
public:
    using Self = std::shared_ptr<Impl>;

    Impl(std::unique_ptr<transport::ByteLink> the_link, core::Clock& the_clock, InstrumentSettings the_settings)
        : clock(the_clock), settings(std::move(the_settings)), link(std::move(the_link)), line(*link, clock, gate) {
        if (settings.dialect == Dialect::kBus) {
            bus = std::make_unique<instrument::BusDriver>(line, clock);
        } else {
            external = std::make_unique<instrument::GeodimeterDriver>(line, clock, settings.profile);
        }
    }

    void attach(Instrument& instrument) {
        owner = &instrument;
        station().on_pointing = [this](const Pointing& pointing, core::Duration at) { tell({pointing, std::nullopt, at}); };
        station().on_unsolicited = [this](const instrument::UnsolicitedBlock& block) {
            tell({std::nullopt, block, clock.now()});
        };
        station().on_lost = [this](const core::Error& error) { lost(error); };
        if (bus) {
            bus->on_silence = [this](const core::Error& error) { lost(error); };
        }
    }

    void lost(const core::Error& error) const {
        if (owner != nullptr && owner->on_lost) {
            owner->on_lost(error);
        }
    }

    void detach() {
        owner = nullptr;
        stopping.request_stop();
        station().on_pointing = nullptr;
        station().on_unsolicited = nullptr;
        station().on_lost = nullptr;
        if (bus) {
            bus->on_silence = nullptr;
        }
        line.reset(core::cancelled().value());
        link->close();
    }

    void tell(const PortData& data) const {
        if (owner != nullptr && owner->Timer1_Timer) {
            owner->Timer1_Timer(data);
        }
    }

    [[nodiscard]] instrument::TotalStation& station() {
        return external ? static_cast<instrument::TotalStation&>(*external) : *bus;
    }

    /// Runs one routine of the driver, alone; ends when the caller, stop() or the destructor wants it.
    template <class T, class Begin>
    static Task<Result<T>> alone(Self self, Begin begin, Stop asked) {
        if (!self->link->isOpen()) {
            co_return core::fail(ErrorKind::kNotConnected, QObject::tr("The instrument was not started."),
                                 QObject::tr("Call Start first."));
        }
        if (std::exchange(self->busy, true)) {
            co_return core::fail(ErrorKind::kRefused, QObject::tr("Another routine is running."),
                                 QObject::tr("Wait for its end, or stop it."));
        }
        self->stopping = {};
        const std::stop_callback on_stop(asked, [self] { self->stopping.request_stop(); });
        auto routine = begin(*self, self->stopping.get_token());
        auto outcome = co_await routine;
        self->busy = false;
        co_return outcome;
    }

    static Task<Result<instrument::Identity>> open(Self self, Stop asked) {
        PMTS_CO_TRY(checkTable(self->settings));
        if (!self->link->isOpen()) {
            PMTS_CO_TRY(self->link->open());
        }
        if (self->settings.switch_on && !self->busy) {
            auto switching = instrument::switchOn(*self->link, self->clock, *self->settings.switch_on, asked);
            PMTS_CO_TRY(co_await switching);
        }
        auto connecting = alone<instrument::Identity>(
            self, [](Impl& impl, Stop token) { return impl.station().connectTo(token); }, asked);
        co_return co_await connecting;
    }

    static Task<Result<protocol::Reply>> instruct(Self self, std::string instruction, Stop stop) {
        PMTS_CO_TRY(checkInstruction(instruction));
        const bool answers_as_other = self->external && self->external->noteForeignCommand(instruction);
        scheduler::MicroInstruction micro;
        micro.bytes = instruction + '\r';
        micro.separate = instruction.starts_with("RGV") || instruction.starts_with("RRV");
        micro.prompts = "@!";
        micro.expects_reply = instruction != "PV,21";
        auto sending = self->line.execute(std::move(micro), stop);
        auto reply = co_await sending;
        if (self->bus && reply) {
            self->bus->noteForeignTurn();
        }
        if (answers_as_other && reply) {
            auto asking = self->external->connectTo(stop);
            PMTS_CO_TRY(co_await asking);
        }
        co_return reply;
    }

    static Task<Result<void>> laser(Self self, std::string routine, Stop stop) {
        const protocol::TableRoutine* const found = self->bus ? self->settings.instructions.find(routine) : nullptr;
        if (found == nullptr) {
            co_return core::fail(ErrorKind::kUnsupported,
                                 self->bus ? QObject::tr("The instruction table has no routine %1.").arg(routine.c_str())
                                           : QObject::tr("The external interface has no command for the laser pointer."),
                                 self->bus ? QObject::tr("Add it to the table when its instructions are known.")
                                           : QObject::tr("Switch it at the control unit, or use the bus under it."));
        }
        auto running = self->bus->run(*found, {}, stop);
        PMTS_CO_TRY(co_await running);
        co_return Result<void>();
    }

    core::Clock& clock;
    InstrumentSettings settings;
    core::VideoGate gate;
    std::unique_ptr<transport::ByteLink> link;
    scheduler::Scheduler line;
    std::unique_ptr<instrument::GeodimeterDriver> external;
    std::unique_ptr<instrument::BusDriver> bus;
    Instrument* owner = nullptr;
    bool busy = false;
    std::stop_source stopping;
};

Instrument::Instrument(std::unique_ptr<transport::ByteLink> link, core::Clock& clock, InstrumentSettings settings)
    : impl_(std::make_shared<Impl>(std::move(link), clock, std::move(settings))) {
    impl_->attach(*this);
}

Instrument::~Instrument() { impl_->detach(); }

void Instrument::stop() {
    impl_->stopping.request_stop();
    impl_->station().stop();
}

Task<Result<instrument::Identity>> Instrument::Start(Stop stop) {
    return Impl::open(impl_, stop);
}

Task<Result<void>> Instrument::Set(int id, QString value, Stop stop) {
    return Impl::alone<void>(impl_, [id, value](Impl& impl, Stop token) { return impl.station().set(id, value, token); }, stop);
}

Task<Result<QString>> Instrument::Get(int id, Stop stop) {
    return Impl::alone<QString>(impl_, [id](Impl& impl, Stop token) { return impl.station().get(id, token); }, stop);
}

Task<Result<Pointing>> Instrument::movH(double ha_gon, Stop stop) {
    return Impl::alone<Pointing>(impl_, [ha = core::Angle::fromGon(ha_gon)](Impl& impl, Stop token) {
        return impl.station().turnHorizontal(ha, impl.settings.tolerance, token);
    }, stop);
}

Task<Result<Pointing>> Instrument::movV(double va_gon, Stop stop) {
    return Impl::alone<Pointing>(impl_, [va = core::Angle::fromGon(va_gon)](Impl& impl, Stop token) {
        return impl.station().turnVertical(va, impl.settings.tolerance, token);
    }, stop);
}

Task<Result<Pointing>> Instrument::movHV(double ha_gon, double va_gon, Stop stop) {
    const Pointing target{core::Angle::fromGon(ha_gon), core::Angle::fromGon(va_gon)};
    return Impl::alone<Pointing>(impl_, [target](Impl& impl, Stop token) {
        return impl.station().turnTo(target, impl.settings.tolerance, token);
    }, stop);
}

Task<Result<instrument::DistanceShot>> Instrument::Dist(Stop stop) {
    return Impl::alone<instrument::DistanceShot>(
        impl_, [](Impl& impl, Stop token) { return impl.station().measureDistance(token); }, stop);
}

Task<Result<void>> Instrument::laserON(Stop stop) {
    return Impl::alone<void>(impl_, [](Impl& impl, Stop token) { return Impl::laser(impl.shared_from_this(), "laser_on", token); },
                             stop);
}

Task<Result<void>> Instrument::laserOFF(Stop stop) {
    return Impl::alone<void>(impl_, [](Impl& impl, Stop token) { return Impl::laser(impl.shared_from_this(), "laser_off", token); },
                             stop);
}

Task<Result<protocol::Reply>> Instrument::prg1(std::string instruction, Stop stop) {
    return Impl::alone<protocol::Reply>(impl_, [instruction](Impl& impl, Stop token) {
        return Impl::instruct(impl.shared_from_this(), instruction, token);
    }, stop);
}

}  // namespace pmts::routines
