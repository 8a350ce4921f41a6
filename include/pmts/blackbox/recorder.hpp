#pragma once

#include "pmts/blackbox/record.hpp"
#include "pmts/core/result.hpp"

#include <QFile>
#include <QString>
#include <QThread>

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>

namespace pmts::blackbox {

struct RecorderSettings {
    QString folder;                              ///< made when missing
    qint64 kept_bytes = qint64{300} << 20;       ///< of all files of the folder; the oldest go first
    qint64 file_bytes = qint64{75} << 20;        ///< then the next file begins
    QCborMap session;                            ///< what each file begins with; the time of day is added
};

/// Writes records into files of a folder on a thread of its own, one write for each as soon as it comes: when the program is
/// killed, at most the record that is being written is lost; when the power goes, the last five seconds. A file that can no
/// longer be written ends the recording, never the work. add() may be called from any thread and never waits for the disk.
class Recorder {
public:
    using MakeBody = std::function<QByteArray()>;
    static constexpr std::size_t kLongestQueue = 4000;

    /// `on_ended`: called once, on the recording thread, when the disk takes no more. The clock outlives the recorder.
    Recorder(RecorderSettings settings, const core::Clock& clock, std::function<void(const core::Error&)> on_ended);
    ~Recorder();  ///< writes what is queued and the record that says so
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    void add(Kind kind, core::Duration at, QByteArray body);
    /// What goes on holding until the next of its kind: written again at the beginning of each file, and never lost.
    void addStanding(Kind kind, core::Duration at, QByteArray body);
    /// The body is made on the recording thread (pictures); left out while one such is waiting, which is no loss.
    void addMade(Kind kind, core::Duration at, MakeBody make_body);
    void waitUntilWritten();

    [[nodiscard]] bool isRecording() const;
    [[nodiscard]] QString path() const;  ///< of the file that is being written
    /// Records there was no room for in the queue: the disk is slower than what happens.
    [[nodiscard]] std::uint64_t lost() const;

private:
    struct Item {
        Record record;
        MakeBody make_body;
        bool is_standing = false;
    };
    void queue(Item item);
    void run();
    void write(Item item);
    [[nodiscard]] bool writeRecord(const Record& record);
    [[nodiscard]] bool writeBytes(const QByteArray& bytes);
    [[nodiscard]] bool beginFile();
    void makeRoom();
    void end(const QString& why);

    const RecorderSettings settings_;
    const core::Clock& clock_;
    const std::function<void(const core::Error&)> on_ended_;
    QFile file_;                              // recording thread only, as the next five
    QString failure_;
    core::Duration synced_at_{};
    qint64 written_ = 0;
    std::uint64_t told_lost_ = 0;
    std::map<Kind, Record> standing_;
    mutable std::mutex mutex_;                // guards all below
    std::condition_variable wake_, drained_;
    std::deque<Item> queue_;
    std::size_t made_waiting_ = 0;
    bool busy_ = true;  ///< until the first file is begun
    bool closing_ = false;
    bool ended_ = false;
    QString path_;
    std::uint64_t lost_ = 0;
    std::unique_ptr<QThread> thread_;
};

}  // namespace pmts::blackbox
