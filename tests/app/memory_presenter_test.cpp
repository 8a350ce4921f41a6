#include "pmts/app/line/memory_presenter.hpp"

#include "field_fixture.hpp"
#include "pmts/app/line/label_backup_presenter.hpp"
#include "pmts/app/desk/whole_file.hpp"

#include <QSignalSpy>
#include <gmock/gmock.h>

namespace pmts::app {
namespace {

using instrument::MemoryFileId;
using protocol::Directory;
using testing::HasSubstr;
using testing::Not;

class MemoryPresenterTest : public FieldTest {
protected:
    static QString data(const char* name) { return QStringLiteral(PMTS_TEST_DATA "/") + QLatin1String(name); }
    bool done() {
        return until([this] { return !memory.transfer().busy; }, 10min);
    }
    void send(const char* name = "DEMO1", bool without_bad = false) {
        memory.upload({Directory::kJob, QString::fromLatin1(name)}, without_bad);
        ASSERT_TRUE(done());
    }
    [[nodiscard]] QStringList names() const {
        QStringList all;
        for (const auto& file : memory.listing().files) {
            all << MemoryPresenter::nameOf(file.directory) + u' ' + file.name;
        }
        return all;
    }
    [[nodiscard]] int count(LineFate fate) const {
        return static_cast<int>(std::ranges::count(memory.document().rows(), fate, &MemoryRow::fate));
    }

    MemoryPresenter memory{instrument, planned, messages};
};

TEST_F(MemoryPresenterTest, AFileOfThePageIsSentReadBackListedAndReadTheSame) {
    connectInstrument();
    memory.openFile(data("DEMO1.JOB"));
    const std::string before = memory.document().text();
    send();
    EXPECT_EQ(count(LineFate::kKept), 31) << newestBar(messages).toStdString();
    EXPECT_TRUE(names().contains(QStringLiteral("Job DEMO1")));

    memory.download({Directory::kJob, QStringLiteral("DEMO1")});
    ASSERT_TRUE(done());
    EXPECT_EQ(memory.document().text(), before);
    EXPECT_THAT(memory.documentSource().toStdString(), HasSubstr("read twice"));
}

TEST_F(MemoryPresenterTest, ThePointsAreComputedAgainAndTheVerdictIsShown) {
    memory.openFile(data("DEMO1.JOB"));
    EXPECT_EQ(memory.document().verdict().state, DeviceState::kGood);
    EXPECT_THAT(memory.document().verdict().text.toStdString(), HasSubstr("2 points computed again, all within 1 mm"));
}

TEST_F(MemoryPresenterTest, ANameThatIsTakenIsAskedForBeforeAnythingIsSent) {
    connectInstrument();
    memory.openFile(data("DEMO1.ARE"));
    send();
    QSignalSpy taken(&memory, &MemoryPresenter::nameTaken);
    sent.clear();
    memory.upload({Directory::kJob, QStringLiteral("DEMO1")});
    ASSERT_EQ(taken.count(), 1);
    EXPECT_EQ(taken.front().at(1).toString(), QStringLiteral("DEMO12"));
    EXPECT_THAT(sent, Not(HasSubstr("LM=")));
}

TEST_F(MemoryPresenterTest, AFileThatCameIntoTheInstrumentMeanwhileIsAskedAboutToo) {
    connectInstrument();
    memory.openFile(data("DEMO1.ARE"));
    QSignalSpy taken(&memory, &MemoryPresenter::nameTaken);
    memory.upload({Directory::kJob, QStringLiteral("0")});  // job 0 is always there, but was not listed
    ASSERT_TRUE(done());
    ASSERT_EQ(taken.count(), 1);
    EXPECT_EQ(count(LineFate::kLost), static_cast<int>(memory.document().rows().size()));
}

TEST_F(MemoryPresenterTest, BadLinesAreShownAndLeftOutOnlyWhenToldTo) {
    connectInstrument();
    const QString path = folder.filePath(QStringLiteral("odd.job"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("5=1\r\nWALL\r\n37=1.000\r\n");
    file.close();
    memory.openFile(path);
    QSignalSpy asked(&memory, &MemoryPresenter::badLinesFound);
    memory.upload({Directory::kJob, QStringLiteral("ODD")});
    EXPECT_EQ(asked.count(), 1);
    EXPECT_FALSE(memory.transfer().busy);
    send("ODD", true);
    EXPECT_EQ(count(LineFate::kKept), 2);
    EXPECT_EQ(count(LineFate::kBad), 1);
}

TEST_F(MemoryPresenterTest, LinesThatAreNotAsTheyWereSentAreSaidUntilTheNextTransfer) {
    connectInstrument();
    memory.openFile(data("DEMO1.JOB"));
    instrument_end->on_received = [this](std::string_view bytes) {
        const bool northing = bytes.starts_with("37=");
        station.receive(northing ? "37=999.999\r\n" : bytes);
    };
    QSignalSpy listed(&instrument, &InstrumentDesk::memoryListed);
    send();
    ASSERT_EQ(listed.count(), 1) << "the list is asked for after every file";
    EXPECT_GT(count(LineFate::kChanged), 0);
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("not as they were sent"));
    EXPECT_EQ(memory.state(), DeviceState::kWarning);
    memory.refresh();
    ASSERT_TRUE(done());
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("not as they were sent"));
    memory.openFile(data("DEMO1.ARE"));
    EXPECT_TRUE(messages.bars().empty());
    EXPECT_EQ(memory.state(), DeviceState::kGood) << "the warning was about the other file";
}

TEST_F(MemoryPresenterTest, AFileLargerThanAnyMemoryIsRefusedByEveryReader) {
    const QString path = folder.filePath(QStringLiteral("large.job"));
    ASSERT_TRUE(writeWhole(path, QByteArray(kLargestMemoryFile + 1, '1')));
    memory.openFile(path);
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("too large"));
    planned.importFrom(path);
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("too large"));
}

TEST_F(MemoryPresenterTest, CancelInTheMiddleSaysWhatTheInstrumentMayHoldAndTheLineServesOn) {
    connectInstrument();
    memory.openFile(data("DEMO1.JOB"));
    memory.upload({Directory::kJob, QStringLiteral("DEMO1")});
    ASSERT_TRUE(until([this] { return memory.transfer().text.contains(QLatin1String("Sending: line 5")); }));
    memory.cancel();
    ASSERT_TRUE(done());
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("may hold Job DEMO1"));
    EXPECT_GT(count(LineFate::kLost), 0);
    memory.refresh();
    ASSERT_TRUE(done());
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("may hold Job DEMO1")) << "looking at the list is the remedy";
    EXPECT_TRUE(turnTo(20, 90)) << "the instrument still obeys";
    EXPECT_NEAR(true_pointing->at(clock.now()).ha.gon(), 20.0, 0.01);
}

TEST_F(MemoryPresenterTest, AnUnpluggedCableInTheMiddleOfAReadingLeavesWhatWasThere) {
    connectInstrument();
    memory.openFile(data("DEMO1.JOB"));
    send();
    memory.openFile(data("DEMO1.ARE"));
    memory.download({Directory::kJob, QStringLiteral("DEMO1")});
    pass(200ms);
    unplug();
    ASSERT_TRUE(done());
    EXPECT_EQ(memory.document().rows().size(), 9U) << "nothing half read is shown or saved";
}

TEST_F(MemoryPresenterTest, ASavedFileHasCrLfAndAFileThatCannotBeWrittenIsSaid) {
    memory.openFile(data("DEMO1.ARE"));
    const QString path = folder.filePath(memory.proposedFileName());
    EXPECT_TRUE(path.endsWith(QLatin1String("DEMO1.ARE")));
    memory.saveFile(path);
    QFile written(path), original(data("DEMO1.ARE"));
    ASSERT_TRUE(written.open(QIODevice::ReadOnly) && original.open(QIODevice::ReadOnly));
    EXPECT_EQ(written.readAll(), original.readAll());
    memory.saveFile(folder.filePath(QStringLiteral("missing/DEMO1.ARE")));
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("cannot be written"));
}

TEST_F(MemoryPresenterTest, ItsPointsBecomePlannedPointsOnceTheUnitsAreKnown) {
    openJob();
    memory.openFile(data("DEMO1.ARE"));
    memory.takePoints();
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("units"));
    memory.chooseUnits({});
    memory.takePoints();
    ASSERT_TRUE(until([this] { return planned.points().size() == 2; }));
    EXPECT_EQ(planned.points()[1].id, QStringLiteral("101"));
    EXPECT_EQ(planned.points()[1].code, QStringLiteral("REF"));
    EXPECT_DOUBLE_EQ(planned.points()[1].e_m, 2100.0);
    EXPECT_DOUBLE_EQ(planned.points()[1].n_m, 1100.0);
}

TEST_F(MemoryPresenterTest, TheImportOfPlannedPointsTakesAJobFile) {
    openJob();
    planned.importFrom(data("DEMO1.JOB"));
    ASSERT_TRUE(until([this] { return planned.points().size() == 4; })) << newestBar(messages).toStdString();
    undo.undo();
    EXPECT_TRUE(until([this] { return planned.points().empty(); }));
}

TEST_F(MemoryPresenterTest, NothingThatErasesIsEverSent) {
    connectInstrument();
    memory.refresh();
    ASSERT_TRUE(done());
    memory.openFile(data("DEMO1.JOB"));
    send();
    memory.upload({Directory::kJob, QStringLiteral("0")});
    ASSERT_TRUE(done());
    EXPECT_EQ(sent.find("\rK"), std::string::npos);
    EXPECT_EQ(sent.find(">K"), std::string::npos);
    EXPECT_EQ(sent.find("\nK"), std::string::npos);
}

class LabelBackupPresenterTest : public FieldTest {
protected:
    void read() {
        backup.read();
        ASSERT_TRUE(until([this] { return !backup.transfer().busy; }, 10min));
    }
    LabelBackupPresenter backup{instrument, messages};
};

TEST_F(LabelBackupPresenterTest, WhatChangedSinceTheEarlierBackupIsToldSettingsFirst) {
    connectInstrument();
    read();
    ASSERT_TRUE(backup.backup().has_value()) << newestBar(messages).toStdString();
    const QString path = folder.filePath(backup.proposedFileName());
    backup.saveFile(path);
    const Ticket ticket = instrument.writeLabel(20, QStringLiteral("0.035"));
    QSignalSpy written(&instrument, &InstrumentDesk::labelWritten);
    ASSERT_TRUE(until([&] { return written.count() == 1; })) << ticket;
    read();
    backup.compareWith(path);
    ASSERT_FALSE(backup.changes().empty()) << newestBar(messages).toStdString();
    EXPECT_TRUE(backup.changes()[0].is_setting);
    EXPECT_TRUE(backup.changes()[0].label.startsWith(QLatin1String("20 ")));
    EXPECT_EQ(backup.changes()[0].after, QStringLiteral("0.035"));
    EXPECT_THAT(backup.comparison().toStdString(), HasSubstr("settings changed: 1"));
    EXPECT_EQ(sent.find("WG,127"), std::string::npos);
    EXPECT_EQ(sent.find("RG,127"), std::string::npos);
}

TEST_F(LabelBackupPresenterTest, ALabelThatDoesNotAnswerIsSaidAndIsNoChange) {
    connectInstrument();
    read();
    const QString path = folder.filePath(backup.proposedFileName());
    backup.saveFile(path);
    on_the_way = [](const std::string& bytes) { return bytes.starts_with("20=") ? std::string() : bytes; };
    read();
    ASSERT_TRUE(backup.backup().has_value()) << newestBar(messages).toStdString();
    EXPECT_THAT(backup.sentence().toStdString(), HasSubstr("1 did not answer"));
    EXPECT_EQ(backup.labels()[20].after, QStringLiteral("(no answer)"));
    backup.compareWith(path);
    EXPECT_TRUE(std::ranges::none_of(backup.changes(), &LabelChangeRow::is_setting));
}

TEST_F(LabelBackupPresenterTest, AnotherFileIsNoBackup) {
    connectInstrument();
    read();
    backup.compareWith(QStringLiteral(PMTS_TEST_DATA "/DEMO1.JOB"));
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("Line 1 of the backup"));
    EXPECT_TRUE(backup.changes().empty());
}

TEST_F(LabelBackupPresenterTest, AFileLargerThanAnyBackupIsNotRead) {
    connectInstrument();
    read();
    const QString path = folder.filePath(QStringLiteral("large.txt"));
    ASSERT_TRUE(writeWhole(path, QByteArray(kLargestMemoryFile + 1, '1')));
    backup.compareWith(path);
    EXPECT_THAT(newestBar(messages).toStdString(), HasSubstr("too large"));
}

}  // namespace
}  // namespace pmts::app
