#include "field_workspace.hpp"

#include "depth_popup.hpp"
#include "field_actions.hpp"
#include "parts/fitting_scroll_area.hpp"
#include "live_panel.hpp"
#include "line/log_page.hpp"
#include "loupe.hpp"
#include "picture_input.hpp"
#include "plan_page.hpp"
#include "planned_page.hpp"
#include "point_entry.hpp"
#include "points_page.hpp"
#include "range_dialog.hpp"
#include "readings_panel.hpp"
#include "still_view.hpp"
#include "zoom_box_page.hpp"

#include <QDataStream>
#include <QDockWidget>
#include <QIODevice>
#include <QVBoxLayout>

#include <algorithm>

namespace pmts::gui {
namespace {

constexpr int kLayoutVersion = 2;  ///< 2: the page of planned points
constexpr int kRightColumn_px = 390;
constexpr int kLeastLower_px = 150;

QDockWidget* withoutTitle(QDockWidget* dock) {
    auto* const none = new QWidget(dock);
    none->setFixedHeight(0);
    dock->setTitleBarWidget(none);
    return dock;
}

}  // namespace

FieldWorkspace::FieldWorkspace(app::Workbench& bench, const FieldActions& actions, QWidget* parent)
    : QMainWindow(parent, Qt::Widget),
      bench_(bench),
      live_(new LivePanel(bench.live, bench.targeting, this)),
      still_(new StillView(bench.live, bench.still_filters, this)),
      loupe_(new Loupe(this)),
      tools_(new PictureTools(actions, this)),
      zoom_box_(new ZoomBoxPage(this)),
      depth_(new DepthPopup(bench.ranges, this)),
      readings_(new ReadingsPanel(this)),
      entry_(new PointEntry(bench.recording, bench.preferences, this)),
      points_(new PointsPage(bench.points, bench.undo, this)),
      plan_(new PlanPage(bench.plan, bench.preferences, this)),
      planned_(new PlannedPage(bench.planned, this)) {
    live_->setActions(actions);
    setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks |
                   QMainWindow::AllowNestedDocks | QMainWindow::GroupedDragging);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    buildMiddle();
    buildDocks();
    wirePages();
    wirePictures(actions);
    wireLoupe();
}

void FieldWorkspace::buildMiddle() {
    lower_ = new QSplitter(Qt::Horizontal, this);
    lower_->addWidget(still_);
    lower_->addWidget(loupe_);
    lower_->setStretchFactor(0, 3);
    lower_->setStretchFactor(1, 2);
    middle_ = new QSplitter(Qt::Vertical, this);
    middle_->addWidget(live_);
    middle_->addWidget(lower_);
    middle_->setStretchFactor(0, 5);
    middle_->setStretchFactor(1, 2);
    middle_->setChildrenCollapsible(true);
    setCentralWidget(middle_);
}

QDockWidget* FieldWorkspace::addPage(const QString& title, const QString& name, QWidget* page) {
    auto* const dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(page);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    docks_.append(dock);
    return dock;
}

void FieldWorkspace::buildDocks() {
    auto* const desk = new QWidget(this);
    auto* const column = new QVBoxLayout(desk);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(readings_);
    column->addWidget(new FittingScrollArea(entry_, desk));
    readings_dock_ = addPage(tr("Readings"), QStringLiteral("readings_dock"), desk);
    readings_dock_->setFeatures(QDockWidget::DockWidgetMovable);
    withoutTitle(readings_dock_);
    desk->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    points_dock_ = addPage(tr("Points"), QStringLiteral("points_dock"), points_);
    plan_dock_ = addPage(tr("Plan"), QStringLiteral("plan_dock"), plan_);
    planned_dock_ = addPage(tr("Planned"), QStringLiteral("planned_dock"), planned_);
    QDockWidget* const log_dock = addPage(tr("Log"), QStringLiteral("log_dock"),
                                          new LogPage(bench_.log, LogPage::Least::kNoWire, this));
    zoom_box_dock_ = addPage(tr("Zoom box"), QStringLiteral("zoom_box_dock"), zoom_box_);
    for (QDockWidget* dock : {points_dock_, plan_dock_, planned_dock_, log_dock, zoom_box_dock_}) {
        withoutTitle(dock);
    }
    tabifyDockWidget(points_dock_, plan_dock_);
    tabifyDockWidget(points_dock_, planned_dock_);
    tabifyDockWidget(points_dock_, log_dock);
    tabifyDockWidget(points_dock_, zoom_box_dock_);
    zoom_box_dock_->hide();  // until somebody draws a box
    points_dock_->raise();
    resizeDocks({readings_dock_}, {kRightColumn_px}, Qt::Horizontal);
}

void FieldWorkspace::wirePages() {
    connect(&bench_.recording, &app::RecordingPresenter::readingsChanged, this,
            [this] { readings_->showReadings(bench_.recording.readings()); });
    connect(entry_, &PointEntry::typingEnded, this, [this] { live_->view().setFocus(); });
    connect(points_, &PointsPage::turnRequested, this, &FieldWorkspace::turnToPoint);
    connect(points_, &PointsPage::pointSelected, this, &FieldWorkspace::selectPoint);
    connect(points_, &PointsPage::planeRequested, &bench_.plane_range, &app::PlaneRange::use);
    connect(points_, &PointsPage::orientRequested, &bench_.station, &app::StationPresenter::orientToPoint);
    connect(points_, &PointsPage::evidenceRequested, &bench_.evidence, &app::EvidencePresenter::load);
    connect(planned_, &PlannedPage::turnRequested, this, &FieldWorkspace::turnToPlanned);
    connect(planned_, &PlannedPage::pointSelected, plan_, &PlanPage::selectPlanned);
    connect(planned_, &PlannedPage::importRequested, this, &FieldWorkspace::importPlannedRequested);
    connect(plan_, &PlanPage::plannedTurnRequested, this, &FieldWorkspace::turnToPlanned);
    connect(plan_, &PlanPage::plannedSelected, planned_, &PlannedPage::selectPoint);
    connect(plan_, &PlanPage::turnRequested, this, &FieldWorkspace::turnToPoint);
    connect(plan_, &PlanPage::pointSelected, points_, &PointsPage::selectPoint);
    readings_->showReadings(bench_.recording.readings());
    const auto show_circles = [this](app::ConnectionState state) {
        readings_->setCirclesLive(state == app::ConnectionState::kConnected);
    };
    connect(&bench_.instrument, &app::InstrumentDesk::connectionChanged, this, show_circles);
    show_circles(bench_.instrument.connectionState());
}

/// Everything that is a picture answers to the same hand.
void FieldWorkspace::wirePictures(const FieldActions& actions) {
    using app::Picture;
    wireInput(*new PictureInput(live_->view(), Picture::kLive, bench_, *tools_));
    wireInput(*new PictureInput(*still_, Picture::kStill, bench_, *tools_));
    wireInput(*(loupe_input_ = new PictureInput(*loupe_, Picture::kLive, bench_, *tools_)));
    wireInput(*(zoom_box_input_ = new PictureInput(zoom_box_->view(), Picture::kLive, bench_, *tools_)));
    connect(&bench_.routines, &app::ImageRoutines::zoomBoxAsked, this, &FieldWorkspace::openZoomBox);
    connect(live_, &LivePanel::overlayChanged, this, [this] { refreshCopies(true); });
    connect(still_, &StillView::overlayChanged, this, [this] { refreshCopies(false); });
    connect(live_, &LivePanel::rangeRequested, actions.range, &QAction::trigger);
    connect(actions.range, &QAction::triggered, this, &FieldWorkspace::openRange);
    connect(live_, &LivePanel::depthRequested, depth_, &DepthPopup::openAbove);
    actions.snap->setChecked(bench_.snap.isOn());
    connect(actions.snap, &QAction::toggled, &bench_.snap, &app::SnapPresenter::setOn);
}

void FieldWorkspace::wireInput(PictureInput& input) {
    connect(&input, &PictureInput::pointChosen, points_, &PointsPage::selectPoint);
    connect(&input, &PictureInput::plannedChosen, planned_, &PlannedPage::selectPoint);
}

void FieldWorkspace::wireLoupe() {
    loupe_->setZoom(bench_.preferences.settings().image_tools.loupe_magnification);
    connect(&live_->view(), &ImageView::hovered, this, [this](const QPointF& px) { showLoupe(true, px); });
    connect(still_, &ImageView::hovered, this, [this](const QPointF& px) { showLoupe(false, px); });
    connect(loupe_, &ImageView::zoomChanged, this, [this](double zoom) {
        app::Settings next = bench_.preferences.settings();
        next.image_tools.loupe_magnification = zoom;
        bench_.preferences.set(next);
    });
}

void FieldWorkspace::showLoupe(bool on_live, const QPointF& px) {
    const ImageView& picture = on_live ? live_->view() : *still_;
    loupe_on_live_ = on_live;
    loupe_input_->setPicture(on_live ? app::Picture::kLive : app::Picture::kStill);
    loupe_->showAround(picture.frame(), px);
    loupe_->showOverlay(picture.overlay());
}

/// Loupe and zoom box show what their picture shows.
void FieldWorkspace::refreshCopies(bool of_live) {
    const ImageView& picture = of_live ? live_->view() : *still_;
    if (loupe_on_live_ == of_live && loupe_->isVisible() && loupe_->place()) {
        loupe_->follow(picture.frame());
        loupe_->showOverlay(picture.overlay());
    }
    const bool boxed_live = zoom_box_->picture() == app::Picture::kLive;
    if (boxed_live == of_live && zoom_box_->hasBox() && zoom_box_->isVisible()) {
        zoom_box_->show(picture.frame(), picture.overlay());
    }
}

void FieldWorkspace::openZoomBox(app::Picture picture, const QRectF& box_px) {
    zoom_box_->open(picture, box_px);
    zoom_box_input_->setPicture(picture);
    showPage(zoom_box_dock_);
    const ImageView& shown = picture == app::Picture::kLive ? live_->view() : *still_;
    zoom_box_->show(shown.frame(), shown.overlay());
}

void FieldWorkspace::openRange() {
    auto* const dialog = new RangeDialog(bench_.ranges, bench_.preferences.units(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

/// The live view as large as its picture can fill; still and loupe share what is left.
void FieldWorkspace::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (sized_) {
        return;
    }
    sized_ = true;
    const int bar = live_->height() - live_->view().height();
    const int picture = centralWidget()->width() * 9 / 16 + bar;
    const int rest = std::max(kLeastLower_px, middle_->height() - picture);
    middle_->setSizes({middle_->height() - rest, rest});
    lower_->setSizes({lower_->width() * 3 / 5, lower_->width() * 2 / 5});
}

void FieldWorkspace::selectPoint(qint64 row_id) {
    plan_->selectPoint(row_id);
    live_->selectPoint(row_id);
    still_->selectPoint(row_id);
}

void FieldWorkspace::turnToPoint(qint64 row_id) {
    bench_.targeting.moveToPoint(row_id);
    live_->view().setFocus();  // the arrow keys are the telescope's again
}

void FieldWorkspace::turnToPlanned(qint64 row_id) {
    if (const survey::PlannedPoint* point = bench_.planned.find(row_id)) {
        bench_.targeting.moveToPlanned(*point);
        live_->view().setFocus();
    }
}

void FieldWorkspace::showEvidence() {
    const auto& all = bench_.points.points();
    if (const auto selected = points_->selectedPoint()) {
        bench_.evidence.load(*selected);
    } else if (!all.empty()) {
        bench_.evidence.load(all.back().row_id);
    } else {
        bench_.messages.toast(tr("No point is recorded yet."));
    }
}

void FieldWorkspace::startTypingPoint() {
    readings_dock_->show();
    entry_->startTyping();
}

void FieldWorkspace::showPage(QDockWidget* dock) {
    dock->show();
    dock->raise();
}

void FieldWorkspace::setFocusMode(bool on) {
    entry_->setVisible(!on);
    lower_->setVisible(!on);
    if (on) {
        hidden_by_focus_.clear();
        for (QDockWidget* dock : docks_) {
            if (dock != readings_dock_ && !dock->isHidden()) {
                hidden_by_focus_.append(dock);
                dock->hide();
            }
        }
        return;
    }
    for (QDockWidget* dock : std::exchange(hidden_by_focus_, {})) {
        dock->show();
    }
    points_dock_->raise();
}

QByteArray FieldWorkspace::layoutState() const {
    QByteArray state;
    QDataStream out(&state, QIODevice::WriteOnly);
    out << kLayoutVersion << saveState(kLayoutVersion) << middle_->saveState() << lower_->saveState();
    return state;
}

void FieldWorkspace::restoreLayout(const QByteArray& state) {
    QDataStream in(state);
    int version = 0;
    QByteArray docks, middle, lower;
    in >> version >> docks >> middle >> lower;
    if (in.status() != QDataStream::Ok || version != kLayoutVersion) {
        return;
    }
    sized_ = true;
    restoreState(docks, kLayoutVersion);
    middle_->restoreState(middle);
    lower_->restoreState(lower);
}

}  // namespace pmts::gui
