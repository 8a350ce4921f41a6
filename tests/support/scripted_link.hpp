#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/task.hpp"
#include "pmts/transport/byte_link.hpp"

#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pmts::test {

/// The far end of a line as a test wants it: keeps what was written, says what it is told to say.
class ScriptedLink final : public transport::ByteLink {
public:
    explicit ScriptedLink(core::Clock& clock) : clock_(clock) {}

    [[nodiscard]] core::Result<void> open() override {
        if (unavailable) {
            return core::fail(core::ErrorKind::kPortUnavailable, QStringLiteral("The port is not there."));
        }
        open_ = true;
        return {};
    }
    void close() override { open_ = false; }
    [[nodiscard]] bool isOpen() const override { return open_; }
    void write(std::string_view bytes) override {
        written.emplace_back(bytes);
        if (respond) {
            if (const auto reply = respond(written.back())) {
                say(*reply, reply_delay);
            }
        }
    }
    [[nodiscard]] core::Result<void> setControlLines(const transport::ControlLines& lines) override {
        control_lines.push_back(lines);
        return {};
    }
    [[nodiscard]] QString description() const override { return QStringLiteral("script"); }

    /// From the event loop, as the promise of ByteLink demands.
    void say(std::string bytes, core::Duration delay = core::Duration::zero()) {
        timers_.push_back(clock_.callAfter(delay, [this, bytes = std::move(bytes)] {
            if (open_ && on_received) {
                on_received(bytes);
            }
        }));
    }
    void unplug() {
        open_ = false;
        if (on_lost) {
            on_lost({.kind = core::ErrorKind::kLinkLost,
                     .happened = QStringLiteral("The cable was pulled."),
                     .remedy = {},
                     .info_code = std::nullopt,
                     .detail = {}});
        }
    }

    std::vector<std::string> written;
    std::vector<transport::ControlLines> control_lines;  ///< as they were set, one after the other
    /// Answer to each command; nullopt is silence.
    std::function<std::optional<std::string>(const std::string& command)> respond;
    core::Duration reply_delay = std::chrono::milliseconds(20);
    bool unavailable = false;

private:
    core::Clock& clock_;
    bool open_ = true;
    std::list<core::Timer> timers_;
};

}  // namespace pmts::test
