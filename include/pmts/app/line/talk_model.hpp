#pragma once

#include "pmts/app/line/line_findings.hpp"

#include <QAbstractTableModel>

#include <memory>

namespace pmts::app {

/// The decoded lines of a recording: when, which way, as text and as hexadecimal bytes, side by side. Rows are worded
/// when they are looked at, whatever their number.
class TalkModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kTime, kSide, kText, kHex, kDoubt, kColumnCount };
    static constexpr int kIsDoubtful = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;

    void setFindings(std::shared_ptr<const LineFindings> findings);
    /// The row that holds a character; -1 when there is none.
    [[nodiscard]] int rowOf(std::size_t character) const;
    /// The row that is said at a sample or last before it; -1 when there is none.
    [[nodiscard]] int rowAt(std::uint64_t sample) const;
    /// First and last sample of a row, the last character's whole length included.
    [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> samplesOf(int row) const;
    [[nodiscard]] std::size_t firstCharacterOf(int row) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] std::span<const protocol::DecodedCharacter> charactersOf(int row) const;
    [[nodiscard]] QString textOf(int row, int column) const;

    std::shared_ptr<const LineFindings> findings_;
};

/// `12.345678 s`, or `#4711`, the sample, where the rate is not known.
[[nodiscard]] QString sampleTimeText(std::uint64_t sample, std::optional<double> samples_per_s);
[[nodiscard]] QString sideText(protocol::TalkSide side);

}  // namespace pmts::app
