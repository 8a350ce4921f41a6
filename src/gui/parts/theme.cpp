#include "pmts/gui/theme.hpp"

#include "line_icon.hpp"

#include <QApplication>
#include <QFile>
#include <QPalette>
#include <QProxyStyle>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace pmts::gui {
namespace {

QColor rgb(QRgb value) { return QColor(value); }

Theme dayTheme() {
    return {.name = PaletteName::kDay,
            .window = rgb(0xe4e7ea),
            .panel = rgb(0xf2f4f6),
            .field = rgb(0xffffff),
            .text = rgb(0x14181c),
            .muted = rgb(0x454d57),
            .border = rgb(0x8b949e),
            .accent = rgb(0x0b57a4),
            .on_accent = rgb(0xffffff),
            .button = rgb(0xfbfcfd),
            .pressed = rgb(0xcfd8e3),
            .disabled_text = rgb(0x58616b),
            .idle = rgb(0x59626d),
            .busy = rgb(0x0b57a4),
            .good = rgb(0x14702f),
            .warning = rgb(0xc77700),
            .failed = rgb(0xb3261e),
            .stop = rgb(0xb3261e),
            .on_stop = rgb(0xffffff),
            .overlay_light = rgb(0xffffff),
            .overlay_dark = rgb(0x101418),
            .line_px = 1.0,
            .wanted_contrast = 4.5};
}

Theme nightTheme() {
    return {.name = PaletteName::kNight,
            .window = rgb(0x15181c),
            .panel = rgb(0x1d2126),
            .field = rgb(0x0e1013),
            .text = rgb(0xe8ebef),
            .muted = rgb(0xb3bcc7),
            .border = rgb(0x5d6772),
            .accent = rgb(0x66b0f7),
            .on_accent = rgb(0x0a1016),
            .button = rgb(0x2a3038),
            .pressed = rgb(0x3c4754),
            .disabled_text = rgb(0x98a2ad),
            .idle = rgb(0x9aa4af),
            .busy = rgb(0x66b0f7),
            .good = rgb(0x4cc26a),
            .warning = rgb(0xf2b134),
            .failed = rgb(0xff6b61),
            .stop = rgb(0xb3261e),
            .on_stop = rgb(0xffffff),
            .overlay_light = rgb(0xfff4e0),
            .overlay_dark = rgb(0x000000),
            .line_px = 1.0,
            .wanted_contrast = 4.5};
}

Theme sunTheme() {
    return {.name = PaletteName::kSun,
            .window = rgb(0xffffff),
            .panel = rgb(0xffffff),
            .field = rgb(0xffffff),
            .text = rgb(0x000000),
            .muted = rgb(0x000000),
            .border = rgb(0x000000),
            .accent = rgb(0x000000),
            .on_accent = rgb(0xffffff),
            .button = rgb(0xffffff),
            .pressed = rgb(0xffe94d),
            .disabled_text = rgb(0x000000),
            .idle = rgb(0x000000),
            .busy = rgb(0x003a9e),
            .good = rgb(0x00500f),
            .warning = rgb(0xffb300),
            .failed = rgb(0x9c0000),
            .stop = rgb(0x8c0000),
            .on_stop = rgb(0xffffff),
            .overlay_light = rgb(0xffffff),
            .overlay_dark = rgb(0x000000),
            .line_px = 2.0,
            .wanted_contrast = 7.0};
}

const std::array<Theme, 3>& themes() {
    static const std::array<Theme, 3> all{dayTheme(), nightTheme(), sunTheme()};
    return all;
}

PaletteName& currentName() {
    static PaletteName name = PaletteName::kDay;
    return name;
}

/// Fusion without the desktop's pictures on dialog buttons, which would be the only icons not drawn for PMTS. A click beside
/// the knob of a slider takes it there.
class FieldStyle final : public QProxyStyle {
public:
    FieldStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* answer) const override {
        switch (hint) {
            case SH_DialogButtonBox_ButtonsHaveIcons: return 0;
            case SH_Slider_AbsoluteSetButtons: return Qt::LeftButton;
            default: return QProxyStyle::styleHint(hint, option, widget, answer);
        }
    }
};

QPalette qtPalette(const Theme& theme) {
    QPalette palette;
    palette.setColor(QPalette::Window, theme.window);
    palette.setColor(QPalette::WindowText, theme.text);
    palette.setColor(QPalette::Base, theme.field);
    palette.setColor(QPalette::AlternateBase, theme.panel);
    palette.setColor(QPalette::Text, theme.text);
    palette.setColor(QPalette::PlaceholderText, theme.muted);
    palette.setColor(QPalette::Button, theme.button);
    palette.setColor(QPalette::ButtonText, theme.text);
    palette.setColor(QPalette::BrightText, theme.on_stop);
    palette.setColor(QPalette::Highlight, theme.accent);
    palette.setColor(QPalette::HighlightedText, theme.on_accent);
    palette.setColor(QPalette::Link, theme.accent);
    palette.setColor(QPalette::LinkVisited, theme.accent);
    palette.setColor(QPalette::ToolTipBase, theme.text);
    palette.setColor(QPalette::ToolTipText, theme.window);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, theme.disabled_text);
    }
    palette.setColor(QPalette::Disabled, QPalette::Base, theme.window);
    return palette;
}

double linear(double channel) {
    return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& color) {
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

}  // namespace

const Theme& themeNamed(PaletteName name) { return themes()[static_cast<std::size_t>(name)]; }

const Theme& currentTheme() { return themeNamed(currentName()); }

void applyTheme(QApplication& application, PaletteName name) {
    currentName() = name;
    const Theme& theme = themeNamed(name);
    // The old sheet goes first: replacing one polishes every widget anew for each of its parents (ten times slower).
    application.setStyleSheet({});
    static const bool has_style = [] {
        QApplication::setStyle(new FieldStyle);
        return true;
    }();
    Q_UNUSED(has_style)
    QApplication::setPalette(qtPalette(theme));
    application.setStyleSheet(styleSheetFor(theme));
}

QString styleSheetFor(const Theme& theme) {
    useResources();
    QFile file(QStringLiteral(":/pmts/style.qss"));
    if (!file.open(QIODevice::ReadOnly)) {
        throw std::logic_error("the style sheet is missing from the resources");
    }
    QString sheet = QString::fromUtf8(file.readAll());
    const std::pair<const char*, QString> values[] = {
        {"@window", theme.window.name()},
        {"@panel", theme.panel.name()},
        {"@field", theme.field.name()},
        {"@text", theme.text.name()},
        {"@muted", theme.muted.name()},
        {"@border", theme.border.name()},
        {"@accent", theme.accent.name()},
        {"@on_accent", theme.on_accent.name()},
        {"@button", theme.button.name()},
        {"@pressed", theme.pressed.name()},
        {"@disabled_text", theme.disabled_text.name()},
        {"@disabled_line",
         theme.name == PaletteName::kSun ? QStringLiteral("dashed") : QStringLiteral("solid")},
        {"@failed", theme.failed.name()},
        {"@warning", theme.warning.name()},
        {"@good", theme.good.name()},
        {"@stop", theme.stop.name()},
        {"@on_stop", theme.on_stop.name()},
        {"@line", QString::number(theme.line_px) + QStringLiteral("px")},
        {"@shade", theme.name == PaletteName::kNight ? QStringLiteral("light") : QStringLiteral("dark")},
    };
    // Longest names first, so that @on_accent is not read as something shorter.
    std::vector<std::pair<QString, QString>> ordered;
    for (const auto& [key, value] : values) {
        ordered.emplace_back(QString::fromLatin1(key), value);
    }
    std::ranges::sort(ordered, [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
    for (const auto& [key, value] : ordered) {
        sheet.replace(key, value);
    }
    return sheet;
}

std::optional<PaletteName> paletteFromText(const QString& text) {
    for (const Theme& theme : themes()) {
        if (text == textOf(theme.name)) {
            return theme.name;
        }
    }
    return std::nullopt;
}

QString textOf(PaletteName name) {
    switch (name) {
        case PaletteName::kNight:
            return QStringLiteral("night");
        case PaletteName::kSun:
            return QStringLiteral("sun");
        case PaletteName::kDay:
            break;
    }
    return QStringLiteral("day");
}

double contrastRatio(const QColor& a, const QColor& b) {
    const double of_a = luminance(a);
    const double of_b = luminance(b);
    return (std::max(of_a, of_b) + 0.05) / (std::min(of_a, of_b) + 0.05);
}

}  // namespace pmts::gui
