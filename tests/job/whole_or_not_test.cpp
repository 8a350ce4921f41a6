#include "job_support.hpp"
#include "other_process.hpp"

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

/// Moves station and points to the east, 1 m a round, until it is killed.
OtherProcess mover(const QString& path) {
    return OtherProcess([path](const OtherProcess::Say& say) {
        const auto job = Job::open(path);
        auto points = *(*job)->points();
        auto station = *(*job)->station();
        for (int round = 0;; ++round) {
            station.e_m += 1;
            for (auto& point : points) {
                point.coordinates.e_m += 1;
            }
            if (!(*job)->setStation(station, points)) {
                return;
            }
            say(round);
        }
    });
}

TEST_F(WholeOrNotTest, AKillWhileTheStationMovesLeavesStationAndPointsTogether) {
    {
        const auto job = created();
        ASSERT_TRUE(job->setStation({.e_m = shotPoint(0).coordinates.e_m}, recorded(*job, 40)).has_value());
    }
    for (int round = 0; round < 6; ++round) {
        OtherProcess process = mover(path);
        for (int i = 0; i < 2 + round; ++i) {
            ASSERT_TRUE(process.next().has_value());
        }
        ::usleep(static_cast<useconds_t>(700 * round));  // another place in the round each time
        process.kill();

        const auto job = reopened();
        const double station_e_m = job->station()->e_m;
        const auto points = *job->points();
        for (std::size_t i = 0; i < points.size(); ++i) {
            ASSERT_DOUBLE_EQ(points[i].coordinates.e_m, station_e_m + static_cast<double>(i));
        }
    }
}

}  // namespace
}  // namespace pmts::job
