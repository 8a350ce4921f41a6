#include "control_figures.hpp"

#include "pmts/core/prompt_thread.hpp"
#include "pmts/scheduler/arbiter.hpp"
#include "pmts/transport/serial_link.hpp"
#include "pty_end.hpp"
#include "support/figure.hpp"
#include "support/two_masters.hpp"

#include <QCoreApplication>
#include <QThread>

#include <array>
#include <atomic>
#include <poll.h>
#include <thread>
#include <vector>

namespace pmts::bench {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using scheduler::ControlMode;

constexpr unsigned kSeed = 20150610;
constexpr std::uint64_t kTransactions = 1'000'000;
constexpr int kExchanges = 10'000;
constexpr std::string_view kCommand = "RG,7\r";
constexpr std::string_view kReply = "7=177.5612\r\n>";

/// Whole runs: one on a good line, one with everything that may go wrong.
double mixedUp(const test::Troubles& troubles) {
    test::TwoMasters masters(kSeed, troubles);
    const bool ended = masters.run(kTransactions);
    const auto& counts = masters.counts();
    std::printf("# seed %u: %llu of PMTS, %llu of the panel, %llu unanswered; interleaved %llu, mangled %llu, lost %llu, "
                "misdirected %llu; longest wait %.0f ms of virtual time%s\n",
                kSeed, static_cast<unsigned long long>(counts.computer), static_cast<unsigned long long>(counts.panel),
                static_cast<unsigned long long>(counts.silent), static_cast<unsigned long long>(counts.interleaved),
                static_cast<unsigned long long>(counts.mangled), static_cast<unsigned long long>(counts.lost),
                static_cast<unsigned long long>(counts.misdirected),
                std::chrono::duration<double, std::milli>(counts.longest_wait).count(), ended ? "" : "; DEADLOCK");
    return static_cast<double>(counts.interleaved + counts.mangled + counts.lost + counts.misdirected) + (ended ? 0 : 1);
}

/// PMTS between the two ports, on a thread of its own.
class Between {
public:
    Between(const std::string& instrument, const std::string& panel, ControlMode mode) {
        context_.moveToThread(&thread_);
        thread_.start(QThread::TimeCriticalPriority);
        QMetaObject::invokeMethod(
            &context_,
            [&] {
                core::makeThisThreadPrompt();  // as the program's instrument thread
                parts_ = std::make_unique<Parts>(instrument, panel, mode);
            },
            Qt::BlockingQueuedConnection);
    }
    ~Between() {
        QMetaObject::invokeMethod(&context_, [this] { parts_.reset(); }, Qt::BlockingQueuedConnection);
        thread_.quit();
        thread_.wait();
    }
    Between(const Between&) = delete;
    Between& operator=(const Between&) = delete;

private:
    struct Parts {
        Parts(const std::string& instrument_name, const std::string& panel_name, ControlMode mode)
            : instrument({.port_name = QString::fromStdString(instrument_name)}),
              panel({.port_name = QString::fromStdString(panel_name)}),
              arbiter(instrument, clock),
              line(arbiter, clock, gate) {
            if (!instrument.open() || !panel.open()) {
                std::fprintf(stderr, "the ports cannot be opened\n");
                std::exit(1);
            }
            line.setKeeper(&arbiter);
            arbiter.setPanel(&panel);
            arbiter.setMode(mode);
        }
        ~Parts() {
            line.setKeeper(nullptr);
            arbiter.setPanel(nullptr);
        }

        core::SystemClock clock;
        core::VideoGate gate;
        transport::SerialLink instrument, panel;
        scheduler::Arbiter arbiter;
        scheduler::Scheduler line;
    };

    QThread thread_;
    QObject context_;
    std::unique_ptr<Parts> parts_;
};

/// From the first byte written at one end to the last one read at the other.
double passageMs(const PtyEnd& from, const PtyEnd& to, std::string_view text) {
    const auto began_at = Clock::now();
    from.say(text);
    std::string got;
    while (got.size() < text.size()) {
        pollfd ready{.fd = to.fd(), .events = POLLIN, .revents = 0};
        std::array<char, 64> bytes{};
        const auto size = ::poll(&ready, 1, 5000) > 0 ? ::read(to.fd(), bytes.data(), bytes.size()) : 0;
        if (size <= 0) {
            std::fprintf(stderr, "nothing came through\n");
            std::exit(1);
        }
        got.append(bytes.data(), static_cast<std::size_t>(size));
    }
    if (got != text) {
        std::fprintf(stderr, "the bytes were changed on their way\n");
        std::exit(1);
    }
    return std::chrono::duration<double, std::milli>(Clock::now() - began_at).count();
}

/// A program that does nothing but pass bytes on: what being between costs on this machine at this moment.
class BareRelay {
public:
    BareRelay() : thread_([this](const std::stop_token& stop) { run(stop); }) {}
    ~BareRelay() {
        thread_.request_stop();
        thread_.join();
    }
    BareRelay(const BareRelay&) = delete;
    BareRelay& operator=(const BareRelay&) = delete;

    const PtyEnd instrument, panel;

private:
    static int openSlave(const PtyEnd& end) { return ::open(end.name().c_str(), O_RDWR | O_NOCTTY); }

    void run(const std::stop_token& stop) const {
        core::makeThisThreadPrompt();
        std::array<pollfd, 2> ends{{{openSlave(panel), POLLIN, 0}, {openSlave(instrument), POLLIN, 0}}};
        std::array<char, 64> bytes{};
        while (!stop.stop_requested()) {
            (void)::poll(ends.data(), ends.size(), 50);
            for (std::size_t from = 0; from < ends.size(); ++from) {
                const auto size = (ends[from].revents & POLLIN) != 0 ? ::read(ends[from].fd, bytes.data(), bytes.size()) : 0;
                if (size > 0 && ::write(ends[1 - from].fd, bytes.data(), static_cast<std::size_t>(size)) != size) {
                    std::perror("write");
                }
            }
        }
        ::close(ends[0].fd);
        ::close(ends[1].fd);
    }

    std::jthread thread_;
};

struct Passages {
    std::vector<double> ours_ms, bare_ms;  ///< in turn: what else loads the machine loads both alike
    bool prompt = false;                   ///< the system let the threads run before others
};

/// Both directions of each exchange.
Passages passages(ControlMode mode) {
    const PtyEnd instrument, panel;
    const Between between(instrument.name(), panel.name(), mode);
    const BareRelay bare;
    Passages taken;
    std::atomic<bool> done = false;
    std::jthread both_ends([&] {
        taken.prompt = core::makeThisThreadPrompt();  // a panel and an instrument do not wait for our processor
        for (int i = 0; i < kExchanges; ++i) {
            taken.ours_ms.push_back(passageMs(panel, instrument, kCommand));
            taken.ours_ms.push_back(passageMs(instrument, panel, kReply));
            taken.bare_ms.push_back(passageMs(bare.panel, bare.instrument, kCommand));
            taken.bare_ms.push_back(passageMs(bare.instrument, bare.panel, kReply));
        }
        done = true;
    });
    while (!done) {  // the busy window: blocked for 200 ms, then one turn of its loop
        QThread::msleep(200);
        QCoreApplication::processEvents();
    }
    both_ends.join();
    return taken;
}

/// The p99 in the median of batches: a burst of foreign load spoils one batch, not the figure.
double p99(const std::vector<double>& sample_ms) {
    constexpr std::ptrdiff_t kBatch = 1000;
    std::vector<double> batches;
    for (auto at = sample_ms.begin(); at + kBatch <= sample_ms.end(); at += kBatch) {
        batches.push_back(quantile({at, at + kBatch}, 0.99));
    }
    return median(batches);
}

void passThrough(const char* name, ControlMode mode) {
    const auto taken = passages(mode);
    std::printf("# %s: median %.3f ms, p99 %.3f ms; a bare relay: median %.3f ms, p99 %.3f ms%s\n", name,
                median(taken.ours_ms), p99(taken.ours_ms), median(taken.bare_ms), p99(taken.bare_ms),
                taken.prompt ? "" : "; no real-time limit (ulimit -r): every other program may come first");
    figure(std::string("scheduler.") + name + "_p99", p99(taken.ours_ms), "ms", Wanted::kAtMost, 2.0);
}

}  // namespace

void measureArbitration() {
    figure("scheduler.arbitration_mixed_up", mixedUp({}), "transactions", Wanted::kAtMost, 0);
    figure("scheduler.arbitration_mixed_up_with_faults",
           mixedUp({.silent = 0.005, .unplugged = 0.01, .unsolicited = 0.05}), "transactions", Wanted::kAtMost, 0);
}

void measurePassThrough() {
    passThrough("pass_through_shared", ControlMode::kShared);
    passThrough("pass_through_panel_mode", ControlMode::kPanel);
}

}  // namespace pmts::bench
