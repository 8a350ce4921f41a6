#include "pmts/app/line/talk_model.hpp"

#include <QCoreApplication>
#include <QFont>

#include <algorithm>
#include <limits>

namespace pmts::app {

void TalkModel::setFindings(std::shared_ptr<const LineFindings> findings) {
    beginResetModel();
    findings_ = std::move(findings);
    endResetModel();
}

int TalkModel::rowOf(std::size_t character) const {
    if (!findings_ || character >= findings_->characters.size()) {
        return -1;
    }
    const auto behind = std::ranges::upper_bound(findings_->talk, character, {}, &protocol::TalkLine::first);
    return static_cast<int>(behind - findings_->talk.begin()) - 1;
}

int TalkModel::rowAt(std::uint64_t sample) const {
    if (!findings_ || findings_->characters.empty()) {
        return -1;
    }
    const auto behind =
        std::ranges::upper_bound(findings_->characters, sample, {}, &protocol::DecodedCharacter::sample);
    const auto at = std::max<std::ptrdiff_t>(0, behind - findings_->characters.begin() - 1);
    return rowOf(static_cast<std::size_t>(at));
}

std::pair<std::uint64_t, std::uint64_t> TalkModel::samplesOf(int row) const {
    const auto characters = charactersOf(row);
    double length = 1.0;
    for (const FoundLine& line : findings_->lines) {
        length = line.framing && line.is_decoded ? std::max(length, 12.0 * line.framing->samples_per_bit) : length;
    }
    return {characters.front().sample, characters.back().sample + static_cast<std::uint64_t>(length)};
}

std::size_t TalkModel::firstCharacterOf(int row) const { return findings_->talk[static_cast<std::size_t>(row)].first; }

std::span<const protocol::DecodedCharacter> TalkModel::charactersOf(int row) const {
    const protocol::TalkLine& line = findings_->talk[static_cast<std::size_t>(row)];
    return std::span(findings_->characters).subspan(line.first, line.count);
}

int TalkModel::rowCount(const QModelIndex& parent) const {
    constexpr std::size_t kMost = std::numeric_limits<int>::max() / 64;  // views count pixels in int
    return parent.isValid() || !findings_ ? 0 : static_cast<int>(std::min(findings_->talk.size(), kMost));
}

int TalkModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumnCount; }

QString TalkModel::textOf(int row, int column) const {
    const auto characters = charactersOf(row);
    switch (column) {
        case kTime:
            return sampleTimeText(characters.front().sample, findings_->recording->samples_per_s);
        case kSide:
            return sideText(characters.front().side);
        case kText:
            return QString::fromStdString(protocol::textOf(characters));
        case kHex:
            return QString::fromStdString(protocol::hexOf(characters));
        default:
            break;
    }
    const auto unsure = findings_->talk[static_cast<std::size_t>(row)].unsure;
    return unsure == 0 ? QString() : tr("? %1").arg(unsure);
}

QVariant TalkModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || !findings_) {
        return {};
    }
    const bool doubtful = findings_->talk[static_cast<std::size_t>(index.row())].unsure > 0;
    switch (role) {
        case Qt::DisplayRole:
            return textOf(index.row(), index.column());
        case Qt::ToolTipRole:
            return index.column() == kDoubt && doubtful ? tr("Characters with a question mark are not sure.")
                                                        : textOf(index.row(), index.column());
        case Qt::TextAlignmentRole:
            return QVariant::fromValue<Qt::Alignment>((index.column() == kTime ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        case kIsDoubtful:
            return doubtful;
        default:
            return {};
    }
}

QVariant TalkModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
        case kTime:
            return tr("Time");
        case kSide:
            return tr("Way");
        case kText:
            return tr("Text");
        case kHex:
            return tr("Bytes");
        default:
            return tr("Doubt");
    }
}

QString sampleTimeText(std::uint64_t sample, std::optional<double> samples_per_s) {
    return samples_per_s ? QStringLiteral("%1 s").arg(static_cast<double>(sample) / *samples_per_s, 0, 'f', 6)
                         : QStringLiteral("#%1").arg(sample);
}

QString sideText(protocol::TalkSide side) {
    switch (side) {
        case protocol::TalkSide::kToInstrument:
            return QCoreApplication::translate("TalkModel", "→ to");
        case protocol::TalkSide::kFromInstrument:
            return QCoreApplication::translate("TalkModel", "← from");
        case protocol::TalkSide::kUnknown:
            break;
    }
    return QStringLiteral("–");
}

}  // namespace pmts::app
