#pragma once

#include <QDialog>

class QDoubleSpinBox;
class QFormLayout;

namespace pmts::gui {

/// Limits to type in, under headings; OK, Cancel and Restore Defaults.
class LimitsDialog : public QDialog {
    Q_OBJECT
public:
    LimitsDialog(const QString& title, QWidget* parent);

Q_SIGNALS:
    void defaultsAsked();

protected:
    void addHeading(const QString& text);
    QDoubleSpinBox* addField(const QString& name, const char* object_name, double least, double most, int decimals,
                             const QString& unit);

private:
    QFormLayout* form_;
};

}  // namespace pmts::gui
