#include "parallax_step.hpp"

#include "field/overlay_strokes.hpp"
#include "pmts/gui/theme.hpp"
#include "parts/quantity_edit.hpp"

#include <QButtonGroup>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

namespace pmts::gui {
namespace {

constexpr double kMark_px = 12.0;
constexpr int kTouch_px = 34;

QCheckBox* check(const QString& text, const char* name, QLayout* row, QWidget* parent) {
    auto* const box = new QCheckBox(text, parent);
    box->setObjectName(QString::fromLatin1(name));
    box->setMinimumHeight(kTouch_px);
    row->addWidget(box);
    return box;
}

}  // namespace

ParallaxStep::ParallaxStep(app::ParallaxPresenter& parallax, const app::Preferences& preferences, QWidget* parent)
    : LabPanel(parent), parallax_(parallax), preferences_(preferences) {
    buildCase();
    buildStages();
    advice_ = addText("advice");
    addHeading(tr("Gap on the near board"));
    gap_ = addText("gap");
    addHeading(tr("Offsets of the camera (right, forward, up)"));
    offsets_ = addText("offsets");
    auto* const ends = addRow();
    accept_ = addButton(tr("Accept"), "accept", ends);
    again_ = addButton(tr("Start again"), "again", ends);
    proof_ = addText("proof");
    steps_ = addText("steps");
    steps_->setTextFormat(Qt::PlainText);
    addStretch();
    connect(accept_, &QPushButton::clicked, &parallax_, &app::ParallaxPresenter::accept);
    connect(again_, &QPushButton::clicked, &parallax_, &app::ParallaxPresenter::startAgain);
    connect(&parallax_, &app::ParallaxPresenter::changed, this, &ParallaxStep::showAll);
    showAll();
}

void ParallaxStep::buildCase() {
    auto* const row = addRow();
    row->addWidget(new QLabel(tr("Sought:"), this));
    x_ = check(tr("Xo"), "x", row, this);
    y_ = check(tr("Yo"), "y", row, this);
    z_ = check(tr("Zo"), "z", row, this);
    row->addStretch(1);
    others_ = check(tr("The others are as in the rig, not zero"), "others", &column(), this);
    for (QCheckBox* const box : {x_, y_, z_, others_}) {
        connect(box, &QCheckBox::clicked, this, &ParallaxStep::takeCase);
    }
}

void ParallaxStep::buildStages() {
    stages_ = new QButtonGroup(this);
    auto* const row = addRow();
    const std::pair<app::ParallaxStage, QString> all[] = {{app::ParallaxStage::kFar, tr("Far")},
                                                          {app::ParallaxStage::kNear, tr("Near")},
                                                          {app::ParallaxStage::kAside, tr("Aside")},
                                                          {app::ParallaxStage::kVerify, tr("Verify")}};
    for (const auto& [stage, text] : all) {
        QPushButton* const button = addButton(text, "stage", row);
        button->setCheckable(true);
        stages_->addButton(button, static_cast<int>(stage));
    }
    connect(stages_, &QButtonGroup::idClicked, this, [this](int id) { parallax_.setStage(static_cast<app::ParallaxStage>(id)); });
    auto* const distance_row = addRow();
    measure_ = addButton(tr("Measure distance"), "measure", distance_row);
    distance_ = new QuantityEdit(this);
    distance_->setObjectName(QStringLiteral("distance"));
    distance_->setKind(QuantityEdit::Kind::kLength);
    distance_->setAccessibleName(tr("Distance to the mark"));
    distance_->setToolTip(tr("Measured, or typed while the telescope is on the mark"));
    distance_row->addWidget(distance_, 1);
    connect(measure_, &QPushButton::clicked, &parallax_, &app::ParallaxPresenter::measure);
    connect(distance_, &QuantityEdit::understood, this, [this](const QString& text) {
        if (const auto metres = preferences_.units().parseLengthM(text); metres && text != parallax_.distanceText()) {
            parallax_.setDistance(*metres);
        }
    });
}

void ParallaxStep::takeCase() {
    parallax_.setSought({.x = x_->isChecked(), .y = y_->isChecked(), .z = z_->isChecked(), .others_are_known = others_->isChecked()});
}

void ParallaxStep::showAll() {
    showStep(parallax_.state(), parallax_.step());
    const calibration::OffsetCase& sought = parallax_.sought();
    x_->setChecked(sought.x);
    y_->setChecked(sought.y);
    z_->setChecked(sought.z);
    others_->setChecked(sought.others_are_known);
    const auto stage = parallax_.stage();
    stages_->setExclusive(false);
    for (QAbstractButton* const button : stages_->buttons()) {
        button->setChecked(stages_->id(button) == static_cast<int>(stage));
    }
    stages_->setExclusive(true);
    measure_->setEnabled(!parallax_.isMeasuring() && stage != app::ParallaxStage::kAside);
    distance_->setUnits(preferences_.units());
    if (!distance_->hasFocus() || !distance_->isModified()) {
        distance_->setText(parallax_.distanceText());
    }
    advice_->setText(parallax_.boardsAdvice());
    gap_->setText(parallax_.gapText());
    offsets_->setText(parallax_.offsetsText());
    accept_->setEnabled(parallax_.canAccept());
    proof_->setText(parallax_.proofText());
    proof_->setVisible(!parallax_.proofText().isEmpty());
    showSteps();
    Q_EMIT overlayChanged();
}

void ParallaxStep::showSteps() {
    QStringList lines;
    for (const app::ParallaxStep& step : parallax_.steps()) {
        lines.append((step.done ? QStringLiteral("✓ ") : step.current ? QStringLiteral("▶ ") : QStringLiteral("    ")) + step.text);
    }
    steps_->setText(lines.join(u'\n'));
}

bool ParallaxStep::pictureClicked(const QPointF& frame_px) {
    if (parallax_.stage() == app::ParallaxStage::kAccept) {
        return false;
    }
    parallax_.click(frame_px);
    return true;
}

void ParallaxStep::paintOver(QPainter& painter, const QTransform& widget_from_frame) {
    if (const auto clicked = parallax_.clickedPixel()) {
        strokeEdged(painter, crossPath(widget_from_frame.map(*clicked), kMark_px), currentTheme().good, currentTheme());
    }
}

}  // namespace pmts::gui
