#include "pmts/app/line/replay_presenter.hpp"

#include "black_box_records.hpp"
#include "replay_source.hpp"
#include "unasked_bytes.hpp"

#include <QCborArray>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QThreadPool>

#include <algorithm>
#include <array>
#include <map>

namespace pmts::app {

namespace {

using blackbox::Kind;

constexpr auto kStep = std::chrono::milliseconds(33);
constexpr qint64 kPiece_ms = 40;                 ///< the window stands still no longer
constexpr std::size_t kLookedAtTogether = 32;

core::Error nothingIsSent() {
    return {.kind = core::ErrorKind::kRefused,
            .happened = QCoreApplication::translate("Replay", "A recording is shown: nothing is sent to any instrument."),
            .remedy = QCoreApplication::translate("Replay", "Start PMTS without a recording to work with an instrument."),
            .info_code = std::nullopt,
            .detail = {}};
}

class BarredLink final : public transport::ByteLink {
public:
    [[nodiscard]] core::Result<void> open() override { return tl::unexpected(nothingIsSent()); }
    void close() override {}
    [[nodiscard]] bool isOpen() const override { return false; }
    void write(std::string_view) override {}
    [[nodiscard]] QString description() const override { return QStringLiteral("recording"); }
};

}  // namespace

std::unique_ptr<transport::ByteLink> ReplayPresenter::barredLink() { return std::make_unique<BarredLink>(); }

ReplayPresenter::ReplayPresenter(const ReplayStage& stage, core::Clock& clock, QObject* parent)
    : QObject(parent), stage_(stage), clock_(clock), unasked_(std::make_unique<UnaskedBytes>()) {
    auto source = std::make_unique<ReplaySource>();
    source_ = source.get();
    stage_.live.setSource(std::move(source));
}

ReplayPresenter::~ReplayPresenter() = default;

void ReplayPresenter::open(const QString& path, double speed) {
    QThreadPool::globalInstance()->start([self = QPointer(this), path, speed] {
        const auto opened = blackbox::Run::open(path);
        QMetaObject::invokeMethod(
            qApp,
            [self, opened, speed] {
                if (self && opened) {
                    self->take(*opened, speed);
                } else if (self) {
                    Q_EMIT self->failed(opened.error());
                }
            },
            Qt::QueuedConnection);
    });
}

void ReplayPresenter::take(std::shared_ptr<const blackbox::Run> run, double speed) {
    run_ = std::move(run);
    due_.clear();
    // The time of a picture is its exposure, before the records that were written meanwhile: the files' order counts.
    const auto& places = run_->places();
    core::Duration latest = places.front().entry.at;
    std::optional<core::Duration> begins, chosen;
    for (const Place& place : places) {
        latest = std::max(latest, place.entry.at);
        due_.push_back(latest);
        // Older records that still hold stand in front of an excerpt: it begins where its time does.
        if (!blackbox::holdsOn(place.entry.kind)) {
            begins = begins.value_or(latest);
            chosen = chosen || place.file < run_->chosen() ? chosen : latest;
        }
    }
    begin_ = begins.value_or(due_.front());
    end_ = due_.back();
    speed_ = speed;
    utc_of_zero_ = QDateTime::fromSecsSinceEpoch(0, Qt::UTC);
    applySession(places.front());
    Q_EMIT opened();
    seek(chosen.value_or(begin_) - begin_);
    play();
}

QDateTime ReplayPresenter::utc() const {
    return utc_of_zero_.addMSecs(std::chrono::duration_cast<std::chrono::milliseconds>(now_).count());
}

QString ReplayPresenter::damageText() const {
    const int damages = run_ ? run_->damages() : 0;
    return damages == 0 ? QString() : tr("Damaged places of the file, passed over: %1.").arg(damages);
}

void ReplayPresenter::play() {
    if (!isOpen() || playing_) {
        return;
    }
    if (isAtEnd()) {
        seek({});
    }
    playing_ = true;
    stepped_at_ = clock_.now();
    Q_EMIT playingChanged(true);
    goOn();
}

void ReplayPresenter::pause() {
    if (playing_) {
        step();
        playing_ = false;
        timer_.cancel();
        Q_EMIT playingChanged(false);
    }
}

void ReplayPresenter::setSpeed(double speed) {
    if (playing_) {
        step();
    }
    speed_ = speed;
    Q_EMIT moved();
}

void ReplayPresenter::goOn() {
    timer_ = clock_.callAfter(kStep, [this] {
        step();
        if (isAtEnd()) {
            pause();
        } else if (playing_) {
            goOn();
        }
    });
}

void ReplayPresenter::step() {
    if (catching_up_) {
        stepped_at_ = clock_.now();
        return;
    }
    const core::Duration passed = clock_.now() - std::exchange(stepped_at_, clock_.now());
    const auto shown = std::chrono::duration_cast<core::Duration>(passed * speed_);
    playUntil(std::min(now_ + shown, end_));
}

void ReplayPresenter::playUntil(core::Duration moment) {
    now_ = moment;
    showMoment();
    catchUp();
}

/// Of several pictures that are due only the last is looked at. The minutes before a jump may be many thousand records: they
/// are shown in pieces, so that the window goes on.
void ReplayPresenter::catchUp() {
    QElapsedTimer taken;
    taken.start();
    const Place* picture = nullptr;
    for (; next_ < due_.size() && due_[next_] <= now_; ++next_) {
        if (next_ % kLookedAtTogether == 0 && taken.elapsed() > kPiece_ms) {
            catching_up_ = true;
            QMetaObject::invokeMethod(this, &ReplayPresenter::catchUp, Qt::QueuedConnection);
            break;
        }
        const Place& place = run_->places()[next_];
        if (place.entry.kind == Kind::kFrame) {
            picture = &place;
        } else {
            apply(place);
        }
    }
    if (picture != nullptr) {
        applyFrame(*picture);
    }
    if (next_ < due_.size() && due_[next_] <= now_) {
        return;
    }
    if (std::exchange(catching_up_, false)) {
        stepped_at_ = clock_.now();  // what the jump took is not played
    }
    showDecided(now_);
    Q_EMIT moved();
}

/// What was shown of another moment.
void ReplayPresenter::forgetShown() {
    stage_.timeline.clear();
    stage_.log.clear();
    stage_.range.forgetAll();
    last_action_.clear();
    bars_.clear();
    unasked_->clear();
    pointing_.reset();
    lost_ = 0;
    stage_.instrument.showConnection(ConnectionState::kDisconnected, tr("Not connected yet in this recording."));
    if (stage_.health != nullptr) {
        stage_.health->showAir({});
    }
    stage_.messages.showBars(bars_);
}

void ReplayPresenter::seek(core::Duration position) {
    if (!isOpen()) {
        return;
    }
    const core::Duration moment = begin_ + std::clamp(position, core::Duration(0), length());
    forgetShown();
    const auto from = std::lower_bound(due_.begin(), due_.end(), moment - kShownBefore);
    next_ = ahead_ = static_cast<std::size_t>(from - due_.begin());
    ahead_sent_at_ = core::Duration::min();
    now_ = moment;
    showStanding(next_);
    stepped_at_ = clock_.now();
    playUntil(moment);
}

/// What was said before and still holds: the newest of its kind. A distance holds longer than the readings after it.
void ReplayPresenter::showStanding(std::size_t before) {
    constexpr Kind kShown[] = {Kind::kSession, Kind::kConnection, Kind::kControl, Kind::kAir,
                               Kind::kMessage, Kind::kLost,       Kind::kReading, Kind::kFrame};
    std::map<Kind, const Place*> newest;
    const Place* distance = nullptr;
    std::size_t missing = std::size(kShown);
    for (std::size_t i = before; i > 0 && (missing > 0 || distance == nullptr); --i) {
        const Place& place = run_->places()[i - 1];
        const Kind kind = place.entry.kind;
        if (std::find(std::begin(kShown), std::end(kShown), kind) == std::end(kShown)) {
            continue;
        }
        distance = distance == nullptr && place.is_distance ? &place : distance;
        if (!place.is_toast && newest.emplace(kind, &place).second) {
            --missing;
        }
    }
    if (newest.contains(Kind::kLost)) {
        lost_ = static_cast<std::uint64_t>(run_->body(*newest[Kind::kLost]).value(QStringLiteral("lost")).toInteger());
    }
    if (distance != nullptr) {
        apply(*distance);
    }
    for (const Kind kind : {Kind::kSession, Kind::kConnection, Kind::kControl, Kind::kAir, Kind::kMessage, Kind::kReading}) {
        if (newest.contains(kind)) {
            apply(*newest[kind]);
        }
    }
    if (newest.contains(Kind::kFrame)) {
        applyFrame(*newest[Kind::kFrame]);
    }
}

void ReplayPresenter::showMoment() { stage_.timeline.showMoment(now_, utc_of_zero_); }

void ReplayPresenter::apply(const Place& place) {
    const core::Duration at = place.entry.at;
    const QCborMap map = run_->body(place);
    switch (place.entry.kind) {
        case Kind::kSession: return applySession(place);
        case Kind::kBytes: return applyBytes(at, map);
        case Kind::kTransaction: return applyTransaction(map);
        case Kind::kControl: Q_EMIT stage_.instrument.controlChanged(controlFrom(map)); return;
        case Kind::kConnection: return applyConnection(map);
        case Kind::kReading: return applyReading(at, map);
        case Kind::kMessage: return applyMessage(map);
        case Kind::kLog: return stage_.log.append(logLineFrom(map));
        case Kind::kTick:
            return stage_.timeline.addFrame(at, static_cast<std::uint64_t>(map.value(QStringLiteral("sequence")).toInteger()),
                                            static_cast<std::uint64_t>(map.value(QStringLiteral("dropped")).toInteger()));
        case Kind::kAction: last_action_ = map.value(QStringLiteral("what")).toString(); return;
        case Kind::kAir: return applyAir(at, map);
        case Kind::kLost: return applyLost(at, map);
        case Kind::kFrame:
        case Kind::kEnd: return;
    }
}

/// Where the clock was set, the time of day goes on from here as it said then.
void ReplayPresenter::applySession(const Place& place) {
    const QDateTime utc = QDateTime::fromString(run_->body(place).value(QStringLiteral("utc")).toString(), Qt::ISODateWithMs);
    if (utc.isValid()) {
        utc_of_zero_ = utc.addMSecs(-std::chrono::duration_cast<std::chrono::milliseconds>(place.entry.at).count());
        showMoment();
    }
}

void ReplayPresenter::applyTransaction(const QCborMap& map) {
    const scheduler::TransactionRecord record = transactionFrom(map);
    showUnasked(unasked_->take(record));
    Q_EMIT stage_.instrument.transactionFinished(record);
}

/// The port commands go to is the instrument's; what comes from the other one are the panel's commands, told as transactions.
void ReplayPresenter::applyBytes(core::Duration at, const QCborMap& map) {
    const QString port = map.value(QStringLiteral("port")).toString();
    const QString direction = map.value(QStringLiteral("dir")).toString();
    const QByteArray bytes = map.value(QStringLiteral("bytes")).toByteArray();
    const bool is_command = !bytes.isEmpty() && bytes.front() >= 'A' && bytes.front() <= 'Z' && bytes.endsWith('\r');
    if (direction == QLatin1String(">") && is_command) {
        instrument_port_ = port;
    } else if (direction == QLatin1String("<") && (instrument_port_.isEmpty() || port == instrument_port_)) {
        unasked_->addReceived(bytes.toStdString(), at);
    }
}

void ReplayPresenter::showDecided(core::Duration until) {
    const auto& places = run_->places();
    const std::size_t known = ahead_;
    while (ahead_ < places.size() && (ahead_ < next_ || places[ahead_].entry.kind != Kind::kTransaction)) {
        ++ahead_;
    }
    if (ahead_ == places.size()) {
        ahead_sent_at_ = core::Duration::max();
    } else if (ahead_ != known || ahead_sent_at_ == core::Duration::min()) {
        ahead_sent_at_ = transactionFrom(run_->body(places[ahead_])).sent_at;
    }
    showUnasked(unasked_->takeOlderThan(std::min(until, ahead_sent_at_ - core::Duration(1))));
}

void ReplayPresenter::showUnasked(const std::vector<UnaskedPiece>& pieces) {
    for (const UnaskedPiece& piece : pieces) {
        if (piece.bytes.starts_with("A,") && pointing_) {
            stage_.timeline.addStreamReading(*pointing_, piece.at);  // the stream of the bus: the readings are told themselves
        } else {
            const protocol::Reply reply = protocol::parseReply(piece.bytes);
            const bool is_noise = !reply.status && reply.items.empty();
            stage_.timeline.addUnasked({.kind = is_noise ? scheduler::StrayKind::kNoise : scheduler::StrayKind::kUnsolicited,
                                        .bytes = piece.bytes,
                                        .at = piece.at});
        }
    }
}

void ReplayPresenter::applyAir(core::Duration at, const QCborMap& map) {
    const InstrumentAir air = airFrom(map);
    stage_.timeline.addAir(temperatureFrom(map), air.pressure_mbar, at);
    if (stage_.health != nullptr) {
        stage_.health->showAir(air);
    }
}

void ReplayPresenter::applyLost(core::Duration at, const QCborMap& map) {
    const auto lost = static_cast<std::uint64_t>(map.value(QStringLiteral("lost")).toInteger());
    if (lost > lost_) {
        stage_.timeline.addMissing(lost - lost_, at, at);
    }
    lost_ = lost;
}

void ReplayPresenter::applyConnection(const QCborMap& map) {
    stage_.instrument.showConnection(connectionFrom(map), map.value(QStringLiteral("sentence")).toString());
    if (const auto identity = identityFrom(map)) {
        stage_.instrument.showIdentity(*identity);
    }
    stage_.messages.showBars(bars_);
}

void ReplayPresenter::applyReading(core::Duration at, const QCborMap& map) {
    const auto pointing = pointingFrom(map);
    if (!pointing) {
        return;
    }
    pointing_ = pointing;
    showDecided(at);  // the readings of a stream belong to the bytes before them
    const QCborValue distance = map.value(QStringLiteral("sd_m"));
    if (distance.isDouble()) {
        stage_.range.addShot(*pointing, distance.toDouble());
    } else if (at > now_ - PointingTrack::kKept) {  // after a jump nobody looks at the older ones
        stage_.instrument.showPointing({.pointing = *pointing, .at = at});
    }
}

void ReplayPresenter::applyMessage(const QCborMap& map) {
    if (map.contains(QStringLiteral("toast"))) {
        Q_EMIT stage_.messages.toastShown(messageFrom(map.value(QStringLiteral("toast")).toMap()));
        return;
    }
    bars_.clear();
    for (const auto& bar : map.value(QStringLiteral("bars")).toArray()) {
        bars_.push_back(messageFrom(bar.toMap()));
    }
    stage_.messages.showBars(bars_);
}

void ReplayPresenter::applyFrame(const Place& place) {
    const camera::FramePtr picture = pictureFrom(run_->body(place));
    if (picture && source_) {
        auto frame = std::make_shared<camera::Frame>(*picture);
        frame->captured_at = place.entry.at;
        source_->show(frame);
    }
}

}  // namespace pmts::app
