#include "station_impl.hpp"

namespace pmts::simulator {

core::Duration Station::Impl::scaled(double seconds) const {
    return std::chrono::duration_cast<core::Duration>(
        std::chrono::duration<double>(seconds / settings_.time_scale));
}

core::Result<void> Station::Impl::injectFault(const QString& text) {
    if (text.trimmed() == u"none") {
        faults_.clear();
        watchIdle();
        return {};
    }
    const auto fault = parseFault(text);
    if (!fault) {
        return tl::unexpected(fault.error());
    }
    if (findFaultKind(fault->name)->lasts == FaultKind::Lasts::kAtOnce) {
        applyAtOnce(*fault);
    } else {
        faults_.add(*fault);
        applyLasting(*fault);
    }
    return {};
}

bool Station::Impl::struckBy(const char* lasting_fault) const {
    const bool strikes = faults_.has(lasting_fault);
    if (strikes) {
        faults_.strike(QString::fromLatin1(lasting_fault));
    }
    return strikes;
}

void Station::Impl::applyLasting(const Fault& fault) {
    if (fault.name == u"auto_power_off") {
        watchIdle();
    } else if (fault.name == u"info_23_loop") {
        repeatInfo23();
    }
}

void Station::Impl::applyAtOnce(const Fault& fault) {
    const core::Duration span = scaled(fault.value);
    if (fault.name == u"unplug") {
        unplug(span);
    } else if (fault.name == u"initialising") {
        deaf_ = true;
        deaf_timer_ = clock_.callAfter(span, [this] { deaf_ = false; });
    } else if (fault.name == u"panel_task") {
        panel_busy_ = true;
        panel_timer_ = clock_.callAfter(span, [this] { panel_busy_ = false; });
    } else if (fault.name == u"reg_key") {
        faults_.strike(fault.name);
        pressRegKey();
    } else if (fault.name == u"memory_lost") {
        switchOn(false);
        pending_reading_status_ = info::kMemoryLost;
    } else if (fault.name == u"power_off") {
        faults_.strike(fault.name);
        switchOff();
        if (fault.value > 0.0) {
            power_timer_ = clock_.callAfter(span, [this] { switchOn(true); });
        }
    }
}

/// Bytes on the way are lost; the instrument itself goes on with what it was told.
void Station::Impl::unplug(core::Duration span) {
    unplugged_ = true;
    faults_.strike(QStringLiteral("unplug"));
    heard_.clear();
    line_.clear();
    unplug_timer_ = clock_.callAfter(span, [this] { unplugged_ = false; });
    if (outside_.on_unplug) {
        outside_.on_unplug(span);
    }
}

void Station::Impl::repeatInfo23() {
    const auto every_s = faults_.value("info_23_loop");
    if (!every_s || *every_s <= 0.0) {
        info_23_timer_.cancel();
        return;
    }
    info_23_timer_ = clock_.callAfter(scaled(*every_s), [this] {
        (void)struckBy("info_23_loop");
        emitBlock({statusText(info::kTimeOut), {}});
        repeatInfo23();
    });
}

bool Station::Impl::refusedByFault(const std::string& line) {
    if (const auto bits = faults_.take("line_error", line)) {
        answer({"21." + std::to_string(static_cast<int>(*bits)), {}});
        return true;
    }
    if (panel_busy_) {
        faults_.strike(QStringLiteral("panel_task"));
        answerStatus(info::kBusy);
        return true;
    }
    const auto forced = faults_.take("info", line);
    if (!forced) {
        return false;
    }
    const int code = static_cast<int>(*forced);
    const bool after_motion =
        code >= info::kHorizontalResidual && code <= info::kBothResiduals && line.starts_with("WS=");
    if (after_motion) {
        forced_motion_status_ = code;
        return false;
    }
    answerStatus(code);
    return true;
}

std::string Station::Impl::withFaults(std::string bytes) {
    const bool ends = end_mark_ != 0 && !bytes.empty();
    if (faults_.take("missing_eot", current_) && ends) {
        bytes.pop_back();
    }
    if (faults_.take("garble", current_)) {
        bytes = faults_.garbled(bytes);
    }
    if (faults_.take("half_block", current_)) {
        bytes.resize(bytes.size() / 2);
    }
    if (faults_.take("stray_end_marks", current_)) {
        bytes.insert(0, 2, static_cast<char>(ends ? end_mark_ : '>'));
    }
    if (faults_.take("twice", current_)) {
        bytes += bytes;
    }
    return bytes;
}

}  // namespace pmts::simulator
