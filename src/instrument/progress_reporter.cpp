#include "progress_reporter.hpp"

#include <algorithm>

namespace pmts::instrument {
namespace {

constexpr core::Duration kInterval = std::chrono::milliseconds(100);

double fractionOf(core::Duration elapsed, std::optional<core::Duration> usual) {
    if (!usual || *usual <= core::Duration::zero()) {
        return 0.0;
    }
    return std::min(1.0, std::chrono::duration<double>(elapsed) / std::chrono::duration<double>(*usual));
}

}  // namespace

void ProgressReporter::begin(Activity activity, std::optional<core::Duration> usual) {
    activity_ = activity;
    usual_ = usual;
    began_at_ = clock_.now();
    tick();
}

void ProgressReporter::end() {
    timer_.cancel();
    activity_ = Activity::kIdle;
    if (report) {
        report({});
    }
}

void ProgressReporter::tick() {
    if (report) {
        const auto elapsed = clock_.now() - began_at_;
        report({.activity = activity_,
                .fraction = fractionOf(elapsed, usual_),
                .elapsed = elapsed,
                .usual = usual_});
    }
    timer_ = clock_.callAfter(kInterval, [this] { tick(); });
}

}  // namespace pmts::instrument
