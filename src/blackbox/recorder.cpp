#include "pmts/blackbox/recorder.hpp"

#include "pmts/blackbox/recording.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <chrono>
#include <utility>

#include <unistd.h>

namespace pmts::blackbox {
namespace {

QString say(const char* text) { return QCoreApplication::translate("BlackBox", text); }

constexpr int kMostAtOnce = 1000;
constexpr core::Duration kLostToPowerAtMost = std::chrono::seconds(5);

}  // namespace

Recorder::Recorder(RecorderSettings settings, const core::Clock& clock, std::function<void(const core::Error&)> on_ended)
    : settings_(std::move(settings)), clock_(clock), on_ended_(std::move(on_ended)) {
    thread_.reset(QThread::create([this] { run(); }));
    thread_->setObjectName(QStringLiteral("black box"));
    thread_->start(QThread::LowPriority);
}

Recorder::~Recorder() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    wake_.notify_one();
    thread_->wait();
}

void Recorder::add(Kind kind, core::Duration at, QByteArray body) {
    queue({.record = {.kind = kind, .at = at, .body = std::move(body)}, .make_body = {}, .is_standing = false});
}

void Recorder::addStanding(Kind kind, core::Duration at, QByteArray body) {
    queue({.record = {.kind = kind, .at = at, .body = std::move(body)}, .make_body = {}, .is_standing = true});
}

void Recorder::addMade(Kind kind, core::Duration at, MakeBody make_body) {
    queue({.record = {.kind = kind, .at = at, .body = {}}, .make_body = std::move(make_body), .is_standing = false});
}

void Recorder::queue(Item item) {
    {
        const std::lock_guard lock(mutex_);
        if (ended_ || closing_) {
            return;
        }
        if (item.make_body && made_waiting_ > 0) {
            return;  // thinned out on purpose, nothing is lost
        }
        if (queue_.size() >= kLongestQueue && !item.is_standing) {
            ++lost_;
            return;
        }
        made_waiting_ += item.make_body ? 1 : 0;
        queue_.push_back(std::move(item));
    }
    wake_.notify_one();
}

void Recorder::waitUntilWritten() {
    std::unique_lock lock(mutex_);
    drained_.wait(lock, [this] { return ended_ || (queue_.empty() && !busy_); });
}

bool Recorder::isRecording() const {
    const std::lock_guard lock(mutex_);
    return !ended_;
}

QString Recorder::path() const {
    const std::lock_guard lock(mutex_);
    return path_;
}

std::uint64_t Recorder::lost() const {
    const std::lock_guard lock(mutex_);
    return lost_;
}

void Recorder::run() {
    if (!beginFile()) {
        return end(failure_);
    }
    std::unique_lock lock(mutex_);
    busy_ = false;
    drained_.notify_all();
    while (!ended_) {
        wake_.wait(lock, [this] { return closing_ || !queue_.empty(); });
        if (queue_.empty()) {
            break;
        }
        Item item = std::move(queue_.front());
        queue_.pop_front();
        busy_ = true;
        lock.unlock();
        write(std::move(item));
        lock.lock();
        busy_ = false;
        if (queue_.empty()) {
            drained_.notify_all();
        }
    }
    lock.unlock();
    if (isRecording()) {
        (void)writeRecord({.kind = Kind::kEnd, .at = clock_.now(), .body = bodyOf({})});
    }
}

void Recorder::write(Item item) {
    if (item.make_body) {
        item.record.body = item.make_body();
        const std::lock_guard lock(mutex_);
        --made_waiting_;
    }
    if (item.is_standing) {
        standing_[item.record.kind] = item.record;
    }
    const std::uint64_t lost = this->lost();
    const bool tells_loss = lost != std::exchange(told_lost_, lost);
    const Record loss{.kind = Kind::kLost, .at = item.record.at,
                      .body = tells_loss ? bodyOf({{QStringLiteral("lost"), static_cast<qint64>(lost)}}) : QByteArray()};
    const bool is_full = written_ >= settings_.file_bytes;
    if ((is_full && !beginFile()) || (tells_loss && !writeRecord(loss)) || !writeRecord(item.record)) {
        return end(failure_);
    }
    if (item.record.at - synced_at_ >= kLostToPowerAtMost) {
        synced_at_ = item.record.at;
        (void)::fdatasync(file_.handle());  // refused by a file system that has none: the next write tells a full disk
    }
}

bool Recorder::writeRecord(const Record& record) { return writeBytes(encoded(record)); }

/// In one piece; what a full disk took of it is cut off again, so that the file ends with a whole record.
bool Recorder::writeBytes(const QByteArray& bytes) {
    if (file_.write(bytes) != bytes.size()) {
        failure_ = file_.errorString();
        (void)file_.resize(written_);
        return false;
    }
    written_ += bytes.size();
    return true;
}

/// A name of its own for each run, also for two programs on one folder.
bool Recorder::beginFile() {
    QDir().mkpath(settings_.folder);
    makeRoom();
    file_.close();
    const QDateTime utc = clock_.utcNow();
    bool is_open = false;
    for (int tries = 0; tries < kMostAtOnce && !is_open; ++tries) {
        file_.setFileName(QDir(settings_.folder).filePath(nextRecordingName(recordingsIn(settings_.folder), utc)));
        is_open = file_.open(QIODevice::NewOnly | QIODevice::WriteOnly | QIODevice::Unbuffered);
        failure_ = file_.errorString();
        if (!is_open && !file_.exists()) {
            return false;  // another reason than a name that is taken
        }
    }
    written_ = 0;
    {
        const std::lock_guard lock(mutex_);
        path_ = file_.fileName();
    }
    QCborMap session = settings_.session;
    session[QStringLiteral("utc")] = utc.toString(Qt::ISODateWithMs);
    const QByteArray head(kFileHead.data(), static_cast<qsizetype>(kFileHead.size()));
    bool is_written = is_open && writeBytes(head) &&
                      writeRecord({.kind = Kind::kSession, .at = clock_.now(), .body = bodyOf(session)});
    for (const auto& [kind, record] : standing_) {
        is_written = is_written && writeRecord(record);
    }
    return is_written;
}

/// The oldest files go until there is room for one more.
void Recorder::makeRoom() {
    const QStringList paths = recordingsIn(settings_.folder);
    qint64 total = settings_.file_bytes;
    for (const QString& path : paths) {
        total += QFileInfo(path).size();
    }
    for (const QString& path : paths) {
        if (total <= settings_.kept_bytes) {
            break;
        }
        total -= QFileInfo(path).size();
        QFile::remove(path);
    }
}

void Recorder::end(const QString& why) {
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
        queue_.clear();
    }
    drained_.notify_all();
    on_ended_({.kind = core::ErrorKind::kFile,
               .happened = say("The black box has stopped: its file can no longer be written (%1).").arg(why),
               .remedy = say("Your work goes on. Make room on the disk, then switch the black box on again."),
               .info_code = std::nullopt,
               .detail = settings_.folder});
}

}  // namespace pmts::blackbox
