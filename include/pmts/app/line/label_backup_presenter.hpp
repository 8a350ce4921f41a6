#pragma once

#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/line/memory_presenter.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/protocol/label_backup.hpp"

#include <QObject>

#include <optional>
#include <vector>

namespace pmts::app {

/// A label that says something else than in the earlier backup, in words.
struct LabelChangeRow {
    QString label;    ///< `20 distance offset`
    QString before;
    QString after;
    bool is_setting = false;
};

/// All labels of the instrument, read into one text; what changed since an earlier one. Only reads.
class LabelBackupPresenter : public QObject {
    Q_OBJECT
public:
    LabelBackupPresenter(InstrumentDesk& instrument, MessageCentre& messages, QObject* parent = nullptr);

    [[nodiscard]] const std::optional<protocol::LabelBackup>& backup() const { return backup_; }
    [[nodiscard]] const TransferView& transfer() const { return transfer_; }
    [[nodiscard]] QString sentence() const;  ///< what was read, when, of which instrument
    [[nodiscard]] QString comparison() const { return comparison_; }
    /// All that was read: `after` is the value, or why there is none.
    [[nodiscard]] std::vector<LabelChangeRow> labels() const;
    [[nodiscard]] const std::vector<LabelChangeRow>& changes() const { return changes_; }
    [[nodiscard]] QString proposedFileName() const;

public Q_SLOTS:
    void read();
    void cancel();
    void saveFile(const QString& path);
    /// With an earlier backup of a file; of another instrument it is said.
    void compareWith(const QString& path);

Q_SIGNALS:
    void changed();
    void transferChanged();

private:
    void onProgress(Ticket ticket, const instrument::TransferProgress& progress);
    void onBackedUp(Ticket ticket, const protocol::LabelBackup& backup);
    void onFailed(Ticket ticket, const core::Error& error);
    void setTransfer(const TransferView& transfer);

    InstrumentDesk& instrument_;
    MessageCentre& messages_;
    std::optional<protocol::LabelBackup> backup_;
    TransferView transfer_;
    QString comparison_;
    std::vector<LabelChangeRow> changes_;
    Ticket ticket_ = 0;
};

}  // namespace pmts::app
