#include "pmts/app/field/photo_export.hpp"

#include "app/field_fixture.hpp"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace pmts::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class PhotoExportTest : public FieldTest {
protected:
    PhotoExportTest() {
        QObject::connect(&photos, &PhotoExport::progressed, &photos, [this] {
            if (on_progress) {
                on_progress();
            }
        });
    }
    void TearDown() override {
        on_progress = {};
        FieldTest::TearDown();
    }
    void takePhotos(int count) {
        openJob();
        QSignalSpy added(&job_desk, &JobDesk::photoAdded);
        for (int i = 0; i < count; ++i) {
            QImage grey(16, 9, QImage::Format_RGB888);
            grey.fill(Qt::gray);
            job_desk.addPhoto(photo(i), grey);
        }
        ASSERT_TRUE(until([&] { return added.count() == count; }));
    }
    [[nodiscard]] static job::Photo photo(int number) {
        job::Photo photo;
        photo.name = QStringLiteral("photo %1").arg(number);
        return photo;
    }
    /// Everything in the folder, half-written files included.
    [[nodiscard]] std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const QString& name : QDir(target.path()).entryList(QDir::Files | QDir::Hidden, QDir::Name)) {
            names.push_back(name.toStdString());
        }
        return names;
    }
    bool exported() {
        return until([this] { return !photos.isRunning(); });
    }
    [[nodiscard]] std::string newestToast() const {
        return toasts.empty() ? std::string() : toasts.back().front().value<Message>().happened.toStdString();
    }

    QTemporaryDir target;
    PhotoExport photos{job_desk, messages};
    QSignalSpy toasts{&messages, &MessageCentre::toastShown};
    std::function<void()> on_progress;  ///< may know what is of the test alone: forgotten when it ends
};

TEST_F(PhotoExportTest, TellsHowFarItIsAndEnds) {
    takePhotos(3);
    std::vector<std::size_t> told;
    on_progress = [&] { told.push_back(photos.done()); };
    photos.exportTo(target.path());
    EXPECT_TRUE(photos.isRunning());
    EXPECT_TRUE(exported());
    EXPECT_EQ(told, (std::vector<std::size_t>{0, 0, 1, 2, 3}));
    EXPECT_EQ(photos.count(), 3U);
    EXPECT_THAT(files(), ElementsAre("photo_0.jpg", "photo_0.json", "photo_1.jpg", "photo_1.json", "photo_2.jpg",
                                     "photo_2.json"));
    EXPECT_THAT(newestToast(), HasSubstr("exported to " + target.path().toStdString()));
}

TEST_F(PhotoExportTest, CancelledBetweenTwoPhotosKeepsWhatIsWrittenWhole) {
    takePhotos(4);
    on_progress = [&] {
        if (photos.done() == 1) {
            photos.cancel();  // the second photo is under way
        }
    };
    photos.exportTo(target.path());
    EXPECT_TRUE(exported());
    QSignalSpy listed(&job_desk, &JobDesk::photosListed);
    job_desk.listPhotos();  // behind everything that could still be written
    ASSERT_TRUE(until([&] { return !listed.empty(); }));
    EXPECT_EQ(photos.done(), 2U);
    EXPECT_THAT(files(), ElementsAre("photo_0.jpg", "photo_0.json", "photo_1.jpg", "photo_1.json"));
    EXPECT_THAT(newestToast(), HasSubstr("2 of 4 photos"));
}

TEST_F(PhotoExportTest, AfterACancelAllCanBeExported) {
    takePhotos(2);
    photos.exportTo(target.path());
    photos.cancel();
    ASSERT_TRUE(exported());
    EXPECT_EQ(photos.done(), 0U);
    photos.exportTo(target.path());
    ASSERT_TRUE(exported());
    EXPECT_EQ(files().size(), 4U);
}

TEST_F(PhotoExportTest, ARecordGoesInBetweenTwoPhotos) {
    takePhotos(3);
    std::optional<std::size_t> written_before;
    QObject::connect(&job_desk, &JobDesk::recorded, &photos, [&] { written_before = photos.done(); });
    photos.exportTo(target.path());
    survey::Point point;
    point.id = QStringLiteral("1");
    job_desk.record(point);
    EXPECT_TRUE(until([&] { return written_before.has_value(); }));
    EXPECT_LT(written_before.value_or(3), 3U);
    EXPECT_TRUE(exported());
}

TEST_F(PhotoExportTest, AFolderThatIsGoneIsSaidSoAndNothingIsReportedAsWritten) {
    takePhotos(3);
    on_progress = [&] {
        if (photos.done() == 1) {
            QDir(target.path()).removeRecursively();
        }
    };
    photos.exportTo(target.path());
    EXPECT_TRUE(exported());
    EXPECT_EQ(photos.done(), 1U);
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr(target.path().toStdString() + "” is not there. 1 of 3"));
    EXPECT_EQ(messages.bars().back().action, MessageAction::kNone);
    EXPECT_TRUE(toasts.empty());
}

TEST_F(PhotoExportTest, AnotherJobEndsItAndNoneOfItsPhotosIsTaken) {
    takePhotos(3);
    photos.exportTo(target.path());
    job_desk.create(folder.filePath(QStringLiteral("other.gpkg")));
    EXPECT_TRUE(exported());
    EXPECT_EQ(photos.done(), files().size() / 2);
    EXPECT_LT(photos.done(), 3U);
    EXPECT_TRUE(messages.bars().empty()) << newestBar(messages).toStdString();
}

}  // namespace
}  // namespace pmts::app
