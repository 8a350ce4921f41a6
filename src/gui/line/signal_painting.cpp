// How the signal and its characters are drawn; signal_view.cpp moves them.
#include "signal_view.hpp"

#include "field/plan_view.hpp"
#include "pmts/app/line/talk_model.hpp"
#include "pmts/gui/theme.hpp"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace pmts::gui {
namespace {

constexpr double kNameWidth_px = 70.0;  ///< over the left end of a lane
constexpr double kLeastBox_px = 12.0;   ///< narrower characters are drawn without text
constexpr double kTickEvery_px = 140.0;
constexpr int kLookedInColumn = 32;  ///< characters asked whether they are sure

QString laneName(const app::LineFindings& findings, const app::FoundLine& line) {
    const QString name = findings.recording->capture.names.value(line.activity.line);
    return name.isEmpty() ? SignalView::tr("Pin %1").arg(line.activity.line) : name;
}

}  // namespace

int SignalView::lanes() const {
    return !findings_ || !findings_->signal
               ? 0
               : static_cast<int>(std::ranges::count_if(findings_->lines, &app::FoundLine::is_decoded));
}

double SignalView::characterLength() const {
    double longest = 1.0;
    for (const app::FoundLine& line : findings_->lines) {
        if (line.is_decoded && line.framing) {
            const int parity = line.framing->text().at(1) == u'N' ? 0 : 1;
            longest = std::max(longest, (2 + line.framing->data_bits + parity) * line.framing->samples_per_bit);
        }
    }
    return longest;
}

void SignalView::paintEvent(QPaintEvent*) {
    const Theme& theme = currentTheme();
    QPainter painter(this);
    painter.fillRect(rect(), theme.field);
    const double text_px = fontMetrics().height();
    if (!findings_) {
        painter.setPen(theme.text);
        painter.drawText(rect(), Qt::AlignCenter, tr("Nothing is imported."));
        return;
    }
    paintSelection(painter, theme);
    const QRectF axis(0, height() - text_px - 6, width(), text_px + 6);
    const QRectF characters(0, axis.top() - text_px - 10, width(), text_px + 8);
    const double lane_px = lanes() > 0 ? std::min(56.0, (characters.top() - 4) / lanes()) : 0.0;
    double top = 2;
    for (const app::FoundLine& line : findings_->lines) {
        if (line.is_decoded && findings_->signal) {
            paintLane(painter, theme, line, QRectF(0, top, width(), lane_px));
            top += lane_px;
        }
    }
    if (characterLength() / per_px_ >= kLeastBox_px) {
        paintCharacters(painter, theme, characters);
    } else {
        paintCharacterColumns(painter, theme, characters);
    }
    paintAxis(painter, theme, axis);
    painter.setPen(QPen(hasFocus() ? theme.accent : theme.border, hasFocus() ? 2.0 : 1.0));
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

void SignalView::paintSelection(QPainter& painter, const Theme& theme) const {
    if (selected_) {
        const QRectF place(QPointF(xOf(static_cast<double>(selected_->first)), 0),
                           QPointF(std::max(xOf(static_cast<double>(selected_->second)), xOf(static_cast<double>(selected_->first)) + 2), height()));
        QColor ground = theme.accent;
        ground.setAlpha(50);
        painter.fillRect(place, ground);
        painter.setPen(QPen(theme.accent, 1.0, Qt::DashLine));
        painter.drawRect(place);
    }
}

/// One column after the other: a level is a stroke, a column with both is filled from one to the other.
void SignalView::paintLane(QPainter& painter, const Theme& theme, const app::FoundLine& line, const QRectF& place) const {
    const double high_y = place.top() + 5, low_y = place.bottom() - 5;
    const std::uint32_t mask = 1U << line.activity.line;
    painter.setPen(QPen(theme.text, theme.line_px));
    std::optional<bool> before;
    for (int x = 0; x < width(); ++x) {
        const auto from = static_cast<std::uint64_t>(std::max(0.0, sampleAt(x)));
        const auto to = std::max(from + 1, static_cast<std::uint64_t>(std::max(0.0, sampleAt(x + 1))));
        const auto levels = findings_->signal->between(from, to);
        const bool high = (levels.high & mask) != 0, low = (levels.low & mask) != 0;
        if (!high && !low) {
            break;
        }
        if ((high && low) || (before && *before != high)) {
            painter.drawLine(QPointF(x, high_y), QPointF(x, low_y));
        }
        if (high != low) {
            painter.drawLine(QPointF(x, high ? high_y : low_y), QPointF(x + 1, high ? high_y : low_y));
            before = high;
        } else {
            before.reset();
        }
    }
    const QRectF name(4, place.top() + 2, kNameWidth_px, fontMetrics().height());
    painter.fillRect(name, theme.field);
    painter.setPen(theme.text);
    painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(laneName(*findings_, line), Qt::ElideRight, static_cast<int>(kNameWidth_px)));
}

/// Boxes with their characters; a doubtful one is hatched and has a question mark.
void SignalView::paintCharacters(QPainter& painter, const Theme& theme, const QRectF& place) const {
    const auto& all = findings_->characters;
    const double length = characterLength();
    const auto first = static_cast<std::uint64_t>(std::max(0.0, first_ - length));
    auto at = std::ranges::lower_bound(all, first, {}, &protocol::DecodedCharacter::sample);
    for (; at != all.end() && xOf(static_cast<double>(at->sample)) < width(); ++at) {
        const double begin = xOf(static_cast<double>(at->sample));
        const QRectF box(begin, place.top(), std::max(2.0, length / per_px_ - 1.0), place.height());
        painter.setPen(QPen(at->isSure() ? theme.border : theme.warning, at->isSure() ? 1.0 : 2.0));
        painter.setBrush(at->isSure() ? QBrush(theme.panel) : QBrush(theme.warning, Qt::BDiagPattern));
        painter.drawRect(box);
        painter.setPen(theme.text);
        const QString text = QString::fromStdString(protocol::shownCharacter(*at)).remove(QLatin1Char('[')).remove(QLatin1Char(']'));
        if (fontMetrics().horizontalAdvance(text) <= box.width()) {
            painter.drawText(box, Qt::AlignCenter, text);
        }
    }
    painter.setBrush(Qt::NoBrush);
}

/// Zoomed out: where something is said the column is filled; where it is not sure a mark sticks out below.
void SignalView::paintCharacterColumns(QPainter& painter, const Theme& theme, const QRectF& place) const {
    const auto& all = findings_->characters;
    const double length = characterLength();
    const QRectF bar = place.adjusted(0, 3, 0, -8);
    for (int x = 0; x < width(); ++x) {
        const auto from = static_cast<std::uint64_t>(std::max(0.0, sampleAt(x) - length));
        auto at = std::ranges::lower_bound(all, from, {}, &protocol::DecodedCharacter::sample);
        const double end = sampleAt(x + 1);
        if (at == all.end() || static_cast<double>(at->sample) >= end) {
            continue;
        }
        painter.fillRect(QRectF(x, bar.top(), 1, bar.height()), theme.accent);
        bool sure = true;
        for (int i = 0; i < kLookedInColumn && sure && at != all.end() && static_cast<double>(at->sample) < end; ++i, ++at) {
            sure = at->isSure();
        }
        if (!sure) {
            painter.fillRect(QRectF(x, bar.bottom(), 1, 7), theme.warning);
        }
    }
}

void SignalView::paintAxis(QPainter& painter, const Theme& theme, const QRectF& place) const {
    const auto rate = findings_->recording->samples_per_s;
    const double unit = rate ? 1.0 / *rate : 1.0;  // seconds or samples
    const double step = niceLength(kTickEvery_px * per_px_ * unit);
    const double first = std::ceil(first_ * unit / step) * step;
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step))));
    painter.setPen(theme.text);
    for (double at = first; xOf(at / unit) < width() && step > 0.0; at += step) {
        const double x = xOf(at / unit);
        painter.drawLine(QPointF(x, place.top()), QPointF(x, place.top() + 4));
        const QString text = rate ? tr("%1 s").arg(at, 0, 'f', decimals) : QStringLiteral("#%1").arg(at, 0, 'f', 0);
        painter.drawText(QPointF(x + 4, place.bottom() - 3), text);
    }
}

}  // namespace pmts::gui
