#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/protocol/memory_file.hpp"
#include "pmts/protocol/units.hpp"
#include "pmts/survey/planned_point.hpp"

#include <QString>

#include <optional>
#include <vector>

namespace pmts::app {

/// What became of a line.
enum class LineFate {
    kRead,     ///< it is here, from a file or from the instrument
    kBad,      ///< it is no `label=data`: it is not sent
    kSent,     ///< it is on its way, not confirmed
    kKept,     ///< read back from the instrument, the same
    kChanged,  ///< read back from the instrument, but not the same
    kLost,     ///< not in the instrument
};

/// A line as the table shows it.
struct MemoryRow {
    int number = 0;
    QString label;    ///< `7`
    QString meaning;  ///< `horizontal angle`; empty: nobody knows this label
    QString data;
    LineFate fate = LineFate::kRead;
    QString remark;   ///< what is wrong with it, or what the instrument made of it
};

/// A job or area file in sight: its lines, what is wrong with them, and whether its points can be computed again.
class MemoryDocument {
public:
    MemoryDocument() = default;
    /// Bytes of a file, or lines from the instrument.
    MemoryDocument(QString name, const std::string& bytes);

    [[nodiscard]] bool isEmpty() const { return file_.lines.empty() && file_.bad.empty(); }
    [[nodiscard]] const QString& name() const { return name_; }
    [[nodiscard]] const protocol::MemoryFile& file() const { return file_; }
    [[nodiscard]] const std::vector<MemoryRow>& rows() const { return rows_; }
    /// `label=data`, as they are sent and saved. Bad lines are not among them.
    [[nodiscard]] std::vector<std::string> lines() const;
    [[nodiscard]] std::string text() const;

    /// Of label 23, or those that were chosen; absent: they must be asked for.
    [[nodiscard]] const std::optional<protocol::WireUnits>& units() const { return units_; }
    [[nodiscard]] bool hasUnitsOfItsOwn() const;
    void chooseUnits(const protocol::WireUnits& units) { units_ = units; }

    /// Whether HA, VA, SD, IH and SH reproduce the coordinates within 1 mm, in one sentence.
    [[nodiscard]] StatusItem verdict() const;
    /// Points with E, N and H, the newest of each name: known points of an area, results and references of a job.
    [[nodiscard]] std::vector<survey::PlannedPoint> points() const;

    void markSent(int lines);
    /// What the instrument holds now, line by line.
    void compareWith(const std::vector<std::string>& kept);

private:
    void makeRows();

    QString name_;
    protocol::MemoryFile file_;
    std::vector<MemoryRow> rows_;
    std::optional<protocol::WireUnits> units_;
};

}  // namespace pmts::app
