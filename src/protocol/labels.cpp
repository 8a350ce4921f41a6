#include "pmts/protocol/labels.hpp"

#include "label_table.hpp"
#include "pmts/protocol/units.hpp"

#include <QCoreApplication>

#include <algorithm>

namespace pmts::protocol {
namespace {

constexpr std::size_t kLongestText = 16;
constexpr std::ptrdiff_t kMostDigits = 9;
constexpr int kHighestSentLabel = 99;

QString tr(const char* text) { return QCoreApplication::translate("Labels", text); }

tl::unexpected<core::Error> notWritable(const QString& happened, const QString& remedy,
                                        std::string_view data) {
    return core::fail(core::ErrorKind::kBadInput, happened, remedy, QString::fromLatin1(data));
}

core::Result<void> checkText(std::string_view data) {
    const bool plain = std::ranges::all_of(data, [](char c) { return c >= 0x20 && c <= 0x7E; });
    if (!plain || data.size() > kLongestText) {
        return notWritable(tr("The instrument takes at most 16 plain characters here."),
                           tr("Use fewer characters, without accents."), data);
    }
    return {};
}

core::Result<void> checkNumber(std::string_view data, LabelKind kind) {
    const auto digits = std::ranges::count_if(data, [](char c) { return c >= '0' && c <= '9'; });
    const bool whole = data.find('.') == std::string_view::npos;
    if (!numberFromWire(data) || data.find(' ') != std::string_view::npos ||
        (kind == LabelKind::kInteger && !whole)) {
        return notWritable(tr("The instrument takes a number here."),
                           tr("Type digits, at most one point and a sign."), data);
    }
    if (digits > kMostDigits) {
        return notWritable(tr("The instrument takes at most nine digits."), tr("Use fewer decimals."), data);
    }
    return {};
}

}  // namespace

const std::vector<Label>& allLabels() {
    static const std::vector<Label> labels(labelTable().begin(), labelTable().end());
    return labels;
}

const Label* findLabel(int number) {
    const auto table = labelTable();
    return number >= 0 && number < static_cast<int>(table.size()) ? &table[static_cast<std::size_t>(number)]
                                                                  : nullptr;
}

core::Result<void> checkLabelData(int label, std::string_view data) {
    const Label* row = findLabel(label);
    if (row == nullptr || label > kHighestSentLabel || row->access != LabelAccess::kSet) {
        return notWritable(tr("Label %1 cannot be set.").arg(label),
                           tr("Choose a label that the instrument lets you set."), data);
    }
    if (data.empty()) {
        return notWritable(tr("The instrument does not take an empty value."), tr("Type a value."), data);
    }
    return row->kind == LabelKind::kText ? checkText(data) : checkNumber(data, row->kind);
}

}  // namespace pmts::protocol
