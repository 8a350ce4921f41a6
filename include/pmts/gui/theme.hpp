#pragma once

#include <QColor>
#include <QString>

#include <optional>

class QApplication;

namespace pmts::gui {

/// Day is light grey, Night dark, Sun pure black and white with thick lines for direct sunlight.
enum class PaletteName { kDay, kNight, kSun };

/// Colours of one palette. State colours never stand alone: a shape goes with each (state_lamp.hpp).
struct Theme {
    PaletteName name = PaletteName::kDay;
    QColor window, panel, field, text, muted, border;
    QColor accent, on_accent;  ///< selected things
    QColor button, pressed, disabled_text;
    QColor idle, busy, good, warning, failed;
    QColor stop, on_stop;
    QColor overlay_light, overlay_dark;  ///< the two edges of everything drawn into an image
    double line_px = 1.0;                ///< outlines
    double wanted_contrast = 4.5;  ///< least contrast of any text, checked by a test that renders every form
};

[[nodiscard]] const Theme& themeNamed(PaletteName name);

/// The palette applied last; Day before that.
[[nodiscard]] const Theme& currentTheme();

/// Fusion style, palette and the generated style sheet, for the whole program.
void applyTheme(QApplication& application, PaletteName name);

/// The style sheet of a palette; its digits grow with the application's font.
[[nodiscard]] QString styleSheetFor(const Theme& theme);

/// `day`, `night`, `sun`, as on the command line and in the settings.
[[nodiscard]] std::optional<PaletteName> paletteFromText(const QString& text);
[[nodiscard]] QString textOf(PaletteName name);

/// WCAG 2 contrast ratio of two opaque colours, 1 to 21.
[[nodiscard]] double contrastRatio(const QColor& a, const QColor& b);

}  // namespace pmts::gui
