#include "pmts/job/export.hpp"

#include "job_support.hpp"
#include "other_process.hpp"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace pmts::job {
namespace {

using core::ErrorKind;
using test::FailedWith;

/// Two good points, one struck out, one absurd.
std::vector<survey::Point> fourPoints() {
    std::vector<survey::Point> points{shotPoint(1), shotPoint(2), shotPoint(3), shotPoint(4)};
    points[1].code = QStringLiteral("ROOF/EAST");
    points[2].struck_out = true;
    points[3].observation.slope_distance_m.reset();
    points[3].observation.absurd_reason = QStringLiteral("no echo");
    return points;
}

class ExportTest : public JobTest {
protected:
    QString exported(const char* name) {
        const QString target = folder.filePath(QLatin1String(name));
        const auto outcome = exportPoints(fourPoints(), target, *exportFormatFromPath(target));
        EXPECT_TRUE(outcome.has_value()) << outcome.error().sentence().toStdString();
        return target;
    }
};

TEST_F(ExportTest, TheEndingNamesTheFormat) {
    EXPECT_EQ(*exportFormatFromPath(QStringLiteral("/a/b.CSV")), ExportFormat::kCsv);
    EXPECT_EQ(*exportFormatFromPath(QStringLiteral("b.geojson")), ExportFormat::kGeoJson);
    EXPECT_EQ(*exportFormatFromPath(QStringLiteral("b.json")), ExportFormat::kGeoJson);
    EXPECT_EQ(*exportFormatFromPath(QStringLiteral("b.dxf")), ExportFormat::kDxf);
    EXPECT_THAT(exportFormatFromPath(QStringLiteral("b.xlsx")), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(exportFormatFromPath(QStringLiteral("csv")), FailedWith(ErrorKind::kBadInput));
}

TEST_F(ExportTest, CsvNamesItsUnitsAndQuotesText) {
    const QList<QByteArray> lines = contents(exported("points.csv")).trimmed().split('\n');
    ASSERT_EQ(lines.size(), 4);  // header, two points, the absurd one; not the struck-out one
    EXPECT_EQ(
        lines[0],
        QByteArray(
            "e_m,n_m,h_m,id,code,sigma_e_m,sigma_n_m,sigma_h_m,station,ha_gon,va_gon,sd_m,target_height_m,"
            "mode,time_utc,absurd_reason,source,remark"));
    EXPECT_TRUE(lines[1].startsWith("2001.5000,1009.5640,50.4890,A001,WALL,0.0030,0.0020,0.0010,"))
        << lines[1].toStdString();
    EXPECT_TRUE(lines[1].contains("177.561150,96.168380,26.1230,1.6000,STD,2015-07-09T10:20:30.456Z,"))
        << lines[1].toStdString();
    EXPECT_TRUE(lines[1].endsWith("\"höchster Stein, \"\"links\"\"\"")) << lines[1].toStdString();
    EXPECT_TRUE(lines[3].startsWith(",,,A004,WALL,,,,")) << lines[3].toStdString();
    EXPECT_TRUE(lines[3].contains(",no echo,"));
}

TEST_F(ExportTest, GeoJsonKeepsEngineeringCoordinatesWithHeight) {
    const auto document = QJsonDocument::fromJson(contents(exported("points.geojson")));
    const QJsonArray features = document[QStringLiteral("features")].toArray();
    ASSERT_EQ(features.size(), 3);
    const QJsonArray at = features[0][QStringLiteral("geometry")][QStringLiteral("coordinates")].toArray();
    EXPECT_EQ(at[0].toDouble(), 2001.5);
    EXPECT_EQ(at[1].toDouble(), 1009.564);
    EXPECT_EQ(at[2].toDouble(), 50.489);
    EXPECT_EQ(features[0][QStringLiteral("properties")][QStringLiteral("id")].toString(),
              QStringLiteral("A001"));
    EXPECT_EQ(features[0][QStringLiteral("properties")][QStringLiteral("remark")].toString(),
              shotPoint(1).remark);
    EXPECT_TRUE(features[2][QStringLiteral("geometry")].isNull());
    EXPECT_FALSE(document.object().contains(QStringLiteral("crs")));
}

TEST_F(ExportTest, DxfHasAPointAndItsNumberOnALayerOfItsCode) {
    const OtherProgram cad(exported("points.dxf"));
    ASSERT_TRUE(cad.isOpen());
    std::vector<QString> found;
    for (const auto& entity : cad.layer("entities")) {
        const OGRPoint& at = *entity->GetGeometryRef()->toPoint();
        found.push_back(QStringLiteral("%1 %2 %3 %4")
                            .arg(QString::fromUtf8(entity->GetFieldAsString("Layer")))
                            .arg(at.getX())
                            .arg(at.getZ())
                            .arg(QString::fromUtf8(entity->GetFieldAsString("Text"))));
    }
    EXPECT_THAT(found, testing::ElementsAre(QStringLiteral("WALL 2001.5 50.489 "),
                                            QStringLiteral("WALL 2001.5 50.489 A001"),
                                            QStringLiteral("ROOF_EAST 2002.5 50.489 "),
                                            QStringLiteral("ROOF_EAST 2002.5 50.489 A002")));
}

TEST_F(ExportTest, OddNumbersOfPointsReachTheDrawing) {
    std::vector<survey::Point> points{shotPoint(1)};
    points[0].id = QStringLiteral("5\" Rohr\\ß");
    points[0].code.clear();
    const QString target = folder.filePath(QStringLiteral("odd.dxf"));
    ASSERT_TRUE(exportPoints(points, target, ExportFormat::kDxf).has_value());
    const OtherProgram cad(target);
    OGRLayer& entities = cad.layer("entities");
    const OGRFeatureUniquePtr point(entities.GetNextFeature());
    const OGRFeatureUniquePtr text(entities.GetNextFeature());
    EXPECT_STREQ(text->GetFieldAsString("Layer"), "POINTS");
    EXPECT_EQ(QString::fromUtf8(text->GetFieldAsString("Text")), points[0].id);
}

TEST_F(ExportTest, NoPointsGiveAFileThatCanBeRead) {
    for (const char* name : {"none.csv", "none.geojson", "none.dxf"}) {
        const QString target = folder.filePath(QLatin1String(name));
        ASSERT_TRUE(exportPoints({}, target, *exportFormatFromPath(target)).has_value()) << name;
        EXPECT_TRUE(OtherProgram(target).isOpen()) << name;
    }
}

TEST_F(ExportTest, AFullDiskLeavesTheFormerFile) {
    const QString target = exported("points.csv");
    const QByteArray former = contents(target);
    OtherProcess exporter([target](const OtherProcess::Say& say) {
        limitFileSize(10000);
        const auto outcome =
            exportPoints(std::vector<survey::Point>(1000, shotPoint(1)), target, ExportFormat::kCsv);
        say(!outcome && outcome.error().kind == ErrorKind::kFile && !outcome.error().remedy.isEmpty() ? 1
                                                                                                      : 0);
    });
    EXPECT_EQ(exporter.next(), 1);
    exporter.kill();
    EXPECT_EQ(contents(target), former);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
}

TEST_F(ExportTest, AFolderThatDoesNotExistIsRefusedWithASentence) {
    const auto outcome =
        exportPoints({}, folder.filePath(QStringLiteral("nowhere/points.csv")), ExportFormat::kCsv);
    ASSERT_THAT(outcome, FailedWith(ErrorKind::kFile));
    EXPECT_FALSE(outcome.error().remedy.isEmpty());
}

}  // namespace
}  // namespace pmts::job
