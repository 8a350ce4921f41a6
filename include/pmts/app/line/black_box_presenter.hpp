#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/line/instrument_air.hpp"
#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/desk/log_model.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/blackbox/recorder.hpp"

#include <QObject>
#include <QPoint>
#include <QTimer>

#include <memory>
#include <optional>

namespace pmts::app {

/// Where records go from any thread: to the recorder that is at work, or nowhere.
class BlackBoxOutlet {
public:
    void use(std::shared_ptr<blackbox::Recorder> recorder);
    [[nodiscard]] std::shared_ptr<blackbox::Recorder> recorder() const;
    void add(blackbox::Kind kind, core::Duration at, const QCborMap& map) const;

private:
    mutable std::mutex mutex_;
    std::shared_ptr<blackbox::Recorder> recorder_;
};

/// The black box: everything that passes by is written down, always, as the settings say. Its trouble is a message, never an
/// end of the work.
class BlackBoxPresenter : public QObject {
    Q_OBJECT
public:
    /// The clock outlives it. Nothing is recorded before start().
    BlackBoxPresenter(QString folder, Preferences& preferences, MessageCentre& messages, const core::Clock& clock,
                      QObject* parent = nullptr);
    ~BlackBoxPresenter() override;

    /// Records from now on, and follows the settings.
    void start();
    [[nodiscard]] bool isRecording() const;
    [[nodiscard]] StatusItem status() const;
    [[nodiscard]] QString folder() const { return folder_; }
    [[nodiscard]] QString path() const;  ///< of the file that is being written; empty when off
    [[nodiscard]] const BlackBoxSettings& settings() const { return preferences_.settings().black_box; }
    [[nodiscard]] QString keptText() const;  ///< `120.4 of 300 MB used`
    void setSettings(const BlackBoxSettings& settings);
    void startAgain();  ///< after a full disk
    /// All that was handed over is in the file.
    void waitUntilWritten();

    /// The same link, its bytes recorded.
    [[nodiscard]] std::unique_ptr<transport::ByteLink> tapped(std::unique_ptr<transport::ByteLink> link) const;
    void watch(InstrumentDesk& instrument);
    void watch(LivePresenter& live, const core::VideoGate& gate);
    void watch(LogModel& log) const;
    /// A click or something that was done; `where`: the widget.
    void noteAction(const QString& what, const QString& where, const std::optional<QPoint>& at = std::nullopt);
    void noteAir(const std::optional<double>& temperature_c);  ///< typed, or read on Lab > Profiles
    void noteAir(const InstrumentAir& air);                     ///< that the instrument uses
    void noteShot(const geometry::Pointing& pointing, double slope_distance_m);

Q_SIGNALS:
    void statusChanged();

private:
    void note(blackbox::Kind kind, const QCborMap& map) const;
    void followSettings();
    void begin();
    void showEnd(const core::Error& error);
    void noteConnection();
    void noteControl();
    void writeAir();
    void noteFrame(const LivePresenter& live, const core::VideoGate& gate);
    void noteMessages();

    const QString folder_;
    Preferences& preferences_;
    MessageCentre& messages_;
    const core::Clock& clock_;
    std::shared_ptr<BlackBoxOutlet> outlet_ = std::make_shared<BlackBoxOutlet>();
    BlackBoxSettings used_;
    bool started_ = false;
    InstrumentDesk* instrument_ = nullptr;
    std::optional<instrument::ControlStatus> control_;
    std::optional<double> typed_degc_;
    InstrumentAir air_;
    bool air_told_ = false;
    std::optional<core::Error> failure_;
    std::uint64_t last_sequence_ = 0;
    std::optional<core::Duration> last_picture_;
    QTimer look_;
};

}  // namespace pmts::app
