#include "event_loop.hpp"
#include "figures.hpp"
#include "pmts/app/field/points_model.hpp"
#include "support/figure.hpp"

#include <QTemporaryDir>

#include <algorithm>

namespace pmts::bench {

namespace {

constexpr int kRecords = 1000;
constexpr int kInFlight = 4;  ///< as a scan has them: the next shots are made while one is written

survey::Point shot(int number) {
    survey::Point point;
    point.id = QString::number(number);
    point.code = QStringLiteral("WALL");
    point.station_name = QStringLiteral("100");
    point.observation.pointing = {.ha = core::Angle::fromGon(number * 0.3), .va = core::Angle::fromGon(100)};
    point.observation.slope_distance_m = 15.0;
    point.observation.edm_mode = QStringLiteral("TRK");
    point.observation.utc = QDateTime::currentDateTimeUtc();
    point.observation.raw_reply = QStringLiteral("0\r\n7=177.5612\r\n8=96.1684\r\n9=15.000\r\n");
    point.coordinates = {.e_m = 1000, .n_m = 1015, .h_m = 100, .sigma_e_m = 0.003, .sigma_n_m = 0.003, .sigma_h_m = 0.003};
    return point;
}

/// Watches the event loop of this thread: the longest time between two turns of a timer that wants to run each millisecond.
class StallWatch : public QObject {
public:
    StallWatch() {
        timer_.setTimerType(Qt::PreciseTimer);
        connect(&timer_, &QTimer::timeout, this, [this] {
            longest_ms_ = std::max(longest_ms_, static_cast<double>(since_.nsecsElapsed()) * 1e-6);
            since_.restart();
        });
        since_.start();
        timer_.start(1);
    }
    [[nodiscard]] double longestMs() const { return longest_ms_; }

private:
    QTimer timer_;
    QElapsedTimer since_;
    double longest_ms_ = 0.0;
};

}  // namespace

void measureRecords() {
    const QTemporaryDir folder;
    QUndoStack undo;
    app::Preferences preferences{QString()};
    app::MessageCentre messages;
    app::JobDesk job;
    app::PointsModel points(job, preferences, messages, undo);
    job.create(folder.filePath(QStringLiteral("bench.gpkg")));
    runUntil([&job] { return job.isOpen(); });

    int asked = 0;
    QObject::connect(&job, &app::JobDesk::recorded, &points, [&](app::Ticket, const survey::Point& point) {
        points.addRecorded(point);
        if (asked < kRecords) {
            job.record(shot(++asked));
        }
    });
    const StallWatch watch;
    QElapsedTimer passed;
    passed.start();
    while (asked < kInFlight) {
        job.record(shot(++asked));
    }
    runUntil([&points] { return points.rowCount() == kRecords; });
    const double took_s = static_cast<double>(passed.nsecsElapsed()) * 1e-9;
    figure("app.records_per_second", kRecords / took_s, "1/s", Wanted::kAtLeast, 200.0);
    figure("app.gui_block_max", watch.longestMs(), "ms", Wanted::kAtMost, 16.0);
}

}  // namespace pmts::bench
