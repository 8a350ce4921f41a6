#include "app/field_fixture.hpp"

#include "pmts/app/desk/job_presenter.hpp"

#include <QFileInfo>

#include <csignal>
#include <sys/resource.h>

namespace pmts::app {
namespace {

/// Files of this process take no byte past a size: what a full disk looks like from inside.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }

private:
    rlimit before_{};
};

/// What the surveyor reads when the job file is in trouble.
class JobFaultTest : public FieldTest {
protected:
    void openAgain() {
        const std::size_t bars = messages.bars().size();
        job.openJob(jobPath());
        ASSERT_TRUE(until([&] { return messages.bars().size() > bars || job.isOpen(); }));
    }
    void close() {
        job.closeJob();
        ASSERT_TRUE(until([this] { return !job.isOpen(); }));
    }

    JobPresenter job{job_desk, preferences, messages};
};

TEST_F(JobFaultTest, FullDiskKeepsTheShotSaysSoAndRecordsItWhenThereIsRoom) {
    connectInstrument();
    openJob();
    ASSERT_TRUE(measure());
    recording.convert();
    {
        const FullDisk disk(static_cast<rlim_t>(QFileInfo(jobPath() + QStringLiteral("-wal")).size()));
        for (int i = 0; i < 200 && recording.readings().shot != ShotState::kKept; ++i) {
            recording.recordAgain();  // until the file must grow
            pass(100ms);
        }
    }
    ASSERT_EQ(recording.readings().shot, ShotState::kKept);
    EXPECT_THAT(newestBar(messages).toStdString(),
                testing::AllOf(testing::HasSubstr("not recorded; the shot is kept"), testing::HasSubstr("full")));
    EXPECT_EQ(messages.bars().back().action, MessageAction::kRetryRecord);
    const std::size_t acknowledged = points.points().size();

    recording.record();
    pass(1s);

    EXPECT_EQ(recording.readings().shot, ShotState::kRecorded);
    close();
    EXPECT_EQ((*job::Job::open(jobPath()))->points()->size(), acknowledged + 1);
}

TEST_F(JobFaultTest, ReadOnlyJobIsRefusedWithASentence) {
    openJob();
    close();
    ASSERT_TRUE(QFile::setPermissions(jobPath(), QFile::ReadOwner | QFile::ReadUser));
    openAgain();
    EXPECT_FALSE(job.isOpen());
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("read-only"));
    EXPECT_FALSE(messages.bars().back().remedy.isEmpty());
}

TEST_F(JobFaultTest, DamagedJobIsRefusedWithASentence) {
    openJob();
    close();
    ASSERT_TRUE(QFile::resize(jobPath(), 5000));
    openAgain();
    EXPECT_FALSE(job.isOpen());
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("damaged"));
    EXPECT_EQ(messages.bars().back().action, MessageAction::kOpenJob);
}

TEST_F(JobFaultTest, JobOpenInAnotherPmtsIsRefusedUntilItCloses) {
    auto other = *job::Job::create(jobPath());
    openAgain();
    EXPECT_FALSE(job.isOpen());
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("opened in another PMTS"));
    other.reset();
    openAgain();
    EXPECT_TRUE(job.isOpen());
    EXPECT_TRUE(messages.bars().empty()) << "solved";
}

TEST_F(JobFaultTest, JobFileMovedAwayWhileRecordingKeepsTheShotUntilItIsBack) {
    connectInstrument();
    openJob();
    ASSERT_TRUE(measure());
    moveJobAway();
    recording.record();
    pass(1s);
    EXPECT_EQ(recording.readings().shot, ShotState::kKept);
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("moved or deleted"));
    bringJobBack();
    recording.record();
    pass(1s);
    EXPECT_EQ(recording.readings().shot, ShotState::kRecorded);
    EXPECT_EQ(points.points().size(), 1U);
}

}  // namespace
}  // namespace pmts::app
