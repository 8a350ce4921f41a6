#include "pmts/gui/main_window.hpp"

#include "action_watch.hpp"
#include "field/aiming_dialog.hpp"
#include "field/arrow_hold.hpp"
#include "line/black_box_page.hpp"
#include "lab/camera_actions.hpp"
#include "connection_dialog.hpp"
#include "field/evidence_dialog.hpp"
#include "field/field_actions.hpp"
#include "field/field_workspace.hpp"
#include "key_guard.hpp"
#include "message_area.hpp"
#include "lab/lab_workspace.hpp"
#include "line/line_workspace.hpp"
#include "field/live_panel.hpp"
#include "line/replay_bar.hpp"
#include "parts/roomy_lists.hpp"
#include "small_dialogs.hpp"
#include "sounds.hpp"
#include "field/station_dialog.hpp"
#include "ui_main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDataStream>
#include <QFileDialog>
#include <QIODevice>
#include <QScreen>

#include <algorithm>

namespace pmts::gui {
namespace {

constexpr int kLayoutVersion = 1;
constexpr int kField = static_cast<int>(ModeBar::Mode::kField);
constexpr int kLab = static_cast<int>(ModeBar::Mode::kLab);
constexpr int kLine = static_cast<int>(ModeBar::Mode::kLine);
constexpr double kTextStep = 0.1;
constexpr QSize kFirstSize(1440, 900);
constexpr QSize kFrameRoom(4, 40);  ///< title bar and frame of the window

PaletteName nameOf(app::Palette palette) { return static_cast<PaletteName>(palette); }

app::Palette paletteOf(PaletteName name) { return static_cast<app::Palette>(name); }

static_assert(static_cast<int>(PaletteName::kDay) == static_cast<int>(app::Palette::kDay));
static_assert(static_cast<int>(PaletteName::kNight) == static_cast<int>(app::Palette::kNight));
static_assert(static_cast<int>(PaletteName::kSun) == static_cast<int>(app::Palette::kSun));

}  // namespace

MainWindow::MainWindow(app::Workbench& bench, QWidget* parent)
    : QMainWindow(parent),
      bench_(bench),
      ui_(std::make_unique<Ui::MainWindow>()),
      base_points_(QApplication::font().pointSizeF()) {
    ui_->setupUi(this);
    setWindowIcon(QIcon(QStringLiteral(":/pmts/icons/pmts.svg")));
    new RoomyLists(this);  // before the first choice takes its looks
    actions_ = new FieldActions(this);
    usePalette(nameOf(bench_.preferences.settings().palette));
    buildWorkspaces();
    buildMenus();
    wireMainJob();
    wirePages();
    wireBars();
    wireLook();
    auto* const camera = new CameraActions(*actions_, bench_, this);
    connect(connection_, &ConnectionDialog::formatRequested, camera, &CameraActions::openFormat);
    connect(lab_, &LabWorkspace::formatRequested, camera, &CameraActions::openFormat);
    new ActionWatch(*bench_.black_box, *this);
    if (bench_.replay) {
        ui_->actionBar->hide();  // nothing can be turned or measured
        addToolBar(Qt::BottomToolBarArea, new ReplayBar(*bench_.replay, this));
    }
    new KeyGuard([this] { return stopWhatMoves(); }, this);
    restoreLook();
    showStatus();
    field_->live().view().setFocus();
}

MainWindow::~MainWindow() = default;

void MainWindow::buildWorkspaces() {
    field_ = new FieldWorkspace(bench_, *actions_, this);
    lab_ = new LabWorkspace(bench_, *actions_, this);
    ui_->workspaces->addWidget(field_);
    ui_->workspaces->addWidget(lab_);
    line_ = new LineWorkspace(bench_, this);
    ui_->workspaces->addWidget(line_);
    ui_->actionBar->setActions(*actions_);
    ui_->actionBar->showStep(bench_.targeting.stepText());
}

void MainWindow::wireMainJob() {
    const FieldActions& a = *actions_;
    app::TargetingPresenter& targeting = bench_.targeting;
    app::RecordingPresenter& recording = bench_.recording;
    connect(a.capture, &QAction::triggered, &bench_.live, &app::LivePresenter::capture);
    connect(a.move, &QAction::triggered, &targeting, &app::TargetingPresenter::move);
    connect(a.measure, &QAction::triggered, &recording, &app::RecordingPresenter::measure);
    connect(a.convert, &QAction::triggered, &recording, &app::RecordingPresenter::convert);
    connect(a.record, &QAction::triggered, &recording, &app::RecordingPresenter::record);
    connect(a.record_again, &QAction::triggered, &recording, &app::RecordingPresenter::recordAgain);
    connect(a.all, &QAction::triggered, &recording, &app::RecordingPresenter::all);
    connect(a.move_open, &QAction::triggered, &targeting, &app::TargetingPresenter::moveWithoutPicture);
    showAiming();
    connect(a.recentre, &QAction::toggled, &targeting, &app::TargetingPresenter::setRecentring);
    connect(a.click_turns, &QAction::toggled, &targeting, &app::TargetingPresenter::setClickTurns);
    connect(&targeting, &app::TargetingPresenter::aimingChanged, this, &MainWindow::showAiming);
    connect(a.change_face, &QAction::triggered, &targeting, &app::TargetingPresenter::changeFace);
    connect(a.clear_target, &QAction::triggered, &targeting, &app::TargetingPresenter::clearTarget);
    new ArrowHold(a, bench_.steps, this);
    connect(a.stop, &QAction::triggered, this, [this] {
        bench_.steps.released();
        bench_.targeting.stop();
        bench_.recording.cancel();
        bench_.live.cancelCapture();
        shownLive().view().setFocus();
    });
    connect(a.edit_point, &QAction::triggered, field_, &FieldWorkspace::startTypingPoint);
    connect(&field_->live(), &LivePanel::cancelRequested, a.stop, &QAction::trigger);
    connect(&targeting, &app::TargetingPresenter::stepChanged, ui_->actionBar, &ActionBar::showStep);
}

bool MainWindow::stopWhatMoves() {
    if (!bench_.instrument.isBusy() && !bench_.recording.isBusy()) {
        return false;
    }
    actions_->stop->trigger();
    return true;
}

void MainWindow::wirePages() {
    const FieldActions& a = *actions_;
    connect(a.new_job, &QAction::triggered, this, &MainWindow::chooseNewJob);
    connect(a.open_job, &QAction::triggered, this, &MainWindow::chooseJob);
    connect(a.export_points, &QAction::triggered, this, &MainWindow::chooseExport);
    connect(a.import_planned, &QAction::triggered, this, &MainWindow::choosePlanned);
    connect(field_, &FieldWorkspace::importPlannedRequested, this, &MainWindow::choosePlanned);
    connect(a.evidence, &QAction::triggered, field_, &FieldWorkspace::showEvidence);
    connect(&bench_.evidence, &app::EvidencePresenter::loaded, this, &MainWindow::openEvidence);
    connect(a.quit, &QAction::triggered, this, &QWidget::close);
    connect(a.station, &QAction::triggered, this, &MainWindow::openStation);
    connect(a.step, &QAction::triggered, this, &MainWindow::openStep);
    connect(a.aim, &QAction::triggered, this, &MainWindow::openAim);
    connect(a.aiming, &QAction::triggered, this, &MainWindow::openAiming);
    connect(a.units, &QAction::triggered, this, &MainWindow::openUnits);
    connect(a.keys, &QAction::triggered, this, &MainWindow::openKeys);
    connect(a.about, &QAction::triggered, this, &MainWindow::openAbout);
    connection_ = new ConnectionDialog(bench_, this);
    connect(connection_, &ConnectionDialog::controlRequested, this, &MainWindow::openControl);
    connect(a.connection, &QAction::triggered, this,
            [this] { connection_->openPage(ConnectionDialog::Page::kInstrument); });
    connect(a.open_black_box, &QAction::triggered, this, [this] { openBlackBoxBeside(this, bench_.black_box->folder()); });
    connect(a.bug_report, &QAction::triggered, this, [this] {
        showMode(kLine);
        line_->openPage(QStringLiteral("black_box_page"));
    });
    connect(a.field, &QAction::triggered, this, [this] { showMode(kField); });
    connect(a.lab, &QAction::triggered, this, [this] { showMode(kLab); });
    connect(a.line, &QAction::triggered, this, [this] { showMode(kLine); });
    connect(ui_->modeBar, &ModeBar::modeChosen, this,
            [this](ModeBar::Mode mode) { showMode(static_cast<int>(mode)); });
}

void MainWindow::wireBars() {
    connect(&bench_.status, &app::StatusPresenter::changed, this, &MainWindow::showStatus);
    connect(ui_->topBar, &TopBar::jobClicked, this, [this] {
        auto* const menu = new QMenu(this);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->addActions({actions_->new_job, actions_->open_job, actions_->export_points});
        menu->addSeparator();
        fillRecentJobs(menu);
        menu->popup(ui_->topBar->mapToGlobal(QPoint(0, ui_->topBar->height())));
    });
    connect(ui_->topBar, &TopBar::stationClicked, actions_->station, &QAction::trigger);
    connect(ui_->topBar, &TopBar::instrumentClicked, actions_->connection, &QAction::trigger);
    connect(ui_->topBar, &TopBar::controlClicked, this, &MainWindow::openControl);
    connect(ui_->topBar, &TopBar::cameraClicked, this,
            [this] { connection_->openPage(ConnectionDialog::Page::kCamera); });
    connect(ui_->topBar, &TopBar::gateClicked, actions_->line, &QAction::trigger);
    app::MessageCentre& messages = bench_.messages;
    connect(&messages, &app::MessageCentre::toastShown, this,
            [this](const app::Message& message) { showToast(message.happened); });
    connect(&messages, &app::MessageCentre::barsChanged, this,
            [this] { ui_->messages->showBars(bench_.messages.bars()); });
    connect(ui_->messages, &MessageArea::dismissed, &messages, &app::MessageCentre::dismiss);
    connect(ui_->messages, &MessageArea::actionChosen, this, &MainWindow::doMessageAction);
    ui_->messages->showBars(messages.bars());
}

void MainWindow::doMessageAction(app::MessageAction action) {
    using app::MessageAction;
    switch (action) {
        case MessageAction::kNone:
            break;
        case MessageAction::kOpenConnectionPage:
            actions_->connection->trigger();
            break;
        case MessageAction::kReconnect:
            bench_.connection.connectSerial(bench_.connection.serialChoice());
            break;
        case MessageAction::kOpenJob:
            chooseJob();
            break;
        case MessageAction::kRetryRecord:
        case MessageAction::kRecordSameId:
            bench_.recording.record();
            break;
        case MessageAction::kShowLog:
            showMode(kLine);
            line_->openPage(QStringLiteral("log_page"));
            break;
        case MessageAction::kOpenSettings:
            openUnits();
            break;
        case MessageAction::kTurnWithoutPicture:
            bench_.targeting.moveWithoutPicture();
            break;
        case MessageAction::kTurnTheLongWay:
            bench_.targeting.moveTheLongWay();
            break;
        case MessageAction::kCheckRig:
            showMode(kLab);
            lab_->openStep(QStringLiteral("check"));
            break;
        case MessageAction::kTakeControl:
            bench_.control.takeControl();
            break;
        case MessageAction::kOpenControlPage:
            openControl();
            break;
        case MessageAction::kAcceptBlock:
            bench_.recording.acceptBlock();
            break;
    }
}

void MainWindow::showStatus() {
    const app::StatusLine& line = bench_.status.line();
    ui_->topBar->showLine(line);
    for (LivePanel* const live : {&field_->live(), &lab_->live()}) {
        live->showBusy(line.busy_shown, line.busy_text, line.busy_fraction);
    }
    if (bench_.replay) {
        return setWindowTitle(tr("Recording – PMTS"));
    }
    setWindowTitle(line.job.text.isEmpty() ? QStringLiteral("PMTS")
                                           : QStringLiteral("%1 – PMTS").arg(line.job.text));
}

void MainWindow::openLab(const QString& step) {
    lab_->openStep(step);
    showMode(kLab);
}

void MainWindow::openControl() {
    showMode(kLine);
    line_->openPage(QStringLiteral("control_page"));
}

void MainWindow::showMode(int mode) {
    ui_->workspaces->setCurrentIndex(mode);
    ui_->modeBar->setMode(static_cast<ModeBar::Mode>(mode));
    if (mode != kLine) {
        shownLive().view().setFocus();
    }
}

void MainWindow::showToast(const QString& text) {
    if (ui_->workspaces->currentWidget() != line_) {
        return shownLive().showToast(text);
    }
    if (line_toast_ == nullptr) {
        line_toast_ = new Toast(line_);
    }
    line_toast_->showText(text);
}

LivePanel& MainWindow::shownLive() const {
    return ui_->workspaces->currentWidget() == lab_ ? lab_->live() : field_->live();
}

void MainWindow::setFocusMode(bool on) {
    showMode(kField);
    ui_->topBar->setVisible(!on);
    ui_->modeBar->setVisible(!on);
    menuBar()->setVisible(!on);
    field_->setFocusMode(on);
}

void MainWindow::showAiming() {
    const app::AimingSettings& aiming = bench_.preferences.settings().aiming;
    actions_->recentre->setChecked(aiming.recentre);
    actions_->click_turns->setChecked(aiming.click_turns);
}

void MainWindow::wireLook() {
    const FieldActions& a = *actions_;
    connect(a.focus, &QAction::toggled, this, &MainWindow::setFocusMode);
    const std::pair<QAction*, PaletteName> palettes[] = {
        {a.day, PaletteName::kDay}, {a.night, PaletteName::kNight}, {a.sun, PaletteName::kSun}};
    for (const auto& [action, name] : palettes) {
        connect(action, &QAction::triggered, this,
                [this, name = name] { bench_.preferences.setPalette(paletteOf(name)); });
    }
    connect(&bench_.preferences, &app::Preferences::paletteChanged, this,
            [this](app::Palette palette) { usePalette(nameOf(palette)); });
    connect(a.larger_text, &QAction::triggered, this, [this] { setTextScale(text_scale_ + kTextStep); });
    connect(a.smaller_text, &QAction::triggered, this, [this] { setTextScale(text_scale_ - kTextStep); });
    auto* const sounds = new Sounds(this);
    sounds->setOn(bench_.preferences.settings().sounds);
    a.sounds->setChecked(bench_.preferences.settings().sounds);
    connect(a.sounds, &QAction::toggled, &bench_.preferences, &app::Preferences::setSounds);
    connect(a.sounds, &QAction::toggled, sounds, &Sounds::setOn);
    connect(&bench_.messages, &app::MessageCentre::cueGiven, sounds, &Sounds::play);
}

void MainWindow::usePalette(PaletteName name) {
    applyTheme(*qApp, name);
    (name == PaletteName::kDay     ? actions_->day
     : name == PaletteName::kNight ? actions_->night
                                   : actions_->sun)
        ->setChecked(true);
}

void MainWindow::setTextScale(double scale) {
    text_scale_ = std::clamp(scale, kSmallestText, kLargestText);
    QFont font = QApplication::font();
    font.setPointSizeF(base_points_ * text_scale_);
    QApplication::setFont(font);
    applyTheme(*qApp, currentTheme().name);
}

void MainWindow::keepLayout() {
    QByteArray layout;
    QDataStream out(&layout, QIODevice::WriteOnly);
    out << kLayoutVersion << field_->layoutState() << text_scale_;
    bench_.preferences.setWindow(saveGeometry(), layout);
}

void MainWindow::restoreLook() {
    const app::Settings& settings = bench_.preferences.settings();
    const QSize room = screen()->availableSize() - kFrameRoom;
    resize(kFirstSize.boundedTo(room));
    if (settings.window_geometry.isEmpty() && room.width() < kFirstSize.width()) {
        setWindowState(Qt::WindowMaximized);
    }
    restoreGeometry(settings.window_geometry);
    QDataStream in(settings.window_layout);
    int version = 0;
    QByteArray field;
    double scale = 1.0;
    in >> version >> field >> scale;
    if (in.status() == QDataStream::Ok && version == kLayoutVersion) {
        field_->restoreLayout(field);
        setTextScale(scale);
    }
}

void MainWindow::closeEvent(QCloseEvent* event) {
    actions_->focus->setChecked(false);  // the layout is kept as it is outside F11
    keepLayout();
    if (stopWhatMoves()) {
        bench_.messages.toast(tr("The instrument was stopped."));
    }
    event->accept();
}

}  // namespace pmts::gui
