#include "board_figures.hpp"

#include "pmts/calibration/board_calibration.hpp"
#include "support/board_pictures.hpp"
#include "support/figure.hpp"

#include <cmath>
#include <cstdio>
#include <string>

namespace pmts::bench {
namespace {

void calibrateDrawn(const std::string& name, const calibration::BoardPattern& pattern) {
    constexpr camera::BrownLens kLens{.f_px = 1400, .cx_px = 643.5, .cy_px = 357.5, .k1 = -0.12, .k2 = 0.02};
    constexpr int kViews = 20;
    const test::BoardPictures pictures(camera::Lens(kLens), 1280, 720);
    std::vector<calibration::BoardView> views;
    unsigned seed = 0;
    for (const test::BoardPlace& place : test::boardPlaces(pattern, kLens.f_px, 1280, kViews)) {
        if (auto view = calibration::findBoard(pictures.draw(pattern, place, 2.0, ++seed), pattern)) {
            views.push_back(*std::move(view));
        }
    }
    const auto result = calibration::calibrateBoard(views);
    if (!result) {
        std::fprintf(stderr, "%s\n", qPrintable(result.error().sentence()));
        return figure("calibration." + name + "_views", 0, "", Wanted::kAtLeast, 1);
    }
    figure("calibration." + name + "_views", static_cast<double>(result->views.size()), "", Wanted::kAtLeast, kViews / 2);
    figure("calibration." + name + "_rms", result->rms_px, "px", Wanted::kAtMost, 0.1);
    figure("calibration." + name + "_against_opencv", 100 * std::abs(result->rms_px / result->opencv_rms_px - 1), "%", Wanted::kAtMost, 5);
    figure("calibration." + name + "_f_error", 100 * std::abs(result->lens.focalLengthPx() / kLens.f_px - 1), "%", Wanted::kAtMost, 0.1);
}

}  // namespace

void boardFigures() {
    calibrateDrawn("chessboard", {});
    calibrateDrawn("charuco", {.columns = 9, .rows = 6, .square_m = 0.025, .dictionary = QStringLiteral("DICT_4X4_50")});
}

}  // namespace pmts::bench
