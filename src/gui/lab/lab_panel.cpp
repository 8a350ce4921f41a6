#include "lab_panel.hpp"

#include "parts/state_lamp.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace pmts::gui {
namespace {

constexpr int kButton_px = 44;  ///< a gloved finger
constexpr int kMargin_px = 12;
constexpr int kSpace_px = 8;
constexpr double kStepFont = 1.2;
constexpr double kValueFont = 2.2;
constexpr int kStepLines = 3;  ///< room for the longest sentence: nothing jumps while it changes

QFont scaled(QFont font, double factor, bool bold) {
    font.setPointSizeF(font.pointSizeF() * factor);
    font.setBold(bold);
    return font;
}

}  // namespace

LabPanel::LabPanel(QWidget* parent) : LabStep(parent), column_(new QVBoxLayout(this)), lamp_(new StateLamp(this)), sentence_(new QLabel(this)) {
    column_->setContentsMargins(kMargin_px, kMargin_px, kMargin_px, kMargin_px);
    column_->setSpacing(kSpace_px);
    sentence_->setObjectName(QStringLiteral("step"));
    sentence_->setWordWrap(true);
    sentence_->setFont(scaled(font(), kStepFont, true));
    sentence_->setMinimumHeight(kStepLines * QFontMetrics(sentence_->font()).lineSpacing());
    sentence_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* const head = new QHBoxLayout;
    head->addWidget(lamp_, 0, Qt::AlignTop);
    head->addWidget(sentence_, 1);
    column_->addLayout(head);
}

void LabPanel::showStep(app::DeviceState state, const QString& sentence) {
    lamp_->setState(state);
    sentence_->setText(sentence);
    if (state != std::exchange(state_, state)) {
        Q_EMIT stateChanged(state);
    }
}

QPushButton* LabPanel::addButton(const QString& text, const char* object_name, QLayout* row) {
    auto* const button = new QPushButton(text, this);
    button->setObjectName(QString::fromLatin1(object_name));
    button->setMinimumHeight(kButton_px);
    (row != nullptr ? row : column_)->addWidget(button);
    return button;
}

QLabel* LabPanel::addText(const char* object_name) {
    auto* const label = new QLabel(this);
    label->setObjectName(QString::fromLatin1(object_name != nullptr ? object_name : ""));
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column_->addWidget(label);
    return label;
}

QLabel* LabPanel::addValue(const char* object_name) {
    QLabel* const label = addText(object_name);
    label->setFont(scaled(font(), kValueFont, true));
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return label;
}

QLabel* LabPanel::addHeading(const QString& text) {
    QLabel* const label = addText();
    label->setProperty("heading", true);
    label->setText(text);
    return label;
}

QHBoxLayout* LabPanel::addRow() {
    auto* const row = new QHBoxLayout;
    row->setSpacing(kSpace_px);
    column_->addLayout(row);
    return row;
}

void LabPanel::addStretch() { column_->addStretch(1); }

}  // namespace pmts::gui
