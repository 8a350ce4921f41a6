#include "driver_bench.hpp"

#include "pmts/protocol/label_backup.hpp"
#include "pmts/protocol/memory_file.hpp"
#include "pmts/protocol/memory_records.hpp"

#include <QFile>
#include <algorithm>
#include <sstream>

namespace pmts::end_to_end {
namespace {

using instrument::MemoryFileId;
using protocol::Directory;
using testing::Contains;
using testing::Not;

std::vector<std::string> linesOfFile(const char* name) {
    QFile file(QStringLiteral(PMTS_TEST_DATA "/") + QLatin1String(name));
    std::vector<std::string> lines;
    if (file.open(QIODevice::ReadOnly)) {
        for (const auto& line : protocol::parseMemoryFile(file.readAll().toStdString()).lines) {
            lines.push_back(std::to_string(line.label) + '=' + line.data);
        }
    }
    return lines;
}

/// What a program sent, command by command; data of a file are no commands.
class InstrumentMemoryTest : public testing::Test {
protected:
    void start(simulator::StationSettings settings = {}) {
        bench = std::make_unique<DriverBench>(std::move(settings));
        bench->wire.second->on_received = [this](std::string_view bytes) {
            sent += bytes;
            bench->station.receive(bytes);
        };
        bench->connect();
    }
    auto upload(const MemoryFileId& id, const std::vector<std::string>& lines) {
        return bench->run(bench->driver.upload(id, lines, {}, {}));
    }
    auto download(const MemoryFileId& id) { return bench->run(bench->driver.download(id, {}, {})); }

    std::string sent;
    std::unique_ptr<DriverBench> bench;
    const MemoryFileId job{Directory::kJob, QStringLiteral("DEMO1")};
    const MemoryFileId area{Directory::kArea, QStringLiteral("DEMO1")};
};

TEST_F(InstrumentMemoryTest, AJobAndAnAreaGoInAreListedAndComeOutTheSame) {
    start();
    for (const auto& [id, name] : {std::pair(job, "DEMO1.JOB"), std::pair(area, "DEMO1.ARE")}) {
        const auto lines = linesOfFile(name);
        ASSERT_FALSE(lines.empty());
        const auto uploaded = upload(id, lines);
        ASSERT_TRUE(uploaded.has_value()) << uploaded.error().happened.toStdString();
        EXPECT_EQ(uploaded->kept, lines);
        EXPECT_EQ(download(id)->lines, lines);
    }
    const auto listing = bench->run(bench->driver.listMemory({}));
    ASSERT_TRUE(listing.has_value());
    EXPECT_THAT(listing->files, Contains(job));
    EXPECT_THAT(listing->files, Contains(area));
    ASSERT_TRUE(listing->free_bytes.has_value());
    EXPECT_LT(*listing->free_bytes, 60000);
}

TEST_F(InstrumentMemoryTest, ASecondFileOfTheSameNameIsRefusedAndTheFirstStays) {
    start();
    ASSERT_TRUE(upload(job, {"5=1", "37=1.000"}).has_value());
    const auto again = upload(job, {"5=2"});
    ASSERT_FALSE(again.has_value());
    EXPECT_EQ(again.error().info_code, 33);
    EXPECT_THAT(download(job)->lines, testing::ElementsAre("5=1", "37=1.000"));
}

TEST_F(InstrumentMemoryTest, AFullMemoryIsInfo36AndNothingIsListed) {
    start(with(&StationSettings::memory_bytes, 10));
    const auto uploaded = upload(job, linesOfFile("DEMO1.JOB"));
    ASSERT_FALSE(uploaded.has_value());
    EXPECT_EQ(uploaded.error().info_code, 36);
    EXPECT_THAT(bench->run(bench->driver.listMemory({}))->files, Not(Contains(job)));
}

TEST_F(InstrumentMemoryTest, AMissingFileIsInfo32) {
    start();
    const auto file = download(job);
    ASSERT_FALSE(file.has_value());
    EXPECT_EQ(file.error().info_code, 32);
}

TEST_F(InstrumentMemoryTest, ALineThatLosesBytesNowAndThenHandsOutNothingWrong) {
    start();
    const auto lines = linesOfFile("DEMO1.JOB");
    ASSERT_TRUE(upload(job, lines).has_value());
    int whole = 0;
    for (unsigned seed = 1; seed <= 10; ++seed) {
        bench->fault(("drop=0.001,seed=" + std::to_string(seed)).c_str());
        const auto file = download(job);
        bench->fault("drop=off");
        if (file) {
            EXPECT_EQ(file->lines, lines) << "seed " << seed;
            ++whole;
        }
    }
    EXPECT_GE(whole, 8);
}

TEST_F(InstrumentMemoryTest, AQuestionAfterACancelledFileIsNotAnsweredByTheFile) {
    start();
    ASSERT_TRUE(upload(job, {"5=1", "7=33.3333", "8=66.6666"}).has_value());
    std::stop_source stop;
    const auto timer = bench->clock.callAfter(60ms, [&stop] { stop.request_stop(); });
    const auto file = bench->run(bench->driver.download(job, {}, stop.get_token()));
    EXPECT_FALSE(file.has_value());
    const auto pointing = bench->run(bench->driver.readPointing({}));
    ASSERT_TRUE(pointing.has_value());
    EXPECT_LT(core::abs(pointing->va - Angle::fromGon(100)), Angle::fromGon(1)) << "66.6666 of the file was not taken for VA";
}

TEST_F(InstrumentMemoryTest, ABackupHoldsEveryLabelAndNamesWhatWasRefused) {
    start();
    const auto backup = bench->run(bench->driver.backUpLabels({}, {}));
    ASSERT_TRUE(backup.has_value()) << backup.error().happened.toStdString();
    EXPECT_EQ(backup->readings.size(), protocol::backupLabels().size());
    EXPECT_EQ(backup->serial_number, "620123");
    EXPECT_EQ(backup->temperature, "20.0");
    EXPECT_EQ(backup->readings.at(23).data, "1111");
    EXPECT_EQ(backup->readings.at(57).refused, (protocol::Status{20, {}}));
    EXPECT_TRUE(protocol::parseBackup(protocol::backupText(*backup)).has_value());
}

TEST_F(InstrumentMemoryTest, AnOffsetThatSomebodySetShowsBetweenTwoBackups) {
    start();
    const auto before = bench->run(bench->driver.backUpLabels({}, {}));
    ASSERT_TRUE(bench->run(bench->driver.set(20, QStringLiteral("0.035"), {})).has_value());
    const auto after = bench->run(bench->driver.backUpLabels({}, {}));
    auto changes = protocol::changesBetween(before.value(), after.value());
    std::erase_if(changes, [](const protocol::LabelChange& change) { return !change.is_setting; });
    EXPECT_THAT(changes, testing::ElementsAre(protocol::LabelChange{20, "0.000", "0.035", true}));
}

TEST_F(InstrumentMemoryTest, NothingThatErasesEverLeaves) {
    start();
    ASSERT_TRUE(upload(job, linesOfFile("DEMO1.JOB")).has_value());
    (void)upload(job, {"5=1"});
    (void)download(job);
    (void)bench->run(bench->driver.listMemory({}));
    (void)bench->run(bench->driver.backUpLabels({}, {}));
    std::istringstream lines(sent);
    for (std::string line; std::getline(lines, line, '\r');) {
        line.erase(0, std::min(line.find_first_not_of("\n>"), line.size()));
        EXPECT_TRUE(protocol::checkDenyList(line).has_value()) << line;
        EXPECT_FALSE(line.starts_with('K')) << line;
        EXPECT_FALSE(line.starts_with("WG")) << line << ": a memory routine writes no label";
    }
}

TEST_F(InstrumentMemoryTest, TheCompensatorIsCalibratedInBothFacesAndTheLineServesAgain) {
    start();
    const auto began = bench->clock.now();
    const auto run = bench->run(bench->driver.calibrateCompensator([] { return core::Completion<bool>(); }, {}));
    ASSERT_TRUE(run.has_value()) << run.error().happened.toStdString();
    EXPECT_TRUE(run->showed_compensator);
    EXPECT_TRUE(run->ended_by_block);
    EXPECT_GT(bench->clock.now() - began, 14s) << "seven seconds a face and half a turn there and back";
    EXPECT_TRUE(bench->run(bench->driver.readPointing({})).has_value());
}

}  // namespace
}  // namespace pmts::end_to_end
