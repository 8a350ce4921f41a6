#include "field/frame_raster.hpp"

#include "test_frame.hpp"

#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

TEST(FrameRasterTest, KeepsBlueBlue) {
    FrameRaster raster;
    const QImage& image =
        raster.render(test::frameWithBluePixel(3, 2, 16, 8), QRect(0, 0, 16, 8), QSize(16, 8));
    EXPECT_EQ(image.pixelColor(3, 2), QColor(0, 0, 255));
    EXPECT_EQ(image.pixelColor(0, 0), QColor(90, 90, 90));
}

TEST(FrameRasterTest, ShowsOnlyThePartAskedFor) {
    FrameRaster raster;
    const QImage& image =
        raster.render(test::frameWithBluePixel(10, 5, 16, 8), QRect(8, 4, 4, 2), QSize(4, 2));
    EXPECT_EQ(image.size(), QSize(4, 2));
    EXPECT_EQ(image.pixelColor(2, 1), QColor(0, 0, 255));
}

TEST(FrameRasterTest, ShowsPixelsAsSquaresWhenMagnified) {
    FrameRaster raster;
    const QImage& image =
        raster.render(test::frameWithBluePixel(1, 1, 4, 4), QRect(0, 0, 4, 4), QSize(32, 32));
    EXPECT_EQ(image.pixelColor(8, 8), QColor(0, 0, 255));
    EXPECT_EQ(image.pixelColor(15, 15), QColor(0, 0, 255));
    EXPECT_EQ(image.pixelColor(16, 16), QColor(90, 90, 90));
}

TEST(FrameRasterTest, DrawsTheSameFrameOnce) {
    FrameRaster raster;
    const auto frame = test::frameWithBluePixel(1, 1, 64, 64);
    const uchar* const first = raster.render(frame, QRect(0, 0, 64, 64), QSize(32, 32)).constBits();
    EXPECT_EQ(raster.render(frame, QRect(0, 0, 64, 64), QSize(32, 32)).constBits(), first);
}

}  // namespace
}  // namespace pmts::gui
