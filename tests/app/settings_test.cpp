#include "pmts/app/settings/preferences.hpp"

#include "support/matchers.hpp"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace pmts::app {
namespace {

class SettingsTest : public testing::Test {
protected:
    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("settings.ini"));
};

TEST_F(SettingsTest, FirstStartHasTheUsualValues) {
    const Settings settings = Settings::load(path);
    EXPECT_EQ(settings.last_device, LastDevice::kSimulated);
    EXPECT_NEAR(settings.arrow_step.arcsec(), 300.0, 1e-9);
    EXPECT_EQ(settings.units.angle_unit, core::AngleUnit::kGon);
    EXPECT_EQ(settings.chosenRig().name, simulatedRigProfile().name);
}

TEST_F(SettingsTest, EverythingKeptComesBack) {
    Settings kept;
    kept.units = {.angle_unit = core::AngleUnit::kDms, .length_unit = core::LengthUnit::kFoot, .length_decimals = 2};
    kept.palette = Palette::kSun;
    kept.window_layout = QByteArray("\0\xff layout", 9);
    kept.last_job = QStringLiteral("/jobs/façade 12.gpkg");
    kept.last_device = LastDevice::kSerial;
    kept.serial = {.path = QStringLiteral("/dev/ttyUSB0"), .adapter = {.usb_vendor = 0x0403, .usb_product = 0x6001,
                   .usb_serial_number = QStringLiteral("A50285BI"), .last_path = QStringLiteral("/dev/ttyUSB0")},
                   .baud = 4800, .data_bits = 7, .parity = Parity::kEven, .stop_bits = 2,
                   .dialect = instrument::LineDialect::kBus};
    kept.camera = {.kind = video::SourceKind::kV4l2, .location = QStringLiteral("/dev/video2"), .name = QStringLiteral("Cam")};
    kept.arrow_step = core::Angle::fromGon(0.25);
    kept.edm_mode = instrument::EdmMode::kDBar;
    kept.aiming.method = targeting::Method::kOatpa;
    kept.aiming.recentre = false;
    kept.aiming.tolerance_px = 0.3;
    kept.aiming.limits.ha_sector = std::pair(core::Angle::fromGon(390), core::Angle::fromGon(20));
    kept.aiming.place = targeting::Place{core::Angle::fromDeg(60.17), core::Angle::fromDeg(24.94)};
    kept.aiming.most_wound = core::Angle::fromGon(600);
    kept.recent_codes = {QStringLiteral("WALL"), QStringLiteral("TREE, old")};
    ASSERT_TRUE(kept.save(path).has_value());

    const Settings back = Settings::load(path);

    EXPECT_EQ(back.units, kept.units);
    EXPECT_EQ(back.palette, kept.palette);
    EXPECT_EQ(back.window_layout, kept.window_layout);
    EXPECT_EQ(back.last_job, kept.last_job);
    EXPECT_EQ(back.last_device, kept.last_device);
    EXPECT_EQ(back.serial, kept.serial);
    EXPECT_EQ(back.camera, kept.camera);
    EXPECT_EQ(back.arrow_step, kept.arrow_step);
    EXPECT_EQ(back.edm_mode, kept.edm_mode);
    EXPECT_EQ(back.recent_codes, kept.recent_codes);
    EXPECT_EQ(back.aiming.method, kept.aiming.method);
    EXPECT_FALSE(back.aiming.recentre);
    EXPECT_EQ(back.aiming.tolerance_px, 0.3);
    EXPECT_EQ(back.aiming.limits.ha_sector, kept.aiming.limits.ha_sector);
    ASSERT_TRUE(back.aiming.place.has_value());
    EXPECT_NEAR(back.aiming.place->latitude.deg(), 60.17, 1e-9);
    EXPECT_EQ(back.aiming.most_wound, kept.aiming.most_wound);
}

TEST_F(SettingsTest, AveragePixelAngleIsKeptWithTheRigItWasMeasuredWith) {
    const targeting::AveragePixelAngle measured{core::Angle::fromGon(0.0785), core::Angle::fromGon(0.0791)};
    Settings kept;
    RigProfile webcam = simulatedRigProfile();
    webcam.name = QStringLiteral("Webcam");
    kept.rig_profiles = {webcam};
    kept.rig_profile = webcam.name;
    kept.setAveragePixelAngle(measured);
    ASSERT_TRUE(kept.save(path).has_value());

    Settings back = Settings::load(path);
    EXPECT_DOUBLE_EQ(back.chosenRig().average_pixel_angle.value().vertical.gon(), 0.0791);
    back.rig_profile.clear();  // the simulated camera has none yet
    EXPECT_FALSE(back.chosenRig().average_pixel_angle.has_value());
}

TEST_F(SettingsTest, AveragePixelAngleOfTheSimulatedCameraIsKeptToo) {
    Settings kept;
    kept.setAveragePixelAngle({{core::Angle::fromGon(0.0785), core::Angle::fromGon(0.0791)}});
    ASSERT_TRUE(kept.save(path).has_value());
    EXPECT_DOUBLE_EQ(Settings::load(path).chosenRig().average_pixel_angle.value().horizontal.gon(), 0.0785);
}

TEST_F(SettingsTest, RigProfilesAreKeptWithTheirOffsets) {
    Settings kept;
    RigProfile profile = simulatedRigProfile();
    profile.name = QStringLiteral("Webcam on the handle");
    profile.rig.mount.kind = camera::MountKind::kHandle;
    profile.rig.mount.offset_m = {0.01, 0.02, 0.25};
    kept.rig_profiles = {profile};
    kept.rig_profile = profile.name;
    ASSERT_TRUE(kept.save(path).has_value());

    const RigProfile back = Settings::load(path).chosenRig();

    EXPECT_EQ(back.name, profile.name);
    EXPECT_EQ(back.rig.mount.kind, camera::MountKind::kHandle);
    EXPECT_EQ(back.rig.mount.offset_m, profile.rig.mount.offset_m);
}

TEST_F(SettingsTest, DamagedEntriesKeepTheirDefaultAndNeverStopTheStart) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("[units]\nangle=17\nlength=feet\n[work]\narrow_step_gon=-3\nedm_mode=x\n[serial]\nbaud=1e99\n[rigs]\nprofiles={\n");
    file.close();
    const Settings settings = Settings::load(path);
    EXPECT_EQ(settings.units, UnitFormat{});
    EXPECT_NEAR(settings.arrow_step.arcsec(), 300.0, 1e-9);
    EXPECT_EQ(settings.serial.baud, 9600);
    EXPECT_TRUE(settings.rig_profiles.empty());
}

TEST_F(SettingsTest, FolderThatCannotBeWrittenIsAnErrorWithASentence) {
    const auto saved = Settings{}.save(QStringLiteral("/proc/pmts/settings.ini"));
    ASSERT_THAT(saved, test::FailedWith(core::ErrorKind::kFile));
    EXPECT_FALSE(saved.error().remedy.isEmpty());
}

TEST_F(SettingsTest, PreferencesAreWrittenWhenTheProgramEnds) {
    {
        Preferences preferences(path);
        preferences.setPalette(Palette::kNight);
    }
    EXPECT_EQ(Settings::load(path).palette, Palette::kNight);
}

TEST_F(SettingsTest, UnitsChangeIsToldOnceAndOnlyWhenTheyChange) {
    Preferences preferences{QString()};
    QSignalSpy changed(&preferences, &Preferences::unitsChanged);
    preferences.setUnits({.angle_unit = core::AngleUnit::kMil});
    preferences.setUnits({.angle_unit = core::AngleUnit::kMil});
    preferences.setSounds(false);
    EXPECT_EQ(changed.size(), 1);
}

}  // namespace
}  // namespace pmts::app
