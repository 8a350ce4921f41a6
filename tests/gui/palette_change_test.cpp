#include "bench_fixture.hpp"
#include "pmts/gui/theme.hpp"

#include <QApplication>

namespace pmts::gui {
namespace {

class PaletteChangeTest : public test::WindowFixture, public testing::WithParamInterface<app::Palette> {
protected:
    void TearDown() override { applyTheme(*qApp, PaletteName::kDay); }

    static QImage picture(MainWindow& shown) {
        shown.setWindowState(Qt::WindowNoState);
        shown.resize(1280, 800);
        shown.show();
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
        return shown.grab().toImage();
    }
};

/// applyTheme() takes a quick way; a sheet that replaces another makes Qt polish every widget the long way.
TEST_P(PaletteChangeTest, NothingIsLeftOverOfThePaletteBefore) {
    (void)picture(*window);
    for (const auto palette : {app::Palette::kNight, app::Palette::kSun, GetParam()}) {
        bench->preferences.setPalette(palette);
    }
    const QImage changed = picture(*window);
    qApp->setStyleSheet(styleSheetFor(currentTheme()) + u' ');
    EXPECT_EQ(changed, picture(*window));
}

INSTANTIATE_TEST_SUITE_P(EveryPalette, PaletteChangeTest,
                         testing::Values(app::Palette::kDay, app::Palette::kNight, app::Palette::kSun));

}  // namespace
}  // namespace pmts::gui
