#include "pmts/app/field/evidence_presenter.hpp"

#include "app/field_fixture.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

/// What the surveyor reads about how a point was aimed.
class EvidencePresenterTest : public FieldTest {
protected:
    void SetUp() override { openJob(); }

    static EvidenceShots recentred() {
        EvidenceShots shots;
        shots.evidence.method = QStringLiteral("rigorous");
        shots.evidence.recentred = true;
        shots.evidence.pointing = {.ha = Angle::fromGon(12.3456), .va = Angle::fromGon(98.7654)};
        shots.evidence.residual_x_px = 0.03;
        shots.evidence.residual_y_px = -0.04;
        shots.evidence.residual = Angle::fromGon(0.0021);
        shots.evidence.tolerance_px = 0.1;
        shots.evidence.score = 0.974;
        shots.evidence.runner_up = 0.512;
        shots.evidence.moves = 2;
        shots.evidence.slope_distance_m = 15.25;
        shots.evidence.slope_distance_source = QStringLiteral("last shot");
        shots.evidence.after.reticle_px = QPointF(30, 20);
        shots.after = QImage(64, 36, QImage::Format_RGB888);
        shots.after.fill(Qt::gray);
        return shots;
    }
    qint64 record(std::optional<EvidenceShots> shots) {
        survey::Point point;
        point.id = QStringLiteral("104");
        point.code = QStringLiteral("WALL");
        point.station_name = QStringLiteral("100");
        point.observation.slope_distance_m = 15.2;
        point.coordinates = {.e_m = 1003.5,
                             .n_m = 1014.25,
                             .h_m = 101.5,
                             .sigma_e_m = 0.002,
                             .sigma_n_m = 0.003,
                             .sigma_h_m = 0.001};
        QSignalSpy recorded(&job_desk, &JobDesk::recorded);
        job_desk.record(point, std::move(shots));
        EXPECT_TRUE(until([&] { return !recorded.empty(); }));
        points.addRecorded(recorded.at(0).at(1).value<survey::Point>());
        return points.points().back().row_id;
    }
    bool load(qint64 row_id) {
        QSignalSpy loaded(&evidence, &EvidencePresenter::loaded);
        evidence.load(row_id);
        return until([&] { return !loaded.empty(); }, 5s);
    }
    static QString value(const std::vector<EvidenceLine>& lines, const char* label) {
        const auto found = std::ranges::find(lines, QLatin1String(label), &EvidenceLine::label);
        return found == lines.end() ? QStringLiteral("no such line") : found->value;
    }

    EvidencePresenter evidence{job_desk, points, preferences, messages};
};

TEST_F(EvidencePresenterTest, SaysHowWellThePointWasAimed) {
    ASSERT_TRUE(load(record(recentred())));
    const EvidenceSheet sheet = evidence.sheet().value();
    EXPECT_EQ(sheet.point_id, QStringLiteral("104"));
    EXPECT_THAT(sheet.subtitle.toStdString(),
                testing::AllOf(testing::HasSubstr("WALL"), testing::HasSubstr("station 100")));
    EXPECT_THAT(sheet.verdict.toStdString(),
                testing::AllOf(testing::HasSubstr("0.05 px"), testing::HasSubstr("0.0021 gon"),
                               testing::HasSubstr("2 moves")));
    EXPECT_EQ(value(sheet.place, "E"), QStringLiteral("1003.500 m   ± 2.0 mm"));
    EXPECT_EQ(value(sheet.aiming, "Method"), QStringLiteral("rigorous, re-centred"));
    EXPECT_EQ(value(sheet.aiming, "Match score"), QStringLiteral("0.974"));
    EXPECT_EQ(value(sheet.aiming, "Best of anything else"), QStringLiteral("0.512"));
    EXPECT_EQ(value(sheet.aiming, "Reticle drawn for"), QStringLiteral("15.250 m (last shot)"));
    EXPECT_EQ(sheet.after.image.size(), QSize(64, 36));
    EXPECT_EQ(sheet.after.reticle_px, QPointF(30, 20));
    EXPECT_TRUE(sheet.before.image.isNull());
}

TEST_F(EvidencePresenterTest, TextsFollowTheUnitsAndTheNames) {
    const qint64 row_id = record(recentred());
    ASSERT_TRUE(load(row_id));
    QSignalSpy changed(&evidence, &EvidencePresenter::sheetChanged);
    preferences.setUnits({.angle_unit = core::AngleUnit::kDegree,
                          .length_unit = core::LengthUnit::kFoot,
                          .length_decimals = 2});
    points.edit(row_id, QStringLiteral("A1"), {}, {});
    EXPECT_GE(changed.count(), 2);
    EXPECT_EQ(value(evidence.sheet()->observation, "SD").left(8), QStringLiteral("49.87 ft"));
    EXPECT_EQ(evidence.sheet()->point_id, QStringLiteral("A1"));
}

TEST_F(EvidencePresenterTest, AnOpenLoopMoveClaimsNothingAPictureDidNotShow) {
    EvidenceShots shots;
    shots.evidence.method = QStringLiteral("TPA");
    ASSERT_TRUE(load(record(shots)));
    const EvidenceSheet sheet = evidence.sheet().value();
    EXPECT_THAT(sheet.verdict.toStdString(), testing::HasSubstr("without looking again"));
    EXPECT_EQ(value(sheet.aiming, "Residual"), QStringLiteral("no such line"));
    EXPECT_EQ(value(sheet.aiming, "Match score"), QStringLiteral("no such line"));
    EXPECT_THAT(value(sheet.aiming, "Known error").toStdString(), testing::HasSubstr("1.76 gon"));
}

TEST_F(EvidencePresenterTest, APointAimedByHandIsSaidToHaveNone) {
    QSignalSpy toast(&messages, &MessageCentre::toastShown);
    EXPECT_FALSE(load(record(std::nullopt)));
    EXPECT_FALSE(evidence.sheet().has_value());
    ASSERT_EQ(toast.count(), 1);
    EXPECT_THAT(toast.at(0).at(0).value<Message>().happened.toStdString(),
                testing::HasSubstr("not aimed by image"));
}

TEST_F(EvidencePresenterTest, ClosingTheJobTakesTheSheetAway) {
    ASSERT_TRUE(load(record(recentred())));
    job_desk.close();
    ASSERT_TRUE(until([this] { return !job_desk.isOpen(); }));
    EXPECT_FALSE(evidence.sheet().has_value());
}

}  // namespace
}  // namespace pmts::app
