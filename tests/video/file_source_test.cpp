#include "support.hpp"

#include <gmock/gmock.h>
#include <opencv2/videoio.hpp>

namespace pmts::video {
namespace {

class FileSourceTest : public testing::Test {
protected:
    /// Four frames, each brighter than the one before, 20 a second.
    QString shortFilm() const {
        const QString path = folder_.filePath(QStringLiteral("film.avi"));
        cv::VideoWriter writer(path.toStdString(), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 20.0,
                               {64, 48});
        for (int i = 1; i <= 4; ++i) {
            writer.write(cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(50 * i)));
        }
        return path;
    }

    QTemporaryDir folder_;
    core::VideoGate gate_;
};

TEST_F(FileSourceTest, PlaysAtItsOwnPaceOverAndOver) {
    const auto source = makeVideoSource({SourceKind::kFile, shortFilm(), QStringLiteral("film")}, gate_);
    const Watcher seen(*source);
    source->start({});
    ASSERT_TRUE(until([&] { return seen.newest != nullptr; }));
    const camera::FramePtr first = seen.newest;

    ASSERT_TRUE(
        until([&] { return seen.newest->sequence >= first->sequence + 9; }));  // the third time through

    EXPECT_EQ(seen.newest->image.size(), cv::Size(64, 48));
    EXPECT_EQ(seen.newest->captured_at - first->captured_at,
              (seen.newest->sequence - first->sequence) * std::chrono::milliseconds(50));
    EXPECT_TRUE(seen.problems.empty());
}

TEST_F(FileSourceTest, MissingOrForeignFileIsASentence) {
    const QString path = folder_.filePath(QStringLiteral("notes.avi"));
    QFile notes(path);
    ASSERT_TRUE(notes.open(QIODevice::WriteOnly));
    notes.write("no film at all");
    notes.close();
    for (const QString& location : {path, folder_.filePath(QStringLiteral("gone.avi"))}) {
        const auto source = makeVideoSource({SourceKind::kFile, location, QStringLiteral("film")}, gate_);
        const Watcher seen(*source);
        source->start({});
        ASSERT_TRUE(until([&] { return seen.hasProblemWith("cannot be played"); }));
        EXPECT_EQ(source->state(), SourceState::kLost);
    }
}

}  // namespace
}  // namespace pmts::video
