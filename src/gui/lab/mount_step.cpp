#include "mount_step.hpp"

#include "field/overlay_strokes.hpp"
#include "pmts/gui/theme.hpp"
#include "parts/quantity_edit.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

namespace pmts::gui {

MountStep::MountStep(app::MountPresenter& mount, const app::Preferences& preferences, QWidget* parent)
    : LabPanel(parent), mount_(mount), preferences_(preferences) {
    auto* const tilt_row = addRow();
    auto* const label = new QLabel(tr("&Turn of VA"), this);
    tilt_ = new QuantityEdit(this);
    tilt_->setObjectName(QStringLiteral("tilt"));
    tilt_->setKind(QuantityEdit::Kind::kAngle);
    label->setBuddy(tilt_);
    tilt_row->addWidget(label);
    tilt_row->addWidget(tilt_, 1);
    auto* const buttons = addRow();
    check_ = addButton(tr("Check"), "check", buttons);
    cancel_ = addButton(tr("Cancel"), "cancel", buttons);
    verdict_ = addHeading({});
    verdict_->setObjectName(QStringLiteral("verdict"));
    evidence_ = addText("evidence");
    addHeading(tr("The camera is on"));
    auto* const kinds = addRow();
    telescope_ = addButton(tr("Telescope"), "telescope", kinds);
    handle_ = addButton(tr("Handle"), "handle", kinds);
    profile_ = addText("profile");
    for (QPushButton* const kind : {telescope_, handle_}) {
        kind->setCheckable(true);
    }
    addStretch();
    connect(check_, &QPushButton::clicked, &mount_, &app::MountPresenter::start);
    connect(cancel_, &QPushButton::clicked, &mount_, &app::MountPresenter::cancel);
    connect(telescope_, &QPushButton::clicked, this, [this] {
        mount_.accept(camera::MountKind::kTelescope);
        showAll();
    });
    connect(handle_, &QPushButton::clicked, this, [this] {
        mount_.accept(camera::MountKind::kHandle);
        showAll();
    });
    connect(tilt_, &QuantityEdit::understood, this, [this](const QString& text) {
        if (const auto tilt = preferences_.units().parseAngle(text)) {
            mount_.setTilt(*tilt);
        }
    });
    connect(&mount_, &app::MountPresenter::changed, this, &MountStep::showAll);
    showAll();
}

void MountStep::showAll() {
    showStep(mount_.state(), mount_.step());
    tilt_->setUnits(preferences_.units());
    if (!tilt_->hasFocus() || !tilt_->isModified()) {
        tilt_->setText(preferences_.units().angle(mount_.tilt()));
    }
    check_->setEnabled(!mount_.isBusy());
    cancel_->setEnabled(mount_.isBusy());
    verdict_->setText(mount_.verdict());
    evidence_->setText(mount_.evidence());
    telescope_->setChecked(mount_.kindInUse() == camera::MountKind::kTelescope);
    handle_->setChecked(mount_.kindInUse() == camera::MountKind::kHandle);
    telescope_->setEnabled(!mount_.isBusy());
    handle_->setEnabled(!mount_.isBusy());
    profile_->setText(mount_.profileText());
    Q_EMIT overlayChanged();
}

/// Where the details went.
void MountStep::paintOver(QPainter& painter, const QTransform& widget_from_frame) {
    if (!mount_.check()) {
        return;
    }
    QPainterPath moves;
    for (const calibration::MovedDetail& detail : mount_.check()->details) {
        const QPointF from(detail.px.x(), detail.px.y());
        const QPointF to = from + QPointF(detail.moved_px.x(), detail.moved_px.y());
        moves.addPath(circlePath(widget_from_frame.map(from), 4));
        moves.moveTo(widget_from_frame.map(from));
        moves.lineTo(widget_from_frame.map(to));
    }
    strokeEdged(painter, moves, currentTheme().good, currentTheme());
}

}  // namespace pmts::gui
