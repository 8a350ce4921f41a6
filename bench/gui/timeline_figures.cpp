#include "timeline_figures.hpp"

#include "pmts/core/virtual_clock.hpp"
#include "support/figure.hpp"
#include "line/timeline_page.hpp"
#include "line/timeline_view.hpp"

#include <QCoreApplication>
#include <QPixmap>

#include <ctime>

namespace {

using namespace std::chrono_literals;
using pmts::core::Duration;

/// Of 100 ms: readings of HA and VA twenty a second, pictures thirty a second, the line taken and given back each time.
class Traffic {
public:
    Traffic(pmts::core::VirtualClock& clock, pmts::app::Timeline& timeline) : clock_(clock), timeline_(timeline) {}

    void goOn() {
        for (const char* const label : {"7", "8"}) {
            exchange(label);
            clock_.advance(50ms);
        }
        for (int i = 0; i < 3; ++i) {
            timeline_.addFrame(clock_.now() - 100ms + 33ms * i, ++pictures_, 0);
        }
    }

private:
    void exchange(const std::string& label) {
        pmts::scheduler::TransactionRecord record;
        record.sent = "RG," + label + "\r";
        record.received = label + "=10.2345\r\n";
        record.queued_at = clock_.now();
        record.sent_at = clock_.now() + 1ms;
        record.finished_at = clock_.now() + 40ms;
        own(pmts::scheduler::LineOwner::kComputer, record.sent_at);
        own(pmts::scheduler::LineOwner::kIdle, record.finished_at);
        timeline_.addTransaction(record);
    }
    void own(pmts::scheduler::LineOwner owner, Duration since) {
        pmts::instrument::ControlStatus status;
        status.owner = owner;
        status.owner_since = since;
        timeline_.addControl(status);
    }

    pmts::core::VirtualClock& clock_;
    pmts::app::Timeline& timeline_;
    std::uint64_t pictures_ = 0;
};

/// Of this thread: the simulator's work and a busy machine are no part of it.
double cpuSeconds() {
    timespec used{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

double medianPaintMs(pmts::gui::TimelineView& view) {
    std::vector<double> took_ms;
    QPixmap target(view.size());
    for (int round = 0; round < 20; ++round) {
        const double from_s = cpuSeconds();
        view.render(&target);
        took_ms.push_back(1e3 * (cpuSeconds() - from_s));
    }
    return pmts::bench::median(took_ms);
}

/// Processor time for a minute of traffic, as a share of that minute.
double shareOfAMinute(Traffic& traffic, pmts::gui::TimelinePage& page) {
    const double before_s = cpuSeconds();
    for (int step = 0; step < 600; ++step) {
        traffic.goOn();
        page.refresh();
        QCoreApplication::processEvents();
    }
    return 100.0 * (cpuSeconds() - before_s) / 60.0;
}

}  // namespace

void timelineFigures() {
    pmts::core::VirtualClock clock;
    pmts::app::Timeline timeline(clock);
    pmts::gui::TimelinePage page(timeline);
    auto& view = *page.findChild<pmts::gui::TimelineView*>();
    Traffic traffic(clock, timeline);
    page.resize(1280, 720);
    page.show();
    for (int i = 0; i < 100; ++i) {
        traffic.goOn();
    }
    QCoreApplication::processEvents();

    using pmts::bench::figure;
    using pmts::bench::Wanted;
    figure("gui.timeline_cpu_share", shareOfAMinute(traffic, page), "%", Wanted::kAtMost, 5.0);
    while (timeline.events().size() < pmts::app::Timeline::kCapacity - 1) {
        traffic.goOn();
    }
    figure("gui.timeline_paint_10_s", medianPaintMs(view), "ms", Wanted::kAtMost, 8.0);
    view.showAll();
    figure("gui.timeline_paint_20000_events", medianPaintMs(view), "ms", Wanted::kAtMost, 50.0);
    view.setFollowing(true);
    figure("gui.timeline_cpu_share_when_full", shareOfAMinute(traffic, page), "%", Wanted::kAtMost, 5.0);
}
