#pragma once

#include "pmts/core/angle.hpp"
#include "pmts/core/result.hpp"
#include "pmts/geometry/pointing.hpp"
#include "pmts/simulator/simulated_rig.hpp"
#include "pmts/video/video_source.hpp"

#include <QObject>
#include <QStringList>
#include <QThread>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace pmts::simulator {
class Simulation;
}

namespace pmts::app {

struct SimulationChoice {
    unsigned seed = 1;
    double time_scale = 1.0;
    QString scene_path;   ///< a scene file, `laboratory`, or empty: the town square
    QStringList faults;
    double baud = 9600.0;
    QString line;  ///< `4800-8N1`: what the instrument alone understands; empty: every setting
    simulator::CameraChoice camera;  ///< what the simulated camera truly is
};

/// A mark of the scene and the true readings with the telescope on it.
struct SceneMark {
    QString name;
    geometry::Pointing pointing;
};

/// As somebody at the eyepiece points at it: in the face that the telescope is in, face I when that is not known.
[[nodiscard]] geometry::Pointing inPresentFace(const SceneMark& mark, const std::optional<geometry::Pointing>& present);

/// The simulated instrument on a thread of its own, served on a real pty, and the painter of its camera.
class SimulationDesk : public QObject {
    Q_OBJECT
public:
    explicit SimulationDesk(QObject* parent = nullptr);
    ~SimulationDesk() override;

    [[nodiscard]] bool isRunning() const { return !port_path_.isEmpty(); }
    [[nodiscard]] QString portPath() const { return port_path_; }
    [[nodiscard]] bool hasPanel() const { return !panel_path_.isEmpty(); }
    /// Draws what the simulated camera sees; empty before started().
    [[nodiscard]] video::ExposurePainter painter() const { return painter_; }
    [[nodiscard]] static QStringList faultNames();
    /// Of the running scene: what somebody at the eyepiece could point at.
    [[nodiscard]] const std::vector<SceneMark>& marks() const { return marks_; }

public Q_SLOTS:
    void start(const pmts::app::SimulationChoice& choice);  ///< while one runs: another takes its place
    /// A hand turns the camera in its clamp, clockwise seen from behind.
    void turnCamera(pmts::core::Angle clockwise);
    void injectFault(const QString& fault);
    void pressRegKey();
    void unplug();  ///< the pty goes away
    void plugIn();  ///< it comes back, under another name
    void plugPanel(bool plugged);  ///< a control unit behind a second pty, also in the next world

Q_SIGNALS:
    void panelPlugged(const QString& port_path);  ///< empty: it is gone
    void started(const QString& port_path);
    void pluggedIn(const QString& port_path);
    void problemReported(const pmts::core::Error& error);

private:
    class Worker;
    void ask(std::function<core::Result<void>(simulator::Simulation&)> request);
    void showFailedStart(const core::Error& error);
    void showStarted(const QString& port_path, const video::ExposurePainter& painter);
    void showPluggedIn(const QString& port_path);
    void showPanel(const QString& port_path);

    QThread thread_;
    std::unique_ptr<Worker> worker_;
    QString port_path_;
    QString panel_path_;
    video::ExposurePainter painter_;
    bool is_starting_ = false;
    std::vector<SceneMark> marks_;
    std::shared_ptr<std::atomic<double>> camera_turned_gon_ = std::make_shared<std::atomic<double>>(0.0);
};

}  // namespace pmts::app
