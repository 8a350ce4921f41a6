#pragma once

#include "pmts/video/video_source.hpp"

#include <QObject>
#include <QThread>

#include <functional>
#include <vector>

namespace pmts::app {

/// Looks for cameras on a thread of its own: the first look loads the media library, which takes a second.
class CameraFinder : public QObject {
    Q_OBJECT
public:
    using Look = std::function<std::vector<video::SourceAddress>()>;

    explicit CameraFinder(Look look, QObject* parent = nullptr);
    ~CameraFinder() override;  ///< waits for a look under way

    [[nodiscard]] bool isLooking() const { return is_looking_; }
    /// Ends in found(); a second wish while one is under way is served by the same look.
    void look();

Q_SIGNALS:
    void found(const std::vector<pmts::video::SourceAddress>& cameras);

private:
    void show(const std::vector<video::SourceAddress>& cameras);

    Look look_;
    QThread thread_;
    QObject hand_;  ///< lives on the thread, which keeps an event loop: the media library watches devices from it
    bool is_looking_ = false;
};

}  // namespace pmts::app
