#pragma once

#include "parts/pan_drag.hpp"
#include "pmts/app/line/line_findings.hpp"

#include <QWidget>

#include <memory>
#include <optional>

class QPainter;

namespace pmts::gui {

struct Theme;

/// The levels of the decoded lines and their characters along the time. The wheel zooms, drag and the arrows pan, + and -
/// zoom, Home shows everything, a click chooses. Draws one column of pixels at a time, whatever the number of samples.
class SignalView : public QWidget {
    Q_OBJECT
public:
    explicit SignalView(QWidget* parent = nullptr);

    void showFindings(std::shared_ptr<const app::LineFindings> findings);
    void select(std::uint64_t from, std::uint64_t to);  ///< marked, and brought into sight with room around it
    void fit();
    void zoomBy(double factor);
    void pan(double share);  ///< of the width; positive goes to later samples

    [[nodiscard]] double firstSample() const { return first_; }
    [[nodiscard]] double samplesPerPixel() const { return per_px_; }
    [[nodiscard]] QSize sizeHint() const override { return {600, 150}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 110}; }

Q_SIGNALS:
    void sampleClicked(std::uint64_t sample);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] double samples() const;
    [[nodiscard]] double sampleAt(double x) const { return first_ + x * per_px_; }
    [[nodiscard]] double xOf(double sample) const { return (sample - first_) / per_px_; }
    [[nodiscard]] int lanes() const;
    void zoomAbout(double x, double factor);
    void keepInside();
    void paintSelection(QPainter& painter, const Theme& theme) const;
    void paintLane(QPainter& painter, const Theme& theme, const app::FoundLine& line, const QRectF& place) const;
    void paintCharacters(QPainter& painter, const Theme& theme, const QRectF& place) const;
    void paintCharacterColumns(QPainter& painter, const Theme& theme, const QRectF& place) const;
    void paintAxis(QPainter& painter, const Theme& theme, const QRectF& place) const;
    [[nodiscard]] double characterLength() const;

    std::shared_ptr<const app::LineFindings> findings_;
    double first_ = 0.0, per_px_ = 1.0;
    bool is_fitted_ = true;
    std::optional<std::pair<std::uint64_t, std::uint64_t>> selected_;
    PanDrag drag_;
};

}  // namespace pmts::gui
