#include "label_access.hpp"

#include "pmts/protocol/labels.hpp"
#include "pmts/protocol/units.hpp"
#include "readings.hpp"

#include <algorithm>
#include <cmath>

namespace pmts::instrument {
namespace {

using core::ErrorKind;
using protocol::LabelKind;

constexpr std::size_t kMostDigits = 9;
constexpr std::size_t kMostText = 16;

QString labelName(const protocol::Label& label) {
    return QStringLiteral("%1 (%2)")
        .arg(label.number)
        .arg(QString::fromLatin1(label.meaning.data(), static_cast<qsizetype>(label.meaning.size())));
}

/// What is wrong with writing this, before anything is sent.
std::optional<core::Error> refusedWrite(int number, const std::string& data) {
    const auto* label = protocol::findLabel(number);
    if (label == nullptr || label->access != protocol::LabelAccess::kSet) {
        const auto name = label == nullptr ? QString::number(number) : labelName(*label);
        return core::fail(ErrorKind::kRefused, QObject::tr("Label %1 cannot be written.").arg(name)).value();
    }
    if (data.empty()) {
        return core::fail(ErrorKind::kBadInput, QObject::tr("Label %1 needs a value.").arg(labelName(*label)))
            .value();
    }
    if (label->kind == LabelKind::kText) {
        const bool plain = data.size() <= kMostText &&
                           std::ranges::all_of(data, [](char c) { return c >= 0x20 && c <= 0x7E; });
        return plain ? std::nullopt
                     : std::optional(core::fail(ErrorKind::kBadInput,
                                                QObject::tr("Label %1 takes at most 16 plain characters.")
                                                    .arg(labelName(*label)))
                                         .value());
    }
    const auto digits = std::ranges::count_if(data, [](char c) { return c >= '0' && c <= '9'; });
    if (!protocol::numberFromWire(data) || digits > static_cast<std::ptrdiff_t>(kMostDigits)) {
        return core::fail(ErrorKind::kBadInput,
                          QObject::tr("Label %1 takes a number of at most 9 digits.").arg(labelName(*label)))
            .value();
    }
    return std::nullopt;
}

core::Error notKept(int label, const std::string& written, const std::string& shown) {
    return {.kind = ErrorKind::kDevice,
            .happened = QObject::tr("The instrument did not keep label %1: %2 was written, it shows %3.")
                            .arg(label)
                            .arg(QString::fromStdString(written), QString::fromStdString(shown)),
            .remedy = QObject::tr("Check the value's range, then write again."),
            .info_code = std::nullopt,
            .detail = {}};
}

/// A new end mark holds from the very next block on, whose end may be this write's answer: until it is known,
/// silence ends.
core::Task<core::Result<void>> writeEndMark(StatePtr state, std::string data, Question question,
                                            std::stop_token stop) {
    const auto mark = protocol::endMarkFromLabel(data);
    if (!mark) {
        co_return tl::unexpected(
            core::fail(ErrorKind::kBadInput, QObject::tr("Label 79 takes 0 to 127.")).value());
    }
    const auto before = state->line->endMark();
    state->line->setEndMark(std::nullopt);
    question.accepts = {};
    auto writing = exchange(state, question, stop);
    const auto reply = co_await writing;
    if (state->line == nullptr) {
        co_return core::cancelled();
    }
    const bool refused = reply && reply->raw.find_first_of("0123456789") != std::string::npos;
    state->line->setEndMark(reply && !refused ? *mark : before);
    if (refused) {
        protocol::Reply bare = *reply;
        bare.raw.erase(bare.raw.find_last_of("\r\n") + 1);
        co_return tl::unexpected(
            deviceError(checkBlock(bare)).value_or(notKept(protocol::kEndMark, data, reply->raw)));
    }
    if (!reply) {
        co_return tl::unexpected(reply.error());
    }
    co_return {};
}

core::Task<core::Result<void>> writeLabel(StatePtr state, int label, std::string data, std::stop_token stop) {
    const protocol::Command command = protocol::WriteLabel{.label = label, .data = data};
    Question question = commandQuestion(*state, command);
    question.ours = false;
    if (const auto allowed = protocol::checkDenyList(question.bytes); !allowed) {
        co_return tl::unexpected(allowed.error());
    }
    if (label == protocol::kEndMark) {
        auto writing = writeEndMark(state, data, question, stop);
        co_return co_await writing;
    }
    auto writing = ask(state, question, stop);
    PMTS_CO_TRY(co_await writing);
    co_return {};
}

/// Values the driver relies on change with some labels.
void applyWritten(GeodimeterState& state, int label) {
    if (label == protocol::kHaRef || label == protocol::kCompensator) {
        state.track = {};
    }
}

core::Task<core::Result<void>> writeAndCompare(StatePtr state, int label, std::string data,
                                               std::stop_token stop) {
    std::string shown;
    const int most = state->settings.retries;
    for (int attempt = 0; attempt <= most; ++attempt) {
        auto writing = writeLabel(state, label, data, stop);
        PMTS_CO_TRY(co_await writing);
        applyWritten(*state, label);
        auto reading = readAgreedText(state, label, {}, stop);
        const auto read = co_await reading;
        if (!read) {
            co_return tl::unexpected(read.error());
        }
        shown = *read;
        if (meansTheSame(label, data, shown)) {
            co_return {};
        }
        if (!state->quality.isNoisy()) {
            break;
        }
    }
    co_return tl::unexpected(notKept(label, data, shown));
}

}  // namespace

bool meansTheSame(int label, const std::string& written, const std::string& shown) {
    const auto* known = protocol::findLabel(label);
    const auto wanted = protocol::numberFromWire(written);
    const auto kept = protocol::numberFromWire(shown);
    if (known == nullptr || known->kind == LabelKind::kText || !wanted || !kept) {
        return QString::fromStdString(written).trimmed() == QString::fromStdString(shown).trimmed();
    }
    const double half_digit = 0.5 * std::pow(10.0, -decimalsOf(shown).value_or(0));
    return std::abs(*wanted - *kept) <= half_digit * 1.0001;
}

core::Task<core::Result<QString>> getLabel(StatePtr state, int label, std::stop_token stop) {
    if (const auto refused = refusal(*state, false); refused && refused->kind != ErrorKind::kRefused) {
        co_return tl::unexpected(*refused);
    }
    if (protocol::findLabel(label) == nullptr) {
        co_return core::fail(ErrorKind::kBadInput, QObject::tr("There is no label %1.").arg(label));
    }
    auto reading = readAgreedText(state, label, {}, stop);
    const auto text = co_await reading;
    if (!text) {
        co_return tl::unexpected(text.error());
    }
    co_return QString::fromLatin1(text->data(), static_cast<qsizetype>(text->size()));
}

core::Task<core::Result<void>> setLabel(StatePtr state, int label, QString data, std::stop_token stop) {
    if (const auto refused = refusal(*state, false)) {
        co_return tl::unexpected(*refused);
    }
    const std::string text = data.trimmed().toStdString();
    if (const auto refused = refusedWrite(label, text)) {
        co_return tl::unexpected(*refused);
    }
    const Routine routine(state, Activity::kReading, stop, std::nullopt);
    auto writing = writeAndCompare(state, label, text, routine.token());
    co_return co_await writing;
}

}  // namespace pmts::instrument
