#include "pmts/app/line/black_box_presenter.hpp"

#include "black_box_records.hpp"
#include "pmts/blackbox/recording.hpp"
#include "pmts/transport/tap_link.hpp"

#include <QCborArray>
#include <QCoreApplication>
#include <QFileInfo>
#include <QSysInfo>
#include <QUuid>

#include <utility>

namespace pmts::app {

namespace {

using blackbox::Kind;

constexpr int kPictureWidth_px = 640;
constexpr int kFilesKept = 4;
constexpr qint64 kMegabyte = 1 << 20;
constexpr auto kLookInterval = std::chrono::seconds(5);
const QString kTopic = QStringLiteral("black box");

QString key(const char* name) { return QLatin1String(name); }

/// Asked of the system, no name of a person or a machine. `run`: the files of one run share a clock.
QCborMap sessionMap() {
    static const QString kRun = QUuid::createUuid().toString(QUuid::WithoutBraces);
    return {{key("run"), kRun},
            {key("program"), QStringLiteral("pmts")},
            {key("version"), QCoreApplication::applicationVersion()},
            {key("system"), QSysInfo::prettyProductName()},
            {key("kernel"), QSysInfo::kernelType() + u' ' + QSysInfo::kernelVersion()},
            {key("machine"), QSysInfo::currentCpuArchitecture()},
            {key("qt"), QString::fromLatin1(qVersion())}};
}

const char* directionName(transport::Direction direction) {
    switch (direction) {
        case transport::Direction::kSent: return ">";
        case transport::Direction::kReceived: return "<";
        case transport::Direction::kLost: return "!";
    }
    return "";
}

}  // namespace

void BlackBoxOutlet::use(std::shared_ptr<blackbox::Recorder> recorder) {
    {
        const std::lock_guard lock(mutex_);
        recorder_.swap(recorder);
    }  // the old one writes its last records without the lock
}

std::shared_ptr<blackbox::Recorder> BlackBoxOutlet::recorder() const {
    const std::lock_guard lock(mutex_);
    return recorder_;
}

void BlackBoxOutlet::add(Kind kind, core::Duration at, const QCborMap& map) const {
    if (const auto recorder = this->recorder()) {
        recorder->add(kind, at, blackbox::bodyOf(map));
    }
}

BlackBoxPresenter::BlackBoxPresenter(QString folder, Preferences& preferences, MessageCentre& messages, const core::Clock& clock,
                                     QObject* parent)
    : QObject(parent), folder_(std::move(folder)), preferences_(preferences), messages_(messages), clock_(clock) {
    connect(&messages_, &MessageCentre::toastShown, this, [this](const Message& message) {
        note(Kind::kMessage, {{key("toast"), mapOf(message)}});
    });
    connect(&messages_, &MessageCentre::barsChanged, this, &BlackBoxPresenter::noteMessages);
    look_.setInterval(kLookInterval);
    connect(&look_, &QTimer::timeout, this, &BlackBoxPresenter::statusChanged);
}

BlackBoxPresenter::~BlackBoxPresenter() { outlet_->use(nullptr); }

void BlackBoxPresenter::start() {
    started_ = true;
    connect(&preferences_, &Preferences::changed, this, &BlackBoxPresenter::followSettings);
    look_.start();
    begin();
}

/// Another rate of pictures needs no new file.
void BlackBoxPresenter::followSettings() {
    const bool begins_anew = settings().on != used_.on || settings().kept_mb != used_.kept_mb;
    used_ = settings();
    if (begins_anew) {
        begin();
    }
}

void BlackBoxPresenter::startAgain() { begin(); }

void BlackBoxPresenter::begin() {
    used_ = settings();
    failure_.reset();
    messages_.solve(kTopic);
    outlet_->use(nullptr);
    if (used_.on) {
        const qint64 kept = used_.kept_mb * kMegabyte;
        blackbox::RecorderSettings wanted{.folder = folder_, .kept_bytes = kept, .file_bytes = kept / kFilesKept,
                                          .session = sessionMap()};
        const auto on_ended = [this](const core::Error& error) {
            QMetaObject::invokeMethod(this, [this, error] { showEnd(error); }, Qt::QueuedConnection);
        };
        outlet_->use(std::make_shared<blackbox::Recorder>(std::move(wanted), clock_, on_ended));
        noteConnection();
        noteControl();
        writeAir();
        noteMessages();
    }
    Q_EMIT statusChanged();
}

void BlackBoxPresenter::showEnd(const core::Error& error) {
    if (isRecording()) {
        return;  // another one has begun meanwhile
    }
    failure_ = error;
    messages_.warn(error.happened, error.remedy, MessageAction::kNone, kTopic);
    Q_EMIT statusChanged();
}

bool BlackBoxPresenter::isRecording() const {
    const auto recorder = outlet_->recorder();
    return recorder && recorder->isRecording();
}

StatusItem BlackBoxPresenter::status() const {
    if (isRecording()) {
        return {.state = DeviceState::kGood, .text = tr("Recording"), .details = tr("What happens is being written down.")};
    }
    if (failure_) {
        return {.state = DeviceState::kFailed, .text = tr("Stopped"), .details = failure_->sentence()};
    }
    return {.state = DeviceState::kIdle, .text = tr("Off"), .details = tr("Nothing is written down.")};
}

QString BlackBoxPresenter::path() const {
    const auto recorder = outlet_->recorder();
    return recorder ? recorder->path() : QString();
}

QString BlackBoxPresenter::keptText() const {
    qint64 bytes = 0;
    const QStringList files = blackbox::recordingsIn(folder_);
    for (const QString& file : files) {
        bytes += QFileInfo(file).size();
    }
    return tr("%1 of %2 MB used")
        .arg(static_cast<double>(bytes) / kMegabyte, 0, 'f', 1)
        .arg(settings().kept_mb);
}

void BlackBoxPresenter::setSettings(const BlackBoxSettings& wanted) {
    Settings next = preferences_.settings();
    next.black_box = wanted;
    preferences_.set(next);
}

void BlackBoxPresenter::waitUntilWritten() {
    if (const auto recorder = outlet_->recorder()) {
        recorder->waitUntilWritten();
    }
}

std::unique_ptr<transport::ByteLink> BlackBoxPresenter::tapped(std::unique_ptr<transport::ByteLink> link) const {
    const QString port = link->description();
    return std::make_unique<transport::TapLink>(
        std::move(link), [outlet = outlet_, port, &clock = clock_](transport::Direction direction, std::string_view bytes) {
            outlet->add(Kind::kBytes, clock.now(),
                        {{key("port"), port},
                         {key("dir"), key(directionName(direction))},
                         {key("bytes"), QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size()))}});
        });
}

void BlackBoxPresenter::note(Kind kind, const QCborMap& map) const { outlet_->add(kind, clock_.now(), map); }

void BlackBoxPresenter::watch(InstrumentDesk& instrument) {
    instrument_ = &instrument;
    connect(&instrument, &InstrumentDesk::transactionFinished, this, [this](const scheduler::TransactionRecord& record) {
        outlet_->add(Kind::kTransaction, record.finished_at, mapOf(record));
    });
    connect(&instrument, &InstrumentDesk::pointingChanged, this, [this](const TimedPointing& reading) {
        outlet_->add(Kind::kReading, reading.at, mapOf(reading.pointing));
    });
    connect(&instrument, &InstrumentDesk::controlChanged, this, [this](const instrument::ControlStatus& status) {
        control_ = status;
        noteControl();
    });
    connect(&instrument, &InstrumentDesk::connectionChanged, this, &BlackBoxPresenter::noteConnection);
    connect(&instrument, &InstrumentDesk::identityChanged, this, &BlackBoxPresenter::noteConnection);
    connect(&instrument, &InstrumentDesk::distanceMeasured, this, [this](Ticket, const instrument::DistanceShot& shot) {
        noteShot(shot.pointing, shot.slope_distance_m);
    });
}

void BlackBoxPresenter::noteConnection() {
    const auto recorder = outlet_->recorder();
    if (recorder && instrument_) {
        recorder->addStanding(Kind::kConnection, clock_.now(),
                              blackbox::bodyOf(mapOf(instrument_->connectionState(), instrument_->connectionSentence(),
                                                     instrument_->identity())));
    }
}

void BlackBoxPresenter::noteShot(const geometry::Pointing& pointing, double slope_distance_m) {
    QCborMap map = mapOf(pointing);
    map[key("sd_m")] = slope_distance_m;
    note(Kind::kReading, map);
}

void BlackBoxPresenter::watch(LivePresenter& live, const core::VideoGate& gate) {
    connect(&live, &LivePresenter::sceneChanged, this, [this, &live, &gate] { noteFrame(live, gate); });
}

/// Of every picture that it came, of few of them what they show.
void BlackBoxPresenter::noteFrame(const LivePresenter& live, const core::VideoGate& gate) {
    const camera::FramePtr frame = live.scene().frame;
    const auto recorder = outlet_->recorder();
    if (!frame || !recorder || frame->sequence == std::exchange(last_sequence_, frame->sequence)) {
        return;
    }
    recorder->add(Kind::kTick, frame->captured_at,
                  blackbox::bodyOf({{key("sequence"), static_cast<qint64>(frame->sequence)},
                                    {key("dropped"), static_cast<qint64>(gate.statistics().frames_dropped)}}));
    if (used_.frames_per_s <= 0.0) {
        return;
    }
    const std::chrono::duration<double> since = frame->captured_at - last_picture_.value_or(frame->captured_at);
    if (!last_picture_ || since.count() < 0.0 || since.count() >= 0.98 / used_.frames_per_s) {
        last_picture_ = frame->captured_at;
        recorder->addMade(Kind::kFrame, frame->captured_at,
                          [frame] { return blackbox::bodyOf(pictureMap(*frame, kPictureWidth_px)); });
    }
}

void BlackBoxPresenter::watch(LogModel& log) const {
    log.on_line = [outlet = outlet_, &clock = clock_](const LogLine& line) {
        outlet->add(Kind::kLog, clock.now(), mapOf(line));
    };
}

void BlackBoxPresenter::noteMessages() {
    QCborArray bars;
    for (const Message& bar : messages_.bars()) {
        bars.append(mapOf(bar));
    }
    note(Kind::kMessage, {{key("bars"), bars}});
}

void BlackBoxPresenter::noteAction(const QString& what, const QString& where, const std::optional<QPoint>& at) {
    QCborMap map{{key("what"), what}, {key("where"), where}};
    if (at) {
        map[key("x")] = at->x();
        map[key("y")] = at->y();
    }
    note(Kind::kAction, map);
}

void BlackBoxPresenter::noteControl() {
    const auto recorder = outlet_->recorder();
    if (recorder && control_) {
        recorder->addStanding(Kind::kControl, clock_.now(), blackbox::bodyOf(mapOf(*control_)));
    }
}

void BlackBoxPresenter::noteAir(const std::optional<double>& temperature_c) {
    if (temperature_c != std::exchange(typed_degc_, temperature_c)) {
        writeAir();
    }
}

void BlackBoxPresenter::noteAir(const InstrumentAir& air) {
    if (!(air == std::exchange(air_, air))) {
        writeAir();
    }
}

void BlackBoxPresenter::writeAir() {
    const auto recorder = outlet_->recorder();
    const bool is_known = typed_degc_ || !air_.isEmpty();
    const bool was_told = std::exchange(air_told_, is_known);
    if (recorder && (is_known || was_told)) {  // also that it is no longer known
        recorder->addStanding(Kind::kAir, clock_.now(), blackbox::bodyOf(mapOf(air_, typed_degc_)));
    }
}

}  // namespace pmts::app
