#include "check_step.hpp"

#include "parts/lab_parts.hpp"
#include "pmts/gui/theme.hpp"

#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QPainter>
#include <QSignalBlocker>
#include <QTableWidget>

namespace pmts::gui {
namespace {

constexpr double kArrow = 10.0;  ///< residuals are drawn this many times enlarged

}  // namespace

CheckStep::CheckStep(app::CheckPresenter& check, app::ProfilesPresenter& profiles, const app::PointsModel& points, QWidget* parent)
    : LabStep(parent), check_(check), profiles_(profiles), points_(points) {
    auto* const column = new QVBoxLayout(this);
    concerns_ = labText("check_concerns", this);
    place_ = new QComboBox(this);
    place_->setObjectName(QStringLiteral("check_place"));
    place_->setAccessibleName(tr("Known place"));
    place_->setMinimumHeight(ActionButton::kLeastSide_px);
    telescope_ = labButton(tr("What the telescope points at"), "check_telescope", this);
    step_ = labText("check_sentence", this);
    run_ = labButton(tr("Start the check"), "check_run", this);
    hand_ = labButton(tr("Take this one by hand"), "check_hand", this);
    hand_->setToolTip(tr("Keeps the click at the present pointing: turn by hand to five places of the picture."));
    cancel_ = labButton(tr("Cancel"), "check_cancel", this);
    verdict_ = labText("check_verdict", this);
    QFont bold = verdict_->font();
    bold.setBold(true);
    verdict_->setFont(bold);
    history_ = new QTableWidget(0, 3, this);
    history_->setObjectName(QStringLiteral("check_history"));
    history_->setAccessibleName(tr("Checks of this profile"));
    history_->setHorizontalHeaderLabels({tr("Checked"), tr("px / mgon"), tr("Result")});
    history_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    history_->horizontalHeader()->setStretchLastSection(true);
    history_->verticalHeader()->hide();
    history_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    history_->setMinimumHeight(150);
    auto* const grid = new QGridLayout;
    grid->addWidget(run_, 0, 0);
    grid->addWidget(cancel_, 0, 1);
    grid->addWidget(hand_, 1, 0, 1, 2);
    column->addWidget(concerns_);
    column->addWidget(labHeading(tr("1  Known place"), this));
    column->addWidget(place_);
    column->addWidget(telescope_);
    column->addWidget(labHeading(tr("2  Click it in the live view, then start"), this));
    column->addWidget(step_);
    column->addLayout(grid);
    column->addWidget(verdict_);
    column->addWidget(labHeading(tr("History"), this));
    column->addWidget(history_);
    column->addStretch(1);
    connect(place_, &QComboBox::activated, this, &CheckStep::choosePlace);
    connect(telescope_, &QPushButton::clicked, &check_, &app::CheckPresenter::useTelescope);
    connect(run_, &QPushButton::clicked, &check_, &app::CheckPresenter::run);
    connect(hand_, &QPushButton::clicked, &check_, &app::CheckPresenter::takeByHand);
    connect(cancel_, &QPushButton::clicked, &check_, &app::CheckPresenter::cancel);
    connect(&check_, &app::CheckPresenter::changed, this, &CheckStep::showAll);
    connect(&profiles_, &app::ProfilesPresenter::changed, this, &CheckStep::showHistory);
    connect(&points_, &app::PointsModel::pointsChanged, this, &CheckStep::fillPoints);
    fillPoints();
    showAll();
    showHistory();
}

void CheckStep::fillPoints() {
    const QSignalBlocker quiet(place_);
    const QVariant kept = place_->currentData();
    place_->clear();
    place_->addItem(tr("Choose a recorded point"), QVariant());
    for (const auto& point : points_.points()) {
        if (!point.struck_out && point.observation.slope_distance_m) {
            place_->addItem(tr("Point %1  %2").arg(point.id, point.code).trimmed(), point.row_id);
        }
    }
    place_->setCurrentIndex(std::max(0, place_->findData(kept)));
}

void CheckStep::choosePlace(int index) {
    if (const QVariant row_id = place_->itemData(index); row_id.isValid()) {
        check_.usePoint(row_id.toLongLong());
    }
}

bool CheckStep::pictureClicked(const QPointF& frame_px) {
    const bool takes = check_.place().has_value() && check_.stage() != app::CheckStage::kRunning;
    if (takes) {
        check_.click(frame_px);
    }
    return takes;
}

bool CheckStep::wantsClearCentre() const {
    return check_.place().has_value() && (check_.stage() == app::CheckStage::kIdle || check_.stage() == app::CheckStage::kReady);
}

void CheckStep::showAll() {
    const bool runs = check_.stage() == app::CheckStage::kRunning;
    const bool is_clicked = check_.clicked().has_value();
    step_->setText(check_.trouble().isEmpty() ? check_.step() : check_.trouble());
    step_->setVisible(!check_.trouble().isEmpty() || check_.stage() != app::CheckStage::kDone);  // then the verdict speaks
    run_->setEnabled(!runs && is_clicked);
    hand_->setEnabled(!runs && is_clicked);
    cancel_->setEnabled(runs);
    place_->setEnabled(!runs);
    telescope_->setEnabled(!runs);
    verdict_->setText(check_.verdict());
    verdict_->setVisible(check_.result().has_value());
    const app::DeviceState state = runs ? app::DeviceState::kBusy
                                   : check_.result() ? (check_.result()->passed ? app::DeviceState::kGood : app::DeviceState::kFailed)
                                                     : app::DeviceState::kIdle;
    Q_EMIT stateChanged(state);
    Q_EMIT overlayChanged();
}

void CheckStep::showHistory() {
    const app::RigProfile profile = profiles_.inUse().profile;
    concerns_->setText(profiles_.concerns().join(u'\n'));
    concerns_->setVisible(!profiles_.concerns().isEmpty());
    history_->setRowCount(static_cast<int>(profile.checks.size()));
    for (int row = 0; row < history_->rowCount(); ++row) {
        const app::RigCheck& check = profile.checks[profile.checks.size() - 1 - static_cast<std::size_t>(row)];
        history_->setItem(row, 0, new QTableWidgetItem(check.utc.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"))));
        history_->setItem(row, 1, new QTableWidgetItem(QStringLiteral("%1 / %2").arg(check.rms_px, 0, 'f', 2).arg(check.rms.gon() * 1000, 0, 'f', 1)));
        history_->setItem(row, 2, new QTableWidgetItem(check.passed ? tr("passed") : tr("failed")));
    }
}

void CheckStep::paintOver(QPainter& painter, const QTransform& widget_from_frame) {
    const Theme& theme = currentTheme();
    const auto twice = [&](const QColor& colour, auto draw) {  // a dark and a light edge read on any ground
        painter.setPen(QPen(Qt::black, 4));
        draw();
        painter.setPen(QPen(colour, 2));
        draw();
    };
    painter.setBrush(Qt::NoBrush);
    if (check_.stage() != app::CheckStage::kIdle) {
        for (const Eigen::Vector2d& px : check_.placesInPicture()) {
            const QPointF at = widget_from_frame.map(QPointF(px.x(), px.y()));
            twice(Qt::white, [&] { painter.drawEllipse(at, 9, 9); });
        }
    }
    if (check_.clicked() && check_.stage() == app::CheckStage::kReady) {
        const QPointF at = widget_from_frame.map(*check_.clicked());
        twice(theme.accent, [&] { painter.drawLine(at - QPointF(14, 0), at + QPointF(14, 0)), painter.drawLine(at - QPointF(0, 14), at + QPointF(0, 14)); });
    }
    if (check_.stage() == app::CheckStage::kDone && check_.result()) {
        for (const app::RecordedResidual& residual : check_.result()->residuals) {
            const Eigen::Vector2d end = residual.px + kArrow * residual.residual_px;
            twice(theme.accent, [&] {
                const QPointF from = widget_from_frame.map(QPointF(residual.px.x(), residual.px.y()));
                painter.drawEllipse(from, 4, 4);
                painter.drawLine(from, widget_from_frame.map(QPointF(end.x(), end.y())));
            });
        }
    }
}

}  // namespace pmts::gui
