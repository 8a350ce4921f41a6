#include "instrument_page.hpp"

#include "axis_limits_dialog.hpp"
#include "axis_test_panel.hpp"
#include "parts/lab_parts.hpp"
#include "parts/state_lamp.hpp"
#include "two_face_panel.hpp"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QSignalBlocker>
#include <QTabWidget>

#include <algorithm>

namespace pmts::gui {
namespace {

constexpr int kState_px = 360;
constexpr std::chrono::seconds kAges{5};

}  // namespace

InstrumentPage::InstrumentPage(app::InstrumentHealth& health, app::AxisTestPresenter& axis_test,
                               app::TwoFacePresenter& faces, QWidget* parent)
    : ListedPage(parent), health_(health), axis_test_(axis_test) {
    auto* const row = new QHBoxLayout(this);
    auto* const left_side = new QWidget(this);
    left_side->setFixedWidth(kState_px);
    auto* const column = new QVBoxLayout(left_side);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(makeState());
    column->addWidget(makeTargetTest());
    auto* const limits = labButton(tr("&Limits of axes and faces…"), "instrument_limits", left_side);
    connect(limits, &QPushButton::clicked, this, &InstrumentPage::editLimits);
    column->addWidget(limits);
    column->addStretch(1);
    auto* const tabs = new QTabWidget(this);
    tabs->setObjectName(QStringLiteral("instrument_tabs"));
    tabs->addTab(new AxisTestPanel(axis_test_, tabs), tr("Collimation and index"));
    tabs->addTab(new TwoFacePanel(faces, tabs), tr("Point in two faces"));
    row->addWidget(left_side);
    row->addWidget(tabs, 1);
    refresh_.setInterval(kAges);
    connect(&refresh_, &QTimer::timeout, this, &InstrumentPage::showAll);
    connect(&health_, &app::InstrumentHealth::changed, this, &InstrumentPage::showAll);
    connect(&axis_test_, &app::AxisTestPresenter::changed, this, &InstrumentPage::showAll);
    connect(&health_, &app::InstrumentHealth::questionAsked, this, &InstrumentPage::askForInstrument);
    showAll();
}

InstrumentPage::Row InstrumentPage::makeRow(const QString& name, const char* object_name, QGridLayout& grid) {
    const Row row{new StateLamp(this), new QLabel(this), labText(object_name, this)};
    const int at = grid.rowCount();
    QFont bold = row.text->font();
    bold.setBold(true);
    row.text->setFont(bold);
    grid.addWidget(row.lamp, at, 0);
    grid.addWidget(new QLabel(name, this), at, 1);
    grid.addWidget(row.text, at, 2);
    grid.addWidget(row.details, at + 1, 1, 1, 2);
    return row;
}

QWidget* InstrumentPage::makeState() {
    auto* const holder = new QWidget(this);
    auto* const column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(labHeading(tr("The instrument now"), holder));
    auto* const grid = new QGridLayout;
    grid->setColumnStretch(2, 1);
    face_ = makeRow(tr("Face"), "instrument_face", *grid);
    compensator_ = makeRow(tr("Compensator"), "instrument_compensator", *grid);
    level_ = makeRow(tr("Level"), "instrument_level", *grid);
    battery_ = makeRow(tr("Battery"), "instrument_battery", *grid);
    air_ = makeRow(tr("Air it uses"), "instrument_air", *grid);
    column->addLayout(grid);
    switch_ = labButton(QString(), "compensator_switch", holder);
    calibrate_ = labButton(tr("Cali&brate the compensator…"), "compensator_calibrate", holder);
    cancel_ = labButton(tr("&Cancel"), "compensator_cancel", holder);
    column->addWidget(switch_);
    column->addWidget(calibrate_);
    column->addWidget(cancel_);
    connect(switch_, &QPushButton::clicked, this,
            [this] { health_.switchCompensator(!health_.compensatorOn().value_or(false)); });
    connect(calibrate_, &QPushButton::clicked, this, &InstrumentPage::askBeforeCalibration);
    connect(cancel_, &QPushButton::clicked, &health_, &app::InstrumentHealth::cancel);
    return holder;
}

QWidget* InstrumentPage::makeTargetTest() {
    auto* const holder = new QWidget(this);
    auto* const column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 8, 0, 0);
    column->addWidget(labHeading(tr("Target test of PMTS"), holder));
    test_on_ = new QCheckBox(tr("A distance belongs to its pointing"), holder);
    test_on_->setObjectName(QStringLiteral("target_test_on"));
    test_on_->setMinimumHeight(ActionButton::kLeastSide_px);
    test_on_->setToolTip(
        tr("A distance measured before the telescope moved further than this is refused. The instrument has a test of "
           "its own, set at the control unit; its answer is info 4."));
    test_mgon_ = new QDoubleSpinBox(holder);
    test_mgon_->setRange(1, 1000);
    test_mgon_->setDecimals(0);
    test_mgon_->setSuffix(tr(" mgon"));
    test_cm_ = new QDoubleSpinBox(holder);
    test_cm_->setRange(1, 1000);
    test_cm_->setDecimals(0);
    test_cm_->setSuffix(tr(" cm"));
    auto* const form = new QFormLayout;
    for (auto* const box : {test_mgon_, test_cm_}) {
        box->setMinimumHeight(ActionButton::kLeastSide_px);
        connect(box, &QDoubleSpinBox::editingFinished, this, &InstrumentPage::keepTargetTest);
    }
    test_mgon_->setAccessibleName(tr("Most the pointing may move"));
    test_cm_->setAccessibleName(tr("Most the target may move"));
    form->addRow(tr("Pointing moved by"), test_mgon_);
    form->addRow(tr("At the target, to 400 m"), test_cm_);
    column->addWidget(test_on_);
    column->addLayout(form);
    connect(test_on_, &QCheckBox::toggled, this, &InstrumentPage::keepTargetTest);
    return holder;
}

void InstrumentPage::show(const Row& row, const app::StatusItem& item) {
    row.lamp->setState(item.state);
    row.text->setText(item.text);
    row.details->setText(item.details);
    row.details->setVisible(!item.details.isEmpty());
}

void InstrumentPage::showAll() {
    show(face_, health_.face());
    show(compensator_, health_.compensator());
    show(level_, health_.level());
    show(battery_, health_.battery());
    show(air_, health_.airUsed());
    if (!health_.isCalibrating()) {
        endQuestion();
    }
    const bool on = health_.compensatorOn().value_or(false);
    const bool ready = health_.canAsk() && !health_.isCalibrating();
    switch_->setText(on ? tr("Switch the compensator &off") : tr("Switch the compensator &on"));
    switch_->setEnabled(ready && health_.compensatorOn().has_value());
    calibrate_->setEnabled(ready);
    cancel_->setVisible(health_.isCalibrating());
    const QSignalBlocker quiet_on(test_on_), quiet_mgon(test_mgon_), quiet_cm(test_cm_);
    const auto& test = health_.targetTest();
    test_on_->setChecked(test.on);
    if (!test_mgon_->hasFocus() && !test_cm_->hasFocus()) {  // what is being typed stays
        test_mgon_->setValue(test.angle.mgon());
        test_cm_->setValue(test.offset_m * 100);
    }
    test_mgon_->setEnabled(test.on);
    test_cm_->setEnabled(test.on);
    const bool test_is_old = axis_test_.kept().state == app::DeviceState::kWarning;
    Q_EMIT stateChanged(test_is_old ? std::max(health_.state(), app::DeviceState::kWarning) : health_.state());
}

void InstrumentPage::entered() {
    health_.refresh();
    refresh_.start();
}

void InstrumentPage::left() { refresh_.stop(); }

void InstrumentPage::askBeforeCalibration() {
    auto* const box = new QMessageBox(QMessageBox::Question, tr("Calibrate the compensator"),
                                      tr("The instrument will turn by itself, half a turn and back, for about 20 s. Is "
                                         "its way free, and does nobody touch it?"),
                                      QMessageBox::Cancel, this);
    auto* const start = box->addButton(tr("Start"), QMessageBox::AcceptRole);
    box->setAttribute(Qt::WA_DeleteOnClose);
    connect(start, &QPushButton::clicked, &health_, &app::InstrumentHealth::calibrateCompensator);
    box->open();
}

void InstrumentPage::askForInstrument() {
    endQuestion();
    question_ = new QMessageBox(QMessageBox::Question, tr("The instrument asks"),
                                tr("The instrument waits for yes or no; look at its display for the question."),
                                QMessageBox::Yes | QMessageBox::No, this);
    question_->setObjectName(QStringLiteral("instrument_question"));
    question_->setAttribute(Qt::WA_DeleteOnClose);
    question_->setModal(false);  // STOP must be within reach
    connect(question_, &QMessageBox::finished, &health_, [this](int answer) { health_.answer(answer == QMessageBox::Yes); });
    question_->show();
}

/// Nobody waits for the answer any more.
void InstrumentPage::endQuestion() {
    if (question_) {
        question_->disconnect(&health_);
        question_->close();
        question_.clear();
    }
}

void InstrumentPage::editLimits() {
    AxisLimitsDialog dialog(axis_test_.care(), this);
    if (dialog.exec() == QDialog::Accepted) {
        axis_test_.setCare(dialog.care());
    }
}

void InstrumentPage::keepTargetTest() {
    auto test = health_.targetTest();
    test.on = test_on_->isChecked();
    test.angle = core::Angle::fromMgon(test_mgon_->value());
    test.offset_m = test_cm_->value() / 100;
    health_.setTargetTest(test);
}

}  // namespace pmts::gui
