#pragma once

#include "pmts/core/virtual_clock.hpp"
#include "pmts/scheduler/scheduler.hpp"
#include "support/matchers.hpp"
#include "support/run_to_end.hpp"
#include "support/scripted_link.hpp"

#include <gtest/gtest.h>

namespace pmts::scheduler {

using namespace std::chrono_literals;
using core::ErrorKind;
using Answer = core::Result<protocol::Reply>;
using testing::ElementsAre;

/// A transaction that a test watches from outside.
struct Watched {
    std::shared_ptr<std::optional<Answer>> outcome = std::make_shared<std::optional<Answer>>();

    [[nodiscard]] bool done() const { return outcome->has_value(); }
    [[nodiscard]] const Answer& answer() const { return outcome->value(); }
};

inline core::Task<void> watch(core::Task<Answer> task, std::shared_ptr<std::optional<Answer>> outcome) {
    *outcome = co_await task;
}

class LineTest : public testing::Test {
protected:
    Watched start(MicroInstruction instruction, std::stop_token stop = {}) {
        Watched watched;
        auto running = watch(line.execute(std::move(instruction), std::move(stop)), watched.outcome);
        return watched;
    }
    static MicroInstruction readLabel(int label) {
        return {.bytes = "RG," + std::to_string(label) + "\r",
                .time_limit = 2s,
                .accepts = [label](const protocol::Reply& reply) {
                    return reply.find(label) != nullptr || (reply.status && reply.items.empty());
                }};
    }
    static MicroInstruction command(std::string bytes, core::Duration limit = 2s) {
        return {.bytes = std::move(bytes), .time_limit = limit, .accepts = [](const protocol::Reply& reply) {
                    return reply.items.empty();
                }};
    }
    static MicroInstruction stopCommand() {
        auto stop = command("PG,3=0\r");
        stop.priority = Priority::kStop;
        stop.interrupts = true;
        return stop;
    }

    core::VirtualClock clock;
    core::VideoGate gate;
    test::ScriptedLink link{clock};
    Scheduler line{link, clock, gate};
};

}  // namespace pmts::scheduler
