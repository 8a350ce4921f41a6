#pragma once

#include "pmts/app/settings/unit_format.hpp"

#include <QAction>
#include <QDialog>
#include <QList>

#include <memory>

namespace Ui {
class AboutDialog;
class AimDialog;
class ExportDialog;
class KeysDialog;
class StepDialog;
class UnitsDialog;
}  // namespace Ui

namespace pmts::gui {

/// Dialogs that return values and compute nothing.
class UnitsDialog : public QDialog {
    Q_OBJECT
public:
    explicit UnitsDialog(const app::UnitFormat& units, QWidget* parent = nullptr);
    ~UnitsDialog() override;
    [[nodiscard]] app::UnitFormat units() const;

private:
    void showExample();
    std::unique_ptr<Ui::UnitsDialog> ui_;
};

/// Every key of the program, from the actions themselves.
class KeysDialog : public QDialog {
    Q_OBJECT
public:
    explicit KeysDialog(const QList<QAction*>& actions, QWidget* parent = nullptr);
    ~KeysDialog() override;

private:
    std::unique_ptr<Ui::KeysDialog> ui_;
};

class AboutDialog : public QDialog {
    Q_OBJECT
public:
    explicit AboutDialog(QWidget* parent = nullptr);
    ~AboutDialog() override;

private:
    std::unique_ptr<Ui::AboutDialog> ui_;
};

/// The step of the arrow keys: typed, or one of the usual ones. Stays open while the text is refused.
class StepDialog : public QDialog {
    Q_OBJECT
public:
    StepDialog(const QString& step_text, const app::UnitFormat& units, QWidget* parent = nullptr);
    ~StepDialog() override;
    void showRejection(const core::Error& error);

Q_SIGNALS:
    void stepChosen(const QString& text);

private:
    std::unique_ptr<Ui::StepDialog> ui_;
};

/// HA and VA to aim at, as texts.
class AimDialog : public QDialog {
    Q_OBJECT
public:
    explicit AimDialog(const app::UnitFormat& units, QWidget* parent = nullptr);
    ~AimDialog() override;
    [[nodiscard]] QString haText() const;
    [[nodiscard]] QString vaText() const;

private:
    std::unique_ptr<Ui::AimDialog> ui_;
};

/// Where to export to; the ending of the path chooses the format.
class ExportDialog : public QDialog {
    Q_OBJECT
public:
    ExportDialog(const QString& path, const QString& filter, QWidget* parent = nullptr);
    ~ExportDialog() override;
    [[nodiscard]] QString path() const;

private:
    void setEnding(const QString& ending);
    std::unique_ptr<Ui::ExportDialog> ui_;
};

}  // namespace pmts::gui
