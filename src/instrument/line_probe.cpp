#include "pmts/instrument/line_probe.hpp"

#include "pmts/protocol/command.hpp"
#include "pmts/protocol/labels.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <ranges>

namespace pmts::instrument {
namespace {

using transport::Parity;
using transport::SerialSettings;

constexpr core::Duration kTick = std::chrono::milliseconds(25);
constexpr int kLongestExchange = 40;  ///< bytes of a question and its answer
constexpr double kBitsPerByte = 11.0;
constexpr std::array kBauds{9600, 4800, 19200, 2400, 1200, 300};

struct Framing {
    int data_bits;
    Parity parity;
    int stop_bits;
};
constexpr std::array<Framing, 5> kOtherFramings{
    {{7, Parity::kEven, 1}, {7, Parity::kOdd, 1}, {8, Parity::kEven, 1}, {8, Parity::kOdd, 1}, {8, Parity::kNone, 2}}};

core::Duration timeFor(int bytes, int baud) {
    return std::chrono::duration_cast<core::Duration>(std::chrono::duration<double>(bytes * kBitsPerByte / baud));
}

bool isMoreTelling(const ProbedPort& a, const ProbedPort& b) {
    return std::pair(a.evidence.symptom, a.evidence.seven_bits_with.has_value()) >
           std::pair(b.evidence.symptom, b.evidence.seven_bits_with.has_value());
}

/// Nothing else can be learned at other settings.
bool isSettled(const LineEvidence& evidence) {
    return evidence.isOurs() || evidence.symptom == LineSymptom::kModem;
}

/// Text under a parity bit tells the framing: it is tried next.
void moveUp(std::vector<SerialSettings>& left, const SerialSettings& line, const LineEvidence& evidence) {
    if (!evidence.seven_bits_with) {
        return;
    }
    std::ranges::stable_partition(left, [&line, &evidence](const SerialSettings& other) {
        return other.baud == line.baud && other.data_bits == 7 && other.parity == *evidence.seven_bits_with;
    });
}

}  // namespace

/// A port, and what is still to be tried on it.
struct LineProbe::Search {
    ProbedPort best;
    std::vector<SerialSettings> left;
};

/// An open port and what came in since the last question.
struct LineProbe::Ear {
    std::unique_ptr<transport::ByteLink> link;
    std::string heard;
    core::Duration last_at{0};
    std::optional<core::Error> lost;
};

namespace {

/// A finished exchange may hold its ear until the stack has unwound, but the next setting opens the port at once.
class ClosedAtEnd {
public:
    explicit ClosedAtEnd(transport::ByteLink& link) : link_(link) {}
    ~ClosedAtEnd() { link_.close(); }
    ClosedAtEnd(const ClosedAtEnd&) = delete;
    ClosedAtEnd& operator=(const ClosedAtEnd&) = delete;

private:
    transport::ByteLink& link_;
};

}  // namespace

LineProbe::LineProbe(MakeLink make_link, core::Clock& clock, ProbeSettings settings)
    : make_link_(std::move(make_link)), clock_(clock), settings_(settings) {}

std::vector<SerialSettings> LineProbe::usualLines() {
    std::vector<SerialSettings> lines;
    for (const int baud : kBauds) {
        lines.push_back({.port_name = {}, .baud = baud});
    }
    for (const int baud : kBauds) {
        for (const Framing& framing : kOtherFramings) {
            lines.push_back({.port_name = {},
                             .baud = baud,
                             .data_bits = framing.data_bits,
                             .parity = framing.parity,
                             .stop_bits = framing.stop_bits});
        }
    }
    return lines;
}

void LineProbe::say(const SerialSettings& line) {
    if (on_step) {
        on_step({.line = line, .done = done_, .of = of_});
    }
}

/// The likely settings are asked on every port before the unlikely ones on any.
core::Task<core::Result<ProbeOutcome>> LineProbe::run(std::vector<QString> ports, std::stop_token stop) {
    std::vector<std::shared_ptr<Search>> searches;
    for (const QString& port : ports) {
        searches.push_back(std::make_shared<Search>(Search{.best = {}, .left = usualLines()}));
        searches.back()->best.line.port_name = port;
    }
    done_ = 0;
    of_ = static_cast<int>(usualLines().size() * ports.size());
    ProbeOutcome outcome;
    const auto goes_on = [](const auto& search) { return !search->left.empty(); };
    while (!outcome.found && std::ranges::any_of(searches, goes_on)) {
        for (const auto& search : searches | std::views::filter(goes_on)) {
            auto asking = askNext(search, stop);
            PMTS_CO_TRY(co_await asking);
            if (search->best.evidence.isOurs()) {
                outcome.found = search->best;
                break;
            }
        }
    }
    std::ranges::transform(searches, std::back_inserter(outcome.ports), [](const auto& search) { return search->best; });
    co_return outcome;
}

core::Task<core::Result<void>> LineProbe::askNext(std::shared_ptr<Search> search, std::stop_token stop) {
    SerialSettings line = search->left.front();
    search->left.erase(search->left.begin());
    line.port_name = search->best.line.port_name;
    say(line);
    auto asking = ask(line, stop);
    const auto shown = co_await asking;
    if (!shown) {
        co_return tl::unexpected(shown.error());
    }
    ++done_;
    if (shown->trouble || isMoreTelling(*shown, search->best)) {
        search->best = *shown;
    }
    if (shown->trouble || isSettled(shown->evidence)) {
        done_ += static_cast<int>(search->left.size());
        search->left.clear();
    }
    moveUp(search->left, line, shown->evidence);
    co_return core::Result<void>{};
}

core::Task<core::Result<ProbedPort>> LineProbe::ask(SerialSettings line, std::stop_token stop) {
    ProbedPort shown;
    shown.line = line;
    const auto ear = std::make_shared<Ear>();
    ear->link = make_link_(line);
    ear->link->on_received = [raw = ear.get(), this](std::string_view bytes) {
        raw->heard += bytes;
        raw->last_at = clock_.now();
    };
    const ClosedAtEnd closing(*ear->link);
    ear->link->on_lost = [raw = ear.get()](const core::Error& error) { raw->lost = error; };
    if (auto opened = ear->link->open(); !opened) {
        shown.trouble = std::move(opened).error();
        co_return shown;
    }
    auto settling = core::sleepFor(clock_, settings_.settle, stop);
    PMTS_CO_TRY(co_await settling);
    // What earlier tries left in the instrument's ear ends here, with a refusal at most.
    auto clearing = exchange(ear, std::string("\r"), settings_.quiet, stop);
    PMTS_CO_TRY(co_await clearing);
    const std::string question = protocol::encode(protocol::ReadLabel{.label = protocol::kEndMark});
    const auto limit = settings_.answer_limit + timeFor(kLongestExchange, line.baud);
    auto asking = exchange(ear, question, limit, stop);
    auto heard = co_await asking;
    if (!heard) {
        co_return tl::unexpected(heard.error());
    }
    shown.evidence = judgeLine(question, *heard);
    const bool usual = line.baud == kBauds.front() && line.data_bits == 8 && line.parity == Parity::kNone;
    if (shown.evidence.symptom == LineSymptom::kEcho && usual) {  // a modem echoes too, and answers what is meant for it
        auto greeting = exchange(ear, std::string("AT\r"), limit, stop);
        const auto greeted = co_await greeting;
        const auto judged = greeted ? judgeLine("AT\r", *greeted) : LineEvidence{};
        if (judged.symptom == LineSymptom::kModem) {
            shown.evidence = judged;
        }
    }
    shown.heard = *std::move(heard);
    shown.trouble = ear->lost;
    co_return shown;
}

/// What came until the line was quiet for long enough, the block ended or nothing came within the limit.
core::Task<core::Result<std::string>> LineProbe::exchange(std::shared_ptr<Ear> ear, std::string question,
                                                          core::Duration limit, std::stop_token stop) {
    constexpr std::string_view kEnd = "\r\n>";
    ear->heard.clear();
    ear->link->write(question);
    const core::Duration asked_at = clock_.now();
    const core::Duration longest = 2 * limit + settings_.quiet;  // somebody may never be quiet
    while (!ear->lost && clock_.now() - asked_at < longest) {
        const bool silent = ear->heard.empty();
        const bool over = silent ? clock_.now() - asked_at >= limit : clock_.now() - ear->last_at >= settings_.quiet;
        if (over || (ear->heard.ends_with(kEnd) && question.size() > 1)) {
            break;
        }
        auto waiting = core::sleepFor(clock_, kTick, stop);
        PMTS_CO_TRY(co_await waiting);
    }
    co_return ear->heard;
}

}  // namespace pmts::instrument
