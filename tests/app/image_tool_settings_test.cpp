#include "pmts/app/settings/settings.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <gmock/gmock.h>

namespace pmts::app {
namespace {

class ImageToolSettingsTest : public testing::Test {
protected:
    [[nodiscard]] ImageToolSettings readAgain(const ImageToolSettings& tools) const {
        Settings settings;
        settings.image_tools = tools;
        EXPECT_TRUE(settings.save(path).has_value());
        return Settings::load(path).image_tools;
    }

    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("settings.ini"));
};

TEST_F(ImageToolSettingsTest, EverythingComesBack) {
    const ImageToolSettings read = readAgain({.snap = true, .loupe_magnification = 12.5, .parallax_near_m = 3.0,
                                              .parallax_far_m = 80.0, .depth = {.near_m = 5.0, .far_m = 60.0}});
    EXPECT_TRUE(read.snap);
    EXPECT_DOUBLE_EQ(read.loupe_magnification, 12.5);
    EXPECT_DOUBLE_EQ(read.parallax_near_m, 3.0);
    EXPECT_DOUBLE_EQ(read.parallax_far_m, 80.0);
    EXPECT_EQ(read.depth, (DepthFilter{.near_m = 5.0, .far_m = 60.0}));
}

TEST_F(ImageToolSettingsTest, LimitThatWasTakenAwayStaysAway) {
    (void)readAgain({.depth = {.near_m = 5.0, .far_m = 60.0}});
    EXPECT_EQ(readAgain({}).depth, DepthFilter{});
}

TEST_F(ImageToolSettingsTest, NonsenseInTheFileKeepsTheDefaults) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("[tools]\nloupe_magnification=99\nparallax_near_m=50\nparallax_far_m=10\ndepth_near_m=soup\n");
    file.close();
    const ImageToolSettings read = Settings::load(path).image_tools;
    EXPECT_DOUBLE_EQ(read.loupe_magnification, 8.0);
    EXPECT_DOUBLE_EQ(read.parallax_near_m, 2.0);
    EXPECT_DOUBLE_EQ(read.parallax_far_m, 200.0);
    EXPECT_EQ(read.depth, DepthFilter{});
}

}  // namespace
}  // namespace pmts::app
