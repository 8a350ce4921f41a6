// Acknowledged records per second: one durable transaction (WAL, synchronous FULL) each, as in the field.
#include "pmts/job/job.hpp"
#include "support/figure.hpp"

#include <QTemporaryDir>

#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace {

using pmts::bench::Wanted;

constexpr int kBatches = 9;
constexpr int kRecordsPerBatch = 200;

pmts::survey::Point shot(int number) {
    pmts::survey::Point point;
    point.id = QStringLiteral("A%1").arg(number);
    point.code = QStringLiteral("WALL");
    point.station_name = QStringLiteral("100");
    point.observation.pointing = {.ha = pmts::core::Angle::fromGon(177.5612),
                                  .va = pmts::core::Angle::fromGon(96.1684)};
    point.observation.slope_distance_m = 25.0 + number * 0.01;
    point.observation.edm_mode = QStringLiteral("STD");
    point.observation.utc = QDateTime(QDate(2015, 7, 9), QTime(10, 20, 30), Qt::UTC).addSecs(number);
    point.observation.raw_reply = QStringLiteral("0\r\n7=177.5612\r\n8=96.1684\r\n9=25.123\r\n>");
    point.coordinates = {.e_m = 2000.0 + number % 97,
                         .n_m = 1000.0 + number % 89,
                         .h_m = 50.0,
                         .sigma_e_m = 0.003,
                         .sigma_n_m = 0.002,
                         .sigma_h_m = 0.001};
    return point;
}

double secondsFor(pmts::job::Job& job, int first) {
    const auto begin = std::chrono::steady_clock::now();
    for (int number = first; number < first + kRecordsPerBatch; ++number) {
        if (const auto outcome = job.record(shot(number)); !outcome) {
            std::fprintf(stderr, "%s\n", qPrintable(outcome.error().sentence()));
            std::exit(1);
        }
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

int main() {
    const QTemporaryDir folder;
    const auto job = pmts::job::Job::create(folder.filePath(QStringLiteral("bench.gpkg")));
    if (!job) {
        std::fprintf(stderr, "%s\n", qPrintable(job.error().sentence()));
        return 1;
    }
    std::vector<double> per_second;
    for (int batch = 0; batch < kBatches; ++batch) {
        per_second.push_back(kRecordsPerBatch / secondsFor(**job, batch * kRecordsPerBatch));
    }
    pmts::bench::figure("job.records_per_second", pmts::bench::median(per_second), "1/s", Wanted::kAtLeast,
                        200);
    return 0;
}
