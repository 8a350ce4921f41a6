#pragma once

#include "line_fixture.hpp"
#include "pmts/scheduler/arbiter.hpp"

namespace pmts::scheduler {

/// PMTS and a panel on one instrument: what the panel says and hears, what the instrument hears.
class ArbiterTest : public testing::Test {
protected:
    ArbiterTest() {
        line.setKeeper(&arbiter);
        arbiter.setPanel(&panel);
        arbiter.on_owner = [this](LineOwner owner, core::Duration at) { owners.emplace_back(owner, at); };
        arbiter.on_panel_turn = [this](const TransactionRecord& record) { turns.push_back(record); };
    }
    ~ArbiterTest() override { line.setKeeper(nullptr); }

    Watched ask(MicroInstruction instruction) {
        Watched watched;
        auto running = watch(line.execute(std::move(instruction)), watched.outcome);
        return watched;
    }
    static MicroInstruction read(int label) {
        return {.bytes = "RG," + std::to_string(label) + "\r",
                .time_limit = 2s,
                .accepts = [label](const protocol::Reply& reply) { return reply.find(label) != nullptr; }};
    }
    static MicroInstruction command(std::string bytes, core::Duration limit = 2s) {
        return {.bytes = std::move(bytes), .time_limit = limit, .accepts = [](const protocol::Reply& reply) {
                    return reply.items.empty();
                }};
    }
    void panelSays(const std::string& bytes) {
        panel.say(bytes);
        clock.advance(0ms);
    }
    void instrumentSays(const std::string& bytes) {
        instrument.say(bytes);
        clock.advance(0ms);
    }
    [[nodiscard]] std::string panelHeard() const { return joined(panel.written); }
    [[nodiscard]] std::string instrumentHeard() const { return joined(instrument.written); }
    static std::string joined(const std::vector<std::string>& parts) {
        std::string all;
        for (const auto& part : parts) {
            all += part;
        }
        return all;
    }

    core::VirtualClock clock;
    core::VideoGate gate;
    test::ScriptedLink instrument{clock};
    test::ScriptedLink panel{clock};
    Arbiter arbiter{instrument, clock};
    Scheduler line{arbiter, clock, gate};
    std::vector<std::pair<LineOwner, core::Duration>> owners;
    std::vector<TransactionRecord> turns;
};

}  // namespace pmts::scheduler
