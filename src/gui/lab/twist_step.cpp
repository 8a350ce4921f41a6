#include "twist_step.hpp"

#include "field/overlay_strokes.hpp"
#include "pmts/gui/theme.hpp"
#include "parts/quantity_edit.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

namespace pmts::gui {

TwistStep::TwistStep(app::TwistPresenter& twist, const app::Preferences& preferences, QWidget* parent)
    : LabPanel(parent), twist_(twist), preferences_(preferences) {
    addHeading(tr("Twist of the camera"));
    value_ = addValue("twist");
    quality_ = addText("quality");
    auto* const tolerance_row = addRow();
    auto* const label = new QLabel(tr("&Good below"), this);
    tolerance_ = new QuantityEdit(this);
    tolerance_->setObjectName(QStringLiteral("tolerance"));
    tolerance_->setKind(QuantityEdit::Kind::kAngle);
    label->setBuddy(tolerance_);
    tolerance_row->addWidget(label);
    tolerance_row->addWidget(tolerance_, 1);
    verify_ = addButton(tr("Verify"), "verify");
    accept_ = addButton(tr("Take it into the rig"), "accept");
    proof_ = addText("proof");
    QLabel* const hint = addText();
    hint->setText(tr("Two lines in view? Click the plumb line. A twist that stays in the camera is no harm once the rig knows it."));
    addStretch();
    connect(verify_, &QPushButton::clicked, &twist_, &app::TwistPresenter::verify);
    connect(accept_, &QPushButton::clicked, &twist_, &app::TwistPresenter::accept);
    connect(tolerance_, &QuantityEdit::understood, this, [this](const QString& text) {
        if (const auto tolerance = preferences_.units().parseAngle(text)) {
            twist_.setTolerance(*tolerance);
        }
    });
    connect(&twist_, &app::TwistPresenter::changed, this, &TwistStep::showAll);
    showAll();
}

void TwistStep::showAll() {
    showStep(twist_.state(), twist_.step());
    value_->setText(twist_.twistText());
    quality_->setText(twist_.qualityText());
    proof_->setText(twist_.proofText());
    tolerance_->setUnits(preferences_.units());
    if (!tolerance_->hasFocus() || !tolerance_->isModified()) {
        tolerance_->setText(preferences_.units().angle(twist_.tolerance()));
    }
    verify_->setEnabled(twist_.twist().has_value() && !twist_.isVerifying());
    accept_->setEnabled(twist_.twist().has_value());
    Q_EMIT overlayChanged();
}

bool TwistStep::pictureClicked(const QPointF& frame_px) {
    twist_.click(frame_px);
    return true;
}

void TwistStep::paintOver(QPainter& painter, const QTransform& widget_from_frame) {
    const std::vector<QPointF>& line = twist_.line();
    if (line.size() < 2) {
        return;
    }
    QPainterPath path(widget_from_frame.map(line.front()));
    for (const QPointF& place : line) {
        path.lineTo(widget_from_frame.map(place));
    }
    const Theme& theme = currentTheme();
    strokeEdged(painter, path, twist_.state() == app::DeviceState::kGood ? theme.good : theme.warning, theme);
    drawEdgedText(painter, widget_from_frame.map(line[line.size() / 4]) + QPointF(12, 0), twist_.twistText(), theme);
}

}  // namespace pmts::gui
