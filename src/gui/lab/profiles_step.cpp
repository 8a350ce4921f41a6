#include "profiles_step.hpp"

#include "parts/lab_parts.hpp"
#include "rig_limits_dialog.hpp"
#include "parts/state_lamp.hpp"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QMessageBox>
#include <QSignalBlocker>
#include <QTableWidget>

namespace pmts::gui {
namespace {

constexpr int kName = 0;
constexpr int kAge = 1;
constexpr int kRms = 2;
constexpr int kColumns = 3;
constexpr double kUnknown_c = -60.0;  ///< shown as a dash

}  // namespace

ProfilesStep::ProfilesStep(app::ProfilesPresenter& profiles, QWidget* parent) : LabStep(parent), profiles_(profiles) {
    auto* const column = new QVBoxLayout(this);
    in_use_ = labText("profile_in_use", this);
    concerns_ = labText("profile_concerns", this);
    table_ = new QTableWidget(0, kColumns, this);
    table_->setObjectName(QStringLiteral("profile_list"));
    table_->setAccessibleName(tr("Rig profiles"));
    table_->setHorizontalHeaderLabels({tr("Profile"), tr("Age"), tr("rms")});
    table_->horizontalHeader()->setSectionResizeMode(kName, QHeaderView::Stretch);
    table_->horizontalHeader()->setSectionResizeMode(kAge, QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setSectionResizeMode(kRms, QHeaderView::ResizeToContents);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(ActionButton::kLeastSide_px);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setMinimumHeight(4 * ActionButton::kLeastSide_px);
    details_ = labText("profile_details", this);
    picks_ = new QCheckBox(tr("Pick the profile that fits the camera"), this);
    picks_->setMinimumHeight(ActionButton::kLeastSide_px);
    temperature_ = new QDoubleSpinBox(this);
    temperature_->setRange(kUnknown_c, 70);
    temperature_->setDecimals(0);
    temperature_->setSuffix(tr(" °C"));
    temperature_->setSpecialValueText(tr("unknown"));
    temperature_->setMinimumHeight(ActionButton::kLeastSide_px);
    temperature_->setAccessibleName(tr("Temperature now"));
    temperature_->setValue(kUnknown_c);
    auto* const read = labButton(tr("Read"), "profile_read_temperature", this);
    read->setToolTip(tr("Ask the instrument for its temperature"));
    use_ = labButton(tr("Use"), "profile_use", this);
    back_ = labButton(tr("Back to the earlier one"), "profile_back", this);
    rename_ = labButton(tr("Rename…"), "profile_rename", this);
    remove_ = labButton(tr("Delete"), "profile_remove", this);
    auto* const copy = labButton(tr("Duplicate"), "profile_copy", this);
    auto* const import_button = labButton(tr("Import…"), "profile_import", this);
    auto* const export_button = labButton(tr("Export…"), "profile_export", this);
    auto* const limits = labButton(tr("Limits…"), "profile_limits", this);
    limits->setToolTip(tr("Age, temperature, check and knock: when a calibration is no longer trusted"));
    auto* const grid = new QGridLayout;
    grid->addWidget(use_, 0, 0);
    grid->addWidget(back_, 0, 1);
    grid->addWidget(rename_, 1, 0);
    grid->addWidget(copy, 1, 1);
    grid->addWidget(import_button, 2, 0);
    grid->addWidget(export_button, 2, 1);
    grid->addWidget(remove_, 3, 0);
    grid->addWidget(limits, 3, 1);
    auto* const weather = new QHBoxLayout;
    weather->addWidget(new QLabel(tr("Temperature now"), this), 1);
    weather->addWidget(temperature_);
    weather->addWidget(read);
    for (QWidget* part : std::initializer_list<QWidget*>{in_use_, concerns_, picks_, table_, details_}) {
        column->addWidget(part);
    }
    column->addLayout(grid);
    column->addLayout(weather);
    column->addStretch(1);
    connect(use_, &QPushButton::clicked, this, [this] { profiles_.use(chosen()); });
    connect(back_, &QPushButton::clicked, this, [this] { profiles_.goBack(chosen()); });
    connect(rename_, &QPushButton::clicked, this, &ProfilesStep::rename);
    connect(remove_, &QPushButton::clicked, this, &ProfilesStep::remove);
    connect(copy, &QPushButton::clicked, this, [this] { profiles_.duplicate(chosen()); });
    connect(import_button, &QPushButton::clicked, this, &ProfilesStep::import);
    connect(export_button, &QPushButton::clicked, this, &ProfilesStep::exportChosen);
    connect(limits, &QPushButton::clicked, this, &ProfilesStep::editLimits);
    connect(picks_, &QCheckBox::clicked, &profiles_, &app::ProfilesPresenter::setPicksByItself);
    connect(read, &QPushButton::clicked, &profiles_, &app::ProfilesPresenter::readTemperature);
    connect(temperature_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        profiles_.setTemperature(value > kUnknown_c ? std::optional(value) : std::nullopt);
    });
    connect(&profiles_, &app::ProfilesPresenter::changed, this, &ProfilesStep::showAll);
    connect(table_, &QTableWidget::itemSelectionChanged, this, &ProfilesStep::showAll);
    showAll();
}

QString ProfilesStep::chosen() const {
    const int row = table_->currentRow();
    return row < 0 ? profiles_.inUse().profile.name : table_->item(row, kName)->text();
}

void ProfilesStep::showAll() {
    const QSignalBlocker quiet(table_);
    const QString kept = chosen();
    const auto rows = profiles_.rows();
    table_->setRowCount(static_cast<int>(rows.size()));
    details_->clear();
    for (int i = 0; i < table_->rowCount(); ++i) {
        const app::ProfileRow& row = rows[static_cast<std::size_t>(i)];
        const QStringList texts{row.name, row.age, row.rms};
        for (int column = 0; column < kColumns; ++column) {
            auto* const item = new QTableWidgetItem(texts[column]);
            QFont font = item->font();
            font.setBold(row.in_use);
            item->setFont(font);
            item->setToolTip(QStringLiteral("%1, %2\n%3\n%4").arg(row.camera, row.mode, row.method, row.state_text));
            if (column == kName) {
                item->setIcon(lampIcon(row.state));
            }
            table_->setItem(i, column, item);
        }
        if (row.name == kept) {
            table_->setCurrentCell(i, kName);
            details_->setText(tr("%1, %2: %3; %4").arg(row.camera, row.mode, row.method, row.state_text));
            back_->setEnabled(row.has_previous);
            use_->setEnabled(!row.in_use);
            const bool own = i + 1 < table_->rowCount();  // the last one is the simulated camera's
            rename_->setEnabled(own);
            remove_->setEnabled(own);
        }
    }
    in_use_->setText(tr("In use: %1. %2").arg(profiles_.inUse().profile.name, profiles_.inUse().sentence));
    concerns_->setText(profiles_.concerns().join(u'\n'));
    concerns_->setVisible(!profiles_.concerns().isEmpty());
    picks_->setChecked(profiles_.picksByItself());
    const QSignalBlocker still(temperature_);
    temperature_->setValue(profiles_.temperature().value_or(kUnknown_c));
    Q_EMIT stateChanged(profiles_.state());
}

void ProfilesStep::rename() {
    bool accepted = false;
    const QString name = QInputDialog::getText(this, tr("Rename"), tr("Name of the profile"), QLineEdit::Normal, chosen(), &accepted);
    if (accepted) {
        profiles_.rename(chosen(), name);
    }
}

void ProfilesStep::remove() {
    const QString name = chosen();
    const auto answer = QMessageBox::question(this, tr("Delete"), tr("Delete the profile “%1” with its calibration and checks?").arg(name));
    if (answer == QMessageBox::Yes) {
        profiles_.remove(name);
    }
}

void ProfilesStep::editLimits() {
    RigLimitsDialog dialog(profiles_.limits(), this);
    if (dialog.exec() == QDialog::Accepted) {
        profiles_.setLimits(dialog.care());
    }
}

void ProfilesStep::exportChosen() {
    const QString path = QFileDialog::getSaveFileName(this, tr("Export"), chosen() + QStringLiteral(".json"),
                                                      tr("PMTS profile (*.json);;OpenCV (*.yaml *.yml);;COLMAP cameras (*.txt)"));
    if (!path.isEmpty()) {
        profiles_.exportTo(chosen(), path);
    }
}

void ProfilesStep::import() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Import"), {}, tr("Profiles and lenses (*.json *.yaml *.yml *.txt)"));
    if (!path.isEmpty()) {
        profiles_.importFrom(path);
    }
}

}  // namespace pmts::gui
