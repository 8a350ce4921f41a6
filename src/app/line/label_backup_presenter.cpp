#include "pmts/app/line/label_backup_presenter.hpp"

#include "pmts/app/desk/whole_file.hpp"
#include "pmts/protocol/labels.hpp"

#include <QFileInfo>
#include <QLocale>

#include <algorithm>

namespace pmts::app {
namespace {

const QString kTopic = QStringLiteral("label_backup");

QString latin1(std::string_view bytes) { return QString::fromLatin1(bytes); }

QString labelName(int label) {
    const auto* const known = protocol::findLabel(label);
    const QString meaning = known == nullptr ? QString() : latin1(known->meaning);
    return QStringLiteral("%1 %2").arg(label).arg(meaning).trimmed();
}

LabelChangeRow rowOf(const protocol::LabelChange& change) {
    const auto text = [](const std::optional<std::string>& data) {
        return data ? latin1(*data) : LabelBackupPresenter::tr("(refused)");
    };
    return {.label = labelName(change.label),
            .before = text(change.before),
            .after = text(change.after),
            .is_setting = change.is_setting};
}

}  // namespace

LabelBackupPresenter::LabelBackupPresenter(InstrumentDesk& instrument, MessageCentre& messages, QObject* parent)
    : QObject(parent), instrument_(instrument), messages_(messages) {
    connect(&instrument_, &InstrumentDesk::transferProgressed, this, &LabelBackupPresenter::onProgress);
    connect(&instrument_, &InstrumentDesk::labelsBackedUp, this, &LabelBackupPresenter::onBackedUp);
    connect(&instrument_, &InstrumentDesk::requestFailed, this, &LabelBackupPresenter::onFailed);
}

QString LabelBackupPresenter::sentence() const {
    if (!backup_) {
        return tr("No backup was read yet. It only reads: nothing in the instrument changes.");
    }
    const auto refused =
        std::ranges::count_if(backup_->readings, [](const auto& reading) { return reading.refused.has_value(); });
    const auto silent = std::ranges::count_if(backup_->readings, &protocol::LabelReading::isSilent);
    const QString read =
        tr("%1 labels of instrument %2, %3 of them refused; %4, %5 degrees.")
            .arg(backup_->readings.size())
            .arg(backup_->serial_number.empty() ? tr("without number") : latin1(backup_->serial_number))
            .arg(refused)
            .arg(QLocale().toString(backup_->utc.toLocalTime(), QLocale::ShortFormat),
                 backup_->temperature.empty() ? QStringLiteral("?") : latin1(backup_->temperature));
    return silent == 0 ? read : read + u' ' + tr("%1 did not answer; they are in no comparison.").arg(silent);
}

std::vector<LabelChangeRow> LabelBackupPresenter::labels() const {
    std::vector<LabelChangeRow> rows;
    for (const auto& reading : backup_ ? backup_->readings : std::vector<protocol::LabelReading>()) {
        const QString value = reading.isSilent()  ? tr("(no answer)")
                              : reading.refused ? tr("(refused, info %1)").arg(reading.refused->code)
                                              : latin1(reading.data.value_or(std::string()));
        rows.push_back({.label = labelName(reading.label), .before = {}, .after = value, .is_setting = false});
    }
    return rows;
}

QString LabelBackupPresenter::proposedFileName() const {
    const QString number = backup_ ? latin1(backup_->serial_number) : QString();
    const QString day = backup_ ? backup_->utc.toString(QStringLiteral("yyyy-MM-dd")) : QString();
    return QStringLiteral("labels-%1-%2.txt").arg(number.isEmpty() ? QStringLiteral("instrument") : number, day);
}

void LabelBackupPresenter::read() {
    if (!transfer_.busy && instrument_.speaksExternal()) {
        messages_.solve(kTopic);
        ticket_ = instrument_.backUpLabels();
        setTransfer({.busy = true, .text = tr("Reading the labels."), .fraction = std::nullopt});
    }
}

void LabelBackupPresenter::cancel() {
    if (transfer_.busy) {
        instrument_.cancel(ticket_);
    }
}

void LabelBackupPresenter::setTransfer(const TransferView& transfer) {
    transfer_ = transfer;
    Q_EMIT transferChanged();
}

void LabelBackupPresenter::onProgress(Ticket ticket, const instrument::TransferProgress& progress) {
    if (ticket == ticket_ && transfer_.busy && progress.of) {
        setTransfer({.busy = true,
                     .text = tr("Reading label %1 of %2.").arg(progress.done).arg(*progress.of),
                     .fraction = static_cast<double>(progress.done) / *progress.of});
    }
}

void LabelBackupPresenter::onBackedUp(Ticket ticket, const protocol::LabelBackup& backup) {
    if (ticket != ticket_) {
        return;
    }
    ticket_ = 0;
    backup_ = backup;
    comparison_.clear();
    changes_.clear();
    setTransfer({});
    Q_EMIT changed();
}

void LabelBackupPresenter::onFailed(Ticket ticket, const core::Error& error) {
    if (ticket != ticket_ || ticket == 0) {
        return;
    }
    ticket_ = 0;
    setTransfer({});
    if (error.kind != core::ErrorKind::kCancelled) {
        messages_.report(error, MessageAction::kNone, kTopic);
    }
}

void LabelBackupPresenter::saveFile(const QString& path) {
    if (!backup_) {
        return;
    }
    messages_.solve(kTopic);
    if (const auto written = writeWhole(path, QByteArray::fromStdString(protocol::backupText(*backup_))); !written) {
        messages_.report(written.error(), MessageAction::kNone, kTopic);
        return;
    }
    messages_.toast(tr("Saved as %1.").arg(QFileInfo(path).fileName()));
}

void LabelBackupPresenter::compareWith(const QString& path) {
    if (!backup_) {
        return;
    }
    const auto bytes = readWhole(path, kLargestMemoryFile);
    const auto earlier = bytes ? protocol::parseBackup(bytes->toStdString())
                               : core::Result<protocol::LabelBackup>(tl::unexpected(bytes.error()));
    if (!earlier) {
        messages_.report(earlier.error(), MessageAction::kNone, kTopic);
        return;
    }
    messages_.solve(kTopic);
    changes_.clear();
    std::ranges::transform(protocol::changesBetween(*earlier, *backup_), std::back_inserter(changes_), rowOf);
    std::ranges::stable_sort(changes_, std::ranges::greater{}, &LabelChangeRow::is_setting);
    const auto settings = std::ranges::count(changes_, true, &LabelChangeRow::is_setting);
    comparison_ = tr("Since %1: settings changed: %2, readings that differ: %3.")
                      .arg(QLocale().toString(earlier->utc.toLocalTime(), QLocale::ShortFormat))
                      .arg(settings)
                      .arg(static_cast<qint64>(changes_.size()) - settings);
    if (earlier->serial_number != backup_->serial_number) {
        comparison_ += u' ' + tr("That backup is of another instrument, %1.").arg(latin1(earlier->serial_number));
    }
    Q_EMIT changed();
}

}  // namespace pmts::app
