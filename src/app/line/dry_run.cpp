#include "pmts/app/line/dry_run.hpp"

#include "pmts/core/virtual_clock.hpp"
#include "pmts/instrument/bus_driver.hpp"
#include "pmts/simulator/bus_station.hpp"
#include "pmts/transport/memory_link.hpp"

#include <optional>

namespace pmts::app {
namespace {

using Outcome = core::Result<instrument::RoutineOutcome>;

constexpr core::Duration kLongest = std::chrono::hours(24);

/// What a base would answer if the table were right.
std::map<std::string, std::string> expectedReplies(const DryRunOrder& order) {
    std::map<std::string, std::string> replies;
    for (const auto& step : order.routine.steps) {
        if (auto bytes = protocol::bytesOf(step, order.numbers)) {
            bytes->pop_back();
            std::string reply = step.expect.empty() ? std::string() : step.expect.front();
            if (reply.ends_with('*')) {
                reply.pop_back();
            }
            replies.emplace(*bytes, reply);
        }
    }
    return replies;
}

simulator::BusStationSettings baseFor(const DryRunOrder& order) {
    simulator::BusStationSettings settings;
    if (order.believes_table) {
        settings.more_replies = expectedReplies(order);
    }
    return settings;
}

core::Task<void> keep(core::Task<Outcome> task, std::shared_ptr<std::optional<Outcome>> outcome) {
    *outcome = co_await task;
}

}  // namespace

Outcome dryRun(const DryRunOrder& order, const std::atomic<bool>& cancelled,
               const std::function<void(const instrument::StepOutcome&)>& on_step) {
    core::VirtualClock clock;
    core::VideoGate gate;
    const auto pointing = std::make_shared<simulator::TruePointing>();
    auto wire = transport::makeMemoryPair(clock);
    simulator::BusStation base(baseFor(order), pointing, clock);
    wire.second->on_received = [&base](std::string_view bytes) { base.receive(bytes); };
    base.send = [&wire](std::string_view bytes) { wire.second->write(bytes); };
    PMTS_TRY(wire.second->open());
    PMTS_TRY(wire.first->open());
    scheduler::Scheduler line(*wire.first, clock, gate);
    instrument::BusDriver driver(line, clock);
    driver.on_step = on_step;
    std::stop_source stop;
    const auto outcome = std::make_shared<std::optional<Outcome>>();
    [[maybe_unused]] const auto running = keep(driver.run(order.routine, order.numbers, stop.get_token()), outcome);
    core::deliverQueuedEvents();
    while (!outcome->has_value() && clock.advanceToNextTimer(kLongest)) {
        if (cancelled) {
            stop.request_stop();
        }
        core::deliverQueuedEvents();
    }
    return outcome->has_value() ? **outcome : Outcome(core::cancelled());
}

}  // namespace pmts::app
