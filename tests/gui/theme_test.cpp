#include "pmts/gui/theme.hpp"

#include <QApplication>
#include <QPalette>
#include <QSlider>
#include <QTest>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

TEST(ContrastRatio, IsTheOneOfThePublishedDefinition) {
    EXPECT_NEAR(contrastRatio(Qt::black, Qt::white), 21.0, 1e-9);
    EXPECT_NEAR(contrastRatio(QColor("#767676"), Qt::white), 4.54,
                0.01);  // the grey WCAG 2 names as just enough
    EXPECT_NEAR(contrastRatio(Qt::red, Qt::red), 1.0, 1e-12);
}

class ThemeTest : public testing::TestWithParam<PaletteName> {};

TEST_P(ThemeTest, TextReachesTheWantedContrastOnEveryGround) {
    const Theme& theme = themeNamed(GetParam());
    const std::pair<QColor, QColor> pairs[] = {
        {theme.text, theme.window},          {theme.text, theme.panel},
        {theme.text, theme.field},           {theme.text, theme.button},
        {theme.text, theme.pressed},         {theme.muted, theme.panel},
        {theme.muted, theme.window},         {theme.muted, theme.field},
        {theme.on_accent, theme.accent},     {theme.on_stop, theme.stop},
        {theme.disabled_text, theme.window}, {theme.overlay_light, theme.overlay_dark}};
    for (const auto& [ink, ground] : pairs) {
        EXPECT_GE(contrastRatio(ink, ground), theme.wanted_contrast)
            << ink.name().toStdString() << " on " << ground.name().toStdString();
    }
}

TEST_P(ThemeTest, NameAndTextBelongTogether) { EXPECT_EQ(paletteFromText(textOf(GetParam())), GetParam()); }

TEST_P(ThemeTest, StyleSheetHasNoNameLeftOver) {
    EXPECT_FALSE(styleSheetFor(themeNamed(GetParam())).contains(u'@'));
}

INSTANTIATE_TEST_SUITE_P(EveryPalette, ThemeTest,
                         testing::Values(PaletteName::kDay, PaletteName::kNight, PaletteName::kSun),
                         [](const auto& palette) { return textOf(palette.param).toStdString(); });

TEST(Theme, SunHasNoGreyTextAndThickLines) {
    const Theme& sun = themeNamed(PaletteName::kSun);
    for (const QColor& ink : {sun.text, sun.muted, sun.disabled_text, sun.border}) {
        EXPECT_EQ(ink, QColor(Qt::black));
    }
    EXPECT_EQ(sun.window, QColor(Qt::white));
    EXPECT_GE(sun.line_px, 2.0);
}

TEST(Theme, AppliedPaletteIsTheCurrentOne) {
    applyTheme(*qApp, PaletteName::kNight);
    EXPECT_EQ(currentTheme().name, PaletteName::kNight);
    EXPECT_EQ(QApplication::palette().color(QPalette::Window), themeNamed(PaletteName::kNight).window);
    applyTheme(*qApp, PaletteName::kDay);
}

TEST(Theme, AClickBesideTheKnobOfASliderTakesItThere) {
    applyTheme(*qApp, PaletteName::kDay);
    QSlider slider(Qt::Horizontal);
    slider.setRange(0, 100);
    slider.resize(400, 40);
    slider.show();
    QTest::mouseClick(&slider, Qt::LeftButton, {}, {300, 20});
    EXPECT_NEAR(slider.value(), 75, 3);
}

TEST(Theme, UnknownPaletteIsNone) { EXPECT_EQ(paletteFromText(QStringLiteral("dusk")), std::nullopt); }

}  // namespace
}  // namespace pmts::gui
