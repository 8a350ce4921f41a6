#pragma once

#include "action_button.hpp"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace pmts::gui {

/// A push button large enough for a glove.
inline QPushButton* labButton(const QString& text, const char* object_name, QWidget* parent) {
    auto* const button = new QPushButton(text, parent);
    button->setObjectName(QLatin1String(object_name));
    button->setMinimumHeight(ActionButton::kLeastSide_px);
    return button;
}

/// A text that wraps and can be copied.
inline QLabel* labText(const char* object_name, QWidget* parent) {
    auto* const label = new QLabel(parent);
    label->setObjectName(QLatin1String(object_name));
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

inline QLabel* labHeading(const QString& text, QWidget* parent) {
    auto* const label = new QLabel(text, parent);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

}  // namespace pmts::gui
