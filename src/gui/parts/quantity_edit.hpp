#pragma once

#include "pmts/app/settings/unit_format.hpp"

#include <QLineEdit>

namespace pmts::gui {

/// A field for an angle or a length: any unit and arithmetic may be typed (`12.5 gon`, `5'`, `2*0.3`, `4
/// ft`); what was understood is shown in the current unit. Text that cannot be read stays, marked, with the
/// reason on hover.
class QuantityEdit : public QLineEdit {
    Q_OBJECT
public:
    enum class Kind { kAngle, kLength };

    explicit QuantityEdit(QWidget* parent = nullptr);

    void setKind(Kind kind) { kind_ = kind; }
    /// Also rewrites what is shown.
    void setUnits(const app::UnitFormat& units);
    [[nodiscard]] bool isUnderstood() const { return understood_; }
    void setWrong(const QString& reason);  ///< empty: right again

Q_SIGNALS:
    /// The field was left or Enter pressed with a text that can be read; the text is in the current unit.
    void understood(const QString& text);

private:
    void readText();
    [[nodiscard]] core::Result<QString> normalizedText(const QString& typed) const;

    Kind kind_ = Kind::kLength;
    app::UnitFormat units_;
    bool understood_ = true;
};

}  // namespace pmts::gui
