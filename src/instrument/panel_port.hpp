#pragma once

#include "pmts/instrument/control_settings.hpp"
#include "pmts/scheduler/arbiter.hpp"

#include <functional>
#include <memory>

namespace pmts::instrument {

/// The second port, where the maker's panel is: opened, given to the arbiter, opened again when it went away.
class PanelPort {
public:
    using MakeLink = std::function<std::unique_ptr<transport::ByteLink>()>;

    /// Both outlive the port.
    PanelPort(scheduler::Arbiter& arbiter, core::Clock& clock, core::Duration first_retry, core::Duration longest_retry);
    ~PanelPort();
    PanelPort(const PanelPort&) = delete;
    PanelPort& operator=(const PanelPort&) = delete;

    /// Empty: no panel. In place of an earlier one, opened as that was.
    void use(MakeLink make_link);
    void open();   ///< what use() says, now and later, until close()
    void close();
    [[nodiscard]] PanelPortState state() const { return state_; }
    [[nodiscard]] const QString& sentence() const { return sentence_; }

    std::function<void()> on_changed;

private:
    void tryToOpen();
    void retry(const core::Error& error);
    void show(PanelPortState state, const QString& sentence);

    scheduler::Arbiter& arbiter_;
    core::Clock& clock_;
    core::Duration first_retry_, longest_retry_, pause_;
    MakeLink make_link_;
    bool used_ = false;
    std::unique_ptr<transport::ByteLink> link_;
    PanelPortState state_ = PanelPortState::kNone;
    QString sentence_;
    core::Timer retry_timer_;
};

}  // namespace pmts::instrument
