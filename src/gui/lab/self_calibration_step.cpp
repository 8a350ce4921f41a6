#include "self_calibration_step.hpp"

#include "calibration_plots.hpp"
#include "correlation_table.hpp"
#include "field/overlay_strokes.hpp"
#include "pmts/app/field/method_page.hpp"
#include "pmts/gui/theme.hpp"
#include "parts/text_table.hpp"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

namespace pmts::gui {
namespace {

constexpr int kButton_px = 48;  ///< a gloved finger
constexpr int kResult_px = 300;
constexpr double kMark_px = 14.0;

QPushButton* bigButton(const QString& text, const char* name, QWidget* parent) {
    auto* const button = new QPushButton(text, parent);
    button->setObjectName(QLatin1String(name));
    button->setMinimumHeight(kButton_px);
    return button;
}

QCheckBox* bigCheck(const QString& text, const char* name, QWidget* parent) {
    auto* const check = new QCheckBox(text, parent);
    check->setObjectName(QLatin1String(name));
    check->setMinimumHeight(kButton_px - 8);
    return check;
}

QLabel* wrapped(const char* name, QWidget* parent) {
    auto* const label = new QLabel(parent);
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QVBoxLayout* column(QWidget* widget) {
    auto* const layout = new QVBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    return layout;
}

}  // namespace

SelfCalibrationStep::SelfCalibrationStep(app::SelfCalibrationPresenter& calibration, QWidget* parent)
    : LabStep(parent),
      calibration_(calibration),
      step_(wrapped("self_step", this)),
      message_(wrapped("self_message", this)) {
    buildChoices();
    buildWait();
    buildResult();
    auto* const all = new QVBoxLayout(this);
    all->addWidget(step_);
    all->addWidget(message_);
    all->addWidget(choices_);
    all->addWidget(wait_);
    all->addWidget(result_, 1);
    all->addStretch(0);
    wire();
    showAll();
}

void SelfCalibrationStep::buildChoices() {
    choices_ = new QWidget(this);
    measure_ = bigCheck(tr("Measure the distance of the spot"), "self_measure", choices_);
    handle_ = bigCheck(tr("The camera is on the handle"), "self_handle", choices_);
    sighted_ = bigCheck(tr("The cross-hair is on the spot"), "self_sighted", choices_);
    sighted_->setToolTip(
        tr("A camera on the handle shows its yaw and pitch only against a direction the telescope gives."));
    calibrate_ = bigButton(tr("Calibrate"), "self_calibrate", choices_);
    further_ = bigButton(tr("Add this spot"), "self_further", choices_);
    auto* const buttons = new QHBoxLayout;
    buttons->addWidget(calibrate_, 1);
    buttons->addWidget(further_, 1);
    QVBoxLayout* const layout = column(choices_);
    layout->addWidget(measure_);
    layout->addWidget(handle_);
    layout->addWidget(sighted_);
    layout->addLayout(buttons);
}

void SelfCalibrationStep::buildWait() {
    wait_ = new QWidget(this);
    bar_ = new QProgressBar(wait_);
    bar_->setTextVisible(false);
    progress_ = wrapped("self_progress", wait_);
    cancel_ = bigButton(tr("Cancel"), "self_cancel", wait_);
    QVBoxLayout* const layout = column(wait_);
    layout->addWidget(progress_);
    layout->addWidget(bar_);
    layout->addWidget(cancel_);
}

void SelfCalibrationStep::buildResult() {
    result_ = new QWidget(this);
    verdict_ = wrapped("self_verdict", result_);
    quality_ = wrapped("self_quality", result_);
    table_ = new QTableWidget(result_);
    table_->setObjectName(QStringLiteral("self_table"));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::NoSelection);
    vectors_ = new ResidualPlot(ResidualPlot::Kind::kVectors, result_);
    radius_ = new ResidualPlot(ResidualPlot::Kind::kRadius, result_);
    correlation_ = new CorrelationTable(result_);
    tabs_ = new QTabWidget(result_);
    tabs_->setObjectName(QStringLiteral("self_tabs"));
    tabs_->addTab(table_, tr("Result"));
    tabs_->addTab(vectors_, tr("Frame"));
    tabs_->addTab(radius_, tr("Radius"));
    tabs_->setTabToolTip(tabs_->addTab(correlation_, tr("Pairs")), tr("Correlation of the parameters, two by two"));
    tabs_->tabBar()->setExpanding(true);
    tabs_->setMinimumHeight(kResult_px);
    accept_ = bigButton(tr("Accept"), "self_accept", result_);
    reject_ = bigButton(tr("Reject"), "self_reject", result_);
    compare_ = bigButton(tr("Compare with the one before"), "self_compare", result_);
    compare_->setCheckable(true);
    auto* const buttons = new QHBoxLayout;
    buttons->addWidget(accept_, 1);
    buttons->addWidget(reject_, 1);
    QVBoxLayout* const layout = column(result_);
    layout->addLayout(buttons);
    layout->addWidget(verdict_);
    layout->addWidget(quality_);
    layout->addWidget(tabs_, 1);
    layout->addWidget(compare_);
}

void SelfCalibrationStep::wire() {
    using Presenter = app::SelfCalibrationPresenter;
    connect(measure_, &QCheckBox::toggled, &calibration_, &Presenter::setMeasuresRange);
    connect(sighted_, &QCheckBox::toggled, &calibration_, &Presenter::setSighted);
    connect(handle_, &QCheckBox::toggled, &calibration_, &Presenter::setOnHandle);
    connect(handle_, &QCheckBox::toggled, sighted_, &QWidget::setVisible);
    connect(calibrate_, &QPushButton::clicked, &calibration_, [this] { calibration_.calibrate(); });
    connect(further_, &QPushButton::clicked, &calibration_, [this] { calibration_.calibrate(true); });
    connect(cancel_, &QPushButton::clicked, &calibration_, &Presenter::cancel);
    connect(accept_, &QPushButton::clicked, &calibration_, &Presenter::accept);
    connect(reject_, &QPushButton::clicked, &calibration_, &Presenter::reject);
    connect(compare_, &QPushButton::toggled, &calibration_, &Presenter::compareWithBefore);
    connect(&calibration_, &Presenter::changed, this, &SelfCalibrationStep::showAll);
    connect(&calibration_, &Presenter::progressChanged, this, &SelfCalibrationStep::showProgress);
    connect(&calibration_, &Presenter::refused, message_, [this](const QString& sentence) {
        message_->setText(sentence);
        message_->show();
    });
    measure_->setChecked(calibration_.measuresRange());
    handle_->setChecked(calibration_.onHandle());
    sighted_->setChecked(calibration_.isSighted());
    sighted_->setVisible(calibration_.onHandle());
}

void SelfCalibrationStep::showAll() {
    const bool busy = calibration_.isBusy();
    step_->setText(calibration_.step());
    message_->clear();
    message_->hide();
    choices_->setVisible(!busy && (calibration_.canCalibrate() || !calibration_.view()));
    calibrate_->setEnabled(calibration_.canCalibrate());
    further_->setVisible(calibration_.spots() > 0);
    further_->setEnabled(calibration_.canCalibrate());
    wait_->setVisible(busy);
    result_->setVisible(!busy && calibration_.view().has_value());
    showProgress();
    showResult();
    Q_EMIT stateChanged(calibration_.state());
    Q_EMIT overlayChanged();
}

void SelfCalibrationStep::showProgress() {
    const app::SelfCalibrationProgress& progress = calibration_.progress();
    const bool counts = calibration_.phase() == app::SelfCalibrationPhase::kSweeping;
    bar_->setMaximum(counts ? progress.of : 0);
    bar_->setValue(progress.done);
    progress_->setText(counts ? progress.sentence : QString());
    progress_->setVisible(counts);
}

void SelfCalibrationStep::showResult() {
    const auto& view = calibration_.view();
    if (!view) {
        return;
    }
    verdict_->setText(view->verdict.join(QStringLiteral("\n")));
    quality_->setText(view->quality);
    app::TextTable texts;
    texts.header = {tr("Parameter"), tr("Value"), tr("Change")};
    for (const app::CalibratedParameter& row : view->parameters) {
        texts.rows.push_back({row.name, row.value + u'\n' + row.deviation, row.change});  // two lines: room for the name
    }
    texts.plain_rows = static_cast<int>(texts.rows.size());
    showTexts(*table_, texts);
    table_->setToolTip(tr("Change: against %1").arg(calibration_.comparedWith()));
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);  // long names wrap
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    const DrawnResiduals residuals = residualsOf(*view);
    vectors_->showResiduals(residuals);
    radius_->showResiduals(residuals);
    correlation_->showView(*view);
    compare_->setVisible(calibration_.canCompareWithBefore());
}

bool SelfCalibrationStep::pictureClicked(const QPointF& frame_px) {
    calibration_.pickSpot(frame_px);
    return true;  // in this step a click never aims
}

/// A square around the picked spot.
void SelfCalibrationStep::paintOver(QPainter& painter, const QTransform& widget_from_frame) {
    const auto spot = calibration_.spotPx();
    if (!spot) {
        return;
    }
    const QPointF at = widget_from_frame.map(*spot);
    const Theme& theme = currentTheme();
    QPainterPath mark = boxPath(at, kMark_px);
    mark.addPath(crossPath(at, kMark_px / 2));
    strokeEdged(painter, mark, theme.accent, theme);
    drawEdgedText(painter, at + QPointF(kMark_px + 6, 5), tr("spot"), theme);
}

}  // namespace pmts::gui
