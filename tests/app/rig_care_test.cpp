#include "pmts/app/lab/board_presenter.hpp"
#include "pmts/app/lab/calibration_report.hpp"
#include "pmts/app/lab/check_presenter.hpp"
#include "pmts/app/lab/still_filters.hpp"

#include "field_fixture.hpp"
#include "support/board_pictures.hpp"

#include <QSignalSpy>

#include <cmath>

namespace pmts::app {
namespace {

CalibrationRecord recordOn(const QDateTime& utc, std::optional<double> temperature_c = {}) {
    CalibrationRecord record{.method = CalibrationMethod::kSelfCalibration, .utc = utc, .rms_px = 0.05};
    record.temperature_c = temperature_c;
    record.camera.size = {1280, 720};
    return record;
}

class RigCareTest : public FieldTest {
protected:
    QString accept(const CalibrationRecord& record) { return preferences.acceptRig(simulatedRigProfile().rig, record); }
    [[nodiscard]] bool warned() const {
        return std::ranges::any_of(messages.bars(), [](const Message& bar) { return bar.action == MessageAction::kCheckRig; });
    }
    void firstMoveMisses(double across_px, double down_px) {
        targeting::Recentred matched;
        matched.residual_px = {across_px, down_px};
        const auto newest = instrument.track().newest();
        Q_EMIT instrument.recentringStepped(1, {.stage = targeting::RecentringStage::kMatched, .move = 1, .target = newest->pointing, .matched = matched});
    }

    ProfilesPresenter profiles{preferences, live, instrument, messages, clock};
};

TEST_F(RigCareTest, FreshCalibrationRaisesNoConcern) {
    accept(recordOn(clock.utcNow(), 20.0));
    profiles.setTemperature(24.0);
    EXPECT_TRUE(profiles.concerns().isEmpty());
    EXPECT_EQ(profiles.state(), DeviceState::kGood);
    EXPECT_FALSE(warned());
}

TEST_F(RigCareTest, OldCalibrationIsSaidOnceWithAButtonThatChecks) {
    accept(recordOn(clock.utcNow().addDays(-31)));
    EXPECT_TRUE(warned());
    const auto bars = messages.bars().size();
    preferences.setSounds(false);  // any other change
    EXPECT_EQ(messages.bars().size(), bars);
    EXPECT_EQ(messages.bars().back().count, 1);
    accept(recordOn(clock.utcNow()));
    EXPECT_FALSE(warned()) << "calibrated again";
}

TEST_F(RigCareTest, HotDayAfterACoolCalibrationIsAConcern) {
    accept(recordOn(clock.utcNow(), 12.0));
    profiles.setTemperature(35.0);
    ASSERT_EQ(profiles.concerns().size(), 1);
    EXPECT_TRUE(profiles.concerns()[0].contains(QStringLiteral("35 °C")));
}

TEST_F(RigCareTest, TemperatureIsReadFromTheInstrument) {
    connectInstrument();
    profiles.readTemperature();
    EXPECT_TRUE(until([this] { return profiles.temperature().has_value(); }));
}

TEST_F(RigCareTest, MovesThatMissToTheSameSideAreASignOfAKnock) {
    connectInstrument();
    const QString name = accept(recordOn(clock.utcNow()));
    range.addShot(instrument.track().newest()->pointing, 15.0);
    for (int i = 0; i < 5; ++i) {
        firstMoveMisses(6.0 + 0.3 * i, -2.0);
    }
    EXPECT_FALSE(preferences.settings().profileNamed(name)->knock_sign.isEmpty());
    EXPECT_TRUE(warned());
}

TEST_F(RigCareTest, MovesThatMissToAllSidesAreNoKnock) {
    connectInstrument();
    const QString name = accept(recordOn(clock.utcNow()));
    range.addShot(instrument.track().newest()->pointing, 15.0);
    for (int i = 0; i < 10; ++i) {
        firstMoveMisses(6.0 * std::cos(2.4 * i), 6.0 * std::sin(2.4 * i));
    }
    EXPECT_TRUE(preferences.settings().profileNamed(name)->knock_sign.isEmpty());
}

TEST_F(RigCareTest, ProfileIsRenamedCopiedAndDeleted) {
    const QString name = accept(recordOn(clock.utcNow()));
    profiles.rename(name, QStringLiteral("Tripod camera"));
    EXPECT_TRUE(preferences.settings().profileNamed(QStringLiteral("Tripod camera")));
    profiles.duplicate(QStringLiteral("Tripod camera"));
    EXPECT_EQ(profiles.rows().size(), 3U) << "two and the simulated camera's own";
    profiles.rename(QStringLiteral("Tripod camera"), QStringLiteral("Tripod camera copy"));
    EXPECT_TRUE(preferences.settings().profileNamed(QStringLiteral("Tripod camera"))) << "that name is taken";
    profiles.remove(QStringLiteral("Tripod camera"));
    EXPECT_EQ(live.rigChoice().fitness, RigFitness::kNominal);
}

TEST_F(RigCareTest, ProfileUsedByHandIsNotPickedOverAgain) {
    const QString first = accept(recordOn(clock.utcNow()));
    profiles.duplicate(first);
    const QString copy = preferences.settings().rig_profiles.back().name;
    profiles.use(copy);
    EXPECT_EQ(live.rigChoice().profile.name, copy);
    EXPECT_FALSE(profiles.picksByItself());
    profiles.setPicksByItself(true);
    EXPECT_EQ(live.rigChoice().profile.name, first);
}

TEST_F(RigCareTest, LensOfAnotherProgramIsImportedWithTheMountInUse) {
    const QString path = folder.filePath(QStringLiteral("lens.yaml"));
    profiles.exportTo(simulatedRigProfile().name, path);
    profiles.importFrom(path);
    ASSERT_EQ(preferences.settings().rig_profiles.size(), 1U);
    const RigProfile& imported = preferences.settings().rig_profiles[0];
    EXPECT_EQ(imported.rig.lens.model(), simulatedRigProfile().rig.lens.model());
    EXPECT_EQ(imported.rig.mount.offset_m, simulatedRigProfile().rig.mount.offset_m);
    EXPECT_EQ(imported.calibration->method, CalibrationMethod::kImported);
    profiles.importFrom(folder.filePath(QStringLiteral("nowhere.yaml")));
    EXPECT_FALSE(messages.bars().empty());
}

// The one-minute check, by hand: the spot is clicked where the true camera sees it.
class CheckTest : public RigCareTest {
protected:
    /// Two black quadrants that meet at `px`.
    static cv::Mat markAt(const Eigen::Vector2d& px) {
        cv::Mat picture(720, 1280, CV_8UC3);
        for (int row = 0; row < picture.rows; ++row) {
            for (int column = 0; column < picture.cols; ++column) {
                const double across = std::tanh(column - px.x()), down = std::tanh(row - px.y());
                const double reach = std::hypot(column - px.x(), row - px.y()) < 20 ? 90.0 : 0.0;
                picture.at<cv::Vec3b>(row, column) = cv::Vec3b::all(cv::saturate_cast<uchar>(120 - reach * across * down));
            }
        }
        return picture;
    }
    /// Clicks a place 15 m away where a camera with this rig shows it, from five pointings; or beside a mark there.
    void checkWith(const camera::Rig& true_rig, const QPointF& beside_px = {}) {
        connectInstrument();
        ASSERT_TRUE(turnTo(10, 98));
        ASSERT_TRUE(measure());
        check.useTelescope();
        ASSERT_TRUE(check.place().has_value()) << qPrintable(check.trouble());
        const double offsets[5][2] = {{0, 0}, {-8, -4}, {8, -4}, {8, 4}, {-8, 4}};
        for (const auto& offset : offsets) {
            ASSERT_TRUE(turnTo(10 + offset[0], 98 + offset[1]));
            showFrames();
            const auto px = targeting::PixelToPointing(true_rig).pixelForPoint(check.place()->p_station, live.scene().pointing.value());
            if (!beside_px.isNull()) {
                camera->picture = [&px](core::Duration) { return markAt(*px); };
                showFrames();
                camera->picture = {};
            }
            check.click(QPointF(px->x(), px->y()) + beside_px);
            check.takeByHand();
        }
    }

    CheckPresenter check{live, instrument, points, preferences, profiles, clock};
};

TEST_F(CheckTest, RigThatSeesRightPassesAndTheCheckIsKept) {
    const QString name = accept(recordOn(clock.utcNow()));
    checkWith(simulatedRigProfile().rig);
    ASSERT_TRUE(check.result().has_value());
    EXPECT_TRUE(check.result()->passed);
    EXPECT_LT(check.result()->rms_px, 0.01);
    ASSERT_EQ(preferences.settings().profileNamed(name)->checks.size(), 1U);
    EXPECT_EQ(preferences.settings().profileNamed(name)->checks[0].pointings, 5);
}

TEST_F(CheckTest, ClickBesideAMarkCountsAsTheMark) {
    accept(recordOn(clock.utcNow()));
    checkWith(simulatedRigProfile().rig, {4, -3});
    ASSERT_TRUE(check.result().has_value());
    EXPECT_LT(check.result()->largest_px, 0.1) << "five pixels without the jump";
}

TEST_F(CheckTest, ClickWithNothingBesideItCountsAsItIsAndIsSaid) {
    connectInstrument();
    ASSERT_TRUE(measure());
    check.useTelescope();
    showFrames();
    check.click({60, 30});
    EXPECT_EQ(check.clicked(), QPointF(60, 30));
    EXPECT_TRUE(check.step().startsWith(QStringLiteral("No corner or mark"))) << qPrintable(check.step());
}

TEST_F(CheckTest, KnockedCameraFailsAndIsSaidInTheMessageBar) {
    const QString name = accept(recordOn(clock.utcNow()));
    camera::Rig knocked = simulatedRigProfile().rig;
    knocked.mount.yaw += Angle::fromGon(0.2);
    checkWith(knocked);
    ASSERT_TRUE(check.result().has_value());
    EXPECT_FALSE(check.result()->passed);
    EXPECT_NEAR(check.result()->rms.gon(), 0.2, 0.01);
    EXPECT_NEAR(check.result()->rms_px, 0.2 / 200 * M_PI * 1400, 0.4);
    EXPECT_FALSE(preferences.settings().profileNamed(name)->knock_sign.isEmpty());
    EXPECT_TRUE(warned());
}

TEST_F(CheckTest, WithoutAMeasuredRangeTheTelescopesSpotIsRefused) {
    connectInstrument();
    check.useTelescope();
    EXPECT_FALSE(check.place().has_value());
    EXPECT_FALSE(check.trouble().isEmpty());
}

// Boards before the live view -----------------------------------------------------------------------------------------

class BoardPresenterTest : public RigCareTest {
protected:
    static constexpr camera::BrownLens kLens{.f_px = 700, .cx_px = 322.5, .cy_px = 237.0, .k1 = -0.18, .k2 = 0.06};
    void showBoards(int count) {
        const test::BoardPictures pictures(camera::Lens(kLens), 640, 480);
        for (const auto& place : test::boardPlaces(board.pattern(), kLens.f_px, 640, count)) {
            const cv::Mat picture = pictures.draw(board.pattern(), place);
            camera->show(clock.now(), picture);
            pass(100ms);
            camera->show(clock.now(), picture);  // held still
            pass(100ms);
        }
    }
    BoardPresenter board{live, preferences, messages, clock, Threading::kCallersThread};
};

TEST_F(BoardPresenterTest, ViewsAreTakenByThemselvesAndTheLensIsAcceptedWithTheMountOfBefore) {
    board.setLooking(true);
    showBoards(18);
    board.setLooking(false);
    ASSERT_GE(board.views().size(), 5U) << qPrintable(board.sentence());
    board.calibrate();
    ASSERT_TRUE(board.result().has_value()) << qPrintable(board.sentence());
    EXPECT_EQ(board.verdictState(), DeviceState::kWarning) << "not the simulated camera's lens";
    EXPECT_FALSE(board.verdict().isEmpty());
    board.acceptLens();
    ASSERT_EQ(preferences.settings().rig_profiles.size(), 1U);
    const RigProfile& profile = preferences.settings().rig_profiles[0];
    EXPECT_NEAR(profile.rig.lens.focalLengthPx(), 700, 5);
    EXPECT_EQ(profile.rig.mount.offset_m, simulatedRigProfile().rig.mount.offset_m);
    EXPECT_EQ(profile.calibration->method, CalibrationMethod::kBoard);
    EXPECT_FALSE(profile.calibration->residuals.empty());
}

TEST_F(BoardPresenterTest, PictureWithoutABoardSaysSo) {
    board.setLooking(true);
    showFrames(1);
    EXPECT_TRUE(board.views().empty());
    EXPECT_FALSE(board.sentence().isEmpty());
    board.calibrate();
    EXPECT_FALSE(board.result().has_value());
    EXPECT_TRUE(board.sentence().contains(QStringLiteral("4")));
}

// Report and filters --------------------------------------------------------------------------------------------------

TEST(CalibrationReportTest, CurvesComeFromTheLensWhateverItsModelIs) {
    RigProfile profile = simulatedRigProfile();
    profile.calibration = recordOn(QDateTime(QDate(2026, 6, 1), QTime(9, 0), Qt::UTC), 21.0);
    profile.calibration->standard_deviations[QStringLiteral("pitch [rad]")] = 1e-5;
    const CalibrationReport report = calibrationReport(profile, {});
    ASSERT_GT(report.angle_curve.size(), 100U);
    const auto& end = report.angle_curve.back();
    EXPECT_NEAR(end.x(), 643.5, 0.01) << "to the farther edge";
    const auto ray = profile.rig.lens.cameraFromPixel({643.5 - end.x(), 357.5});
    EXPECT_NEAR(end.y(), std::atan2(std::abs(ray->x()), ray->z()) * 200 / M_PI, 1e-6);
    EXPECT_GT(end.y(), report.ideal_curve.back().y()) << "a barrel sees more";
    EXPECT_NEAR(report.width_curve.front().y(), 200 / M_PI / 1400, 2e-5);
    const auto pitch = std::ranges::find_if(report.parameters, [](const auto& p) { return p.name.startsWith(QStringLiteral("pitch")); });
    ASSERT_NE(pitch, report.parameters.end());
    EXPECT_EQ(pitch->value, QStringLiteral("-200.0"));
    EXPECT_EQ(pitch->deviation, QStringLiteral("± 0.6"));
    EXPECT_TRUE(calibrationReportText(report).contains(QStringLiteral("self-calibration")));
}

TEST(StillFiltersTest, FilterBelongsToItsStillAndTheFrameStaysAsItWas) {
    auto frame = std::make_shared<camera::Frame>();
    frame->image = cv::Mat(20, 20, CV_8UC3, cv::Scalar(30, 60, 90));
    StillFilters filters;
    QSignalSpy changed(&filters, &StillFilters::changed);
    camera::ImageFilter red;
    red.single_band = true;
    filters.set(3, red);
    EXPECT_EQ(changed.size(), 1);
    EXPECT_EQ(filters.shown(4, frame), frame);
    const camera::FramePtr shown = filters.shown(3, frame);
    EXPECT_EQ(shown->image.at<cv::Vec3b>(3, 3), cv::Vec3b(90, 90, 90));
    EXPECT_EQ(filters.shown(3, frame), shown) << "made once";
    EXPECT_EQ(frame->image.at<cv::Vec3b>(3, 3), cv::Vec3b(30, 60, 90));
    const QTemporaryDir folder;
    EXPECT_TRUE(filters.write(3, frame, folder.filePath(QStringLiteral("red.png"))).has_value());
    EXPECT_FALSE(filters.write(3, frame, QStringLiteral("/nowhere/red.png")).has_value());
}

}  // namespace
}  // namespace pmts::app
