#pragma once

#include "pmts/job/job.hpp"
#include "support/matchers.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <memory>

namespace pmts::job {

/// Point `number` of a row of shots to the east, each 1 m farther; everything a shot can carry is set.
inline survey::Point shotPoint(int number) {
    survey::Point point;
    point.id = QStringLiteral("A%1").arg(number, 3, 10, QChar(u'0'));
    point.code = QStringLiteral("WALL");
    point.remark = QStringLiteral("höchster Stein, \"links\"");
    point.station_name = QStringLiteral("100");
    point.observation.pointing = {.ha = core::Angle::fromGon(177.56115),
                                  .va = core::Angle::fromGon(96.16838)};
    point.observation.slope_distance_m = 25.123 + number;
    point.observation.target_height_m = 1.6;
    point.observation.edm_mode = QStringLiteral("STD");
    point.observation.time_taken_s = 4.8;
    point.observation.utc = QDateTime(QDate(2015, 7, 9), QTime(10, 20, 30, 456), Qt::UTC);
    point.observation.raw_reply = QStringLiteral("0\r\n7=177.5612\r\n8=96.1684\r\n9=25.123\r\n>");
    point.coordinates = {.e_m = 2000.5 + number,
                         .n_m = 1009.564,
                         .h_m = 50.489,
                         .sigma_e_m = 0.003,
                         .sigma_n_m = 0.002,
                         .sigma_h_m = 0.001};
    return point;
}

/// All bytes of a file, none when it cannot be read.
inline QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A re-centred aiming; everything it can carry is set.
inline Evidence aimedWell() {
    Evidence evidence;
    evidence.method = QStringLiteral("rigorous");
    evidence.recentred = true;
    evidence.pointing = {.ha = core::Angle::fromGon(177.56117), .va = core::Angle::fromGon(96.16841)};
    evidence.residual_x_px = 0.06;
    evidence.residual_y_px = -0.04;
    evidence.residual = core::Angle::fromArcsec(7.5);
    evidence.tolerance_px = 0.1;
    evidence.tolerance = core::Angle::fromArcsec(20);
    evidence.score = 0.985;
    evidence.runner_up = 0.61;
    evidence.sigma_px = 0.02;
    evidence.moves = 2;
    evidence.slope_distance_m = 25.1;
    evidence.slope_distance_source = QStringLiteral("last shot");
    evidence.utc = QDateTime(QDate(2015, 7, 9), QTime(10, 20, 28, 123), Qt::UTC);
    evidence.before = {.encoded_image = "before, as PNG", .spot_px = QPointF(40.5, 20.25), .reticle_px = {}};
    evidence.after = {
        .encoded_image = "after, as PNG", .spot_px = QPointF(80, 45), .reticle_px = QPointF(80.06, 44.96)};
    return evidence;
}

class JobTest : public testing::Test {
protected:
    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("facade-12.gpkg"));

    std::unique_ptr<Job> created() {
        auto job = Job::create(path);
        EXPECT_TRUE(job.has_value()) << job.error().sentence().toStdString()
                                     << job.error().detail.toStdString();
        return job ? std::move(*job) : nullptr;
    }
    std::unique_ptr<Job> reopened() {
        auto job = Job::open(path);
        EXPECT_TRUE(job.has_value()) << job.error().sentence().toStdString()
                                     << job.error().detail.toStdString();
        return job ? std::move(*job) : nullptr;
    }
    void createWith(int points) {
        const auto job = created();
        for (int i = 0; i < points; ++i) {
            ASSERT_TRUE(job->record(shotPoint(i)).has_value());
        }
    }
};

/// Another program looking at a file through GDAL with its default settings.
class OtherProgram {
public:
    explicit OtherProgram(const QString& path, unsigned access = GDAL_OF_READONLY) {
        GDALAllRegister();
        CPLPushErrorHandler(CPLQuietErrorHandler);
        dataset_.reset(static_cast<GDALDataset*>(
            GDALOpenEx(path.toUtf8().constData(), GDAL_OF_VECTOR | access, nullptr, nullptr, nullptr)));
    }
    ~OtherProgram() {
        dataset_.reset();
        CPLPopErrorHandler();
    }
    OtherProgram(const OtherProgram&) = delete;
    OtherProgram& operator=(const OtherProgram&) = delete;

    [[nodiscard]] bool isOpen() const { return dataset_ != nullptr; }
    [[nodiscard]] OGRLayer& layer(const char* name) const { return *dataset_->GetLayerByName(name); }
    struct Column {
        const char* name;
        OGRFieldType type;
    };
    void addTable(const char* name, std::initializer_list<Column> columns) {
        OGRLayer* const layer = dataset_->CreateLayer(name, nullptr, wkbNone, nullptr);
        for (const Column& column : columns) {
            OGRFieldDefn field(column.name, column.type);
            layer->CreateField(&field);
        }
    }
    /// First value of a query; empty when there is none or SQLite refused it.
    [[nodiscard]] QString value(const char* sql) const {
        OGRLayer* const rows = dataset_->ExecuteSQL(sql, nullptr, nullptr);
        if (rows == nullptr) {
            return {};
        }
        const OGRFeatureUniquePtr row(rows->GetNextFeature());
        const QString text = row ? QString::fromUtf8(row->GetFieldAsString(0)) : QString();
        dataset_->ReleaseResultSet(rows);
        return text;
    }
    /// What SQLite answered to a statement; empty when it took it.
    [[nodiscard]] QString refusal(const char* sql) const {
        CPLErrorReset();
        OGRLayer* const rows = dataset_->ExecuteSQL(sql, nullptr, nullptr);
        if (rows != nullptr) {
            dataset_->ReleaseResultSet(rows);
        }
        return CPLGetLastErrorType() == CE_None ? QString() : QString::fromUtf8(CPLGetLastErrorMsg());
    }

private:
    struct Close {
        void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
    };
    std::unique_ptr<GDALDataset, Close> dataset_;
};

}  // namespace pmts::job
