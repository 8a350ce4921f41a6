#include "pmts/app/replay_presenter.hpp"

#include "black_box_records.hpp"
#include "replay_source.hpp"

#include <QCborArray>
#include <QCoreApplication>
#include <QThreadPool>

#include <algorithm>
#include <array>
#include <map>

namespace pmts::app {

namespace {

using blackbox::Entry;
using blackbox::Kind;

constexpr auto kStep = std::chrono::milliseconds(33);

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
    : QObject(parent), stage_(stage), clock_(clock) {
    auto source = std::make_unique<ReplaySource>();
    source_ = source.get();
    stage_.live.setSource(std::move(source));
}

ReplayPresenter::~ReplayPresenter() = default;

void ReplayPresenter::open(const QString& path, double speed) {
    QThreadPool::globalInstance()->start([self = QPointer(this), path, speed] {
        const auto opened = blackbox::Recording::open(path);
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

void ReplayPresenter::take(std::shared_ptr<const blackbox::Recording> recording, double speed) {
    recording_ = std::move(recording);
    due_.clear();
    // The time of a picture is its exposure, before the records that were written meanwhile: the file's order counts.
    core::Duration latest = recording_->entries().front().at;
    for (const Entry& entry : recording_->entries()) {
        latest = std::max(latest, entry.at);
        due_.push_back(latest);
    }
    const Entry& first = recording_->entries().front();
    const QDateTime utc = QDateTime::fromString(recording_->body(first).value(QStringLiteral("utc")).toString(), Qt::ISODateWithMs);
    utc_of_zero_ = (utc.isValid() ? utc : QDateTime::fromSecsSinceEpoch(0, Qt::UTC))
                       .addMSecs(-std::chrono::duration_cast<std::chrono::milliseconds>(first.at).count());
    // Older records that still hold stand in front of an excerpt: it begins where its time does.
    const auto begins = std::find_if(recording_->entries().begin(), recording_->entries().end(), [](const Entry& entry) {
        return entry.kind != Kind::kSession && entry.kind != Kind::kConnection && entry.kind != Kind::kControl && entry.kind != Kind::kAir;
    });
    begin_ = begins == recording_->entries().end() ? due_.front()
                                                   : due_[static_cast<std::size_t>(begins - recording_->entries().begin())];
    end_ = due_.back();
    speed_ = speed;
    Q_EMIT opened();
    seek({});
    play();
}

QDateTime ReplayPresenter::utc() const {
    return utc_of_zero_.addMSecs(std::chrono::duration_cast<std::chrono::milliseconds>(now_).count());
}

QString ReplayPresenter::damageText() const {
    const int damages = recording_ ? static_cast<int>(recording_->damages().size()) : 0;
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
    const core::Duration passed = clock_.now() - std::exchange(stepped_at_, clock_.now());
    const auto shown = std::chrono::duration_cast<core::Duration>(passed * speed_);
    playUntil(std::min(now_ + shown, end_));
}

/// Of several pictures that are due only the last is looked at.
void ReplayPresenter::playUntil(core::Duration moment) {
    now_ = moment;
    showMoment();
    const Entry* picture = nullptr;
    for (; next_ < due_.size() && due_[next_] <= now_; ++next_) {
        const Entry& entry = recording_->entries()[next_];
        if (entry.kind == Kind::kFrame) {
            picture = &entry;
        } else {
            apply(entry);
        }
    }
    if (picture != nullptr) {
        applyFrame(*picture);
    }
    Q_EMIT moved();
}

void ReplayPresenter::seek(core::Duration position) {
    if (!isOpen()) {
        return;
    }
    const core::Duration moment = begin_ + std::clamp(position, core::Duration(0), length());
    stage_.timeline.clear();
    stage_.log.clear();
    last_action_.clear();
    bars_.clear();
    stage_.instrument.showConnection(ConnectionState::kDisconnected, tr("Not connected yet in this recording."));
    stage_.messages.showBars(bars_);
    const auto from = std::lower_bound(due_.begin(), due_.end(), moment - kShownBefore);
    next_ = static_cast<std::size_t>(from - due_.begin());
    now_ = moment;
    showStanding(next_);
    stepped_at_ = clock_.now();
    playUntil(moment);
}

/// What was said before and still holds: the newest of its kind.
void ReplayPresenter::showStanding(std::size_t before) {
    std::map<Kind, const Entry*> newest;
    for (std::size_t i = 0; i < before; ++i) {
        const Entry& entry = recording_->entries()[i];
        const bool is_toast = entry.kind == Kind::kMessage && !recording_->body(entry).contains(QStringLiteral("bars"));
        if (!is_toast) {
            newest[entry.kind] = &entry;
        }
    }
    for (const Kind kind : {Kind::kConnection, Kind::kControl, Kind::kMessage, Kind::kReading}) {
        if (newest.contains(kind)) {
            apply(*newest[kind]);
        }
    }
    if (newest.contains(Kind::kFrame)) {
        applyFrame(*newest[Kind::kFrame]);
    }
}

void ReplayPresenter::showMoment() { stage_.timeline.showMoment(now_, utc_of_zero_); }

void ReplayPresenter::apply(const Entry& entry) {
    const QCborMap map = recording_->body(entry);
    switch (entry.kind) {
        case Kind::kTransaction: Q_EMIT stage_.instrument.transactionFinished(transactionFrom(map)); return;
        case Kind::kControl: Q_EMIT stage_.instrument.controlChanged(controlFrom(map)); return;
        case Kind::kConnection: return applyConnection(map);
        case Kind::kReading: return applyReading(entry, map);
        case Kind::kMessage: return applyMessage(map);
        case Kind::kLog: return stage_.log.append(logLineFrom(map));
        case Kind::kTick:
            return stage_.timeline.addFrame(entry.at, static_cast<std::uint64_t>(map.value(QStringLiteral("sequence")).toInteger()),
                                            static_cast<std::uint64_t>(map.value(QStringLiteral("dropped")).toInteger()));
        case Kind::kAction: last_action_ = map.value(QStringLiteral("what")).toString(); return;
        default: return;  // bytes are in the transactions, the rest says how the file was written
    }
}

void ReplayPresenter::applyConnection(const QCborMap& map) {
    stage_.instrument.showConnection(connectionFrom(map), map.value(QStringLiteral("sentence")).toString());
    if (const auto identity = identityFrom(map)) {
        stage_.instrument.showIdentity(*identity);
    }
    stage_.messages.showBars(bars_);
}

void ReplayPresenter::applyReading(const Entry& entry, const QCborMap& map) {
    const auto pointing = pointingFrom(map);
    if (!pointing) {
        return;
    }
    const QCborValue distance = map.value(QStringLiteral("sd_m"));
    if (distance.isDouble()) {
        stage_.range.addShot(*pointing, distance.toDouble());
    } else if (entry.at > now_ - PointingTrack::kKept) {  // after a jump nobody looks at the older ones
        stage_.instrument.showPointing({.pointing = *pointing, .at = entry.at});
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

void ReplayPresenter::applyFrame(const Entry& entry) {
    const camera::FramePtr picture = pictureFrom(recording_->body(entry));
    if (picture && source_) {
        auto frame = std::make_shared<camera::Frame>(*picture);
        frame->captured_at = entry.at;
        source_->show(frame);
    }
}

}  // namespace pmts::app
