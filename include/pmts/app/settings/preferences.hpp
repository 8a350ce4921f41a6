#pragma once

#include "pmts/app/settings/settings.hpp"

#include <QObject>
#include <QTimer>

namespace pmts::app {

/// The settings in use. Presenters read them and follow changed(); every change is written to the file soon after.
class Preferences : public QObject {
    Q_OBJECT
public:
    /// An empty path keeps nothing: tests.
    explicit Preferences(QString path, QObject* parent = nullptr);
    ~Preferences() override;  ///< writes what is not written yet

    [[nodiscard]] const Settings& settings() const { return settings_; }
    [[nodiscard]] const UnitFormat& units() const { return settings_.units; }

public Q_SLOTS:
    void set(const pmts::app::Settings& settings);
    void setUnits(const pmts::app::UnitFormat& units);
    void setPalette(pmts::app::Palette palette);
    void setWindow(const QByteArray& geometry, const QByteArray& layout);
    void setSounds(bool on);
    void setUnsolicitedPolicy(pmts::app::UnsolicitedPolicy policy);
    void setAveragePixelAngle(const pmts::targeting::AveragePixelAngle& angle);  ///< of the chosen rig
    /// Keeps a new calibration in the profile of the record's camera, mode, focus and zoom; what it had becomes its `previous`.
    /// Without such a profile a new one is made. The profile is used from now on where its camera is. Returns its name.
    QString acceptRig(const pmts::camera::Rig& rig, const pmts::app::CalibrationRecord& record);
    /// Exchanges a profile's rig with the one before it; false when there is none. Twice is as before.
    bool goBackToPreviousRig(const QString& profile);
    /// Keeps a check with its profile: a passed one clears the sign of a knock, a failed one is such a sign.
    void keepCheck(const QString& profile, const pmts::app::RigCheck& check);
    /// Empty clears it.
    void setKnockSign(const QString& profile, const QString& sentence);
    void save();

Q_SIGNALS:
    void changed();
    void unitsChanged(const pmts::app::UnitFormat& units);
    void paletteChanged(pmts::app::Palette palette);
    void problemReported(const pmts::core::Error& error);

private:
    void keep(Settings next);
    template <class Change>
    void change(Change change);
    template <class Change>
    bool changeProfile(const QString& name, Change change);

    QString path_;
    Settings settings_;
    QTimer save_soon_;
};

}  // namespace pmts::app
