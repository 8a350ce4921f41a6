#include "pmts/blackbox/recorder.hpp"

#include "box_support.hpp"
#include "job/other_process.hpp"
#include "pmts/core/virtual_clock.hpp"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <future>
#include <numeric>

namespace pmts::blackbox {
namespace {

/// A picture whose making holds the recording thread until it is released.
class HeldPicture {
public:
    explicit HeldPicture(Recorder& recorder) {
        recorder.addMade(Kind::kFrame, {}, [this] {
            begun_.set_value();
            released_.get_future().wait();
            return bodyOf({});
        });
        begun_.get_future().wait();
    }
    void release() { released_.set_value(); }

private:
    std::promise<void> begun_, released_;
};

class BlackBoxRecorderTest : public testing::Test {
protected:
    [[nodiscard]] RecorderSettings settings() const {
        return {.folder = folder.filePath(QStringLiteral("box")), .session = {{QStringLiteral("version"), QStringLiteral("0.1")}}};
    }
    static void record(Recorder& recorder, int number, int size = 40) {
        const Record wanted = numbered(number, size);
        recorder.add(wanted.kind, wanted.at, wanted.body);
    }
    [[nodiscard]] QStringList files() const { return recordingsIn(settings().folder); }
    [[nodiscard]] std::vector<int> numbersInAll() const {
        std::vector<int> numbers;
        for (const QString& path : files()) {
            const auto recording = Recording::open(path);
            if (recording) {
                const auto more = numbersIn(**recording);
                numbers.insert(numbers.end(), more.begin(), more.end());
            }
        }
        return numbers;
    }

    [[nodiscard]] static std::vector<Kind> kindsIn(const QString& path) {
        std::vector<Kind> kinds;
        const auto recording = Recording::open(path);
        for (const Entry& entry : (*recording)->entries()) {
            kinds.push_back(entry.kind);
        }
        return kinds;
    }

    QTemporaryDir folder;
    core::SystemClock clock;
    std::promise<core::Error> ended;
    std::function<void(const core::Error&)> on_ended = [this](const core::Error& error) { ended.set_value(error); };
};

std::vector<int> upTo(int last) {
    std::vector<int> numbers(static_cast<std::size_t>(last));
    std::iota(numbers.begin(), numbers.end(), 1);
    return numbers;
}

TEST_F(BlackBoxRecorderTest, EverythingIsThereInOrderWithTheSessionInFrontAndTheEndBehind) {
    {
        Recorder recorder(settings(), clock, on_ended);
        for (int i = 1; i <= 500; ++i) {
            record(recorder, i);
        }
    }
    ASSERT_EQ(files().size(), 1);
    const auto recording = Recording::open(files()[0]);
    ASSERT_TRUE(recording.has_value());
    EXPECT_EQ((*recording)->entries().front().kind, Kind::kSession);
    EXPECT_EQ((*recording)->body((*recording)->entries().front()).value(QStringLiteral("version")).toString(), QStringLiteral("0.1"));
    EXPECT_EQ((*recording)->entries().back().kind, Kind::kEnd);
    EXPECT_EQ(numbersIn(**recording), upTo(500));
}

TEST_F(BlackBoxRecorderTest, AKilledProgramLosesAtMostTheRecordThatWasBeingWritten) {
    job::OtherProcess program([this](const job::OtherProcess::Say& say) {
        Recorder recorder(settings(), clock, {});
        for (int i = 1;; ++i) {
            record(recorder, i, 5000);
            recorder.waitUntilWritten();
            say(i);
        }
    });
    int told = 0;
    while (told < 200) {
        told = program.next().value_or(1000000);
    }
    program.kill();

    ASSERT_EQ(told, 200);
    const auto numbers = numbersInAll();
    ASSERT_GE(numbers.size(), 200U);
    EXPECT_EQ(numbers, upTo(static_cast<int>(numbers.size())));
}

TEST_F(BlackBoxRecorderTest, KilledInTheMiddleOfAWriteTheRecordsBeforeItAreWhole) {
    constexpr rlim_t kDiesAt = 50000;
    job::OtherProcess program([this](const job::OtherProcess::Say&) {
        job::dieAtFileSize(kDiesAt);
        Recorder recorder(settings(), clock, {});
        for (int i = 1;; ++i) {
            record(recorder, i, 4000);
            recorder.waitUntilWritten();
        }
    });
    EXPECT_EQ(program.endedBySignal(), SIGXFSZ);
    EXPECT_EQ(numbersInAll(), upTo(12));
}

TEST_F(BlackBoxRecorderTest, AFullDiskEndsTheRecordingWithASentenceAndAWholeFile) {
    job::OtherProcess program([this](const job::OtherProcess::Say& say) {
        job::limitFileSize(50000);
        std::promise<core::ErrorKind> kind;
        Recorder recorder(settings(), clock, [&kind](const core::Error& error) {
            kind.set_value(error.happened.isEmpty() || error.remedy.isEmpty() ? core::ErrorKind::kProtocol : error.kind);
        });
        for (int i = 1; i <= 100; ++i) {
            record(recorder, i, 4000);  // goes on when the disk is full: nothing throws, nothing waits
        }
        say(static_cast<int>(kind.get_future().get()));
        say(recorder.isRecording() ? 1 : 0);
        recorder.waitUntilWritten();
    });
    EXPECT_EQ(program.next(), static_cast<int>(core::ErrorKind::kFile));
    EXPECT_EQ(program.next(), 0);
    EXPECT_EQ(program.endedBySignal(), 0);
    const auto recording = Recording::open(files()[0]);
    ASSERT_TRUE(recording.has_value());
    EXPECT_TRUE((*recording)->damages().empty()) << "what did not fit is cut off again";
    EXPECT_EQ(numbersIn(**recording), upTo(12));
}

TEST_F(BlackBoxRecorderTest, AFolderThatCannotBeMadeEndsTheRecordingToo) {
    auto nowhere = settings();
    nowhere.folder = QStringLiteral("/proc/none/box");
    Recorder recorder(nowhere, clock, on_ended);
    EXPECT_EQ(ended.get_future().get().kind, core::ErrorKind::kFile);
    record(recorder, 1);
    recorder.waitUntilWritten();
    EXPECT_FALSE(recorder.isRecording());
}

TEST_F(BlackBoxRecorderTest, TheOldestFilesGoAndWhatHoldsOnIsSaidAgainInEachFile) {
    auto small = settings();
    small.kept_bytes = 100000;
    small.file_bytes = 20000;
    {
        Recorder recorder(small, clock, on_ended);
        recorder.addStanding(Kind::kConnection, {}, bodyOf({{QStringLiteral("state"), 2}}));
        for (int i = 1; i <= 200; ++i) {
            record(recorder, i, 2000);
            recorder.waitUntilWritten();
        }
    }
    qint64 total = 0;
    for (const QString& path : files()) {
        total += QFileInfo(path).size();
        const auto recording = Recording::open(path);
        ASSERT_TRUE(recording.has_value());
        ASSERT_EQ((*recording)->entries()[0].kind, Kind::kSession);
        ASSERT_EQ((*recording)->entries()[1].kind, Kind::kConnection) << path.toStdString();
    }
    EXPECT_LE(total, 103000);
    const auto numbers = numbersInAll();
    EXPECT_EQ(numbers.back(), 200);
    EXPECT_GT(numbers.front(), 100);
}

TEST_F(BlackBoxRecorderTest, TwoProgramsOnOneFolderWriteFilesOfTheirOwn) {
    Recorder one(settings(), clock, on_ended);
    Recorder other(settings(), clock, on_ended);
    record(one, 1);
    record(other, 2);
    one.waitUntilWritten();
    other.waitUntilWritten();
    EXPECT_EQ(files().size(), 2);
    EXPECT_NE(one.path(), other.path());
}

TEST_F(BlackBoxRecorderTest, PicturesAreMadeOnTheRecordingThreadAndNeverPileUp) {
    Recorder recorder(settings(), clock, on_ended);
    HeldPicture held(recorder);
    for (int i = 0; i < 10; ++i) {
        recorder.addMade(Kind::kFrame, {}, [] { return bodyOf({}); });
    }
    held.release();
    recorder.waitUntilWritten();
    EXPECT_EQ(recorder.lost(), 0U) << "left out on purpose: no disk was too slow";
    recorder.addMade(Kind::kFrame, {}, [] { return bodyOf({}); });
    recorder.waitUntilWritten();
    EXPECT_EQ(recorder.lost(), 0U);
    EXPECT_EQ(kindsIn(recorder.path()), (std::vector{Kind::kSession, Kind::kFrame, Kind::kFrame}));
}

TEST_F(BlackBoxRecorderTest, WithoutRoomInTheQueueRecordsAreLostAndCountedButWhatHoldsOnIsKept) {
    Recorder recorder(settings(), clock, on_ended);
    HeldPicture held(recorder);
    for (int i = 1; i <= static_cast<int>(Recorder::kLongestQueue) + 5; ++i) {
        record(recorder, i);
    }
    recorder.addStanding(Kind::kControl, {}, bodyOf({{QStringLiteral("owner"), 2}}));
    held.release();
    recorder.waitUntilWritten();

    EXPECT_EQ(recorder.lost(), 5U);
    const auto kinds = kindsIn(recorder.path());
    EXPECT_EQ(kinds.back(), Kind::kControl);
    EXPECT_EQ(std::count(kinds.begin(), kinds.end(), Kind::kLost), 1);
}

TEST_F(BlackBoxRecorderTest, AClockThatIsSetBackOrForwardNeverCostsTheNewestFiles) {
    auto small = settings();
    small.kept_bytes = 60000;
    small.file_bytes = 15000;
    core::VirtualClock jumping;
    int number = 0;
    for (const std::chrono::hours jump : {std::chrono::hours(0), std::chrono::hours(-30 * 24), std::chrono::hours(60 * 24),
                                          std::chrono::hours(-30 * 24)}) {
        jumping.setTimeOfDayBy(jump);
        Recorder recorder(small, jumping, on_ended);
        for (int i = 0; i < 10; ++i) {
            record(recorder, ++number, 2000);
            recorder.waitUntilWritten();
        }
    }
    const auto kept = numbersInAll();  // in the order of the names
    ASSERT_GT(kept.size(), 15U);
    EXPECT_EQ(kept.back(), number);
    for (std::size_t i = 1; i < kept.size(); ++i) {
        EXPECT_EQ(kept[i], kept[i - 1] + 1) << "a newer file went before an older one";
    }
}

TEST(RecordingNameTest, ItIsTheTimeOfDayAndGoesOnBehindTheNewest) {
    const QDateTime utc(QDate(2026, 6, 1), QTime(6, 0), Qt::UTC);
    const auto next = [&](const QStringList& present) { return nextRecordingName(present, utc); };
    EXPECT_EQ(next({}), QStringLiteral("pmts-20260601T060000Z-0000.pmtsbox"));
    EXPECT_EQ(next({QStringLiteral("/a/pmts-20260531T060000Z-0004.pmtsbox"), QStringLiteral("/a/mine.pmtsbox")}),
              QStringLiteral("pmts-20260601T060000Z-0000.pmtsbox"));
    EXPECT_EQ(next({QStringLiteral("/a/pmts-20260601T060000Z-0000.pmtsbox")}), QStringLiteral("pmts-20260601T060000Z-0001.pmtsbox"));
    EXPECT_EQ(next({QStringLiteral("/a/pmts-20260701T060000Z-0003.pmtsbox")}), QStringLiteral("pmts-20260701T060000Z-0004.pmtsbox"));
    EXPECT_EQ(next({QStringLiteral("/a/pmts-20260701T060000Z-9999.pmtsbox")}), QStringLiteral("pmts-20260701T060001Z-0000.pmtsbox"));
}

}  // namespace
}  // namespace pmts::blackbox
