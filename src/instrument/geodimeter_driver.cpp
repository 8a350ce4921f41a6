#include "pmts/instrument/geodimeter_driver.hpp"

#include "block_check.hpp"
#include "compensator.hpp"
#include "connecting.hpp"
#include "distance.hpp"
#include "distance_limit.hpp"
#include "file_transfer.hpp"
#include "geodimeter_state.hpp"
#include "label_access.hpp"
#include "label_survey.hpp"
#include "motion.hpp"
#include "pmts/protocol/labels.hpp"
#include "readings.hpp"

#include <algorithm>
#include <array>

namespace pmts::instrument {
namespace {

std::optional<core::Angle> angleIn(const GeodimeterState& state, const CheckedBlock& block, int label) {
    const auto* text = block.find(label);
    const auto angle =
        text != nullptr && decimalsOf(*text) ? circleAngle(state, *text) : tl::unexpected(core::Error{});
    return angle ? std::optional(*angle) : std::nullopt;
}

std::optional<double> lengthIn(const GeodimeterState& state, const CheckedBlock& block, int label) {
    const auto* text = block.find(label);
    if (text == nullptr || !decimalsOf(*text) || !state.units) {
        return std::nullopt;
    }
    const auto length_m = protocol::metresFromWire(*text, state.units->length);
    return length_m ? std::optional(*length_m) : std::nullopt;
}

QString textIn(const CheckedBlock& block, int label) {
    const auto* text = block.find(label);
    return text == nullptr ? QString() : QString::fromStdString(*text);
}

/// A damaged block that nobody asked for cannot be asked for again: its values are left out, its bytes are
/// shown.
/// To a question of the driver's own: REG sends a table, never one of these labels alone.
bool isLateAnswer(const CheckedBlock& block) {
    constexpr std::array kAsked{protocol::kHa,       protocol::kVa,       protocol::kSd,          protocol::kUnits,
                                protocol::kTargetHa, protocol::kTargetVa, protocol::kSerialNumber, protocol::kEndMark};
    return block.items.size() == 1 && std::ranges::find(kAsked, block.items.front().label) != kAsked.end();
}

/// No routine begins before the units are known again: the next poll says so, and the connection begins anew. A routine that
/// runs keeps the units it began with; the code ends it.
void forgetSettings(GeodimeterState& state, const core::Error& error) {
    state.mode_selected = false;
    state.track.is_still = false;
    state.distance_is_ours = false;
    state.settings_lost = error;
}

void handUnsolicited(GeodimeterState& state, const protocol::Reply& reply) {
    const auto block = checkBlock(reply);
    if (block.items.empty()) {
        return state.warnings.note(block.status);
    }
    if (isLateAnswer(block) || state.front == nullptr) {
        return;
    }
    state.distance_is_ours = false;
    UnsolicitedBlock unsolicited;
    unsolicited.ha = angleIn(state, block, protocol::kHa);
    unsolicited.va = angleIn(state, block, protocol::kVa);
    unsolicited.slope_distance_m = lengthIn(state, block, protocol::kSd);
    unsolicited.n_m = lengthIn(state, block, protocol::kNorthing);
    unsolicited.e_m = lengthIn(state, block, protocol::kEasting);
    unsolicited.h_m = lengthIn(state, block, protocol::kElevation);
    unsolicited.point_number = textIn(block, protocol::kPointNumber);
    unsolicited.point_code = textIn(block, protocol::kPointCode);
    unsolicited.raw = QString::fromLatin1(reply.raw.data(), static_cast<qsizetype>(reply.raw.size()));
    if (state.front->on_unsolicited) {
        state.front->on_unsolicited(unsolicited);
    }
}

core::Task<core::Result<geometry::Pointing>> readCircles(StatePtr state, std::stop_token stop) {
    if (const auto refused = refusal(*state, true); refused && refused->happened != busyError().happened) {
        co_return tl::unexpected(*refused);
    }
    auto reading = readVerifiedPointing(state, stop);
    co_return co_await reading;
}

core::Task<core::Result<geometry::Pointing>> pollIfIdle(StatePtr state, std::stop_token stop) {
    if (const auto refused = refusal(*state, true)) {
        co_return tl::unexpected(*refused);
    }
    auto polling = pollCircles(state, stop);
    co_return co_await polling;
}

core::Task<core::Result<void>> changeMode(StatePtr state, EdmMode mode) {
    if (const auto refused = refusal(*state, false)) {
        co_return tl::unexpected(*refused);
    }
    const Routine routine(state, Activity::kReading, {}, std::nullopt);
    auto selecting = selectMode(state, mode, routine.token());
    co_return co_await selecting;
}

core::Task<core::Result<bool>> askSignal(StatePtr state, std::stop_token stop) {
    constexpr int kNoSignal = 300, kSignal = 301;
    if (const auto refused = refusal(*state, false)) {
        co_return tl::unexpected(*refused);
    }
    const Routine routine(state, Activity::kReading, stop, std::nullopt);
    for (int attempt = 0;; ++attempt) {
        Question question = commandQuestion(*state, protocol::SignalTest{});
        question.silence_is_success = false;
        question.accepts = [](const protocol::Reply& reply) {
            return checkBlock(reply).kind == BlockKind::kStatus ||
                   checkBlock(reply).kind == BlockKind::kMalformed;
        };
        auto asking = exchange(state, question, routine.token());
        const auto reply = co_await asking;
        const auto block = reply ? checkBlock(*reply) : CheckedBlock{};
        const auto& status = block.status;
        if (status && (status->code == kNoSignal || status->code == kSignal)) {
            co_return status->code == kSignal;
        }
        const auto error = reply ? deviceError(block) : std::optional(reply.error());
        if (attempt >= state->settings.retries || (error && !isLineTrouble(*error))) {
            co_return tl::unexpected(error.value_or(
                core::fail(core::ErrorKind::kProtocol, QObject::tr("The signal test was not understood."))
                    .value()));
        }
    }
}

}  // namespace

GeodimeterDriver::GeodimeterDriver(scheduler::Scheduler& line, core::Clock& clock,
                                   GeodimeterSettings settings)
    : state_(std::make_shared<GeodimeterState>(line, clock, std::move(settings))) {
    state_->front = this;
    state_->progress.report = [this](const Progress& progress) {
        if (on_progress) {
            on_progress(progress);
        }
    };
    state_->warnings.report = [this](const std::vector<core::Error>& standing) {
        if (on_warnings) {
            on_warnings(standing);
        }
    };
    state_->warnings.on_settings_lost = [this](const core::Error& error) { forgetSettings(*state_, error); };
    line.on_unsolicited = [state = state_](const protocol::Reply& reply) { handUnsolicited(*state, reply); };
    line.on_lost = [state = state_](const core::Error& error) {
        state->track.is_still = false;
        if (state->front != nullptr && state->front->on_lost) {
            state->front->on_lost(error);
        }
    };
}

GeodimeterDriver::~GeodimeterDriver() {
    state_->line->on_unsolicited = nullptr;
    state_->line->on_lost = nullptr;
    state_->routine_stop.request_stop();
    state_->progress.report = nullptr;
    state_->warnings.report = nullptr;
    state_->warnings.on_settings_lost = nullptr;
    state_->front = nullptr;
    state_->line = nullptr;
}

core::Task<core::Result<Identity>> GeodimeterDriver::connectTo(std::stop_token stop) {
    return identify(state_, std::move(stop));
}

core::Task<core::Result<geometry::Pointing>> GeodimeterDriver::readPointing(std::stop_token stop) {
    return readCircles(state_, std::move(stop));
}

core::Task<core::Result<geometry::Pointing>> GeodimeterDriver::turnTo(geometry::Pointing target,
                                                                      core::Angle tolerance,
                                                                      std::stop_token stop) {
    return turn(state_, {.ha = target.ha, .va = target.va, .tolerance = tolerance}, std::move(stop));
}

core::Task<core::Result<geometry::Pointing>> GeodimeterDriver::turnHorizontal(core::Angle ha,
                                                                              core::Angle tolerance,
                                                                              std::stop_token stop) {
    return turn(state_, {.ha = ha, .va = std::nullopt, .tolerance = tolerance}, std::move(stop));
}

core::Task<core::Result<geometry::Pointing>> GeodimeterDriver::turnVertical(core::Angle va,
                                                                            core::Angle tolerance,
                                                                            std::stop_token stop) {
    return turn(state_, {.ha = std::nullopt, .va = va, .tolerance = tolerance}, std::move(stop));
}

core::Task<core::Result<DistanceShot>> GeodimeterDriver::measureDistance(std::stop_token stop) {
    return measure(state_, std::move(stop));
}

core::Task<core::Result<void>> GeodimeterDriver::setMode(EdmMode mode) { return changeMode(state_, mode); }

EdmMode GeodimeterDriver::mode() const { return state_->mode; }

core::Task<core::Result<bool>> GeodimeterDriver::testSignal(std::stop_token stop) {
    return askSignal(state_, std::move(stop));
}

core::Task<core::Result<QString>> GeodimeterDriver::get(int label, std::stop_token stop) {
    return getLabel(state_, label, std::move(stop));
}

core::Task<core::Result<void>> GeodimeterDriver::set(int label, QString data, std::stop_token stop) {
    return setLabel(state_, label, std::move(data), std::move(stop));
}

/// The bytes first, then the routine: it must not come in between with anything of its own.
void GeodimeterDriver::stop() {
    const auto state = state_;
    sendStop(state);
    state->routine_stop.request_stop();
}

core::Task<core::Result<MemoryListing>> GeodimeterDriver::listMemory(std::stop_token stop) {
    return instrument::listMemory(state_, std::move(stop));
}

core::Task<core::Result<DownloadedFile>> GeodimeterDriver::download(MemoryFileId id, OnTransfer progress,
                                                                    std::stop_token stop) {
    return downloadFile(state_, std::move(id), std::move(progress), std::move(stop));
}

core::Task<core::Result<UploadedFile>> GeodimeterDriver::upload(MemoryFileId id, std::vector<std::string> lines,
                                                                OnTransfer progress, std::stop_token stop) {
    return uploadFile(state_, std::move(id), std::move(lines), std::move(progress), std::move(stop));
}

core::Task<core::Result<protocol::LabelBackup>> GeodimeterDriver::backUpLabels(OnTransfer progress, std::stop_token stop) {
    return instrument::backUpLabels(state_, std::move(progress), std::move(stop));
}

core::Task<core::Result<CompensatorRun>> GeodimeterDriver::calibrateCompensator(
    std::function<core::Completion<bool>()> on_question, std::stop_token stop) {
    return instrument::calibrateCompensator(state_, std::move(on_question), std::move(stop));
}

void GeodimeterDriver::setTargetTest(const TargetTest& test) { state_->settings.target_test = test; }

core::Task<core::Result<geometry::Pointing>> GeodimeterDriver::pollPointing(std::stop_token stop) {
    return pollIfIdle(state_, std::move(stop));
}

bool GeodimeterDriver::isBusy() const { return state_->busy; }

bool GeodimeterDriver::noteForeignCommand(std::string_view command) {
    return instrument::noteForeignCommand(*state_, command);
}

void GeodimeterDriver::expectRange(std::optional<double> slope_distance_m) {
    state_->expected_range_m = slope_distance_m;
}

const scheduler::TtStatistics& GeodimeterDriver::statistics() const { return state_->statistics; }

core::Duration GeodimeterDriver::distanceLimit() const { return learnedLimit(*state_); }

}  // namespace pmts::instrument
