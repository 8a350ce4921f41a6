#include "small_dialogs.hpp"

#include "parts/action_button.hpp"
#include "ui_about_dialog.h"
#include "ui_aim_dialog.h"
#include "ui_export_dialog.h"
#include "ui_keys_dialog.h"
#include "ui_step_dialog.h"
#include "ui_units_dialog.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QPushButton>

namespace pmts::gui {
namespace {

constexpr const char* kUsualSteps[] = {"10\"", "1'", "5'", "30'", "1°", "0.01 gon", "0.1 gon", "1 gon"};
constexpr int kStepColumns = 4;
constexpr int kMostDecimals = 4;
constexpr int kLogo_px = 72;

void appendKey(QTableWidget* table, const QString& key, const QString& name, const QString& tip) {
    const int row = table->rowCount();
    table->insertRow(row);
    table->setItem(row, 0, new QTableWidgetItem(key));
    table->setItem(row, 1, new QTableWidgetItem(name));
    table->setItem(row, 2, new QTableWidgetItem(tip));
}

}  // namespace

UnitsDialog::UnitsDialog(const app::UnitFormat& units, QWidget* parent)
    : QDialog(parent), ui_(std::make_unique<Ui::UnitsDialog>()) {
    ui_->setupUi(this);
    const std::pair<core::AngleUnit, QString> angles[] = {
        {core::AngleUnit::kGon, tr("gon")},
        {core::AngleUnit::kDms, tr("degrees, minutes, seconds")},
        {core::AngleUnit::kDegree, tr("degrees")},
        {core::AngleUnit::kMil, tr("mil (6400)")}};
    for (const auto& [unit, name] : angles) {
        ui_->angle->addItem(name, static_cast<int>(unit));
    }
    ui_->length->addItem(tr("metres"), static_cast<int>(app::LengthUnit::kMetre));
    ui_->length->addItem(tr("feet (0.3048 m)"), static_cast<int>(app::LengthUnit::kFoot));
    ui_->angle->setCurrentIndex(ui_->angle->findData(static_cast<int>(units.angle_unit)));
    ui_->length->setCurrentIndex(ui_->length->findData(static_cast<int>(units.length_unit)));
    for (int decimals = 0; decimals <= kMostDecimals; ++decimals) {
        ui_->decimals->addItem(QString::number(decimals));
    }
    ui_->decimals->setCurrentIndex(units.length_decimals);
    connect(ui_->angle, &QComboBox::currentIndexChanged, this, &UnitsDialog::showExample);
    connect(ui_->length, &QComboBox::currentIndexChanged, this, &UnitsDialog::showExample);
    connect(ui_->decimals, &QComboBox::currentIndexChanged, this, &UnitsDialog::showExample);
    showExample();
}

UnitsDialog::~UnitsDialog() = default;

app::UnitFormat UnitsDialog::units() const {
    return {.angle_unit = static_cast<core::AngleUnit>(ui_->angle->currentData().toInt()),
            .length_unit = static_cast<app::LengthUnit>(ui_->length->currentData().toInt()),
            .length_decimals = ui_->decimals->currentIndex()};
}

void UnitsDialog::showExample() {
    const app::UnitFormat chosen = units();
    ui_->example->setText(
        tr("HA %1    SD %2").arg(chosen.angle(core::Angle::fromGon(177.5612)), chosen.length(23.418)));
}

KeysDialog::KeysDialog(const QList<QAction*>& actions, QWidget* parent)
    : QDialog(parent), ui_(std::make_unique<Ui::KeysDialog>()) {
    ui_->setupUi(this);
    ui_->table->setHorizontalHeaderLabels({tr("Key"), tr("Action"), tr("What it does")});
    for (const QAction* action : actions) {
        appendKey(ui_->table, keyCapText(action->shortcut()), action->text().remove(QStringLiteral("…")),
                  action->statusTip());
    }
    appendKey(ui_->table, tr("Click"), tr("Aim"),
              tr("In the live view or the still: shows HA and VA, nothing moves"));
    appendKey(ui_->table, tr("Double-click"), tr("Turn to"), tr("In a picture, the table or the plan"));
    appendKey(ui_->table, tr("Ctrl+click"), tr("Aim"), tr("Also where a point is drawn: a plain click there chooses it"));
    appendKey(ui_->table, tr("Drag"), tr("Turn"),
              tr("In the whole live view: the grabbed spot comes to where it is released; enlarged: Shift and drag"));
    appendKey(ui_->table, tr("Arrow held"), tr("Run"), tr("Step after step, until it is released"));
    appendKey(ui_->table, tr("Wheel, pinch"), tr("Zoom"), tr("Live view, still, loupe; drag to pan"));
    appendKey(ui_->table, tr("F2"), tr("Edit"), tr("ID, code or remark in the table"));
    appendKey(ui_->table, tr("Delete"), tr("Strike out"), tr("The selected points; undo brings them back"));
    ui_->table->verticalHeader()->hide();
    ui_->table->horizontalHeader()->setStretchLastSection(true);
    ui_->table->resizeColumnsToContents();
    ui_->table->setColumnWidth(0, ui_->table->columnWidth(0) + 12);
    ui_->table->setColumnWidth(1, ui_->table->columnWidth(1) + 12);
    ui_->buttons->setFocus();
    resize(680, 620);
}

KeysDialog::~KeysDialog() = default;

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent), ui_(std::make_unique<Ui::AboutDialog>()) {
    ui_->setupUi(this);
    ui_->logo->setPixmap(QIcon(QStringLiteral(":/pmts/icons/pmts.svg")).pixmap(kLogo_px));
    ui_->title->setText(tr("PMTS %1\nPhotogrammetric mapping with a total station")
                            .arg(QCoreApplication::applicationVersion()));
    ui_->text->setText(
        tr("A robotic total station, a camera and a computer as one measuring system.\n\n"
           "Free software under the GNU General Public License, version 3 or later. It comes without any "
           "warranty."));
}

AboutDialog::~AboutDialog() = default;

StepDialog::StepDialog(const QString& step_text, const app::UnitFormat& units, QWidget* parent)
    : QDialog(parent), ui_(std::make_unique<Ui::StepDialog>()) {
    ui_->setupUi(this);
    ui_->step->setKind(QuantityEdit::Kind::kAngle);
    ui_->step->setUnits(units);
    ui_->step->setText(step_text);
    ui_->step->selectAll();
    int index = 0;
    for (const char* text : kUsualSteps) {
        auto* const button = new QPushButton(QString::fromUtf8(text), this);
        button->setMinimumHeight(ActionButton::kLeastSide_px);
        button->setAutoDefault(false);
        ui_->presets->addWidget(button, index / kStepColumns, index % kStepColumns);
        connect(button, &QPushButton::clicked, this, [this, button] {
            Q_EMIT stepChosen(button->text());
            accept();
        });
        ++index;
    }
    connect(ui_->buttons, &QDialogButtonBox::accepted, this, [this] {
        const QString typed = ui_->step->text();
        ui_->step->setWrong({});
        Q_EMIT stepChosen(typed);
        if (ui_->step->isUnderstood()) {
            accept();
        }
    });
}

StepDialog::~StepDialog() = default;

void StepDialog::showRejection(const core::Error& error) {
    ui_->step->setWrong(error.sentence());
    ui_->label->setText(error.sentence());
    ui_->step->setFocus();
}

AimDialog::AimDialog(const app::UnitFormat& units, QWidget* parent)
    : QDialog(parent), ui_(std::make_unique<Ui::AimDialog>()) {
    ui_->setupUi(this);
    for (QuantityEdit* field : {ui_->ha, ui_->va}) {
        field->setKind(QuantityEdit::Kind::kAngle);
        field->setUnits(units);
    }
}

AimDialog::~AimDialog() = default;

QString AimDialog::haText() const { return ui_->ha->text(); }

QString AimDialog::vaText() const { return ui_->va->text(); }

ExportDialog::ExportDialog(const QString& path, const QString& filter, QWidget* parent)
    : QDialog(parent), ui_(std::make_unique<Ui::ExportDialog>()) {
    ui_->setupUi(this);
    ui_->path->setText(path);
    ui_->csv->setChecked(true);
    connect(ui_->csv, &QRadioButton::clicked, this, [this] { setEnding(QStringLiteral("csv")); });
    connect(ui_->geojson, &QRadioButton::clicked, this, [this] { setEnding(QStringLiteral("geojson")); });
    connect(ui_->dxf, &QRadioButton::clicked, this, [this] { setEnding(QStringLiteral("dxf")); });
    connect(ui_->browse, &QPushButton::clicked, this, [this, filter] {
        const QString chosen = QFileDialog::getSaveFileName(this, windowTitle(), ui_->path->text(), filter);
        if (!chosen.isEmpty()) {
            ui_->path->setText(chosen);
        }
    });
}

ExportDialog::~ExportDialog() = default;

QString ExportDialog::path() const { return ui_->path->text().trimmed(); }

void ExportDialog::setEnding(const QString& ending) {
    const QFileInfo file(path());
    ui_->path->setText(QStringLiteral("%1/%2.%3").arg(file.path(), file.completeBaseName(), ending));
}

}  // namespace pmts::gui
