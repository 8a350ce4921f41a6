#pragma once

#include "capture_device.hpp"

#include <QEventLoop>
#include <QSaveFile>
#include <QTemporaryDir>
#include <QTimer>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

namespace pmts::video {

inline constexpr std::chrono::seconds kGenerous{20};

/// Runs the event loop until the condition holds, looking after every event; false after a generous limit.
inline bool until(const std::function<bool()>& condition, std::chrono::milliseconds limit = kGenerous) {
    const auto latest = std::chrono::steady_clock::now() + limit;
    QTimer pulse;  // conditions that no event announces, such as counters
    pulse.start(std::chrono::milliseconds(5));
    while (!condition()) {
        if (std::chrono::steady_clock::now() > latest) {
            return false;
        }
        QEventLoop loop;
        QObject::connect(&pulse, &QTimer::timeout, &loop, &QEventLoop::quit);
        loop.exec();
    }
    return true;
}

/// What a receiver on the test's thread has seen of a source.
struct Watcher : QObject {
    explicit Watcher(VideoSource& source) {
        connect(&source, &VideoSource::frameReady, this, [this, &source] {
            ++notices;
            if (takes_frames) {
                newest = source.newestFrame();
            }
        });
        connect(&source, &VideoSource::stateChanged, this,
                [this](SourceState state) { states.push_back(state); });
        connect(&source, &VideoSource::problemReported, this,
                [this](const core::Error& error) { problems.push_back(error.sentence().toStdString()); });
    }
    [[nodiscard]] bool hasProblemWith(const std::string& part) const {
        return std::any_of(problems.begin(), problems.end(), [&](const std::string& problem) {
            return problem.find(part) != std::string::npos;
        });
    }

    bool takes_frames = true;
    int notices = 0;
    camera::FramePtr newest;
    std::vector<SourceState> states;
    std::vector<std::string> problems;
};

/// A folder of virtual cameras; see tests/support/virtual_v4l2.
class CameraFolder {
public:
    CameraFolder() { qputenv("PMTS_VIRTUAL_CAMERAS", folder_.path().toUtf8()); }
    ~CameraFolder() { qunsetenv("PMTS_VIRTUAL_CAMERAS"); }
    [[nodiscard]] QString path() const { return folder_.path(); }
    [[nodiscard]] QString node(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }
    void plug(const char* name, const QByteArray& text) const {
        QSaveFile file(node(name));  // the camera reads it while it runs: never half a file
        file.open(QIODevice::WriteOnly);
        file.write(text);
        file.commit();
    }
    void unplug(const char* name) const { QFile::remove(node(name)); }

private:
    QTemporaryDir folder_;
};

}  // namespace pmts::video
