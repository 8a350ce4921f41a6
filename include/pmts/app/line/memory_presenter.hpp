#pragma once

#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/line/memory_document.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/field/planned_points_model.hpp"

#include <QObject>

#include <optional>
#include <vector>

namespace pmts::app {

/// What the page shows while something runs.
struct TransferView {
    bool busy = false;
    QString text;                     ///< what and how far, in words
    std::optional<double> fraction;   ///< absent: the end is not known
};

/// The instrument's memory: what is in it, one file in sight, and its ways in and out. A file is written whole or not
/// at all; nothing in the instrument is ever overwritten or erased.
class MemoryPresenter : public QObject {
    Q_OBJECT
public:
    MemoryPresenter(InstrumentDesk& instrument, PlannedPointsModel& planned, MessageCentre& messages,
                    QObject* parent = nullptr);

    [[nodiscard]] bool isConnected() const;
    [[nodiscard]] bool isReachable() const { return instrument_.speaksExternal(); }  ///< the bus does not lead there
    [[nodiscard]] QString roomText() const;  ///< free bytes, or why they are not known
    [[nodiscard]] bool isListed() const { return listed_; }
    [[nodiscard]] const instrument::MemoryListing& listing() const { return listing_; }
    [[nodiscard]] const MemoryDocument& document() const { return document_; }
    [[nodiscard]] QString documentSource() const { return source_; }  ///< where it is from, what came of it
    [[nodiscard]] const TransferView& transfer() const { return transfer_; }
    [[nodiscard]] DeviceState state() const { return state_; }

    [[nodiscard]] static QString nameOf(protocol::Directory directory);  ///< `Job`, `Area`
    /// A name for a file of the computer: up to 15 plain characters.
    [[nodiscard]] static QString proposedName(const QString& file_name);
    [[nodiscard]] static QString fileFilter();
    [[nodiscard]] QString proposedFileName() const;

public Q_SLOTS:
    void refresh();
    void download(const pmts::instrument::MemoryFileId& file);
    /// Refused where the name is taken: nameTaken() proposes another. Bad lines are left out only when `without_bad`.
    void upload(const pmts::instrument::MemoryFileId& file, bool without_bad = false);
    void cancel();
    void openFile(const QString& path);
    /// Whole or not at all; CR LF.
    void saveFile(const QString& path);
    void chooseUnits(const pmts::protocol::WireUnits& units);
    /// Its points with E, N, H become planned points of the open job.
    void takePoints();

Q_SIGNALS:
    void listingChanged();
    void documentChanged();
    void transferChanged();
    void stateChanged(pmts::app::DeviceState state);
    void nameTaken(const pmts::instrument::MemoryFileId& wanted, const QString& free_name);
    void badLinesFound(const pmts::instrument::MemoryFileId& wanted, int count);

private:
    void setState(DeviceState state);
    void begin(Ticket ticket, const QString& text, DeviceState state = DeviceState::kBusy);
    void end(DeviceState state);
    void forgetVerdict();
    void onListed(Ticket ticket, const instrument::MemoryListing& listing);
    void onProgress(Ticket ticket, const instrument::TransferProgress& progress);
    void onDownloaded(Ticket ticket, const instrument::DownloadedFile& file);
    void onUploaded(Ticket ticket, const instrument::UploadedFile& file);
    void onFailed(Ticket ticket, const core::Error& error);
    void show(MemoryDocument document, const QString& source);
    [[nodiscard]] bool isTaken(const instrument::MemoryFileId& file) const;
    [[nodiscard]] QString freeName(const instrument::MemoryFileId& file) const;

    InstrumentDesk& instrument_;
    PlannedPointsModel& planned_;
    MessageCentre& messages_;
    instrument::MemoryListing listing_;
    bool listed_ = false;
    MemoryDocument document_;
    QString source_;
    TransferView transfer_;
    DeviceState state_ = DeviceState::kIdle;
    DeviceState verdict_ = DeviceState::kGood;  ///< of the latest transfer, for the lamp after a listing
    Ticket ticket_ = 0;
    std::optional<instrument::MemoryFileId> sending_;
};

}  // namespace pmts::app
