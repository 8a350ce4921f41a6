#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/desk/live_presenter.hpp"

#include <QObject>
#include <QStringList>

#include <deque>
#include <optional>
#include <vector>

namespace pmts::app {

struct ProfileRow {
    QString name, camera, mode, method, age, rms;
    DeviceState state = DeviceState::kGood;
    QString state_text;  ///< why it is not good, else `good`
    bool in_use = false;
    bool has_previous = false;
};

/// The rig profiles, which of them is in use, and what speaks against it: another mode, age, temperature, a knock.
/// Concerns about the one in use are said in the message bar once, with a button that opens the check.
class ProfilesPresenter : public QObject {
    Q_OBJECT
public:
    ProfilesPresenter(Preferences& preferences, LivePresenter& live, InstrumentDesk& instrument, MessageCentre& messages,
                      const core::Clock& clock, QObject* parent = nullptr);

    [[nodiscard]] std::vector<ProfileRow> rows() const;
    [[nodiscard]] RigChoice inUse() const { return live_.rigChoice(); }
    [[nodiscard]] QStringList concerns() const;  ///< of the one in use, sentences
    [[nodiscard]] DeviceState state() const;
    [[nodiscard]] const std::optional<double>& temperature() const { return temperature_c_; }
    [[nodiscard]] const RigCareSettings& limits() const { return preferences_.settings().rig_care; }
    [[nodiscard]] bool picksByItself() const { return preferences_.settings().pick_rig; }

public Q_SLOTS:
    /// Uses this one from now on. One that another camera or mode would keep the program from picking turns the picking off.
    void use(const QString& name);
    void setPicksByItself(bool on);
    void setLimits(const RigCareSettings& limits);  ///< of age, temperature, checks and knocks
    void rename(const QString& from, const QString& to);
    void duplicate(const QString& name);
    void remove(const QString& name);
    void goBack(const QString& name);
    void exportTo(const QString& name, const QString& path);    ///< .json profile, .yaml OpenCV, .txt COLMAP
    void importFrom(const QString& path);                       ///< the same; a lens keeps the mount of the rig in use
    void setTemperature(const std::optional<double>& temperature_c);
    void readTemperature();                                     ///< label 56 of the instrument

Q_SIGNALS:
    void changed();

private:
    [[nodiscard]] QStringList concernsOf(const RigProfile& profile) const;
    [[nodiscard]] ProfileRow rowOf(const RigProfile& profile) const;
    void judge();
    void watchMove(const targeting::RecentringStep& step);
    void edit(const std::function<void(Settings&)>& change);
    void importLens(const QString& path);

    Preferences& preferences_;
    LivePresenter& live_;
    InstrumentDesk& instrument_;
    MessageCentre& messages_;
    const core::Clock& clock_;
    std::optional<double> temperature_c_;
    Ticket temperature_ticket_ = 0;
    QString said_;  ///< last, so that nothing is said twice
    std::deque<Eigen::Vector2d> left_over_px_;  ///< by the first moves of the last clicks
};

}  // namespace pmts::app
