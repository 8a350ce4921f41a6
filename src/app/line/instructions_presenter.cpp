#include "pmts/app/line/instructions_presenter.hpp"

#include "pmts/app/desk/whole_file.hpp"
#include "pmts/core/logging.hpp"

#include <QFile>

namespace pmts::app {
namespace {

constexpr core::Duration kDraftAfter = std::chrono::seconds(1);
constexpr qint64 kLargestDraft = qint64{16} << 20;  ///< more than can be saved: nothing that was typed is lost
const QString kTopic = QStringLiteral("instructions");

QString shown(const std::string& text) { return QString::fromStdString(text); }

}  // namespace

InstructionsPresenter::InstructionsPresenter(InstructionFile& file, InstrumentDesk& instrument, MessageCentre& messages,
                                             core::Clock& clock, Threading threading, QObject* parent)
    : QObject(parent), file_(file), instrument_(instrument), messages_(messages), clock_(clock), threading_(threading) {
    known_ = file_.text();
    takeDraft();
    readTable();
    connect(&file_, &InstructionFile::changed, this, &InstructionsPresenter::followFile);
    connect(&file_, &InstructionFile::problemReported, this, &InstructionsPresenter::reportFile);
    if (file_.trouble()) {
        reportFile(*file_.trouble());  // it was told before anybody listened
    }
    wireDesk();
}

void InstructionsPresenter::takeDraft() {
    text_ = known_;
    if (file_.path().isEmpty() || !QFile::exists(draftPath())) {
        return;
    }
    const auto draft = readWhole(draftPath(), kLargestDraft);
    if (!draft) {
        messages_.report(draft.error(), MessageAction::kNone, kTopic);
        return;
    }
    text_ = QString::fromUtf8(*draft);
    is_draft_ = isModified();
}

void InstructionsPresenter::reportFile(const core::Error& error) {
    messages_.report(error, MessageAction::kNone, kTopic);
    Q_EMIT tableChanged();
}

InstructionsPresenter::~InstructionsPresenter() {
    *cancel_dry_run_ = true;
    keepDraft();
}

// The text.

void InstructionsPresenter::setText(const QString& text) {
    if (text == text_) {
        return;
    }
    text_ = text;
    readTable();
    keepDraftSoon();
}

void InstructionsPresenter::replaceText(const QString& text) {
    text_ = text;
    is_draft_ = false;
    keepDraft();
    Q_EMIT textChanged();  // the text before its problems, so that they find their lines
    readTable();
}

void InstructionsPresenter::readTable() {
    table_ = protocol::readInstructionTable(text_.toStdString());
    if (chosen() == nullptr) {
        chosen_ = table_.routines.empty() ? QString() : shown(table_.routines.front().name);
    }
    if (running_ == Running::kNothing) {
        steps_.clear();
        outcome_ = {};
    }
    is_draft_ = is_draft_ && isModified();
    Q_EMIT tableChanged();
    Q_EMIT chosenChanged();
    Q_EMIT runChanged();
}

/// What is typed and not saved is never overwritten: the person decides between it and the file.
void InstructionsPresenter::followFile() {
    const bool was_typed = text_ != known_;
    known_ = file_.text();
    messages_.solve(kTopic);
    is_file_newer_ = was_typed && isModified();
    if (was_typed) {
        Q_EMIT tableChanged();
        Q_EMIT runChanged();  // what runs on the line is the file's
    } else {
        replaceText(known_);
    }
}

QString InstructionsPresenter::fileSentence() const {
    if (file_.trouble()) {
        return tr("%1 cannot be read, and is not replaced before it can. Export keeps this text.").arg(file_.path());
    }
    if (is_file_newer_) {
        return tr("Another program changed the file. Save keeps this text, Revert takes the file's.");
    }
    if (is_draft_) {
        return tr("Unsaved text of the last time was kept. Save keeps it, Revert drops it.");
    }
    if (isModified()) {
        return tr("Not saved.");
    }
    return file_.isShipped() ? tr("The shipped table. Saving makes your own copy: %1").arg(file_.path()) : file_.path();
}

void InstructionsPresenter::save() {
    known_ = text_;  // what follows is no change by somebody else
    if (const auto saved = file_.save(text_); !saved) {
        known_ = file_.text();
        messages_.report(saved.error(), MessageAction::kNone, kTopic);
        return;
    }
    messages_.solve(kTopic);
    is_file_newer_ = false;
    is_draft_ = false;
    keepDraft();
    if (!table_.problems.empty()) {
        messages_.toast(file_.table().routines.empty()
                            ? tr("Saved. The table has problems: it is not run.")
                            : tr("Saved. The table has problems: Run takes the last good one that was saved."));
    }
    Q_EMIT tableChanged();
}

void InstructionsPresenter::revert() {
    is_file_newer_ = false;
    replaceText(file_.text());
}

void InstructionsPresenter::importFrom(const QString& path) {
    const auto bytes = readWhole(path, InstructionFile::kLargest);
    if (!bytes) {
        messages_.report(bytes.error());
        return;
    }
    text_ = QString::fromUtf8(*bytes);
    Q_EMIT textChanged();
    readTable();
    keepDraftSoon();
}

void InstructionsPresenter::exportTo(const QString& path) {
    if (const auto written = writeWhole(path, text_.toUtf8()); !written) {
        messages_.report(written.error());
        return;
    }
    messages_.toast(tr("Exported to %1.").arg(path));
}

QString InstructionsPresenter::draftPath() const { return file_.path() + QStringLiteral(".draft"); }

void InstructionsPresenter::keepDraftSoon() {
    draft_timer_ = clock_.callAfter(kDraftAfter, [this] { keepDraft(); });
}

void InstructionsPresenter::keepDraft() {
    draft_timer_.cancel();
    if (file_.path().isEmpty()) {
        return;
    }
    if (!isModified()) {
        QFile::remove(draftPath());
        return;
    }
    if (const auto kept = writeWhole(draftPath(), text_.toUtf8()); !kept) {
        qCWarning(core::logApp) << "the unsaved instruction table was not kept:" << kept.error().happened;
    }
}

}  // namespace pmts::app
