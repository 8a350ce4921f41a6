#include "black_box_page.hpp"

#include "parts/lab_parts.hpp"
#include "parts/state_lamp.hpp"

#include <QCheckBox>
#include <QCoreApplication>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFrame>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QProcess>
#include <QSignalBlocker>
#include <QSpinBox>

namespace pmts::gui {
namespace {

constexpr int kWords_px = 70;
constexpr int kInside_px = 250;
constexpr qsizetype kShownBytes = 100000;

template <class Spin, class Number>
Spin* number(const char* name, const QString& says, Number low, Number high, const QString& unit, QWidget* parent) {
    auto* const spin = new Spin(parent);
    spin->setObjectName(QLatin1String(name));
    spin->setAccessibleName(says);
    spin->setRange(low, high);
    spin->setSuffix(unit);
    spin->setMinimumHeight(ActionButton::kLeastSide_px);
    spin->setKeyboardTracking(false);
    return spin;
}

QCheckBox* check(const QString& text, const char* name, QWidget* parent) {
    auto* const box = new QCheckBox(text, parent);
    box->setObjectName(QLatin1String(name));
    box->setMinimumHeight(ActionButton::kLeastSide_px);
    return box;
}

}  // namespace

void openBlackBoxBeside(QWidget* parent, const QString& folder) {
    const QString path = QFileDialog::getOpenFileName(parent, QCoreApplication::translate("BlackBox", "Open black box"), folder,
                                                      QCoreApplication::translate("BlackBox", "Black box (*.pmtsbox)"));
    if (!path.isEmpty()) {
        QProcess::startDetached(QCoreApplication::applicationFilePath(), {QStringLiteral("--replay"), path});
    }
}

BlackBoxPage::BlackBoxPage(app::BlackBoxPresenter& black_box, app::BugReportPresenter& report, QWidget* parent)
    : ListedPage(parent), black_box_(black_box), report_(report) {
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(10, 8, 10, 8);
    column->setSpacing(6);
    column->addWidget(makeRecording());
    auto* const rule = new QFrame(this);
    rule->setFrameShape(QFrame::HLine);
    column->addWidget(rule);
    column->addWidget(makeReport());
    column->addWidget(makePreview(), 1);
    said_ = labText("report_said", this);
    said_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    column->addWidget(said_);
    connect(&black_box_, &app::BlackBoxPresenter::statusChanged, this, &BlackBoxPage::showStatus);
    connect(on_, &QCheckBox::toggled, this, &BlackBoxPage::keepSettings);
    // Not at each step of the arrows: less room is made at once, out of the oldest recordings.
    connect(kept_mb_, &QSpinBox::editingFinished, this, &BlackBoxPage::keepSettings);
    connect(rate_, &QDoubleSpinBox::editingFinished, this, &BlackBoxPage::keepSettings);
    connect(again_, &QPushButton::clicked, &black_box_, &app::BlackBoxPresenter::startAgain);
    wireReport();
    showStatus();
    showReport();
}

QWidget* BlackBoxPage::makeRecording() {
    auto* const part = new QWidget(this);
    auto* const column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(labHeading(tr("What happens is written down"), part));
    auto* const state_row = new QHBoxLayout;
    lamp_ = new StateLamp(part);
    state_ = labText("black_box_state", part);
    kept_ = labText("black_box_kept", part);
    kept_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a long path must not widen the window
    state_row->addWidget(lamp_);
    state_row->addWidget(state_, 1);
    column->addLayout(state_row);
    column->addWidget(kept_);
    auto* const row = new QHBoxLayout;
    on_ = check(tr("Record"), "black_box_on", part);
    kept_mb_ = number<QSpinBox>("black_box_mb", tr("Room kept for recordings"), 20, 20000, tr(" MB"), part);
    rate_ = number<QDoubleSpinBox>("black_box_rate", tr("Pictures a second"), 0.0, 10.0, tr(" pictures/s"), part);
    rate_->setDecimals(1);
    rate_->setSingleStep(0.5);
    again_ = labButton(tr("Start again"), "black_box_again", part);
    auto* const open = labButton(tr("Open a recording…"), "black_box_open", part);
    row->addWidget(on_);
    row->addWidget(new QLabel(tr("Keep"), part));
    row->addWidget(kept_mb_);
    row->addWidget(new QLabel(tr("with"), part));
    row->addWidget(rate_);
    row->addStretch(1);
    row->addWidget(again_);
    row->addWidget(open);
    column->addLayout(row);
    connect(open, &QPushButton::clicked, this, [this] { openBlackBoxBeside(this, black_box_.folder()); });
    return part;
}

QWidget* BlackBoxPage::makeReport() {
    auto* const part = new QWidget(this);
    auto* const column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(labHeading(tr("Bug report"), part));
    words_ = new QPlainTextEdit(part);
    words_->setObjectName(QStringLiteral("report_words"));
    words_->setAccessibleName(tr("What happened"));
    words_->setPlaceholderText(tr("What did you do, what happened, what should have happened?"));
    words_->setFixedHeight(kWords_px);
    words_->setTabChangesFocus(true);
    column->addWidget(words_);
    auto* const row = new QHBoxLayout;
    minutes_ = number<QSpinBox>("report_minutes", tr("Minutes in the report"), 1, 240, tr(" min"), part);
    minutes_->setValue(app::BugReportOrder().minutes);
    pictures_ = check(tr("With pictures"), "report_pictures", part);
    pictures_->setChecked(true);
    look_ = labButton(tr("Put together and look"), "report_look", part);
    cancel_ = labButton(tr("Cancel"), "report_cancel", part);
    save_ = labButton(tr("Save report…"), "report_save", part);
    row->addWidget(new QLabel(tr("The last"), part));
    row->addWidget(minutes_);
    row->addWidget(pictures_);
    row->addStretch(1);
    row->addWidget(cancel_);
    row->addWidget(look_);
    row->addWidget(save_);
    column->addLayout(row);
    return part;
}

QWidget* BlackBoxPage::makePreview() {
    auto* const part = new QWidget(this);
    auto* const row = new QHBoxLayout(part);
    row->setContentsMargins(0, 0, 0, 0);
    inside_ = new QListWidget(part);
    inside_->setObjectName(QStringLiteral("report_inside"));
    inside_->setAccessibleName(tr("What is in the report"));
    inside_->setFixedWidth(kInside_px);
    preview_ = new QPlainTextEdit(part);
    preview_->setObjectName(QStringLiteral("report_preview"));
    preview_->setAccessibleName(tr("The chosen part of the report"));
    preview_->setReadOnly(true);
    preview_->setLineWrapMode(QPlainTextEdit::NoWrap);
    row->addWidget(inside_);
    row->addWidget(preview_, 1);
    return part;
}

void BlackBoxPage::wireReport() {
    connect(look_, &QPushButton::clicked, this, &BlackBoxPage::prepare);
    connect(cancel_, &QPushButton::clicked, &report_, &app::BugReportPresenter::cancel);
    connect(save_, &QPushButton::clicked, this, &BlackBoxPage::chooseFile);
    connect(inside_, &QListWidget::currentRowChanged, this, &BlackBoxPage::showFile);
    connect(&report_, &app::BugReportPresenter::prepared, this, [this] {
        said_->setText(tr("This is what will be written. Folders, your name and the computer's are left out; "
                          "pictures show what the camera saw."));
    });
    connect(&report_, &app::BugReportPresenter::failed, this, [this](const core::Error& error) { said_->setText(error.sentence()); });
    connect(&report_, &app::BugReportPresenter::busyChanged, this, &BlackBoxPage::showReport);
    connect(&report_, &app::BugReportPresenter::writingProgressed, this,
            [this](double done) { said_->setText(tr("The report is being written, %1 %…").arg(qRound(done * 100))); });
    connect(&report_, &app::BugReportPresenter::written, this, [this](const QString& path) {
        said_->setText(tr("“%1” is written. Attach it to your report.").arg(QDir::toNativeSeparators(path)));
    });
    connect(cancel_, &QPushButton::clicked, said_, &QLabel::clear);
    // What was looked at is no longer what would be written.
    connect(words_, &QPlainTextEdit::textChanged, &report_, &app::BugReportPresenter::forget);
    connect(minutes_, &QSpinBox::valueChanged, &report_, &app::BugReportPresenter::forget);
    connect(pictures_, &QCheckBox::toggled, &report_, &app::BugReportPresenter::forget);
}

void BlackBoxPage::entered() { showStatus(); }

void BlackBoxPage::showStatus() {
    const app::StatusItem status = black_box_.status();
    const app::BlackBoxSettings& settings = black_box_.settings();
    lamp_->setState(status.state);
    state_->setText(tr("%1. %2").arg(status.text, status.details));
    kept_->setText(tr("%1 in %2").arg(black_box_.keptText(), QDir::toNativeSeparators(black_box_.folder())));
    again_->setVisible(status.state == app::DeviceState::kFailed);
    const QSignalBlocker quiet_on(on_), quiet_mb(kept_mb_), quiet_rate(rate_);
    on_->setChecked(settings.on);
    if (!kept_mb_->hasFocus()) {  // what is being typed stays
        kept_mb_->setValue(settings.kept_mb);
    }
    if (!rate_->hasFocus()) {
        rate_->setValue(settings.frames_per_s);
    }
    Q_EMIT stateChanged(status.state);
}

void BlackBoxPage::keepSettings() {
    black_box_.setSettings({.on = on_->isChecked(), .kept_mb = kept_mb_->value(), .frames_per_s = rate_->value()});
}

void BlackBoxPage::prepare() {
    report_.prepare({.minutes = minutes_->value(), .pictures = pictures_->isChecked(), .words = words_->toPlainText()});
}

void BlackBoxPage::showReport() {
    const bool busy = report_.isBusy();
    look_->setEnabled(!busy);
    cancel_->setVisible(busy);
    save_->setEnabled(report_.report().has_value() && !busy);
    if (report_.isWriting()) {
        return;  // what is written stays to be looked at
    }
    if (busy) {
        said_->setText(tr("The report is being put together from the black box…"));
    }
    inside_->clear();
    if (report_.report()) {
        for (const QString& part : report_.report()->inside) {
            auto* const item = new QListWidgetItem(part, inside_);
            item->setSizeHint({0, ActionButton::kLeastSide_px});
        }
        inside_->setCurrentRow(0);
    } else {
        preview_->setPlainText(busy ? QString() : tr("The report is shown here before anything is written."));
    }
}

void BlackBoxPage::showFile(int row) {
    if (row < 0 || !report_.report()) {
        return;
    }
    const blackbox::ZipEntry& file = report_.report()->files[static_cast<std::size_t>(row)];
    const bool is_text = file.name.endsWith(QLatin1String(".txt"));
    preview_->setPlainText(is_text ? QString::fromUtf8(file.bytes.left(kShownBytes))
                                   : tr("The recording itself. Save the report, then open this part of it with "
                                        "“Open a recording…” to see it play.\n\n%1").arg(report_.report()->overview));
}

void BlackBoxPage::chooseFile() {
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Save the bug report"), app::BugReportPresenter::usualName(report_.utcNow()), tr("Archive (*.zip)"));
    if (path.isEmpty()) {
        return;
    }
    report_.write(path);
}

}  // namespace pmts::gui
