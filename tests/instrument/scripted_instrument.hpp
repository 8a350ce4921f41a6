#pragma once

#include "pmts/core/virtual_clock.hpp"
#include "pmts/instrument/geodimeter_driver.hpp"
#include "pmts/protocol/labels.hpp"
#include "support/matchers.hpp"
#include "support/run_to_end.hpp"
#include "support/scripted_link.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <map>

namespace pmts::instrument {

using namespace std::chrono_literals;
using core::Angle;
using core::ErrorKind;
using testing::ElementsAre;

/// A small instrument behind a ScriptedLink: right answers by itself, any other answer when a test says so.
class ScriptedInstrument {
public:
    ScriptedInstrument(test::ScriptedLink& line, core::VirtualClock& time) : link(line), clock(time) {
        link.respond = [this](const std::string& command) { return answer(command); };
    }

    std::optional<std::string> answer(const std::string& command) {
        const std::string line = command.substr(0, command.find('\r'));
        for (auto& [start, replies] : next) {
            if (line.starts_with(start) && !replies.empty()) {
                const auto reply = replies.front();
                replies.pop_front();
                return reply;
            }
        }
        if (silent) {
            return std::nullopt;
        }
        if (line == "RG") {
            return measurement();
        }
        if (line == "RGT") {
            return signal ? block("301") : block("300");
        }
        if (line.starts_with("RG,")) {
            return label(std::stoi(line.substr(3)));
        }
        if (line.starts_with("WG,")) {
            const auto equals = line.find('=');
            labels[std::stoi(line.substr(3))] = line.substr(equals + 1);
            return block("");
        }
        if (line.starts_with("WS=")) {
            link.say(turn(line), motion_time);
            return std::nullopt;
        }
        if (line == "TG") {
            triggered_at = clock.now();
            is_read = false;
            return block("");
        }
        if (line.starts_with("PG,3=")) {
            mode = line.substr(5);
            triggered_at.reset();
            return block("");
        }
        return block("30");
    }

    std::string measurement() {
        const std::string angles = "7=" + angle(ha) + "\r\n8=" + angle(va) + "\r\n";
        if (!triggered_at || !echo || clock.now() < *triggered_at + measuring_time) {
            return "0\r\n" + angles + end;
        }
        if (is_read) {
            return block("3");
        }
        is_read = true;
        return "0\r\n" + angles + "9=" + labels[9] + "\r\n" + end;
    }

    std::string label(int number) {
        if (number == 7) {
            return block("7=" + angle(ha));
        }
        if (number == 8) {
            return block("8=" + angle(va));
        }
        return labels.contains(number) ? block(std::to_string(number) + "=" + labels[number]) : block("20");
    }

    std::string turn(const std::string& line) {
        if (line.find('H') != std::string::npos) {
            ha = std::stod(labels[27]) + ha_residual_cc * 1e-4;
        }
        if (line.find('V') != std::string::npos) {
            va = std::stod(labels[26]) + va_residual_cc * 1e-4;
        }
        return block("");
    }

    [[nodiscard]] std::string block(const std::string& line) const {
        return (line.empty() ? "" : line + "\r\n") + end;
    }
    static std::string angle(double gon) { return QString::number(gon, 'f', 4).toStdString(); }

    test::ScriptedLink& link;
    core::VirtualClock& clock;
    std::map<std::string, std::deque<std::optional<std::string>>>
        next;  ///< answers to commands that begin so
    std::map<int, std::string> labels{{9, "23.418"}, {23, "1111"}, {55, "620123"},
                                      {79, "62"},    {30, "5.3"},  {5, "100"}};
    double ha = 10.0, va = 100.0;
    double ha_residual_cc = 0.0, va_residual_cc = 0.0;
    core::Duration motion_time = 2s, measuring_time = 5s;
    std::optional<core::Duration> triggered_at;
    bool is_read = false, echo = true, signal = true, silent = false;
    std::string mode = "0";
    std::string end = ">";
};

class DriverTest : public testing::Test {
protected:
    static GeodimeterSettings profile() { return {}; }

    template <class T>
    core::Result<T> run(core::Task<core::Result<T>> task, core::Duration limit = 120s) {
        auto outcome = test::runToEnd(std::move(task), clock, limit);
        if (!outcome) {
            return core::fail(ErrorKind::kTimeOut, QStringLiteral("the driver never answered"));
        }
        return *outcome;
    }
    void connect() {
        ASSERT_TRUE(run(driver.connectTo({})).has_value());
        link.written.clear();
    }
    static geometry::Pointing pointing(double ha_gon, double va_gon) {
        return {.ha = Angle::fromGon(ha_gon), .va = Angle::fromGon(va_gon)};
    }
    [[nodiscard]] long sent(const std::string& command) const {
        return std::count(link.written.begin(), link.written.end(), command + "\r");
    }

    core::VirtualClock clock;
    core::VideoGate gate;
    test::ScriptedLink link{clock};
    ScriptedInstrument station{link, clock};
    scheduler::Scheduler line{link, clock, gate};
    GeodimeterDriver driver{line, clock, profile()};
};

}  // namespace pmts::instrument
