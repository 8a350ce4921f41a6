#include "field/evidence_dialog.hpp"

#include "evidence_support.hpp"
#include "pmts/core/virtual_clock.hpp"

#include <QFile>
#include <QLabel>
#include <QTemporaryDir>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

/// A job with one point that was aimed by image, and one that was not.
class EvidenceDialogTest : public testing::Test {
protected:
    EvidenceDialogTest() {
        job.create(folder.filePath(QStringLiteral("wall.gpkg")));
        QObject::connect(&job, &app::JobDesk::recorded, &points,
                         [this](app::Ticket, const survey::Point& point) { points.addRecorded(point); });
        survey::Point point;
        point.id = QStringLiteral("104");
        point.observation.slope_distance_m = 15.2;
        app::EvidenceShots shots;
        shots.evidence.method = QStringLiteral("rigorous");
        shots.evidence.residual_x_px = 0.03;
        shots.evidence.residual_y_px = 0.04;
        shots.evidence.moves = 2;
        shots.after = test::pictureOfAWall();
        job.record(point, shots);
        core::deliverQueuedEvents();
        evidence.load(1);
        core::deliverQueuedEvents();
    }
    ~EvidenceDialogTest() override { core::deliverQueuedEvents(); }

    static QString label(const EvidenceDialog& dialog, const char* name) {
        return dialog.findChild<QLabel*>(QLatin1String(name))->text();
    }

    QTemporaryDir folder;
    QUndoStack undo;
    app::Preferences preferences{QString()};
    app::MessageCentre messages;
    app::JobDesk job{app::Threading::kCallersThread};
    app::PointsModel points{job, preferences, messages, undo};
    app::EvidencePresenter evidence{job, points, preferences, messages};
};

TEST_F(EvidenceDialogTest, ShowsPointResidualAndNumbers) {
    const EvidenceDialog dialog(evidence);
    EXPECT_EQ(label(dialog, "title"), QStringLiteral("Point 104"));
    EXPECT_THAT(label(dialog, "verdict").toStdString(), testing::HasSubstr("0.05 px"));
    EXPECT_THAT(label(dialog, "point").toStdString(), testing::HasSubstr("15.200"));
    EXPECT_THAT(label(dialog, "aiming").toStdString(), testing::HasSubstr("Moves"));
}

TEST_F(EvidenceDialogTest, FollowsTheUnits) {
    const EvidenceDialog dialog(evidence);
    preferences.setUnits(
        {.angle_unit = core::AngleUnit::kGon, .length_unit = core::LengthUnit::kFoot, .length_decimals = 2});
    EXPECT_THAT(label(dialog, "point").toStdString(), testing::HasSubstr("49.87"));
}

TEST_F(EvidenceDialogTest, SavesThePdfAndSaysWhere) {
    EvidenceDialog dialog(evidence);
    const QString path = folder.filePath(QStringLiteral("point-104.pdf"));
    dialog.saveTo(path);
    EXPECT_TRUE(QFile::exists(path));
    EXPECT_THAT(label(dialog, "outcome").toStdString(), testing::HasSubstr("point-104.pdf"));
    dialog.saveTo(QStringLiteral("/nowhere/point-104.pdf"));
    EXPECT_THAT(label(dialog, "outcome").toStdString(), testing::HasSubstr("cannot be written"));
}

TEST_F(EvidenceDialogTest, ClosesWithItsJob) {
    EvidenceDialog dialog(evidence);
    dialog.show();
    job.close();
    core::deliverQueuedEvents();
    EXPECT_FALSE(dialog.isVisible());
}

}  // namespace
}  // namespace pmts::gui
