#include "pmts/app/lab/rig_profile.hpp"

#include "support/matchers.hpp"

#include <QTemporaryDir>

namespace pmts::app {
namespace {

TEST(RigProfileTest, ExportedProfileIsImportedAgain) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("rig.json"));
    ASSERT_TRUE(saveRigProfile(simulatedRigProfile(), path).has_value());
    const auto back = loadRigProfile(path);
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(back->name, simulatedRigProfile().name);
    EXPECT_EQ(back->rig.mount.offset_m, simulatedRigProfile().rig.mount.offset_m);
}

TEST(RigProfileTest, DamagedPixelAngleIsRefusedAndNamed) {
    RigProfile profile = simulatedRigProfile();
    profile.average_pixel_angle = {core::Angle::fromGon(0.0785), core::Angle::fromGon(0.0791)};
    const QByteArray good = rigProfileToJson(profile);
    ASSERT_TRUE(rigProfileFromJson(good).has_value());
    const auto damaged = rigProfileFromJson(QByteArray(good).replace("0.0785", "\"wide\""));
    ASSERT_THAT(damaged, test::FailedWith(core::ErrorKind::kBadInput));
    EXPECT_TRUE(damaged.error().remedy.contains(QStringLiteral("average_pixel_angle")));
}

TEST(RigProfileTest, OtherJsonIsRefusedWithASentence) {
    const auto profile = rigProfileFromJson(R"({"type": "FeatureCollection"})");
    ASSERT_THAT(profile, test::FailedWith(core::ErrorKind::kBadInput));
    EXPECT_FALSE(profile.error().remedy.isEmpty());
}

TEST(RigProfileTest, MissingFileIsRefusedWithItsPathInTheLog) {
    const auto profile = loadRigProfile(QStringLiteral("/nowhere/rig.json"));
    ASSERT_THAT(profile, test::FailedWith(core::ErrorKind::kFile));
    EXPECT_TRUE(profile.error().detail.contains(QStringLiteral("/nowhere/rig.json")));
}

}  // namespace
}  // namespace pmts::app
