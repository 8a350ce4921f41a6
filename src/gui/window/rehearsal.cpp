#include "pmts/gui/rehearsal.hpp"

#include "field/field_actions.hpp"
#include "field/field_workspace.hpp"
#include "field/image_view.hpp"
#include "pmts/app/desk/workbench.hpp"
#include "pmts/gui/main_window.hpp"
#include "rehearsal_hands.hpp"

#include <QDir>
#include <QFileInfo>

#include <cmath>
#include <cstdio>

namespace pmts::gui {
namespace {

using namespace std::chrono_literals;
using core::Result;
using core::Task;

constexpr core::Duration kTurnLimit = 60s;
constexpr core::Duration kMeasureLimit = 90s;
constexpr core::Duration kScreenLimit = 20s;
constexpr core::Duration kConnectLimit = 30s;
const char* const kCodes[] = {"WALL", "DOOR", "WALL", "MARK", "EDGE"};

core::Error failed(const QString& happened) {
    return {.kind = core::ErrorKind::kTimeOut,
            .happened = happened,
            .remedy = {},
            .info_code = std::nullopt,
            .detail = {}};
}

Task<Result<void>> waitForStart(Hands& hands, app::Workbench& bench) {
    PMTS_STEP(hands.until(u"the job did not open"_qs, kScreenLimit, [&bench] { return bench.job.isOpen(); }));
    PMTS_STEP(hands.until(u"the simulated instrument did not answer"_qs, kConnectLimit, [&bench] {
        return bench.instrument.connectionState() == app::ConnectionState::kConnected;
    }));
    PMTS_STEP(hands.until(u"no live picture with HA and VA appeared"_qs, kScreenLimit, [&bench] {
        return bench.live.scene().frame && bench.live.scene().pointing && bench.live.scene().reticle_px;
    }));
    co_return {};
}

/// Station 1000/1000/100, instrument height 1.600, orientation 0, typed into the dialog and applied.
Task<Result<void>> setUpStation(Hands& hands, app::Workbench& bench) {
    PMTS_STEP(hands.press(Qt::Key_T));
    QWidget* const dialog = hands.window(u"StationDialog"_qs);
    if (dialog == nullptr) {
        co_return tl::unexpected(failed(u"the station dialog did not open"_qs));
    }
    const std::pair<const char*, const char*> fields[] = {
        {"name", "100"},   {"easting", "1000 m"},          {"northing", "1000"},
        {"height", "100"}, {"instrument_height", "2*0.8"}, {"orientation", "0 gon"}};
    for (const auto& [field, text] : fields) {
        hands.type(dialog, field, QString::fromLatin1(text));
    }
    hands.clickText(dialog, u"Apply"_qs);
    PMTS_STEP(hands.until(u"the station was not set"_qs, kScreenLimit, [&bench] {
        return std::abs(bench.station.station().instrument_height_m - 1.6) < 1e-9 &&
               bench.station.station().e_m == 1000.0;
    }));
    PMTS_STEP(hands.settle());
    hands.shootWith(dialog, u"10-station.png"_qs);
    hands.closeWindow(dialog);
    co_return {};
}

Task<Result<void>> waitForArrival(Hands& hands, app::Workbench& bench, QString what) {
    PMTS_STEP(hands.until(u"the telescope did not arrive at "_qs + what, kTurnLimit, [&bench] {
        const auto& target = bench.targeting.target();
        return target && !bench.targeting.isMoving() &&
               (target->state == app::MoveState::kArrived || target->state == app::MoveState::kLost);
    }));
    if (bench.targeting.target()->state == app::MoveState::kLost) {
        co_return tl::unexpected(
            failed(u"the move to %1 ended with: %2"_qs.arg(what, bench.targeting.target()->sentence)));
    }
    co_return {};
}

/// Types HA and VA a little beside the mark and turns there: the surveyor swings the telescope round by hand.
Task<Result<void>> swingTo(Hands& hands, app::Workbench& bench, KnownMark mark) {
    const double level_m = std::hypot(mark.x_m, mark.y_m);
    const auto ha =
        core::normalized(core::Angle::fromRad(std::atan2(mark.x_m, mark.y_m)) + core::Angle::fromGon(1.5));
    const auto va = core::Angle::fromRad(std::atan2(level_m, mark.z_m)) + core::Angle::fromGon(0.8);
    PMTS_STEP(hands.press(Qt::Key_A));
    QWidget* const dialog = hands.window(u"AimDialog"_qs);
    if (dialog == nullptr) {
        co_return tl::unexpected(failed(u"the aim dialog did not open"_qs));
    }
    hands.type(dialog, "ha", u"%1 gon"_qs.arg(ha.gon(), 0, 'f', 4));
    hands.type(dialog, "va", u"%1 gon"_qs.arg(va.gon(), 0, 'f', 4));
    hands.clickText(dialog, u"OK"_qs);
    PMTS_STEP(hands.until(u"the typed direction did not become the target"_qs, kScreenLimit, [&bench] {
        return bench.targeting.target() && bench.targeting.target()->state == app::MoveState::kAimed;
    }));
    PMTS_STEP(hands.press(Qt::Key_Return));
    PMTS_STEP(hands.until(u"the telescope did not start to turn"_qs, kScreenLimit,
                          [&bench] { return bench.targeting.isMoving() || bench.instrument.isTurning(); }));
    PMTS_STEP(hands.pause(400ms));
    hands.shoot(u"05-turning.png"_qs, Hands::Again::kKeepFirst);
    PMTS_STEP(waitForArrival(hands, bench, mark.name));
    co_return {};
}

Task<Result<void>> measure(Hands& hands, app::Workbench& bench) {
    PMTS_STEP(hands.press(Qt::Key_D));
    PMTS_STEP(hands.until(u"the distance was not measured"_qs, kMeasureLimit,
                          [&bench] { return bench.recording.readings().shot == app::ShotState::kMeasured; }));
    co_return {};
}

/// Zooms in and double-clicks the centre of the mark, so that it sits at the reticle.
Task<Result<void>> refine(Hands& hands, app::Workbench& bench, KnownMark mark) {
    ImageView& view = hands.liveView();
    PMTS_STEP(hands.freshFrame());
    const auto px = hands.markPixel(mark);
    if (!px) {
        co_return tl::unexpected(failed(u"the mark %1 was not found in the live view"_qs.arg(mark.name)));
    }
    view.zoomAbout(view.widgetFromImage(*px), ImageView::kLargestZoom);
    hands.doubleClick(view, view.widgetFromImage(*px));
    PMTS_STEP(hands.until(u"the refining click started no move"_qs, kScreenLimit, [&bench] {
        return bench.targeting.target() && bench.targeting.target()->state != app::MoveState::kAimed;
    }));
    PMTS_STEP(waitForArrival(hands, bench, mark.name));
    view.fit();
    co_return {};
}

/// The thesis's precise targeting: click, measure, click again now that the range is known.
Task<Result<void>> aimPrecisely(Hands& hands, app::Workbench& bench, KnownMark mark) {
    PMTS_STEP(refine(hands, bench, mark));
    PMTS_STEP(measure(hands, bench));
    PMTS_STEP(refine(hands, bench, mark));
    PMTS_STEP(refine(hands, bench, mark));
    co_return {};
}

/// D, M and R one by one, with a picture of each.
Task<Result<void>> recordStepByStep(Hands& hands, app::Workbench& bench) {
    PMTS_STEP(measure(hands, bench));
    PMTS_STEP(hands.freshFrame());
    hands.hover(hands.liveView(), QPointF(hands.liveView().width(), hands.liveView().height()) / 2);
    hands.shoot(u"06-measured.png"_qs);
    PMTS_STEP(hands.press(Qt::Key_M));
    PMTS_STEP(hands.until(u"the distance was not converted to E, N, H"_qs, kScreenLimit, [&bench] {
        return bench.recording.readings().shot == app::ShotState::kConverted;
    }));
    PMTS_STEP(hands.press(Qt::Key_R));
    PMTS_STEP(hands.until(u"the point was not recorded"_qs, kScreenLimit,
                          [&bench] { return bench.recording.readings().shot == app::ShotState::kRecorded; }));
    co_return {};
}

Task<Result<void>> recordAtOnce(Hands& hands, app::Workbench& bench) {
    const auto before = bench.points.points().size();
    PMTS_STEP(hands.press(Qt::Key_Space));
    PMTS_STEP(hands.until(u"Space did not record a point"_qs, kMeasureLimit,
                          [&bench, before] { return bench.points.points().size() == before + 1; }));
    co_return {};
}

Task<Result<void>> nameNextPoint(Hands& hands, app::Workbench& bench, QString id, QString code) {
    PMTS_STEP(hands.press(Qt::Key_P));
    hands.type(&hands.root(), "id", id);
    hands.type(&hands.root(), "code", code);
    hands.pressIn(&hands.root(), "code", Qt::Key_Return);
    PMTS_STEP(hands.until(u"the next point was not named"_qs, kScreenLimit, [&bench, id, code] {
        return bench.recording.pointId() == id && bench.recording.code() == code;
    }));
    co_return {};
}

/// The first picture of the job: capture, aim in the still, turn with Enter.
Task<Result<void>> captureAndAim(Hands& hands, app::Workbench& bench) {
    PMTS_STEP(hands.press(Qt::Key_C));
    PMTS_STEP(hands.until(u"no still was captured"_qs, kScreenLimit,
                          [&bench] { return bench.live.still().has_value(); }));
    auto* const still = hands.root().findChild<ImageView*>(u"still_view"_qs);
    PMTS_STEP(hands.settle());
    hands.click(*still, QPointF(still->width() * 0.62, still->height() * 0.44));
    PMTS_STEP(hands.until(u"the click in the still did not become the target"_qs, kScreenLimit, [&bench] {
        return bench.targeting.target() && !bench.targeting.target()->ha_text.isEmpty();
    }));
    PMTS_STEP(hands.freshFrame());
    hands.hover(*still, QPointF(still->width() * 0.62, still->height() * 0.44));
    hands.shoot(u"04-still-target.png"_qs);
    PMTS_STEP(hands.press(Qt::Key_Return));
    PMTS_STEP(waitForArrival(hands, bench, u"the clicked target"_qs));
    for (const int arrow : {Qt::Key_Right, Qt::Key_Up}) {
        PMTS_STEP(hands.press(static_cast<Qt::Key>(arrow)));
        PMTS_STEP(waitForArrival(hands, bench, u"the next step"_qs));
    }
    co_return {};
}

Result<void> compare(const app::Workbench& bench, const RehearsalPlan& plan) {
    const survey::Station& station = bench.station.station();
    double worst_m = 0.0;
    for (const KnownMark& mark : plan.marks) {
        const survey::Point* const point = bench.points.findId(mark.name);
        if (point == nullptr) {
            return tl::unexpected(failed(u"point %1 is not in the job"_qs.arg(mark.name)));
        }
        const double e_m = point->coordinates.e_m - (station.e_m + mark.x_m);
        const double n_m = point->coordinates.n_m - (station.n_m + mark.y_m);
        const double h_m = point->coordinates.h_m - (station.h_m + station.instrument_height_m + mark.z_m);
        const double off_m = std::sqrt(e_m * e_m + n_m * n_m + h_m * h_m);
        std::printf("%-6s off by %6.1f mm (E %+6.1f, N %+6.1f, H %+6.1f)\n", qPrintable(mark.name),
                    off_m * 1e3, e_m * 1e3, n_m * 1e3, h_m * 1e3);
        worst_m = std::max(worst_m, off_m);
    }
    std::printf("largest difference from the truth: %.1f mm\n", worst_m * 1e3);
    std::fflush(stdout);
    if (worst_m > plan.largest_error_m) {
        return tl::unexpected(
            failed(u"a recorded point is %1 mm from its mark"_qs.arg(worst_m * 1e3, 0, 'f', 1)));
    }
    return {};
}

Task<Result<void>> measureMarks(Hands& hands, app::Workbench& bench, std::vector<KnownMark> marks) {
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const QString code = QString::fromLatin1(kCodes[i % std::size(kCodes)]);
        PMTS_STEP(swingTo(hands, bench, marks[i]));
        PMTS_STEP(aimPrecisely(hands, bench, marks[i]));
        PMTS_STEP(nameNextPoint(hands, bench, marks[i].name, code));
        if (i == 0) {
            PMTS_STEP(recordStepByStep(hands, bench));
        } else {
            PMTS_STEP(recordAtOnce(hands, bench));
        }
    }
    PMTS_STEP(hands.freshFrame());
    hands.shoot(u"07-recorded.png"_qs);
    co_return {};
}

/// A double-click in the table turns to the first point; the plan shows them all.
Task<Result<void>> turnFromTable(Hands& hands, app::Workbench& bench) {
    hands.doubleClickFirstRow(u"table"_qs, hands.field().pointsDock());
    PMTS_STEP(hands.until(u"the double-click in the table started no move"_qs, kScreenLimit,
                          [&bench] { return bench.targeting.isMoving(); }));
    PMTS_STEP(waitForArrival(hands, bench, u"the point of the table"_qs));
    hands.field().showPage(hands.field().planDock());
    PMTS_STEP(hands.freshFrame());
    hands.shoot(u"08-plan.png"_qs);
    hands.field().showPage(hands.field().pointsDock());
    co_return {};
}

Task<Result<void>> exportPoints(Hands& hands, QString path) {
    PMTS_STEP(hands.press(Qt::Key_E, Qt::ControlModifier));
    QWidget* const dialog = hands.window(u"ExportDialog"_qs);
    if (dialog == nullptr) {
        co_return tl::unexpected(failed(u"the export dialog did not open"_qs));
    }
    hands.type(dialog, "path", path);
    hands.clickText(dialog, u"Save"_qs);
    PMTS_STEP(hands.until(u"the points were not exported"_qs, kScreenLimit,
                          [path] { return QFileInfo(path).size() > 0; }));
    co_return {};
}

Task<Result<void>> showDialog(Hands& hands, Qt::Key key, QString name, QString picture,
                              Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    PMTS_STEP(hands.press(key, modifiers));
    PMTS_STEP(hands.until(u"%1 did not open"_qs.arg(name), kScreenLimit,
                          [&hands, name] { return hands.window(name) != nullptr; }));
    QWidget* const dialog = hands.window(name);
    PMTS_STEP(hands.settle());
    hands.shootWith(dialog, picture);
    hands.closeWindow(dialog);
    co_return {};
}

Task<Result<void>> showLooks(Hands& hands) {
    const FieldActions& actions = hands.actions();
    const std::pair<QAction*, const char*> palettes[] = {
        {actions.night, "14-night.png"}, {actions.sun, "15-sun.png"}, {actions.day, nullptr}};
    for (const auto& [palette, picture] : palettes) {
        palette->trigger();
        PMTS_STEP(hands.freshFrame());
        if (picture != nullptr) {
            hands.shoot(QString::fromLatin1(picture));
        }
    }
    PMTS_STEP(hands.press(Qt::Key_F11));
    PMTS_STEP(hands.freshFrame());
    hands.shoot(u"16-only-live-view.png"_qs);
    PMTS_STEP(hands.press(Qt::Key_F11));
    PMTS_STEP(hands.press(Qt::Key_5, Qt::ControlModifier));
    PMTS_STEP(hands.settle());
    hands.shoot(u"17-line.png"_qs);
    PMTS_STEP(hands.press(Qt::Key_1, Qt::ControlModifier));
    co_return {};
}

}  // namespace

Task<Result<void>> rehearse(MainWindow& window, app::Workbench& bench, RehearsalPlan plan) {
    Hands hands(window, bench, plan.folder);
    hands.shoot(u"01-start.png"_qs);
    PMTS_STEP(waitForStart(hands, bench));
    PMTS_STEP(hands.freshFrame());
    hands.shoot(u"02-live.png"_qs);
    PMTS_STEP(setUpStation(hands, bench));
    PMTS_STEP(captureAndAim(hands, bench));
    PMTS_STEP(measureMarks(hands, bench, plan.marks));
    PMTS_STEP(turnFromTable(hands, bench));
    PMTS_STEP(showDialog(hands, Qt::Key_E, u"EvidenceDialog"_qs, u"09-evidence.png"_qs));
    PMTS_STEP(showDialog(hands, Qt::Key_A, u"AimingDialog"_qs, u"18-aiming.png"_qs, Qt::ShiftModifier));
    PMTS_STEP(showDialog(hands, Qt::Key_U, u"UnitsDialog"_qs, u"11-units.png"_qs));
    PMTS_STEP(showDialog(hands, Qt::Key_I, u"ConnectionDialog"_qs, u"12-connection.png"_qs));
    PMTS_STEP(showDialog(hands, Qt::Key_F1, u"KeysDialog"_qs, u"13-keys.png"_qs));
    PMTS_STEP(showLooks(hands));
    PMTS_STEP(exportPoints(hands, QDir(plan.folder).filePath(u"points.csv"_qs)));
    co_return compare(bench, plan);
}

}  // namespace pmts::gui
