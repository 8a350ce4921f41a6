#include "panel_port.hpp"

#include <algorithm>

namespace pmts::instrument {

PanelPort::PanelPort(scheduler::Arbiter& arbiter, core::Clock& clock, core::Duration first_retry,
                     core::Duration longest_retry)
    : arbiter_(arbiter), clock_(clock), first_retry_(first_retry), longest_retry_(longest_retry), pause_(first_retry) {}

PanelPort::~PanelPort() {
    on_changed = nullptr;
    close();
}

void PanelPort::use(MakeLink make_link) {
    const bool is_used = used_;
    close();
    make_link_ = std::move(make_link);
    if (is_used) {
        open();
    }
}

void PanelPort::open() {
    used_ = true;
    if (make_link_ && link_ == nullptr) {
        pause_ = first_retry_;
        tryToOpen();
    }
}

void PanelPort::close() {
    used_ = false;
    retry_timer_.cancel();
    arbiter_.setPanel(nullptr);
    if (link_ != nullptr) {
        link_->on_lost = nullptr;
        link_->close();
        link_.reset();
    }
    show(PanelPortState::kNone, {});
}

void PanelPort::tryToOpen() {
    link_ = make_link_();
    if (const auto opened = link_->open(); !opened) {
        retry(opened.error());
        return;
    }
    link_->on_lost = [this](const core::Error& error) {
        arbiter_.setPanel(nullptr);
        retry(error);
    };
    arbiter_.setPanel(link_.get());
    pause_ = first_retry_;
    show(PanelPortState::kOpen, {});
}

void PanelPort::retry(const core::Error& error) {
    show(PanelPortState::kMissing, error.sentence());
    retry_timer_ = clock_.callAfter(pause_, [this] { tryToOpen(); });
    pause_ = std::min(2 * pause_, longest_retry_);
}

void PanelPort::show(PanelPortState state, const QString& sentence) {
    const bool changed = state != state_ || sentence != sentence_;
    state_ = state;
    sentence_ = sentence;
    if (changed && on_changed) {
        on_changed();
    }
}

}  // namespace pmts::instrument
