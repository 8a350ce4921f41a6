#include "scripted_instrument.hpp"

#include "pmts/protocol/labels.hpp"

#include <algorithm>

namespace pmts::instrument {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

const std::string kFile = "5=1\r\n37=1000.000\r\n38=2000.000\r\n39=50.000\r\n>";

/// An instrument with one job that takes another; what a real one may do wrong is put into `next`.
class FileTransferTest : public DriverTest {
protected:
    FileTransferTest() {
        link.respond = [this](const std::string& command) { return answer(command); };
    }

    std::optional<std::string> answer(const std::string& command) {
        if (loading) {
            return hearFile(command);
        }
        const bool ready = command.starts_with("LM=") || command.starts_with("LI=");
        auto& queue = station.next[command.substr(0, command.find('\r'))];
        if (queue.empty() && (command.starts_with("OM=") || command.starts_with("OI="))) {
            return command.starts_with("OM=B") ? heard + '>' : kFile;
        }
        const auto reply = queue.empty() && ready ? std::optional<std::string>("*") : station.answer(command);
        loading = ready && reply && reply->find('*') != std::string::npos;
        return reply;
    }
    std::optional<std::string> hearFile(const std::string& bytes) {
        if (bytes.find('>') == std::string::npos) {
            heard += bytes;
            const auto early = std::exchange(early_answer, std::nullopt);
            loading = !early || early == ">";  // a bare block end is noise: the file stays open
            return early;
        }
        loading = false;
        return load_result;
    }
    static MemoryFileId job(const char* name) {
        return {protocol::Directory::kJob, QString::fromLatin1(name)};
    }
    auto download(const char* name) { return run(driver.download(job(name), progress(), stop.get_token())); }
    auto upload(std::vector<std::string> lines) {
        return run(driver.upload(job("B"), std::move(lines), progress(), stop.get_token()));
    }
    OnTransfer progress() {
        return [this](const TransferProgress& step) {
            steps.push_back(step);
            if (on_step) {
                on_step(step);
            }
        };
    }

    bool loading = false;
    std::string heard;
    std::string load_result = ">";
    std::optional<std::string> early_answer;
    std::vector<TransferProgress> steps;
    std::function<void(const TransferProgress&)> on_step;
    std::stop_source stop;
};

TEST_F(FileTransferTest, AFileIsReadTwiceAndHandedOutLineByLine) {
    connect();
    const auto file = download("A");
    ASSERT_TRUE(file.has_value());
    EXPECT_THAT(file->lines, ElementsAre("5=1", "37=1000.000", "38=2000.000", "39=50.000"));
    EXPECT_EQ(file->readings, 2);
    EXPECT_EQ(sent("OM=A"), 2);
}

TEST_F(FileTransferTest, ALineLostInTheMiddleIsNoticedAndReadAgain) {
    connect();
    station.next["OM=A"] = {"5=1\r\n37=1000.000\r\n39=50.000\r\n>"};
    const auto file = download("A");
    ASSERT_TRUE(file.has_value());
    EXPECT_EQ(file->lines.size(), 4U);
    EXPECT_EQ(file->readings, 3);
}

TEST_F(FileTransferTest, AFileThatNeverReadsTheSameTwiceIsNotHandedOut) {
    connect();
    for (const char* digit : {"1", "2", "3", "4", "5", "6"}) {
        station.next["OM=A"].push_back(std::string("5=") + digit + "\r\n>");
    }
    const auto file = download("A");
    ASSERT_FALSE(file.has_value());
    EXPECT_THAT(file.error().remedy.toStdString(), HasSubstr("Nothing was saved"));
}

TEST_F(FileTransferTest, ABlockEndThatWasLostIsATimeOutAndReadAgain) {
    connect();
    station.next["OM=A"] = {"5=1\r\n37=1000.000\r\n"};
    const auto file = download("A");
    ASSERT_TRUE(file.has_value());
    EXPECT_EQ(file->lines.size(), 4U);
}

TEST_F(FileTransferTest, AFileThatIsNotThereIsInfo32) {
    connect();
    station.next["OM=A"] = {"32\r\n>", "32\r\n>"};
    const auto file = download("A");
    ASSERT_FALSE(file.has_value());
    EXPECT_EQ(file.error().info_code, 32);
}

TEST_F(FileTransferTest, TheListNamesJobsAndAreasAndTheFreeMemory) {
    connect();
    station.next["OMC"] = {"50=0\r\n50=DEMO1\r\n>", "50=0\r\n50=DEMO1\r\n>"};
    station.next["OIC"] = {"15=0\r\n>", "15=0\r\n>"};
    station.next["M"] = {"58760\r\n>"};
    const auto listing = run(driver.listMemory({}));
    ASSERT_TRUE(listing.has_value());
    EXPECT_THAT(listing->files, ElementsAre(job("0"), job("DEMO1"), MemoryFileId{protocol::Directory::kArea, "0"}));
    EXPECT_EQ(listing->free_bytes, 58760);
}

TEST_F(FileTransferTest, LinesGoInAfterTheStarAndAreReadBack) {
    connect();
    const auto sent_file = upload({"5=1", "37=1000.000"});
    ASSERT_TRUE(sent_file.has_value());
    EXPECT_EQ(heard, "5=1\r\n37=1000.000\r\n");
    EXPECT_EQ(sent_file->sent_lines, 2);
    EXPECT_THAT(sent_file->kept, ElementsAre("5=1", "37=1000.000"));
    EXPECT_EQ(steps.back().step, TransferStep::kReadingBack);
}

TEST_F(FileTransferTest, AStarWithALineEndAndABlockEndServesToo) {
    connect();
    station.next["LM=B"] = {"*\r\n>"};
    const auto sent_file = upload({"5=1"});
    ASSERT_TRUE(sent_file.has_value()) << sent_file.error().happened.toStdString();
    EXPECT_EQ(heard, "5=1\r\n");
}

TEST_F(FileTransferTest, ABlockEndBeforeTheStarIsPassedOver) {
    connect();
    station.next["LM=B"] = {">*"};
    const auto sent_file = upload({"5=1"});
    ASSERT_TRUE(sent_file.has_value()) << sent_file.error().happened.toStdString();
    EXPECT_EQ(heard, "5=1\r\n");
}

TEST_F(FileTransferTest, AnAnswerThatIsNeitherStarNorRefusalClosesTheFileBlindly) {
    connect();
    station.next["LM=B"] = {"0\r\n>*"};
    EXPECT_FALSE(upload({"5=1"}).has_value());
    EXPECT_FALSE(loading) << "whatever is asked next would become a line of the file";
}

TEST_F(FileTransferTest, AFileThatExistsIsNeverOverwritten) {
    connect();
    station.next["LM=B"] = {"33\r\n>"};
    const auto sent_file = upload({"5=1"});
    ASSERT_FALSE(sent_file.has_value());
    EXPECT_EQ(sent_file.error().info_code, 33);
    EXPECT_EQ(heard, "");
}

TEST_F(FileTransferTest, WhatTheInstrumentSaysAtTheEndIsTheOutcome) {
    connect();
    for (const int code : {34, 35, 36, 24}) {
        load_result = std::to_string(code) + "\r\n>";
        const auto sent_file = upload({"5=1"});
        ASSERT_FALSE(sent_file.has_value()) << code;
        EXPECT_EQ(sent_file.error().info_code, code);
    }
}

TEST_F(FileTransferTest, AnErrorInTheMiddleEndsTheSending) {
    connect();
    early_answer = "35\r\n>";
    const auto sent_file = upload({"5=1", "37=1", "38=1", "39=1"});
    ASSERT_FALSE(sent_file.has_value());
    EXPECT_EQ(sent_file.error().info_code, 35);
    EXPECT_LT(std::ranges::count(heard, '\n'), 4);
}

TEST_F(FileTransferTest, AnEmptyBlockInTheMiddleIsNoEndAndNoCancelAndTheFileIsClosed) {
    connect();
    early_answer = ">";
    const auto sent_file = upload({"5=1", "37=1", "38=1", "39=1"});
    ASSERT_FALSE(sent_file.has_value());
    EXPECT_EQ(sent_file.error().kind, ErrorKind::kProtocol);
    EXPECT_THAT(sent_file.error().happened.toStdString(), HasSubstr("of 4, before the end"));
    EXPECT_FALSE(loading) << "whatever is asked next would become a line of the file";
    EXPECT_THAT(heard, Not(HasSubstr("RG")));
}

TEST_F(FileTransferTest, AnEmptyBlockAfterTheLastLineIsNoEndEither) {
    connect();
    early_answer = ">";
    const auto sent_file = upload({"0=" + std::string(50, 'A')});  // 52 ms on the wire
    ASSERT_FALSE(sent_file.has_value());
    EXPECT_THAT(sent_file.error().happened.toStdString(), HasSubstr("after line 1 of 1"));
    EXPECT_FALSE(loading);
}

TEST_F(FileTransferTest, ReadingsThatNobodyAskedForAreNotTheFile) {
    connect();
    station.next["OM=A"] = {"7=10.0000\r\n8=99.0000\r\n9=12.345\r\n>" + kFile, "37=1.0\r\n38=2.0\r\n39=3.0\r\n>" + kFile};
    const auto file = download("A");
    ASSERT_TRUE(file.has_value());
    EXPECT_THAT(file->lines, ElementsAre("5=1", "37=1000.000", "38=2000.000", "39=50.000"));
}

TEST_F(FileTransferTest, WhereOnlyReadingsComeTheOutputOfTheInstrumentIsBlamed) {
    connect();
    for (int i = 0; i < 6; ++i) {
        station.next["OM=A"].push_back("37=1.0\r\n38=2.0\r\n39=3.0\r\n>");
    }
    const auto file = download("A");
    ASSERT_FALSE(file.has_value());
    EXPECT_THAT(file.error().remedy.toStdString(), HasSubstr("slave"));
}

TEST_F(FileTransferTest, AFileOfOnePointThatWasJustSentIsKnownWhenItIsReadBack) {
    connect();
    const auto sent_file = upload({"37=1000.000", "38=2000.000"});
    ASSERT_TRUE(sent_file.has_value());
    EXPECT_THAT(sent_file->kept, ElementsAre("37=1000.000", "38=2000.000"));
}

TEST_F(FileTransferTest, ReadingsThatNobodyAskedForAreNoNamesOfFiles) {
    connect();
    const std::string readings = "7=10.0000\r\n8=99.0000\r\n>", names = "50=0\r\n50=DEMO1\r\n>";
    station.next["OMC"] = {readings + names, readings + names};
    station.next["OIC"] = {"15=0\r\n>", "15=0\r\n>"};
    const auto listing = run(driver.listMemory({}));
    ASSERT_TRUE(listing.has_value());
    EXPECT_THAT(listing->files, ElementsAre(job("0"), job("DEMO1"), MemoryFileId{protocol::Directory::kArea, "0"}));
}

TEST_F(FileTransferTest, ALineThatHoldsTheEndMarkIsRefusedBeforeAnythingIsSent) {
    connect();
    const auto sent_file = upload({"5=1", "0=A>B"});
    ASSERT_FALSE(sent_file.has_value());
    EXPECT_THAT(sent_file.error().happened.toStdString(), HasSubstr("Line 2"));
    EXPECT_EQ(sent("LM=B"), 0);
}

TEST_F(FileTransferTest, CancelEndsTheFileSoThatNoQuestionGoesIntoIt) {
    connect();
    on_step = [this](const TransferProgress& step) {
        if (step.done == 2) {
            driver.stop();
        }
    };
    const auto sent_file = upload({"5=1", "37=1", "38=1", "39=1"});
    ASSERT_TRUE(sent_file.has_value());
    EXPECT_TRUE(sent_file->cancelled);
    EXPECT_EQ(sent_file->sent_lines, 2);
    EXPECT_EQ(heard, "5=1\r\n37=1\r\n");
    EXPECT_FALSE(loading) << "the end mark was sent";
}

TEST_F(FileTransferTest, WhileAFileIsLoadedNobodyElseAsks) {
    connect();
    on_step = [this](const TransferProgress& step) {
        if (step.step == TransferStep::kSending && step.done == 1) {
            [[maybe_unused]] const auto asking = driver.get(protocol::kPpm, {});
        }
    };
    ASSERT_TRUE(upload({"5=1", "37=1", "38=1"}).has_value());
    EXPECT_EQ(heard, "5=1\r\n37=1\r\n38=1\r\n");
    EXPECT_GE(sent("RG,30"), 1) << "it was asked afterwards";
}

TEST_F(FileTransferTest, AStarThatNeverComesIsSaidAndTheLoadIsEnded) {
    connect();
    station.next["LM=B"] = {std::nullopt};
    const auto sent_file = upload({"5=1"});
    ASSERT_FALSE(sent_file.has_value());
    EXPECT_THAT(sent_file.error().remedy.toStdString(), HasSubstr("another name"));
    EXPECT_THAT(link.written, Contains(">\r"));
}

TEST_F(FileTransferTest, WithoutAnEndMarkNothingIsSent) {
    station.labels[79] = "0";
    station.end = "";
    connect();
    const auto sent_file = upload({"5=1"});
    ASSERT_FALSE(sent_file.has_value());
    EXPECT_EQ(sent_file.error().kind, ErrorKind::kUnsupported);
}

}  // namespace
}  // namespace pmts::instrument
