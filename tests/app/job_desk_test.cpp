#include "app/field_fixture.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

/// Requests to the job and their one outcome each.
class JobDeskTest : public FieldTest {
protected:
    static survey::Point shot() {
        survey::Point point;
        point.id = QStringLiteral("1");
        point.observation.slope_distance_m = 10.0;
        return point;
    }
    static EvidenceShots aimed() {
        EvidenceShots shots;
        shots.evidence.method = QStringLiteral("rigorous");
        shots.evidence.score = 0.97;
        shots.evidence.before.spot_px = QPointF(20, 10);
        shots.before = QImage(80, 45, QImage::Format_RGB888);
        shots.before.fill(Qt::darkGreen);
        return shots;
    }
    /// The arguments of the only emission, after the event loop ran.
    QVariantList outcome(QSignalSpy& spy) {
        (void)until([&] { return !spy.empty(); });
        EXPECT_EQ(spy.count(), 1);
        EXPECT_EQ(failed.count(), 0);
        return spy.value(0);
    }

    QSignalSpy failed{&job_desk, &JobDesk::requestFailed};
};

TEST_F(JobDeskTest, EvidenceIsEncodedAndComesBackWithItsPoint) {
    openJob();
    QSignalSpy recorded(&job_desk, &JobDesk::recorded);
    job_desk.record(shot(), aimed());
    const auto point = outcome(recorded).value(1).value<survey::Point>();

    QSignalSpy loaded(&job_desk, &JobDesk::evidenceLoaded);
    const Ticket ticket = job_desk.loadEvidence(point.row_id);
    const auto told = outcome(loaded);

    EXPECT_EQ(told.value(0).value<Ticket>(), ticket);
    const auto evidence = told.value(2).value<std::optional<job::Evidence>>();
    ASSERT_TRUE(evidence.has_value());
    EXPECT_EQ(evidence->score, 0.97);
    EXPECT_EQ(QImage::fromData(evidence->before.encoded_image).size(), QSize(80, 45));
    EXPECT_EQ(evidence->before.spot_px, QPointF(20, 10));
    EXPECT_TRUE(evidence->after.encoded_image.isEmpty()) << "there was no picture after";
}

TEST_F(JobDeskTest, APointWithoutEvidenceHasNone) {
    openJob();
    job_desk.record(shot());
    QSignalSpy loaded(&job_desk, &JobDesk::evidenceLoaded);
    job_desk.loadEvidence(1);
    EXPECT_FALSE(outcome(loaded).value(2).value<std::optional<job::Evidence>>().has_value());
}

TEST_F(JobDeskTest, MarksOfAPhotoAreAddedChangedListedAndRemoved) {
    openJob();
    QSignalSpy added(&job_desk, &JobDesk::markAdded);
    QSignalSpy updated(&job_desk, &JobDesk::markUpdated);
    QSignalSpy removed(&job_desk, &JobDesk::markRemoved);
    QSignalSpy listed(&job_desk, &JobDesk::marksLoaded);
    job_desk.addPhoto({}, QImage(8, 8, QImage::Format_RGB888));
    job_desk.addMark({.photo_row = 1, .x_px = 3, .y_px = 4, .label = QStringLiteral("crack")});
    auto mark = outcome(added).value(1).value<job::ImageMark>();
    mark.label = QStringLiteral("bolt");
    job_desk.updateMark(mark);
    outcome(updated);
    job_desk.loadMarks(1);
    const auto marks = outcome(listed).value(2).value<std::vector<job::ImageMark>>();
    ASSERT_EQ(marks.size(), 1U);
    EXPECT_EQ(marks[0].label, QStringLiteral("bolt"));
    job_desk.removeMark(mark.row_id);
    EXPECT_EQ(outcome(removed).value(1).toLongLong(), mark.row_id);
}

TEST_F(JobDeskTest, PlannedPointsAreThereWhenTheJobIsOpenedAgain) {
    openJob();
    QSignalSpy added(&job_desk, &JobDesk::plannedAdded);
    job_desk.addPlanned(
        {survey::PlannedPoint{.row_id = 0, .id = QStringLiteral("P1"), .code = {}, .remark = {}, .e_m = 5}});
    outcome(added);
    QSignalSpy opened(&job_desk, &JobDesk::opened);
    job_desk.open(jobPath());
    const auto contents = outcome(opened).value(0).value<JobContents>();
    ASSERT_EQ(contents.planned.size(), 1U);
    EXPECT_EQ(contents.planned[0].e_m, 5.0);
}

TEST_F(JobDeskTest, WithoutAJobEveryRequestFailsOnce) {
    job_desk.record(shot(), aimed());
    job_desk.loadEvidence(1);
    job_desk.addMark({.photo_row = 1, .label = {}});
    job_desk.updateMark({.label = {}});
    job_desk.removeMark(1);
    job_desk.loadMarks(1);
    job_desk.importPlanned(QStringLiteral("/nowhere.csv"));
    job_desk.addPlanned({});
    const Ticket last = job_desk.removePlanned({});
    pass(1s);
    ASSERT_EQ(failed.count(), 9);
    EXPECT_EQ(failed.last().at(0).value<Ticket>(), last);
    EXPECT_EQ(failed.last().at(1).value<core::Error>().kind, core::ErrorKind::kFile);
}

}  // namespace
}  // namespace pmts::app
