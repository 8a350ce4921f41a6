#include "connecting.hpp"

#include "pmts/protocol/labels.hpp"
#include "readings.hpp"

#include <algorithm>

namespace pmts::instrument {
namespace {

using core::ErrorKind;
using protocol::InfoClass;

constexpr std::size_t kShownEvidence = 40;

core::Error connectError(ErrorKind kind, QString happened, QString remedy, const std::string& heard) {
    return {.kind = kind,
            .happened = std::move(happened),
            .remedy = std::move(remedy),
            .info_code = std::nullopt,
            .detail = QString::fromLatin1(heard.data(), static_cast<qsizetype>(heard.size()))};
}

bool isReadable(char c) { return (c >= 0x20 && c <= 0x7E) || c == '\r' || c == '\n'; }

QString shown(const std::string& heard) {
    const std::string start = heard.substr(0, kShownEvidence);
    return QString::fromLatin1(start.data(), static_cast<qsizetype>(start.size())).simplified();
}

/// `79=62` and the byte behind its line end: the block end, whatever it is.
struct EndMark {
    bool known = false;
    std::optional<char> mark;
};

EndMark endMarkIn(const protocol::Reply& reply) {
    const auto start = reply.raw.find("79=");
    const auto end = start == std::string::npos ? start : reply.raw.find_first_of("\r\n", start);
    if (end == std::string::npos) {
        return {};
    }
    const auto mark =
        protocol::endMarkFromLabel(std::string_view(reply.raw).substr(start + 3, end - start - 3));
    return mark ? EndMark{.known = true, .mark = *mark} : EndMark{};
}

Question probe(const GeodimeterState& state) {
    return {.bytes = protocol::encode(protocol::ReadLabel{.label = protocol::kEndMark}),
            .limit = state.settings.probe_limit,
            .accepts = [](const protocol::Reply& reply) { return !reply.raw.empty(); }};
}

struct Probed {
    bool answers = false;
    std::string heard;  ///< what came instead
};

/// First with the usual `>`, or the one it had when it was asked last; then by silence, which shows any other block end
/// and none (label 79 = 0).
core::Task<core::Result<Probed>> findEndMark(StatePtr state, std::optional<char> likely, std::stop_token stop) {
    Probed probed;
    for (int i = 0; i < state->settings.probe_attempts; ++i) {
        state->line->setEndMark(i == 0 ? likely : std::nullopt);
        auto asking = exchange(state, probe(*state), stop);
        const auto reply = co_await asking;
        if (state->line == nullptr || (!reply && reply.error().kind != ErrorKind::kTimeOut)) {
            co_return tl::unexpected(reply ? core::cancelled().value() : reply.error());
        }
        const std::string heard = reply ? reply->raw : reply.error().detail.toStdString();
        probed.heard += heard;
        const auto end = reply ? endMarkIn(*reply) : EndMark{};
        // An instrument that cannot show label 79 still ended its refusal with something.
        const bool refuses = reply && reply->ended && checkBlock(*reply).kind == BlockKind::kStatus;
        if (end.known || (refuses && i + 1 == state->settings.probe_attempts)) {
            state->line->setEndMark(end.known ? end.mark : std::optional('>'));
            probed.answers = true;
            break;
        }
        if (refuses) {
            state->line->setEndMark('>');
        }
    }
    co_return probed;
}

core::Task<core::Result<void>> findUnits(StatePtr state, std::stop_token stop) {
    state->units = state->settings.unit_override;
    if (state->units) {
        co_return {};
    }
    auto reading = readAgreedText(state, protocol::kUnits, {}, stop);
    const auto text = co_await reading;
    // Only an instrument that refuses the label has unknown units; on a bad line the answer has not been
    // heard.
    const bool refuses = !text && isClass(text.error(), InfoClass::kProtocol);
    if (!text && !refuses) {
        co_return tl::unexpected(text.error());
    }
    const auto units = text ? protocol::parseUnitStatus(*text) : tl::unexpected(text.error());
    if (units) {
        state->units = *units;
    } else if (!refuses) {
        co_return tl::unexpected(units.error());
    }
    co_return {};
}

core::Task<core::Result<QString>> findSerialNumber(StatePtr state, std::stop_token stop) {
    auto reading = readAgreedText(state, protocol::kSerialNumber, {}, stop);
    const auto text = co_await reading;
    if (!text && isClass(text.error(), InfoClass::kProtocol)) {
        co_return QString();  // an instrument without one is still an instrument
    }
    if (!text) {
        co_return tl::unexpected(text.error());
    }
    co_return QString::fromStdString(*text).trimmed();
}

/// Nothing learned on another line or from another instrument holds here.
void forget(GeodimeterState& state) {
    state.identity.reset();
    state.units.reset();
    state.settings_lost.reset();
    state.mode_selected = false;
    state.distance_is_ours = false;
    state.targets_readable = true;
    state.decimals.clear();
    state.track = {};
    state.warnings.forget();
}

core::Task<core::Result<void>> askFirstValues(StatePtr state, std::stop_token stop) {
    if (state->units) {
        auto reading = readVerifiedPointing(state, stop);
        const auto pointing = co_await reading;
        // A tilted instrument (info 1) has no circles to show, but it is there and says so.
        if (!pointing && pointing.error().kind != ErrorKind::kDevice) {
            co_return tl::unexpected(pointing.error());
        }
    }
    if (state->settings.mode_at_connect) {
        state->mode = *state->settings.mode_at_connect;
        const protocol::Command command = protocol::SetMode{.mode = state->mode};
        auto selecting = ask(state, commandQuestion(*state, command), stop);
        PMTS_CO_TRY(co_await selecting);
        state->mode_selected = true;
    }
    co_return {};
}

}  // namespace

core::Error noInstrument(const std::string& heard) {
    if (heard.empty()) {
        return connectError(
            ErrorKind::kTimeOut, QObject::tr("Nothing answers on this port."),
            QObject::tr("Switch the instrument on, check the cable and the port, and set on the instrument: "
                        "menu 4, 1, Serial: "
                        "Request, 9600 baud, 8 data bits, no parity, 1 stop bit (label 78 = 1.8.0.9600)."),
            heard);
    }
    const auto readable = static_cast<double>(std::ranges::count_if(heard, isReadable));
    if (readable < 0.8 * static_cast<double>(heard.size())) {
        return connectError(
            ErrorKind::kProtocol, QObject::tr("Something answers, but not readably: the baud rates differ."),
            QObject::tr(
                "Set the same line parameters on both sides; on the instrument label 78 = 1.8.0.9600."),
            heard);
    }
    return connectError(
        ErrorKind::kUnsupported,
        QObject::tr("Another device answers on this port (\"%1\").").arg(shown(heard)),
        QObject::tr(
            "Choose the port of the instrument; on the instrument the end mark is label 79 = 62 and the "
            "output is set to Request."),
        heard);
}

core::Task<core::Result<Identity>> identify(StatePtr state, std::stop_token stop) {
    if (state->line == nullptr) {
        co_return core::cancelled();
    }
    if (state->busy) {
        co_return tl::unexpected(busyError());
    }
    const auto likely = state->identity ? state->line->endMark() : std::optional('>');
    forget(*state);
    const Routine routine(state, Activity::kConnecting, stop, std::nullopt);
    auto probing = findEndMark(state, likely, routine.token());
    const auto probed = co_await probing;
    if (!probed) {
        co_return tl::unexpected(probed.error());
    }
    if (!probed->answers) {
        co_return tl::unexpected(noInstrument(probed->heard));
    }
    auto finding_units = findUnits(state, routine.token());
    PMTS_CO_TRY(co_await finding_units);
    auto finding_number = findSerialNumber(state, routine.token());
    const auto number = co_await finding_number;
    if (!number) {
        co_return tl::unexpected(number.error());
    }
    auto first_values = askFirstValues(state, routine.token());
    PMTS_CO_TRY(co_await first_values);
    if (state->line == nullptr) {
        co_return core::cancelled();
    }
    state->identity = Identity{.model = QStringLiteral("Geodimeter"),
                               .serial_number = *number,
                               .units = state->units.value_or(protocol::WireUnits{}),
                               .units_known = state->units.has_value(),
                               .end_mark = state->line->endMark()};
    co_return *state->identity;
}

}  // namespace pmts::instrument
