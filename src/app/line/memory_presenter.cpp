#include "pmts/app/line/memory_presenter.hpp"

#include "pmts/app/desk/whole_file.hpp"

#include <QFileInfo>
#include <QLocale>

#include <algorithm>

namespace pmts::app {
namespace {

const QString kTopic = QStringLiteral("memory");
const QString kVerdictTopic = QStringLiteral("memory_verdict");  ///< of a transfer: a listing leaves it alone
constexpr int kFileExists = 33;
constexpr qsizetype kLongestName = 15;

QString idText(const instrument::MemoryFileId& file) {
    return MemoryPresenter::nameOf(file.directory) + u' ' + file.name;
}

std::string bytesOf(const std::vector<std::string>& lines) {
    std::string bytes;
    for (const std::string& line : lines) {
        bytes += line + "\r\n";
    }
    return bytes;
}

}  // namespace

MemoryPresenter::MemoryPresenter(InstrumentDesk& instrument, PlannedPointsModel& planned, MessageCentre& messages,
                                 QObject* parent)
    : QObject(parent), instrument_(instrument), planned_(planned), messages_(messages) {
    connect(&instrument_, &InstrumentDesk::memoryListed, this, &MemoryPresenter::onListed);
    connect(&instrument_, &InstrumentDesk::transferProgressed, this, &MemoryPresenter::onProgress);
    connect(&instrument_, &InstrumentDesk::fileDownloaded, this, &MemoryPresenter::onDownloaded);
    connect(&instrument_, &InstrumentDesk::fileUploaded, this, &MemoryPresenter::onUploaded);
    connect(&instrument_, &InstrumentDesk::requestFailed, this, &MemoryPresenter::onFailed);
    connect(&instrument_, &InstrumentDesk::connectionChanged, this, [this] {
        listed_ = listed_ && isReachable();
        Q_EMIT listingChanged();
    });
}

bool MemoryPresenter::isConnected() const { return instrument_.connectionState() == ConnectionState::kConnected; }

QString MemoryPresenter::roomText() const {
    if (!isConnected()) {
        return tr("No instrument is connected.");
    }
    if (!isReachable()) {
        return tr("The memory is reached on the external interface only: connect to the instrument's foot.");
    }
    if (!listed_) {
        return tr("The files were not asked for yet.");
    }
    return listing_.free_bytes ? tr("%1 bytes are free.").arg(QLocale().toString(*listing_.free_bytes))
                               : tr("The instrument does not say how much is free.");
}

QString MemoryPresenter::nameOf(protocol::Directory directory) {
    return directory == protocol::Directory::kArea ? tr("Area") : tr("Job");
}

QString MemoryPresenter::proposedName(const QString& file_name) {
    QString name;
    for (const QChar c : QFileInfo(file_name).completeBaseName()) {
        if (c > u' ' && c < u'\x7f' && c != u'=' && c != u'>' && name.size() < kLongestName) {
            name += c;
        }
    }
    return name.isEmpty() ? QStringLiteral("PMTS") : name;
}

QString MemoryPresenter::fileFilter() {
    return tr("Job and area files (*.job *.JOB *.are *.ARE *.dat *.DAT *.txt);;All files (*)");
}

QString MemoryPresenter::proposedFileName() const {
    const QString base = proposedName(document_.name() + QStringLiteral(".x"));
    const bool is_area = std::ranges::none_of(document_.rows(), [](const MemoryRow& row) {
        return row.label == QLatin1String("2") || row.label == QLatin1String("7");
    });
    return base + (is_area ? QStringLiteral(".ARE") : QStringLiteral(".JOB"));
}

// From and to the instrument ------------------------------------------------------------------------------------------

void MemoryPresenter::refresh() {
    if (!transfer_.busy && isReachable()) {
        begin(instrument_.listMemory(), tr("Asking what is in the memory."));
    }
}

void MemoryPresenter::download(const instrument::MemoryFileId& file) {
    if (!transfer_.busy && isReachable()) {
        forgetVerdict();
        begin(instrument_.downloadFile(file), tr("Reading %1.").arg(idText(file)));
    }
}

void MemoryPresenter::upload(const instrument::MemoryFileId& file, bool without_bad) {
    if (transfer_.busy || !isReachable() || document_.file().lines.empty()) {
        return;
    }
    if (isTaken(file)) {
        Q_EMIT nameTaken(file, freeName(file));
        return;
    }
    if (!document_.file().bad.empty() && !without_bad) {
        Q_EMIT badLinesFound(file, static_cast<int>(document_.file().bad.size()));
        return;
    }
    forgetVerdict();
    sending_ = file;
    begin(instrument_.uploadFile(file, document_.lines()), tr("Sending %1.").arg(idText(file)));
}

void MemoryPresenter::cancel() {
    if (transfer_.busy) {
        transfer_.text = tr("Ending: the instrument finishes its part.");
        transfer_.fraction.reset();
        Q_EMIT transferChanged();
        instrument_.cancel(ticket_);
    }
}

void MemoryPresenter::setState(DeviceState state) {
    state_ = state;
    Q_EMIT stateChanged(state_);
}

void MemoryPresenter::begin(Ticket ticket, const QString& text, DeviceState state) {
    ticket_ = ticket;
    messages_.solve(kTopic);
    transfer_ = {.busy = true, .text = text, .fraction = std::nullopt};
    setState(state);
    Q_EMIT transferChanged();
}

/// A new file is in sight, or a new way begins: what the last one came to is old.
void MemoryPresenter::forgetVerdict() {
    messages_.solve(kVerdictTopic);
    verdict_ = DeviceState::kGood;
}

void MemoryPresenter::end(DeviceState state) {
    ticket_ = 0;
    sending_.reset();
    transfer_ = {};
    setState(state);
    Q_EMIT transferChanged();
}

void MemoryPresenter::onListed(Ticket ticket, const instrument::MemoryListing& listing) {
    if (ticket != ticket_) {
        return;
    }
    listing_ = listing;
    listed_ = true;
    end(verdict_);
    Q_EMIT listingChanged();
}

void MemoryPresenter::onProgress(Ticket ticket, const instrument::TransferProgress& progress) {
    using instrument::TransferStep;
    if (ticket != ticket_ || !transfer_.busy) {
        return;
    }
    const QString lines =
        progress.of ? tr("line %1 of %2").arg(progress.done).arg(*progress.of) : tr("line %1").arg(progress.done);
    switch (progress.step) {
        case TransferStep::kReading:
            transfer_.text = tr("Reading: %1").arg(lines);
            break;
        case TransferStep::kComparing:
            transfer_.text = tr("Reading again, to compare: %1").arg(lines);
            break;
        case TransferStep::kSending:
            transfer_.text = tr("Sending: %1").arg(lines);
            break;
        case TransferStep::kReadingBack:
            transfer_.text = tr("Reading back: %1").arg(lines);
            break;
        case TransferStep::kLabels:
            break;  // of a backup
    }
    transfer_.fraction = progress.of && *progress.of > 0
                             ? std::optional(std::min(1.0, static_cast<double>(progress.done) / *progress.of))
                             : std::nullopt;
    Q_EMIT transferChanged();
}

void MemoryPresenter::onDownloaded(Ticket ticket, const instrument::DownloadedFile& file) {
    if (ticket != ticket_) {
        return;
    }
    end(DeviceState::kGood);
    show(MemoryDocument(file.id.name, bytesOf(file.lines)),
         file.readings > 2 ? tr("%1 from the instrument; the line loses bytes, %2 readings were needed")
                                 .arg(idText(file.id))
                                 .arg(file.readings)
                           : tr("%1 from the instrument, read twice and the same").arg(idText(file.id)));
}

void MemoryPresenter::onUploaded(Ticket ticket, const instrument::UploadedFile& file) {
    if (ticket != ticket_) {
        return;
    }
    verdict_ = DeviceState::kWarning;
    if (file.cancelled) {
        end(verdict_);
        document_.markSent(file.sent_lines);
        source_ = tr("%1: cancelled after line %2").arg(idText(file.id)).arg(file.sent_lines);
        messages_.warn(tr("Cancelled: the instrument may hold %1 with the first %2 lines.")
                           .arg(idText(file.id))
                           .arg(file.sent_lines),
                       tr("Erase it at the control unit, or send the file under another name; PMTS erases nothing."),
                       MessageAction::kNone, kVerdictTopic);
        Q_EMIT documentChanged();
        return;
    }
    document_.compareWith(file.kept);
    const auto differ = std::ranges::count_if(document_.rows(), [](const MemoryRow& row) {
        return row.fate == LineFate::kChanged || row.fate == LineFate::kLost;
    });
    source_ =
        differ == 0
            ? tr("%1 is in the instrument: %2 lines, read back and the same").arg(idText(file.id)).arg(file.sent_lines)
            : tr("%1 is in the instrument, but %2 lines are not as they were sent").arg(idText(file.id)).arg(differ);
    if (differ == 0) {
        messages_.toast(source_);
        verdict_ = DeviceState::kGood;
    } else {
        messages_.warn(source_ + u'.', tr("Look at the marked lines."), MessageAction::kNone, kVerdictTopic);
    }
    end(verdict_);
    Q_EMIT documentChanged();
    refresh();
}

void MemoryPresenter::onFailed(Ticket ticket, const core::Error& error) {
    if (ticket != ticket_ || ticket == 0) {
        return;
    }
    const auto sending = sending_;
    const bool cancelled = error.kind == core::ErrorKind::kCancelled;
    end(cancelled ? DeviceState::kIdle : DeviceState::kFailed);
    if (sending) {
        document_.markSent(0);
        Q_EMIT documentChanged();
    }
    if (sending && error.info_code == kFileExists) {
        Q_EMIT nameTaken(*sending, freeName(*sending));
    } else if (!cancelled) {
        verdict_ = sending ? DeviceState::kFailed : verdict_;
        messages_.report(error, MessageAction::kNone, sending ? kVerdictTopic : kTopic);
    }
}

bool MemoryPresenter::isTaken(const instrument::MemoryFileId& file) const {
    return std::ranges::find(listing_.files, file) != listing_.files.end();
}

QString MemoryPresenter::freeName(const instrument::MemoryFileId& file) const {
    instrument::MemoryFileId other = file;
    for (int i = 2; other == file || isTaken(other); ++i) {
        const QString number = QString::number(i);
        other.name = file.name.left(kLongestName - number.size()) + number;
    }
    return other.name;
}

// Files of the computer -----------------------------------------------------------------------------------------------

void MemoryPresenter::openFile(const QString& path) {
    messages_.solve(kTopic);
    forgetVerdict();
    if (!transfer_.busy) {
        setState(listed_ ? verdict_ : DeviceState::kIdle);
    }
    const auto bytes = readWhole(path, kLargestMemoryFile);
    if (!bytes) {
        messages_.report(bytes.error(), MessageAction::kNone, kTopic);
        return;
    }
    show(MemoryDocument(QFileInfo(path).completeBaseName(), bytes->toStdString()),
         tr("from %1").arg(QFileInfo(path).fileName()));
}

void MemoryPresenter::saveFile(const QString& path) {
    messages_.solve(kTopic);
    if (const auto written = writeWhole(path, QByteArray::fromStdString(document_.text())); !written) {
        messages_.report(written.error(), MessageAction::kNone, kTopic);
        return;
    }
    messages_.toast(tr("Saved as %1.").arg(QFileInfo(path).fileName()));
}

void MemoryPresenter::chooseUnits(const protocol::WireUnits& units) {
    document_.chooseUnits(units);
    Q_EMIT documentChanged();
}

void MemoryPresenter::takePoints() {
    if (!document_.units()) {
        messages_.warn(tr("The units of the file are not known."), tr("Choose them first."), MessageAction::kNone,
                       kTopic);
        return;
    }
    const auto points = document_.points();
    if (points.empty()) {
        messages_.warn(tr("No point of the file has N, E and elevation."),
                       tr("Labels 37, 38 and 39 say where a point is."), MessageAction::kNone, kTopic);
        return;
    }
    planned_.add(points, document_.name());
}

void MemoryPresenter::show(MemoryDocument document, const QString& source) {
    document_ = std::move(document);
    source_ = source;
    Q_EMIT documentChanged();
}

}  // namespace pmts::app
