#pragma once

#include "pmts/protocol/command.hpp"

#include <QMetaType>
#include <QString>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pmts::instrument {

/// A file in the instrument's memory: a job (M) or an area (I).
struct MemoryFileId {
    protocol::Directory directory = protocol::Directory::kJob;
    QString name;  ///< 1 to 15 characters, case counts

    [[nodiscard]] bool operator==(const MemoryFileId&) const = default;
};

struct MemoryListing {
    std::vector<MemoryFileId> files;
    std::optional<qint64> free_bytes;  ///< absent: the instrument does not say
};

enum class TransferStep { kReading, kComparing, kSending, kReadingBack, kLabels };

/// How far a transfer is: lines (or labels), and how many where that is known.
struct TransferProgress {
    TransferStep step = TransferStep::kReading;
    int done = 0;
    std::optional<int> of;
};
using OnTransfer = std::function<void(const TransferProgress&)>;

/// A file as two readings agreed on it. The line has no check sum: one reading is believed by nobody.
struct DownloadedFile {
    MemoryFileId id;
    std::vector<std::string> lines;
    int readings = 0;  ///< more than two: the line loses bytes
};

/// What came of a file that was sent.
struct UploadedFile {
    MemoryFileId id;
    int sent_lines = 0;
    bool cancelled = false;          ///< the instrument may hold the lines sent so far; PMTS never erases
    std::vector<std::string> kept;   ///< read back; empty when cancelled
};

/// What came of PV,20 (protocol page 2.9): no end of it is documented.
struct CompensatorRun {
    bool ended_by_block = false;  ///< false: it fell silent, and answers questions again
    bool showed_compensator = false;
    bool answered_no = false;     ///< to the latest question
};

}  // namespace pmts::instrument
