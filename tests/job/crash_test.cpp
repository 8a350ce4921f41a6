#include "job_support.hpp"
#include "other_process.hpp"

#include <QDir>

namespace pmts::job {
namespace {

using core::ErrorKind;

/// Records points without end and tells each number only after the job acknowledged it.
OtherProcess recorder(const QString& path, int from) {
    return OtherProcess([path, from](const OtherProcess::Say& say) {
        const auto job = Job::open(path);
        for (int number = from; job && (*job)->record(shotPoint(number)); ++number) {
            say(number);
        }
    });
}

TEST_F(JobTest, NothingAcknowledgedIsMissingAfterKillMinusNine) {
    createWith(0);
    int last_acknowledged = -1;
    for (int round = 0; round < 10; ++round) {
        OtherProcess writer = recorder(path, last_acknowledged + 1);
        for (int i = 0; i < 5 + 13 * round; ++i) {
            last_acknowledged = writer.next().value_or(-1);
            ASSERT_GE(last_acknowledged, 0);
        }
        writer.kill();
        while (const auto late = writer.next()) {  // acknowledged between our last look and the kill
            last_acknowledged = *late;
        }

        const auto job = Job::open(path);
        ASSERT_TRUE(job.has_value()) << job.error().sentence().toStdString()
                                     << job.error().detail.toStdString();
        const auto points = *(*job)->points();
        ASSERT_GE(points.size(), static_cast<std::size_t>(last_acknowledged) + 1);
        ASSERT_LE(points.size(), static_cast<std::size_t>(last_acknowledged) + 2)
            << "more than the one under way";
        for (std::size_t i = 0; i < points.size(); ++i) {
            ASSERT_EQ(points[i].id, shotPoint(static_cast<int>(i)).id);
            ASSERT_EQ(points[i].coordinates.e_m, shotPoint(static_cast<int>(i)).coordinates.e_m);
        }
        last_acknowledged = static_cast<int>(points.size()) - 1;
    }
}

TEST_F(JobTest, CountExtentAndIndexAreTrueAgainAfterAKill) {
    createWith(0);
    int last = -1;
    {
        OtherProcess writer = recorder(path, 0);
        for (int i = 0; i < 40; ++i) {
            last = writer.next().value_or(-1);
        }
    }
    ASSERT_GE(last, 39);
    const auto count = reopened()->points()->size();

    const OtherProgram qgis(path);
    EXPECT_EQ(qgis.value("SELECT feature_count FROM gpkg_ogr_contents WHERE table_name = 'points'"),
              QString::number(count));
    EXPECT_EQ(qgis.value("SELECT max_x FROM gpkg_contents WHERE table_name = 'points'").toDouble(),
              shotPoint(static_cast<int>(count) - 1).coordinates.e_m);
    EXPECT_EQ(qgis.value("SELECT COUNT(*) FROM rtree_points_geom"), QString::number(count));
    EXPECT_EQ(qgis.value("PRAGMA integrity_check"), QStringLiteral("ok"));
}

TEST_F(JobTest, TheLockDiesWithItsProcess) {
    createWith(0);
    OtherProcess writer = recorder(path, 0);
    ASSERT_TRUE(writer.next().has_value());
    EXPECT_THAT(Job::open(path),
                test::FailedWith(ErrorKind::kFile));  // another process, not only another object
    writer.kill();
    EXPECT_TRUE(Job::open(path).has_value());
}

TEST_F(JobTest, AnotherProcessReadsWhileWeWrite) {
    const auto job = created();
    ASSERT_TRUE(job->record(shotPoint(0)).has_value());
    OtherProcess reader([path = path](const OtherProcess::Say& say) {
        for (;;) {
            const OtherProgram qgis(path);
            OGRLayer& points = qgis.layer("points");
            OGREnvelope extent;
            const bool whole = points.GetExtent(&extent, TRUE) == OGRERR_NONE && extent.MaxX >= 2000.5;
            say(whole ? static_cast<int>(points.GetFeatureCount()) : -1);
        }
    });
    int seen = 0;
    for (int number = 1; number < 2000 && seen < 50; ++number) {
        ASSERT_TRUE(job->record(shotPoint(number)).has_value());
        const int recorded = number + 1;
        const int count = reader.next().value_or(-1);
        ASSERT_GE(count, seen) << "the reader lost points it had seen";
        ASSERT_LE(count, recorded);
        seen = count;
    }
    EXPECT_GE(seen, 50);
    ASSERT_EQ(static_cast<int>(OtherProgram(path).layer("points").GetFeatureCount()),
              static_cast<int>(job->points()->size()));
}

TEST_F(JobTest, AFullDiskIsAnErrorAndWhatWasRecordedStays) {
    createWith(0);
    int acknowledged = 0;
    std::optional<int> refused, again;
    {
        OtherProcess writer([path = path](const OtherProcess::Say& say) {
            const auto job = Job::open(path);
            limitFileSize(1000000);
            for (int number = 0;; ++number) {
                if (const auto outcome = (*job)->record(shotPoint(number)); !outcome) {
                    const bool told = outcome.error().kind == ErrorKind::kFile &&
                                      !outcome.error().remedy.isEmpty() &&
                                      outcome.error().happened.contains(QStringLiteral("full"));
                    say(told ? -1 : -2);
                    limitFileSize(RLIM_INFINITY);  // somebody makes room
                    say((*job)->record(shotPoint(number)) ? -3 : -4);
                    return;
                }
                say(number);
            }
        });
        while (const auto number = writer.next()) {
            if (*number >= 0) {
                acknowledged = *number + 1;
            } else {
                (refused ? again : refused) = number;
            }
        }
    }
    EXPECT_GT(acknowledged, 10);
    EXPECT_EQ(refused, -1);
    EXPECT_EQ(again, -3);
    const auto points = *reopened()->points();
    ASSERT_EQ(points.size(), static_cast<std::size_t>(acknowledged) + 1);
    EXPECT_EQ(points.back().id, shotPoint(acknowledged).id);
}

TEST_F(JobTest, AFullDiskLeavesNoHalfMadeJob) {
    OtherProcess creator([path = path](const OtherProcess::Say& say) {
        limitFileSize(20000);
        const auto job = Job::create(path);
        say(!job && job.error().kind == ErrorKind::kFile ? 1 : 0);
    });
    EXPECT_EQ(creator.next(), 1);
    creator.kill();
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
    EXPECT_TRUE(Job::create(path).has_value());
}

}  // namespace
}  // namespace pmts::job
