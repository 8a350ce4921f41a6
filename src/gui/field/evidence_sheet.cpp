#include "evidence_sheet.hpp"

#include "thumbnail_painting.hpp"
#include "pmts/app/desk/whole_file.hpp"

#include <QCoreApplication>
#include <QPageSize>
#include <QPdfWriter>
#include <QSaveFile>

#include <algorithm>

namespace pmts::gui {
namespace {

constexpr QRectF kText(150, 130, 1800, 2710);  ///< inside the margins
constexpr double kGap = 40;
constexpr double kColumn = (1800 - kGap) / 2;
constexpr double kMostPictureHeight = 700;
constexpr double kStroke = 3;
constexpr int kTitle = 70;  ///< heights of letters
constexpr int kHeading = 38;
constexpr int kPlain = 31;
constexpr int kPdfResolution = 600;

QString tr(const char* sentence) { return QCoreApplication::translate("EvidenceSheet", sentence); }

QFont letters(int height, bool bold = false) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(height);
    font.setBold(bold);
    return font;
}

/// Writes downwards in one column of the page.
class Column {
public:
    Column(QPainter& painter, double left, double top, double width)
        : painter_(painter), left_(left), top_(top), width_(width) {}

    [[nodiscard]] double top() const { return top_; }
    void skip(double height) { top_ += height; }

    void write(const QString& text, const QFont& font, Qt::Alignment alignment = Qt::AlignLeft) {
        painter_.setFont(font);
        QRectF written;
        painter_.drawText(QRectF(left_, top_, width_, kText.bottom() - top_), alignment | Qt::TextWordWrap,
                          text, &written);
        top_ = written.bottom();
    }

    void writeLines(const QString& heading, const std::vector<app::EvidenceLine>& lines) {
        write(heading, letters(kHeading, true));
        painter_.setPen(QPen(Qt::black, kStroke));
        painter_.drawLine(QPointF(left_, top_ + 6), QPointF(left_ + width_, top_ + 6));
        skip(18);
        for (const app::EvidenceLine& line : lines) {
            writeLine(line);
        }
        skip(kGap);
    }

private:
    /// Label and value beside each other, a long value in several lines.
    void writeLine(const app::EvidenceLine& line) {
        const double label_width = 0.40 * width_;
        painter_.setFont(letters(kPlain));
        QRectF label, value;
        painter_.drawText(QRectF(left_, top_, label_width - 15, kText.height()), Qt::TextWordWrap, line.label,
                          &label);
        painter_.drawText(QRectF(left_ + label_width, top_, width_ - label_width, kText.height()),
                          Qt::TextWordWrap, line.value, &value);
        top_ = std::max(label.bottom(), value.bottom()) + 8;
    }

    QPainter& painter_;
    double left_, top_, width_;
};

double paintPictures(QPainter& painter, const app::EvidenceSheet& sheet, double top) {
    double bottom = top;
    double left = kText.left();
    for (const app::EvidenceThumbnail* thumbnail : {&sheet.before, &sheet.after}) {
        painter.setFont(letters(kPlain));
        painter.setPen(QPen(Qt::black, kStroke));
        QSizeF size = thumbnail->image.isNull() ? QSizeF(16, 9) : QSizeF(thumbnail->image.size());
        size.scale(kColumn, kMostPictureHeight, Qt::KeepAspectRatio);
        const QRectF covered = paintThumbnail(
            painter, QRectF(QPointF(left, top), QSizeF(kColumn, size.height())), *thumbnail, 1.4 * kStroke);
        Column caption(painter, left, covered.bottom() + 8, kColumn);
        caption.write(thumbnail->caption, letters(kPlain));
        bottom = std::max(bottom, caption.top());
        left += kColumn + kGap;
    }
    Column legend(painter, kText.left(), bottom + 4, kText.width());
    legend.write(tr("Cross: the reticle, where the telescope's axis meets the view. Ring: the spot that was "
                    "aimed at."),
                 letters(kPlain - 4));
    return legend.top();
}

void paintFooter(QPainter& painter) {
    painter.setFont(letters(kPlain - 4));
    painter.drawText(
        kText, Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap,
        tr("The coordinates come from the circles and the distance; the pictures show how well the telescope "
           "was aimed. Precisions are one sigma.   PMTS %1")
            .arg(QCoreApplication::applicationVersion()));
}

}  // namespace

void paintEvidenceSheet(QPainter& painter, const app::EvidenceSheet& sheet) {
    painter.setPen(QPen(Qt::black, kStroke));
    Column job(painter, kText.left(), kText.top(), kText.width());
    job.write(tr("Job %1").arg(sheet.job_name), letters(kPlain), Qt::AlignRight);
    Column head(painter, kText.left(), kText.top() - 20, 0.75 * kText.width());
    head.write(tr("Point %1").arg(sheet.point_id), letters(kTitle, true));
    head.write(sheet.subtitle, letters(kPlain));
    double top = paintPictures(painter, sheet, std::max(head.top(), job.top()) + kGap) + kGap;
    Column verdict(painter, kText.left(), top, kText.width());
    verdict.write(sheet.verdict, letters(kHeading, true));
    top = verdict.top() + kGap;
    Column point(painter, kText.left(), top, kColumn);
    point.writeLines(tr("Point"), sheet.place);
    point.writeLines(tr("Observation"), sheet.observation);
    Column aiming(painter, kText.left() + kColumn + kGap, top, kColumn);
    aiming.writeLines(tr("Aiming by image"), sheet.aiming);
    paintFooter(painter);
}

void usePageUnits(QPainter& painter, int dots_per_inch) {
    painter.scale(dots_per_inch / 254.0, dots_per_inch / 254.0);
}

core::Result<void> writeEvidencePdf(const app::EvidenceSheet& sheet, const QString& path) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
        return app::cannotWrite(path, file.errorString());
    }
    QPdfWriter pdf(&file);
    pdf.setTitle(tr("Point %1").arg(sheet.point_id));
    pdf.setCreator(QStringLiteral("PMTS"));
    pdf.setPageSize(QPageSize(QPageSize::A4));
    pdf.setPageMargins({});
    pdf.setResolution(kPdfResolution);
    QPainter painter(&pdf);
    usePageUnits(painter, kPdfResolution);
    paintEvidenceSheet(painter, sheet);
    if (!painter.end() || !file.commit()) {
        return app::cannotWrite(path, file.errorString());
    }
    return {};
}

}  // namespace pmts::gui
