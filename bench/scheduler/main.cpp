#include "control_figures.hpp"
#include "pmts/scheduler/scheduler.hpp"
#include "pmts/transport/serial_link.hpp"
#include "pty_end.hpp"
#include "support/figure.hpp"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QSerialPort>
#include <QThread>
#include <QTimer>

#include <atomic>
#include <cstdlib>
#include <poll.h>
#include <semaphore>
#include <thread>
#include <unistd.h>

// What the scheduler adds to a round trip over a real pty, while the main thread is blocked for 200 ms at a
// time as a busy window would be. The other end answers as fast as it can; the raw QSerialPort round trip of
// the same run is taken off.
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kRoundTrips = 20000;
constexpr int kStops = 300;

double milliseconds(Clock::duration span) { return std::chrono::duration<double, std::milli>(span).count(); }

/// The far end: answers each command at its CR, with a label or with the bare block end; `WS` never. Notes
/// when a stop arrives.
class Responder {
public:
    Responder() : thread_([this](std::stop_token stop) { run(stop); }) {}
    ~Responder() {
        thread_.request_stop();
        thread_.join();
    }
    Responder(const Responder&) = delete;
    Responder& operator=(const Responder&) = delete;

    [[nodiscard]] const std::string& name() const { return end_.name(); }
    [[nodiscard]] Clock::time_point stopArrivedAt() {
        stop_arrived_.acquire();
        return stop_at_;
    }

private:
    void run(const std::stop_token& stop) {
        std::string line;
        while (!stop.stop_requested()) {
            pollfd ready{.fd = end_.fd(), .events = POLLIN, .revents = 0};
            char byte = 0;
            if (::poll(&ready, 1, 50) <= 0 || ::read(end_.fd(), &byte, 1) != 1) {
                continue;
            }
            if (byte != '\r') {
                line += byte;
                continue;
            }
            answer(std::exchange(line, {}));
        }
    }

    void answer(const std::string& line) {
        if (line.starts_with("PG,3")) {
            stop_at_ = Clock::now();
            end_.say("190\r\n>>");
            stop_arrived_.release();
        } else if (!line.starts_with("WS")) {
            end_.say("7=177.5612\r\n>");
        }
    }

    pmts::bench::PtyEnd end_;
    Clock::time_point stop_at_;
    std::counting_semaphore<> stop_arrived_{0};
    std::jthread thread_;
};

struct Line {
    explicit Line(const std::string& port_name)
        : link({.port_name = QString::fromStdString(port_name)}), scheduler(link, clock, gate) {
        if (const auto opened = link.open(); !opened) {
            std::fprintf(stderr, "%s\n", opened.error().sentence().toUtf8().constData());
            std::exit(1);
        }
    }
    pmts::core::SystemClock clock;
    pmts::core::VideoGate gate;
    pmts::transport::SerialLink link;
    pmts::scheduler::Scheduler scheduler;
};

/// One raw round trip, one through the scheduler, in turn: whatever else loads the machine loads both alike.
class RoundTrips {
public:
    RoundTrips(const std::string& raw_port, Line& line)
        : port_(QString::fromStdString(raw_port)), line_(line) {
        if (!port_.open(QIODevice::ReadWrite)) {
            std::fprintf(stderr, "the port cannot be opened\n");
            std::exit(1);
        }
        QObject::connect(&port_, &QSerialPort::readyRead, &loop_, [this] {
            if (port_.readAll().endsWith('>')) {
                raw_ms.push_back(milliseconds(Clock::now() - began_at_));
                askScheduled();
            }
        });
    }
    void run() {
        askRaw();
        loop_.exec();
    }

    std::vector<double> raw_ms;
    std::vector<double> scheduled_ms;  ///< from execute() to the resumed coroutine

private:
    void askRaw() {
        began_at_ = Clock::now();
        port_.write("RG,7\r");
    }
    QCoro::Task<void> askScheduled() {
        pmts::scheduler::MicroInstruction read;
        read.bytes = "RG,7\r";
        const auto began_at = Clock::now();
        auto asking = line_.scheduler.execute(read);
        const auto reply = co_await asking;
        scheduled_ms.push_back(milliseconds(Clock::now() - began_at));
        if (!reply) {
            std::fprintf(stderr, "%s\n", reply.error().sentence().toUtf8().constData());
            std::exit(1);
        }
        if (scheduled_ms.size() < kRoundTrips) {
            askRaw();
        } else {
            loop_.quit();
        }
    }

    QSerialPort port_;
    Line& line_;
    QEventLoop loop_;
    Clock::time_point began_at_;
};

/// A stop in the middle of a motion that does not answer, posted from the main thread as the Esc key does.
std::vector<double> stopsToWire(Responder& responder, Line& line, QObject& instrument_side) {
    std::vector<double> spans_ms;
    for (int i = 0; i < kStops; ++i) {
        std::binary_semaphore ended{0};
        QMetaObject::invokeMethod(
            &instrument_side,
            [&] {
                pmts::scheduler::MicroInstruction motion;
                motion.bytes = "WS=PH02V02\r";
                [](auto task, std::binary_semaphore& done) -> QCoro::Task<void> {
                    [[maybe_unused]] const auto outcome = co_await task;
                    done.release();
                }(line.scheduler.execute(motion), ended);
            },
            Qt::BlockingQueuedConnection);
        const auto pressed_at = Clock::now();
        QMetaObject::invokeMethod(
            &instrument_side,
            [&] {
                pmts::scheduler::MicroInstruction stop;
                stop.bytes = "PG,3=0\r";
                stop.priority = pmts::scheduler::Priority::kStop;
                stop.interrupts = true;
                [[maybe_unused]] const auto stopping = line.scheduler.execute(stop);
            },
            Qt::QueuedConnection);
        spans_ms.push_back(milliseconds(responder.stopArrivedAt() - pressed_at));
        ended.acquire();
    }
    return spans_ms;
}

/// Difference of the p99, in the median of batches: a burst of foreign load within the run spoils one batch,
/// not the figure.
double addedAtP99(const std::vector<double>& raw_ms, const std::vector<double>& scheduled_ms) {
    constexpr std::ptrdiff_t kBatch = 1000;
    std::vector<double> added_ms;
    for (std::ptrdiff_t at = 0; at + kBatch <= static_cast<std::ptrdiff_t>(kRoundTrips); at += kBatch) {
        const std::vector<double> raw(raw_ms.begin() + at, raw_ms.begin() + at + kBatch);
        const std::vector<double> scheduled(scheduled_ms.begin() + at, scheduled_ms.begin() + at + kBatch);
        added_ms.push_back(pmts::bench::quantile(scheduled, 0.99) - pmts::bench::quantile(raw, 0.99));
    }
    return pmts::bench::median(added_ms);
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication app(argc, argv);
    Responder responder;
    QThread thread;
    QObject instrument_side;
    instrument_side.moveToThread(&thread);
    thread.start(QThread::TimeCriticalPriority);

    Responder raw_responder;
    std::vector<double> raw_ms;
    std::vector<double> scheduled_ms;
    std::atomic<bool> done = false;
    std::unique_ptr<Line> line;
    QMetaObject::invokeMethod(&instrument_side, [&] {
        line = std::make_unique<Line>(responder.name());
        RoundTrips trips(raw_responder.name(), *line);
        trips.run();
        raw_ms = trips.raw_ms;
        scheduled_ms = trips.scheduled_ms;
        done = true;
    });
    while (!done) {  // the busy window: blocked for 200 ms, then one turn of its loop
        QThread::msleep(200);
        QCoreApplication::processEvents();
    }
    const auto stops_ms = stopsToWire(responder, *line, instrument_side);
    QMetaObject::invokeMethod(
        &instrument_side, [&] { line.reset(); }, Qt::BlockingQueuedConnection);
    thread.quit();
    thread.wait();

    using pmts::bench::figure, pmts::bench::quantile, pmts::bench::Wanted;
    const double added_ms = std::max(0.0, addedAtP99(raw_ms, scheduled_ms));
    figure("scheduler.added_latency_p99", added_ms, "ms", Wanted::kAtMost, 1.0);
    figure("scheduler.stop_to_wire_p99", quantile(stops_ms, 0.99), "ms", Wanted::kAtMost, 50.0);
    pmts::bench::measurePassThrough();
    pmts::bench::measureArbitration();
    return 0;
}
