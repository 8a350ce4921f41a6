#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/app/desk/threading.hpp"
#include "pmts/camera/picture_meters.hpp"

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QRectF>
#include <QStringList>
#include <QThreadPool>

#include <optional>
#include <vector>

namespace pmts::app {

/// One control as the page shows it: `Exposure`, `10 ms`.
struct ControlRow {
    video::ControlRange range;
    video::ControlValue value;
    QString name;
    QString unit;
    QString text;   ///< value with unit, or that the camera looks after it
    QString limits; ///< `0.5 … 100 ms, usually 10 ms`
};

/// What the meters say about the newest picture that was looked at.
struct CameraMeters {
    camera::PictureMeters picture;
    double sharpness = 0.0;       ///< of the box, when there is one, else of the whole picture
    double best_sharpness = 0.0;  ///< since the peak was reset
    QString sharpness_text;
    QString exposure_text;        ///< one sentence and what to do
    DeviceState exposure_state = DeviceState::kIdle;
    QImage burnt;                 ///< 8-bit mask of the burnt out pixels, when it is asked for
};

/// The camera in use: modes, controls, start, pause and stop, and the meters for exposure and focus. What is chosen is
/// kept for this camera. Meters are computed in a pool, five times a second at most, while somebody looks.
class CameraPresenter : public QObject {
    Q_OBJECT
public:
    CameraPresenter(LivePresenter& live, Preferences& preferences, MessageCentre& messages,
                    Threading threading = Threading::kOwnThread, QObject* parent = nullptr);
    ~CameraPresenter() override;

    [[nodiscard]] QString name() const;      ///< empty without a camera
    [[nodiscard]] DeviceState state() const;
    /// `HD Webcam: 1280x720 at 29.9 of 30 pictures a second.`
    [[nodiscard]] QString sentence() const;
    [[nodiscard]] bool isRunning() const;    ///< or starting, or trying to
    [[nodiscard]] bool isPaused() const;
    [[nodiscard]] bool hasCamera() const { return live_.source() != nullptr; }

    /// Modes. What the camera offers, largest picture first; all of one picture size, then of one layout.
    [[nodiscard]] video::VideoFormat format() const;
    [[nodiscard]] std::vector<QSize> sizes() const;
    [[nodiscard]] QStringList pixelFormats(const QSize& size) const;
    [[nodiscard]] std::vector<double> rates(const QSize& size, const QString& pixel_format) const;
    [[nodiscard]] QString measuredText() const;  ///< `29.9 pictures a second, 0 lost`
    /// What a change of size does to the calibration; empty when nothing.
    [[nodiscard]] QString rigNote() const;

    [[nodiscard]] std::vector<ControlRow> controls() const;
    [[nodiscard]] bool canLock() const;  ///< an automatic is on

    [[nodiscard]] bool hasLargerMode() const { return live_.largestMode().has_value(); }
    [[nodiscard]] bool takesFullStills() const;
    [[nodiscard]] QString fullStillText() const;  ///< `2560x1440; the last one took 0.4 s`

    void waitForMeters();  ///< until a look under way has been shown; for tests
    [[nodiscard]] const CameraMeters& meters() const { return meters_; }
    [[nodiscard]] const std::optional<QRectF>& box() const { return box_; }
    [[nodiscard]] bool showsBurnt() const { return shows_burnt_; }

public Q_SLOTS:
    void start();
    void pause();
    void togglePause();
    void stop();  ///< the device is free for others
    void setFormat(const pmts::video::VideoFormat& format);
    void setAutomatic(pmts::video::CameraControl control, bool automatic);
    void setValue(pmts::video::CameraControl control, double value);  ///< by hand
    void lock();  ///< every automatic stops where it is
    void useUsualValues();
    void setFullStills(bool on);

    void setMetering(bool on);  ///< somebody looks at the meters
    void setBox(const std::optional<QRectF>& frame_px);  ///< sharpness of this part alone
    void resetPeak();
    void setShowsBurnt(bool on);

Q_SIGNALS:
    void stateChanged();
    void modesChanged();
    void controlsChanged();
    void rateChanged();
    void metersChanged();
    void optionsChanged();

private:
    void followSource();
    void showReport();
    void keepControls();
    void wish(const std::vector<video::ControlValue>& wishes);
    void change(const std::function<void(CameraSetting&)>& how);
    [[nodiscard]] CameraSetting setting() const;
    void look();
    void showMeters(const camera::PictureMeters& picture, const QImage& burnt);

    LivePresenter& live_;
    Preferences& preferences_;
    MessageCentre& messages_;
    const Threading threading_;
    video::DeviceReport report_;
    bool chose_controls_ = false;  ///< the next report tells what became of a choice: keep it
    std::optional<core::Duration> last_still_took_;
    bool metering_ = false;
    bool measuring_ = false;
    bool shows_burnt_ = false;
    std::optional<QRectF> box_;
    QElapsedTimer since_look_;
    CameraMeters meters_;
    QThreadPool pool_;
};

[[nodiscard]] QString controlName(video::CameraControl control);

}  // namespace pmts::app
