// Photos written with their pose, read back by GDAL, which has a reader of its own.
#include "pmts/job/photo_file.hpp"

#include "gdal_session.hpp"
#include "other_process.hpp"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

namespace pmts::job {
namespace {

QByteArray encoded(const char* ending) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(ending, cv::Mat(48, 64, CV_8UC3, cv::Scalar(40, 90, 200)), bytes);
    return QByteArray(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()));
}

class PhotoFileTest : public testing::Test {
protected:
    PhotoFileTest() {
        GDALAllRegister();
        file.photo.name = QStringLiteral("Photo 7");
        file.photo.encoded_image = encoded(".jpg");
        file.photo.pointing = {core::Angle::fromGon(177.5612), core::Angle::fromGon(96.1684)};
        file.photo.station_name = QStringLiteral("100");
        file.photo.utc = QDateTime(QDate(2024, 5, 17), QTime(9, 8, 7, 250), Qt::UTC);
        file.camera = QStringLiteral("HD Pro Webcam");
        file.station = survey::Station{.name = QStringLiteral("100"), .e_m = 1000.25, .n_m = 2000.5, .h_m = 101.125};
        file.slope_distance_m = 23.418;
        file.range_source = QStringLiteral("measured");
        file.focal_length_px = 1400.25;
        file.rig = {{"version", 1}};
    }
    QString written() { return writePhotoFile(file, folder.path()).value_or(QString()); }

    /// What GDAL reads, in the domain of the metadata.
    static std::string read(const QString& path, const char* key) {
        const GDALDatasetUniquePtr data(GDALDataset::Open(path.toUtf8().constData()));
        const char* const value = data->GetMetadataItem(key);
        return value == nullptr ? std::string() : value;
    }
    static std::string xmp(const QString& path) {
        const GDALDatasetUniquePtr data(GDALDataset::Open(path.toUtf8().constData()));
        char** const domain = data->GetMetadata("xml:XMP");
        return domain == nullptr ? std::string() : *domain;
    }

    QTemporaryDir folder;
    PhotoFile file;
};

TEST_F(PhotoFileTest, AnotherReaderFindsCameraTimeAndDistanceInTheExif) {
    const QString path = written();
    ASSERT_EQ(path, folder.filePath(QStringLiteral("Photo_7.jpg")));
    EXPECT_EQ(read(path, "EXIF_Model"), "HD Pro Webcam");
    EXPECT_EQ(read(path, "EXIF_DateTimeOriginal"), "2024:05:17 09:08:07");
    EXPECT_THAT(read(path, "EXIF_SubjectDistance"), testing::HasSubstr("23.418"));
}

TEST_F(PhotoFileTest, AnotherReaderFindsThePoseInTheXmp) {
    const std::string text = xmp(written());
    EXPECT_THAT(text, testing::HasSubstr("HorizontalAngleGon=\"177.56120\""));
    EXPECT_THAT(text, testing::HasSubstr("VerticalAngleGon=\"96.16840\""));
    EXPECT_THAT(text, testing::HasSubstr("StationEastM=\"1000.2500\""));
    EXPECT_THAT(text, testing::HasSubstr("FocalLengthPx=\"1400.2500\""));
}

TEST_F(PhotoFileTest, PictureItselfIsNotTouched) {
    const QByteArray before = file.photo.encoded_image;
    const cv::Mat original = cv::imdecode(std::vector<char>(before.begin(), before.end()), cv::IMREAD_COLOR);
    const cv::Mat exported = cv::imread(written().toStdString());
    ASSERT_EQ(exported.size(), original.size());
    EXPECT_EQ(cv::norm(exported, original, cv::NORM_INF), 0.0);
}

TEST_F(PhotoFileTest, SidecarSaysTheSameInWordsOfItsOwn) {
    (void)written();
    QFile sidecar(folder.filePath(QStringLiteral("Photo_7.json")));
    ASSERT_TRUE(sidecar.open(QIODevice::ReadOnly));
    const QJsonObject json = QJsonDocument::fromJson(sidecar.readAll()).object();
    EXPECT_EQ(json.value("picture").toString(), QStringLiteral("Photo_7.jpg"));
    EXPECT_NEAR(json.value("ha_gon").toDouble(), 177.5612, 1e-9);
    EXPECT_NEAR(json.value("station")["n_m"].toDouble(), 2000.5, 1e-9);
    EXPECT_EQ(json.value("range_source").toString(), QStringLiteral("measured"));
    EXPECT_TRUE(json.contains("rig"));
}

TEST_F(PhotoFileTest, WhatIsNotKnownIsAbsent) {
    file.station.reset();
    file.slope_distance_m.reset();
    file.focal_length_px.reset();
    file.camera.clear();
    const QString path = written();
    EXPECT_EQ(read(path, "EXIF_Model"), "");
    EXPECT_THAT(xmp(path), testing::Not(testing::HasSubstr("StationEastM")));
    EXPECT_FALSE(photoSidecar(file, {}).contains(QStringLiteral("slope_distance_m")));
}

TEST_F(PhotoFileTest, PngCarriesThePoseToo) {
    file.photo.encoded_image = encoded(".png");
    const QString path = written();
    EXPECT_TRUE(path.endsWith(QStringLiteral(".png")));
    EXPECT_THAT(xmp(path), testing::HasSubstr("HorizontalAngleGon=\"177.56120\""));
}

TEST_F(PhotoFileTest, DamagedPhotoIsRefusedWithItsName) {
    file.photo.encoded_image = "no picture";
    const auto refused = writePhotoFile(file, folder.path());
    ASSERT_FALSE(refused.has_value());
    EXPECT_TRUE(refused.error().happened.contains(QStringLiteral("Photo 7")));
}

TEST_F(PhotoFileTest, FolderThatCannotBeWrittenIsASentence) {
    const auto refused = writePhotoFile(file, folder.filePath(QStringLiteral("missing")));
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().kind, core::ErrorKind::kFile);
}

TEST_F(PhotoFileTest, AFullDiskIsSaidSoAndLeavesNeitherPictureNorSidecar) {
    for (const rlim_t room_bytes : {rlim_t{100}, static_cast<rlim_t>(file.photo.encoded_image.size())}) {
        OtherProcess exporter([this, room_bytes](const OtherProcess::Say& say) {
            limitFileSize(room_bytes);
            const auto outcome = writePhotoFile(file, folder.path());
            const bool told = !outcome && outcome.error().kind == core::ErrorKind::kFile &&
                              outcome.error().happened.contains(QStringLiteral("no room left"));
            say(told && !outcome.error().remedy.isEmpty() ? 1 : 0);
        });
        EXPECT_EQ(exporter.next(), 1);
        EXPECT_EQ(exporter.endedBySignal(), 0);
        EXPECT_THAT(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), testing::IsEmpty());
    }
}

TEST_F(PhotoFileTest, AFolderThatIsGoneIsSaidSo) {
    const auto outcome = writePhotoFile(file, folder.filePath(QStringLiteral("gone")));
    ASSERT_FALSE(outcome.has_value());
    EXPECT_EQ(outcome.error().kind, core::ErrorKind::kFile);
    EXPECT_TRUE(outcome.error().happened.contains(QStringLiteral("gone” is not there"))) << outcome.error().happened.toStdString();
    EXPECT_FALSE(outcome.error().remedy.isEmpty());
}

}  // namespace
}  // namespace pmts::job
