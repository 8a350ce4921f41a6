#include "lab_workspace.hpp"

#include "camera_step.hpp"
#include "board_step.hpp"
#include "check_step.hpp"
#include "field/depth_popup.hpp"
#include "field/field_actions.hpp"
#include "lab_step.hpp"
#include "field/live_panel.hpp"
#include "mount_step.hpp"
#include "window/page_list.hpp"
#include "parallax_step.hpp"
#include "field/picture_input.hpp"
#include "self_calibration_step.hpp"
#include "profiles_step.hpp"
#include "report_step.hpp"
#include "table_step.hpp"
#include "twist_step.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace pmts::gui {
namespace {

constexpr int kPanel_px = 400;
constexpr int kLeastPanel_px = 372;  ///< a table of a calibration with whole words
constexpr int kMargin_px = 8;

QScrollArea* scrolled(LabStep* step, QWidget* parent) {
    auto* const area = new QScrollArea(parent);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(step);
    return area;
}

}  // namespace

LabWorkspace::LabWorkspace(app::Workbench& bench, const FieldActions& actions, QWidget* parent)
    : QWidget(parent),
      panels_(new QStackedWidget(this)),
      list_(new PageList(*panels_, this)),
      readings_(new QLabel(this)),
      live_(new LivePanel(bench.live, bench.targeting, this)) {
    list_->setObjectName(QStringLiteral("lab_steps"));
    list_->setAccessibleName(tr("Steps of the laboratory"));
    auto* const left = new QVBoxLayout;
    left->setSpacing(0);
    left->addWidget(list_, 1);
    left->addWidget(readings_);
    readings_->setFixedWidth(PageList::kWidth_px);
    readings_->setMargin(kMargin_px);
    readings_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* const split = new QSplitter(Qt::Horizontal, this);
    split->addWidget(live_);
    split->addWidget(panels_);
    panels_->setMinimumWidth(kLeastPanel_px);
    split->setStretchFactor(0, 1);
    split->setSizes({3 * kPanel_px, kLeastPanel_px});
    split->setChildrenCollapsible(false);
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addLayout(left);
    row->addWidget(split, 1);
    wireLive(bench, actions);
    addSteps(bench);
    const auto show_readings = [this, &recording = bench.recording] { showReadings(recording.readings()); };
    connect(&bench.recording, &app::RecordingPresenter::readingsChanged, this, show_readings);
    show_readings();
    connect(list_, &PageList::enteredPageChanged, this, &LabWorkspace::showOverlay);
    list_->setCurrentRow(0);
}

/// One line for each step, in the order of the work.
void LabWorkspace::addSteps(app::Workbench& bench) {
    auto* const camera = new CameraStep(bench.camera);
    add(camera, QStringLiteral("camera_step"));
    connect(camera, &CameraStep::formatRequested, this, &LabWorkspace::formatRequested);
    add(new MountStep(bench.mount, bench.preferences, panels_), QStringLiteral("mount"));
    add(new TwistStep(bench.twist, bench.preferences, panels_), QStringLiteral("twist"));
    add(new ParallaxStep(bench.board_parallax, bench.preferences, panels_), QStringLiteral("parallax"));
    add(new TableStep(bench.distortion_table, panels_), QStringLiteral("table"));
    add(new SelfCalibrationStep(bench.self_calibration, panels_), QStringLiteral("self_calibration"));
    add(new BoardStep(bench.board, panels_), QStringLiteral("boards"));
    add(new CheckStep(bench.check, bench.profiles, bench.points, panels_), QStringLiteral("check"));
    add(new ProfilesStep(bench.profiles, panels_), QStringLiteral("profiles"));
    add(new ReportStep(bench.profiles, bench.preferences, panels_), QStringLiteral("report"));
}

void LabWorkspace::add(LabStep* step, const QString& object_name) {
    list_->add(step, scrolled(step, panels_), object_name);
    connect(step, &LabStep::overlayChanged, this, &LabWorkspace::showOverlay);
}

LabStep* LabWorkspace::entered() const { return static_cast<LabStep*>(list_->enteredPage()); }

void LabWorkspace::wireLive(app::Workbench& bench, const FieldActions& actions) {
    live_->setActions(actions);
    live_->hideFieldTools();
    auto* const tools = new PictureTools(actions, this);
    auto* const input = new PictureInput(live_->view(), app::Picture::kLive, bench, *tools);
    input->setFirstUse([this](const QPointF& px) { return entered() != nullptr && entered()->pictureClicked(px); });
    live_->view().setPaintOver([this](QPainter& painter, const QTransform& widget_from_frame) {
        if (entered() != nullptr) {
            entered()->paintOver(painter, widget_from_frame);
        }
    });
    connect(live_, &LivePanel::rangeRequested, actions.range, &QAction::trigger);
    connect(live_, &LivePanel::depthRequested, new DepthPopup(bench.ranges, this), &DepthPopup::openAbove);
    connect(live_, &LivePanel::cancelRequested, actions.stop, &QAction::trigger);
}

void LabWorkspace::showReadings(const app::Readings& readings) {
    readings_->setText(tr("HA  %1\nVA  %2\nSD  %3").arg(readings.ha, readings.va, readings.sd));
    readings_->setToolTip(tr("Angles in %1, distances in %2").arg(readings.angle_unit, readings.length_unit));
}

LabStep* LabWorkspace::current() const { return static_cast<LabStep*>(list_->chosenPage()); }

void LabWorkspace::openStep(const QString& object_name) { list_->openPage(object_name); }

void LabWorkspace::showOverlay() {
    live_->setReticleShown(entered() == nullptr || !entered()->wantsClearCentre());
    live_->view().update();
}

void LabWorkspace::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    list_->setWorkspaceShown(true);
}

void LabWorkspace::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    list_->setWorkspaceShown(false);
}

}  // namespace pmts::gui
