#include "app/field_fixture.hpp"

#include "pmts/app/desk/job_presenter.hpp"

#include <QFile>
#include <QSignalSpy>

namespace pmts::app {
namespace {

class JobPresenterTest : public FieldTest {
protected:
    [[nodiscard]] QString inFolder(const char* name) const { return folder.filePath(QLatin1String(name)); }

    JobPresenter job{job_desk, preferences, messages};
};

TEST_F(JobPresenterTest, CreatedJobIsOpenAndRemembered) {
    job.createJob(inFolder("a.gpkg"));
    ASSERT_TRUE(until([this] { return job.isOpen(); }));
    EXPECT_EQ(job.name(), QStringLiteral("a"));
    EXPECT_EQ(preferences.settings().last_job, inFolder("a.gpkg"));
    EXPECT_EQ(job.recentJobs(), QStringList{inFolder("a.gpkg")});
}

TEST_F(JobPresenterTest, ForeignFileIsRefusedWithASentence) {
    QFile file(inFolder("notes.gpkg"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("not a job");
    file.close();
    QSignalSpy failed(&job_desk, &JobDesk::openFailed);
    job.openJob(inFolder("notes.gpkg"));
    ASSERT_TRUE(until([&] { return !failed.empty(); }));
    ASSERT_EQ(messages.bars().size(), 1U);
    EXPECT_EQ(messages.bars().front().action, MessageAction::kOpenJob);
    EXPECT_FALSE(messages.bars().front().remedy.isEmpty());
    EXPECT_FALSE(job.isOpen());
}

TEST_F(JobPresenterTest, RequestsWithoutAJobFailWithARemedy) {
    QSignalSpy failed(&job_desk, &JobDesk::requestFailed);
    job.exportTo(inFolder("points.csv"));
    ASSERT_TRUE(until([&] { return !failed.empty(); }));
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("No job is open."));
}

TEST_F(JobPresenterTest, ExportWritesAFileByItsEnding) {
    job.createJob(inFolder("a.gpkg"));
    QSignalSpy exported(&job, &JobPresenter::exported);
    for (const char* name : {"points.csv", "points.geojson", "points.dxf"}) {
        job.exportTo(inFolder(name));
    }
    ASSERT_TRUE(until([&] { return exported.size() == 3; })) << newestBar(messages).toStdString();
    EXPECT_TRUE(QFile::exists(inFolder("points.dxf")));
}

TEST_F(JobPresenterTest, ExportToAnUnknownEndingSaysWhichAreKnown) {
    job.createJob(inFolder("a.gpkg"));
    job.exportTo(inFolder("points.xyz"));
    ASSERT_TRUE(until([this] { return !messages.bars().empty(); }));
    EXPECT_EQ(messages.bars().front().topic, QStringLiteral("export"));
}

TEST_F(JobPresenterTest, AcknowledgedPointsAreInTheFileInOrder) {
    JobDesk own_thread;
    QSignalSpy opened(&own_thread, &JobDesk::opened);
    QList<QString> acknowledged;
    QObject::connect(&own_thread, &JobDesk::recorded, [&](Ticket, const survey::Point& point) { acknowledged.append(point.id); });
    own_thread.create(inFolder("many.gpkg"));
    ASSERT_TRUE(opened.wait(30000));
    QSignalSpy recorded(&own_thread, &JobDesk::recorded);
    for (int i = 1; i <= 50; ++i) {
        survey::Point point;
        point.id = QString::number(i);
        point.observation.slope_distance_m = i;
        own_thread.record(point);
    }
    while (acknowledged.size() < 50 && recorded.wait(30000)) {
    }
    ASSERT_EQ(acknowledged.size(), 50);
    EXPECT_EQ(acknowledged.first(), QStringLiteral("1"));
    EXPECT_EQ(acknowledged.last(), QStringLiteral("50"));
}

TEST_F(JobPresenterTest, EverythingQueuedIsWrittenBeforeTheDeskEnds) {
    {
        JobDesk own_thread;
        own_thread.create(inFolder("queued.gpkg"));
        for (int i = 0; i < 20; ++i) {
            survey::Point point;
            point.id = QString::number(i);
            point.observation.slope_distance_m = 5.0;
            own_thread.record(point);
        }
    }
    EXPECT_EQ((*job::Job::open(inFolder("queued.gpkg")))->points()->size(), 20U);
}

}  // namespace
}  // namespace pmts::app
