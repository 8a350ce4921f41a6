#include "field/evidence_sheet.hpp"

#include "evidence_support.hpp"
#include "field/thumbnail_painting.hpp"

#include <QFile>
#include <QPaintEngine>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

/// Notes every text that is drawn, and where it ends.
class TextEngine : public QPaintEngine {
public:
    TextEngine() : QPaintEngine(QPaintEngine::AllFeatures) {}
    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState&) override {}
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawImage(const QRectF& place, const QImage&, const QRectF&, Qt::ImageConversionFlags) override {
        pictures.append(painter()->combinedTransform().mapRect(place));
    }
    void drawPath(const QPainterPath&) override {}
    void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        texts.append(item.text());
        written |= painter()->combinedTransform().mapRect(
            QRectF(at.x(), at.y() - item.ascent(), item.width(), item.ascent()));
    }
    [[nodiscard]] Type type() const override { return QPaintEngine::User; }

    QStringList texts;
    QList<QRectF> pictures;
    QRectF written;
};

/// A sheet of A4 at 254 dots an inch: a dot is a tenth of a millimetre.
class TextPage : public QPaintDevice {
public:
    [[nodiscard]] QPaintEngine* paintEngine() const override { return &engine; }
    mutable TextEngine engine;

protected:
    [[nodiscard]] int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
            case PdmWidth:
                return 2100;
            case PdmHeight:
                return 2970;
            case PdmDpiX:
            case PdmDpiY:
            case PdmPhysicalDpiX:
            case PdmPhysicalDpiY:
                return 254;
            case PdmDevicePixelRatio:
                return 1;
            case PdmDevicePixelRatioScaled:
                return static_cast<int>(QPaintDevice::devicePixelRatioFScale());
            case PdmDepth:
                return 32;
            default:
                return 0;
        }
    }
};

QString textOn(TextPage& page, const app::EvidenceSheet& sheet) {
    QPainter painter(&page);
    usePageUnits(painter, 254);
    paintEvidenceSheet(painter, sheet);
    painter.end();
    return page.engine.texts.join(u' ');
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

TEST(EvidenceSheetTest, ShowsPointPlacePrecisionMethodAndResidual) {
    TextPage page;
    const QString text = textOn(page, test::aimedSheet());
    for (const char* words : {"Point 104", "facade-12", "station 100", "1003.500 m", "± 3.0 mm",
                              "12.3456 gon", "15.200 m", "rigorous", "Known error", "0.974", "0.05 px"}) {
        EXPECT_THAT(text.toStdString(), testing::HasSubstr(words));
    }
    EXPECT_EQ(page.engine.pictures.size(), 2);
}

TEST(EvidenceSheetTest, StaysInsideTheMarginsAlsoWithLongTexts) {
    app::EvidenceSheet sheet = test::aimedSheet();
    sheet.subtitle = QStringLiteral("the upper left corner of the third window ").repeated(8);
    sheet.aiming.push_back(
        {QStringLiteral("Known error"), QStringLiteral("up to 1.76 gon on the photo ").repeated(6)});
    sheet.after.image = QImage(200, 300, QImage::Format_RGB888);  // a camera that stands on its side
    TextPage page;
    textOn(page, sheet);
    const QRectF a4(140, 90, 1820, 2770);
    EXPECT_TRUE(a4.contains(page.engine.written))
        << page.engine.written.right() << ' ' << page.engine.written.bottom();
    for (const QRectF& picture : page.engine.pictures) {
        EXPECT_TRUE(a4.contains(picture));
    }
    EXPECT_FALSE(page.engine.pictures[0].intersects(page.engine.pictures[1]));
}

TEST(EvidenceSheetTest, ThePdfIsOnePageOfA4WithBothPictures) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("point-104.pdf"));
    ASSERT_TRUE(writeEvidencePdf(test::aimedSheet(), path).has_value());
    const QString pdf = QString::fromLatin1(contents(path));
    EXPECT_TRUE(pdf.startsWith(QStringLiteral("%PDF-1.")));
    EXPECT_EQ(pdf.count(QRegularExpression(QStringLiteral("/Type\\s*/Page\\b"))), 1);
    EXPECT_EQ(pdf.count(QRegularExpression(QStringLiteral("/Subtype\\s*/Image\\b"))), 2);
    EXPECT_TRUE(pdf.contains(QRegularExpression(QStringLiteral("/MediaBox\\s*\\[0 0 59[45]"))));
    EXPECT_TRUE(pdf.contains(QStringLiteral("/Subtype /CIDFontType2")))
        << "text is text, not a picture of it";
}

TEST(EvidenceSheetTest, AFolderThatDoesNotTakeThePdfIsSaid) {
    const auto written = writeEvidencePdf(test::aimedSheet(), QStringLiteral("/nowhere/point.pdf"));
    ASSERT_FALSE(written.has_value());
    EXPECT_EQ(written.error().kind, core::ErrorKind::kFile);
    EXPECT_FALSE(written.error().remedy.isEmpty());
}

TEST(ThumbnailPaintingTest, ReticleAndSpotAreDrawnWhereTheyAreInThePicture) {
    QImage canvas(640, 400, QImage::Format_RGB32);
    canvas.fill(Qt::white);
    QPainter painter(&canvas);
    auto thumbnail = test::aimedSheet().after;
    thumbnail.spot_px.reset();
    const QRectF place = paintThumbnail(painter, QRectF(0, 0, 640, 400), thumbnail, 2);
    painter.end();
    EXPECT_EQ(place, QRectF(0, 20, 640, 360));  // four times as large, in the middle of its room
    const QPoint centre((80.5 * 4), 20 + 45.5 * 4);
    EXPECT_EQ(canvas.pixelColor(centre + QPoint(20, 0)), QColor(Qt::white)) << "an arm of the cross";
    EXPECT_EQ(canvas.pixelColor(centre), QColor(90, 110, 90)) << "what is aimed at stays visible";
}

}  // namespace
}  // namespace pmts::gui
