#pragma once

#include "pmts/app/field/method_page.hpp"
#include "pmts/core/result.hpp"

#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>

#include <memory>
#include <vector>

namespace pmts::gui {

class PlotWidget;

/// A PDF, A4 with margins, written from the top of a page down; a new page when the room is used up.
class PdfSheet {
public:
    static constexpr double kGap = 14.0;  ///< between the parts, dots

    /// kFile when the file cannot be written.
    [[nodiscard]] static core::Result<std::unique_ptr<PdfSheet>> open(const QString& path, const QString& title);
    /// Only now the file stands under its name; kFile when the disk is full.
    [[nodiscard]] core::Result<void> finish();

    void newPage();
    void makeRoom(double height);  ///< a new page unless so much of this one is left
    void paragraph(const QString& text, double points, bool bold = false);
    void pair(const QString& name, const QString& value);  ///< beside each other; both wrap
    void table(const app::TextTable& table);
    void plot(PlotWidget& plot, double height);
    [[nodiscard]] double roomLeft() const { return height() - top_; }
    [[nodiscard]] double height() const { return pdf_.height(); }

private:
    explicit PdfSheet(const QString& path);

    [[nodiscard]] std::vector<double> widthsOf(const app::TextTable& table, double points) const;
    [[nodiscard]] double fittingPoints(const app::TextTable& table) const;
    void row(const QStringList& cells, const std::vector<double>& widths, double points, bool bold);
    void line();

    QSaveFile file_;
    QPdfWriter pdf_;
    QPainter painter_;
    double top_ = 0;
};

}  // namespace pmts::gui
