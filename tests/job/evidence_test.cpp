#include "job_support.hpp"

namespace pmts::job {
namespace {

TEST_F(JobTest, APointKeepsHowItWasAimed) {
    auto job = created();
    const auto point = job->record(shotPoint(1), aimedWell());
    ASSERT_TRUE(point.has_value());
    job.reset();

    const auto found = reopened()->evidenceOf(point->row_id);

    ASSERT_TRUE(found.has_value() && found->has_value());
    const Evidence expected = aimedWell();
    EXPECT_EQ((*found)->point_row, point->row_id);
    EXPECT_EQ((*found)->method, expected.method);
    EXPECT_TRUE((*found)->recentred);
    EXPECT_EQ((*found)->pointing, expected.pointing);
    EXPECT_EQ((*found)->residual_x_px, expected.residual_x_px);
    EXPECT_EQ((*found)->residual_y_px, expected.residual_y_px);
    EXPECT_EQ((*found)->residual, expected.residual);
    EXPECT_EQ((*found)->tolerance, expected.tolerance);
    EXPECT_EQ((*found)->score, expected.score);
    EXPECT_EQ((*found)->runner_up, expected.runner_up);
    EXPECT_EQ((*found)->sigma_px, expected.sigma_px);
    EXPECT_EQ((*found)->moves, 2);
    EXPECT_EQ((*found)->slope_distance_source, expected.slope_distance_source);
    EXPECT_EQ((*found)->utc, expected.utc);
    EXPECT_EQ((*found)->before.encoded_image, expected.before.encoded_image);
    EXPECT_EQ((*found)->before.spot_px, expected.before.spot_px);
    EXPECT_FALSE((*found)->before.reticle_px.has_value()) << "it lay outside the picture";
    EXPECT_EQ((*found)->after.encoded_image, expected.after.encoded_image);
    EXPECT_EQ((*found)->after.reticle_px, expected.after.reticle_px);
}

TEST_F(JobTest, WhatAnOpenLoopMoveDidNotMeasureIsAbsent) {
    const auto job = created();
    Evidence open_loop;
    open_loop.method = QStringLiteral("TPA");
    const auto point = job->record(shotPoint(1), open_loop);

    const auto found = *job->evidenceOf(point->row_id);

    ASSERT_TRUE(found.has_value());
    EXPECT_FALSE(found->recentred);
    EXPECT_FALSE(found->residual.has_value() || found->residual_x_px || found->score || found->sigma_px);
    EXPECT_TRUE(found->before.encoded_image.isEmpty());
    const OtherProgram qgis(path);
    EXPECT_EQ(qgis.value("SELECT score IS NULL AND before_image IS NULL FROM evidence"), QStringLiteral("1"));
}

TEST_F(JobTest, APointAimedByHandHasNoEvidence) {
    const auto job = created();
    const auto aimed = job->record(shotPoint(1), aimedWell());
    const auto by_hand = job->record(shotPoint(2));
    EXPECT_TRUE(job->evidenceOf(aimed->row_id)->has_value());
    EXPECT_FALSE(job->evidenceOf(by_hand->row_id)->has_value());
}

TEST_F(JobTest, AnEvidenceThatCannotBeWrittenLeavesNoPointEither) {
    const auto job = created();
    ASSERT_EQ(
        OtherProgram(path, GDAL_OF_UPDATE)
            .refusal("CREATE TRIGGER full BEFORE INSERT ON evidence BEGIN SELECT RAISE(ABORT, 'no'); END"),
        QString());
    EXPECT_FALSE(job->record(shotPoint(1), aimedWell()).has_value());
    EXPECT_TRUE(job->points()->empty());
    EXPECT_EQ(OtherProgram(path).value("SELECT COUNT(*) FROM observations"), QStringLiteral("0"));
    EXPECT_TRUE(job->record(shotPoint(2)).has_value()) << "without evidence it goes on";
}

TEST_F(JobTest, EvidenceCannotBeChangedByAnyProgram) {
    const auto job = created();
    ASSERT_TRUE(job->record(shotPoint(1), aimedWell()).has_value());
    const OtherProgram editor(path, GDAL_OF_UPDATE);
    for (const char* sql : {"UPDATE evidence SET score = 1", "DELETE FROM evidence",
                            "INSERT OR REPLACE INTO evidence (fid, score) VALUES (1, 1.0)"}) {
        EXPECT_TRUE(editor.refusal(sql).contains(QStringLiteral("never changed"))) << sql;
    }
}

}  // namespace
}  // namespace pmts::job
