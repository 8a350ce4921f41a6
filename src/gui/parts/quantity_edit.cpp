#include "quantity_edit.hpp"

#include <QStyle>

namespace pmts::gui {

QuantityEdit::QuantityEdit(QWidget* parent) : QLineEdit(parent) {
    setLayoutDirection(Qt::LeftToRight);  // numbers with their unit, in every language
    connect(this, &QLineEdit::editingFinished, this, &QuantityEdit::readText);
    connect(this, &QLineEdit::textEdited, this, [this] { setWrong({}); });
}

core::Result<QString> QuantityEdit::normalizedText(const QString& typed) const {
    if (kind_ == Kind::kAngle) {
        return units_.parseAngle(typed).map([this](core::Angle angle) { return units_.angle(angle); });
    }
    return units_.parseLengthM(typed).map([this](double length_m) { return units_.length(length_m); });
}

void QuantityEdit::setUnits(const app::UnitFormat& units) {
    // Read with the old unit, written with the new one.
    const QString before = text();
    const auto angle = units_.parseAngle(before);
    const auto length_m = units_.parseLengthM(before);
    units_ = units;
    if (before.isEmpty()) {
        return;
    }
    if (kind_ == Kind::kAngle && angle) {
        setText(units_.angle(*angle));
    } else if (kind_ == Kind::kLength && length_m) {
        setText(units_.length(*length_m));
    }
}

void QuantityEdit::setWrong(const QString& reason) {
    understood_ = reason.isEmpty();
    setToolTip(reason);
    setProperty("wrong", !understood_);
    style()->unpolish(this);
    style()->polish(this);
}

void QuantityEdit::readText() {
    if (text().trimmed().isEmpty() || !isModified()) {
        return;
    }
    const auto normal = normalizedText(text());
    if (!normal) {
        setWrong(normal.error().sentence());
        return;
    }
    setWrong({});
    setText(*normal);
    Q_EMIT understood(*normal);
}

}  // namespace pmts::gui
