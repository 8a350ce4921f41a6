#include "pmts/app/photo_export.hpp"

#include "app/field_fixture.hpp"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace pmts::app {
namespace {

class PhotoExportTest : public FieldTest {
protected:
    void takePhotos(int count) {
        openJob();
        QSignalSpy added(&job_desk, &JobDesk::photoAdded);
        for (int i = 0; i < count; ++i) {
            job_desk.addPhoto(photo(i), QImage(16, 9, QImage::Format_RGB888));
        }
        (void)until([&] { return added.count() == count; });
    }
    [[nodiscard]] static job::Photo photo(int number) {
        job::Photo photo;
        photo.name = QStringLiteral("photo %1").arg(number);
        return photo;
    }
    [[nodiscard]] qsizetype files() const { return QDir(target.path()).entryList({QStringLiteral("*.jpg")}).size(); }

    QTemporaryDir target;
    PhotoExport photos{job_desk, messages};
};

TEST_F(PhotoExportTest, TellsHowFarItIsAndEnds) {
    takePhotos(3);
    std::vector<std::size_t> told;
    QObject::connect(&photos, &PhotoExport::progressed, [&] { told.push_back(photos.done()); });
    photos.exportTo(target.path());
    EXPECT_TRUE(photos.isRunning());
    EXPECT_TRUE(until([&] { return !photos.isRunning(); }));
    EXPECT_EQ(told, (std::vector<std::size_t>{0, 0, 1, 2, 3}));
    EXPECT_EQ(files(), 3);
}

TEST_F(PhotoExportTest, CancelledBetweenTwoPhotosKeepsWhatIsWritten) {
    takePhotos(3);
    QObject::connect(&photos, &PhotoExport::progressed, [&] {
        if (photos.done() == 1) {
            photos.cancel();
        }
    });
    photos.exportTo(target.path());
    EXPECT_TRUE(until([&] { return !photos.isRunning(); }));
    QSignalSpy listed(&job_desk, &JobDesk::photosListed);
    job_desk.listPhotos();
    (void)until([&] { return !listed.empty(); });
    EXPECT_EQ(photos.done(), 1U);
    EXPECT_LT(files(), 3);
}

TEST_F(PhotoExportTest, ARecordGoesInBetweenTwoPhotos) {
    takePhotos(3);
    std::optional<std::size_t> written_before;
    QObject::connect(&job_desk, &JobDesk::recorded, [&] { written_before = photos.done(); });
    photos.exportTo(target.path());
    survey::Point point;
    point.id = QStringLiteral("1");
    job_desk.record(point);
    EXPECT_TRUE(until([&] { return written_before.has_value(); }));
    EXPECT_LT(written_before.value_or(3), 3U);
}

}  // namespace
}  // namespace pmts::app
