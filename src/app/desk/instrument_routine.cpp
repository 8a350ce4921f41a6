#include "instrument_worker.hpp"

namespace pmts::app {

core::Task<core::Result<instrument::RoutineOutcome>> InstrumentDesk::Worker::runRoutine(std::shared_ptr<Worker> self,
                                                                                        protocol::TableRoutine routine,
                                                                                        std::map<std::string, double> numbers,
                                                                                        Ticket ticket, std::stop_token stop) {
    instrument::BusDriver* const bus = self->connection_->bus();
    if (bus == nullptr) {
        co_return core::fail(core::ErrorKind::kUnsupported, tr("The connected line is the external interface."),
                             tr("Routines of an instruction table run on the bus under the panel."));
    }
    bus->on_begin = [self, ticket](std::size_t index) {
        self->say([ticket, index](InstrumentDesk& desk) { Q_EMIT desk.routineStepBegan(ticket, index); });
    };
    bus->on_step = [self, ticket](const instrument::StepOutcome& step) {
        self->say([ticket, step](InstrumentDesk& desk) { Q_EMIT desk.routineStepped(ticket, step); });
    };
    auto running = bus->run(std::move(routine), std::move(numbers), std::move(stop));
    auto outcome = co_await running;
    bus->on_begin = nullptr;
    bus->on_step = nullptr;
    co_return outcome;
}

}  // namespace pmts::app
