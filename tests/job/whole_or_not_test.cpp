#include "job_support.hpp"
#include "other_process.hpp"

#include <QFileInfo>

namespace pmts::job {
namespace {

/// A change of many rows is one transaction: whatever ends it in the middle, all of it happened or nothing.
class WholeOrNotTest : public JobTest {
protected:
    std::vector<survey::Point> recorded(Job& job, int count) {
        std::vector<survey::Point> points;
        for (int i = 0; i < count; ++i) {
            points.push_back(*job.record(shotPoint(i)));
        }
        return points;
    }
    /// From now on the file refuses to change this point.
    void refuseChangesOf(qint64 row_id) {
        const QString sql = QStringLiteral(
                                "CREATE TRIGGER stop BEFORE UPDATE ON points WHEN OLD.fid = %1 "
                                "BEGIN SELECT RAISE(ABORT, 'stopped in the middle'); END")
                                .arg(row_id);
        ASSERT_EQ(OtherProgram(path, GDAL_OF_UPDATE).refusal(sql.toUtf8().constData()), QString());
    }
};

TEST_F(WholeOrNotTest, OneRefusedPointLeavesAllNamesAsTheyWere) {
    const auto job = created();
    auto points = recorded(*job, 10);
    refuseChangesOf(points[6].row_id);
    for (auto& point : points) {
        point.code = QStringLiteral("ROOF");
        point.struck_out = true;
    }

    EXPECT_THAT(job->update(points), test::FailedWith(core::ErrorKind::kFile));

    const auto kept = *job->points();
    ASSERT_EQ(kept.size(), points.size());
    for (const auto& point : kept) {
        EXPECT_EQ(point.code, QStringLiteral("WALL"));
        EXPECT_FALSE(point.struck_out);
    }
    points.erase(points.begin() + 6);
    EXPECT_TRUE(job->update(points).has_value()) << "the others can still be changed";
}

TEST_F(WholeOrNotTest, AnUnknownPointAmongManyChangesNone) {
    const auto job = created();
    auto points = recorded(*job, 2);
    points[0].code = QStringLiteral("ROOF");
    points.push_back(shotPoint(3));
    EXPECT_THAT(job->update(points), test::FailedWith(core::ErrorKind::kBadInput));
    EXPECT_EQ(job->points()->front().code, QStringLiteral("WALL"));
}

TEST_F(WholeOrNotTest, AStationWhosePointsCannotMoveIsNotSetEither) {
    const auto job = created();
    auto points = recorded(*job, 10);
    refuseChangesOf(points[6].row_id);
    for (auto& point : points) {
        point.coordinates.e_m += 500;
    }

    EXPECT_THAT(job->setStation({.name = QStringLiteral("100"), .e_m = 1500}, points),
                test::FailedWith(core::ErrorKind::kFile));

    EXPECT_TRUE(job->stations()->empty());
    EXPECT_EQ(job->points()->front().coordinates.e_m, shotPoint(0).coordinates.e_m);
    ASSERT_TRUE(job->record(shotPoint(11)).has_value());
    EXPECT_EQ(OtherProgram(path).value("SELECT COUNT(station_row) FROM observations"), QStringLiteral("0"));
}

/// Moves station and points to the east, 1 m a round. In the third it is killed when this share of the round's bytes
/// is in the write-ahead log.
OtherProcess mover(const QString& path, double share) {
    return OtherProcess([path, share](const OtherProcess::Say& say) {
        const auto job = Job::open(path);
        auto points = *(*job)->points();
        auto station = *(*job)->station();
        const auto written = [&path] { return static_cast<double>(QFileInfo(path + QStringLiteral("-wal")).size()); };
        double before = written();
        for (int round = 1;; ++round) {
            station.e_m += 1;
            for (auto& point : points) {
                point.coordinates.e_m += 1;
            }
            if (!(*job)->setStation(station, points)) {
                return;
            }
            say(round);
            const double now = written();
            if (round == 2) {
                dieAtFileSize(static_cast<rlim_t>(now + share * (now - before)));
            }
            before = now;
        }
    });
}

TEST_F(WholeOrNotTest, AKillWhileTheStationMovesLeavesStationAndPointsTogether) {
    {
        const auto job = created();
        ASSERT_TRUE(job->setStation({.e_m = shotPoint(0).coordinates.e_m}, recorded(*job, 40)).has_value());
    }
    constexpr int kKills = 12;
    for (int kill = 0; kill < kKills; ++kill) {
        OtherProcess process = mover(path, (kill + 0.5) / kKills);
        EXPECT_EQ(process.next(), 1);
        EXPECT_EQ(process.next(), 2);
        ASSERT_EQ(process.endedBySignal(), SIGXFSZ);
        ASSERT_EQ(process.next(), std::nullopt) << "the third round was not over";

        const auto job = reopened();
        const double station_e_m = job->station()->e_m;
        ASSERT_DOUBLE_EQ(station_e_m, shotPoint(0).coordinates.e_m + 2 * (kill + 1));
        const auto points = *job->points();
        ASSERT_EQ(points.size(), 40U);
        for (std::size_t i = 0; i < points.size(); ++i) {
            ASSERT_DOUBLE_EQ(points[i].coordinates.e_m, station_e_m + static_cast<double>(i));
        }
    }
}

}  // namespace
}  // namespace pmts::job
