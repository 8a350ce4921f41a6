#include "pmts/app/line/instructions_presenter.hpp"

#include "pmts/core/virtual_clock.hpp"
#include "pmts/simulator/bus_station.hpp"
#include "pmts/transport/memory_link.hpp"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QFile>
#include <QTemporaryDir>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pmts::app {
namespace {

using namespace std::chrono_literals;
using Running = InstructionsPresenter::Running;

/// The presenter over a desk whose line is the simulated bus in memory, in virtual time.
class InstructionsTest : public testing::Test {
protected:
    InstructionsTest() {
        truth->place({.ha = core::Angle::fromGon(177.56115), .va = core::Angle::fromGon(96.16838)});
        open();
    }
    void TearDown() override {
        presenter.reset();
        desk.disconnectInstrument();
        clock.advance(10s);
    }
    void open() {
        presenter.reset();
        file.emplace(path(), clock);
        presenter.emplace(*file, desk, messages, clock, Threading::kCallersThread);
    }
    [[nodiscard]] QString path() const { return folder.filePath(QStringLiteral("instructions.txt")); }
    [[nodiscard]] QString draftPath() const { return path() + QStringLiteral(".draft"); }

    InstrumentWiring wiring() {
        return {.threading = Threading::kCallersThread, .clock = &clock,
                .make_link = [this](const SerialChoice&) { return makeLink(); },
                .find_patch = targeting::findHere(targeting::PatchMatcher()), .connection = {}};
    }
    std::unique_ptr<transport::ByteLink> makeLink() {
        auto pair = transport::makeMemoryPair(clock);
        base_end = std::move(pair.second);
        (void)base_end->open();
        base_end->on_received = [this](std::string_view bytes) {
            sent += bytes;
            base.receive(bytes);
        };
        base.send = [this](std::string_view bytes) { base_end->write(bytes); };
        return std::move(pair.first);
    }
    void connectTo(instrument::LineDialect dialect) {
        SerialChoice choice;
        choice.path = QStringLiteral("memory");
        choice.dialect = dialect;
        desk.connectSerial(choice);
        clock.advance(2s);
    }
    /// Another program writes the file; the watcher's news come as events.
    void writeElsewhere(const QByteArray& text) {
        QFile other(path());
        ASSERT_TRUE(other.open(QIODevice::WriteOnly));
        other.write(text);
        other.close();
    }
    /// The watcher tells it within milliseconds; a machine that is busy may take its time.
    void untilFileSays(const QByteArray& text) {
        QDeadlineTimer limit(30s);
        while (file->text() != QString::fromUtf8(text) && !limit.hasExpired()) {
            QCoreApplication::processEvents(QEventLoop::AllEvents, 50);
            clock.advance(1s);
        }
        ASSERT_EQ(file->text().toUtf8(), text) << "the watcher of the file told nothing for 30 s";
    }
    [[nodiscard]] std::string newestBar() const {
        return messages.bars().empty() ? std::string() : messages.bars().back().happened.toStdString();
    }
    void runToTheEnd() {
        presenter->confirmNote();
        presenter->startRun();
        clock.advance(10s);
    }
    [[nodiscard]] QStringList sentSteps() const {
        QStringList all;
        for (const auto& step : presenter->steps()) {
            all << step.sent;
        }
        return all;
    }

    core::VirtualClock clock;
    core::VideoGate gate;
    QTemporaryDir folder;
    MessageCentre messages;
    std::shared_ptr<simulator::TruePointing> truth = std::make_shared<simulator::TruePointing>();
    simulator::BusStation base{{}, truth, clock};
    std::unique_ptr<transport::MemoryLink> base_end;
    std::string sent;
    InstrumentDesk desk{gate, wiring()};
    std::optional<InstructionFile> file;
    std::optional<InstructionsPresenter> presenter;
};

const QByteArray kOwn = "routine own\nsend PV,77={n 1..5}\nexpect 240.8\n";

TEST_F(InstructionsTest, TheShippedTableIsThereWithoutACopy) {
    EXPECT_TRUE(file->isShipped());
    ASSERT_NE(presenter->chosen(), nullptr);
    EXPECT_EQ(presenter->chosen()->name, "laser_on");
    EXPECT_TRUE(presenter->note().contains(QStringLiteral("unverified on hardware")));
    EXPECT_FALSE(QFile::exists(path()));
}

TEST_F(InstructionsTest, AProblemHasItsLineAndTheLastGoodTableStaysInUse) {
    presenter->setText(QStringLiteral("routine own\nsend XV,102=0\nexpect 0.8\n"));
    ASSERT_EQ(presenter->table().problems.size(), 1U);
    EXPECT_EQ(presenter->table().problems[0].line, 2);
    EXPECT_TRUE(presenter->table().problems[0].sentence.contains(u'X'));
    EXPECT_FALSE(presenter->dryRunTrouble().isEmpty());

    presenter->save();
    EXPECT_NE(file->table().find("laser_on"), nullptr);
    EXPECT_EQ(file->problems().size(), 1U);
}

TEST_F(InstructionsTest, RunTakesTheSavedTableAndSaysSoWhileTheTextHasAProblem) {
    connectTo(instrument::LineDialect::kBus);
    ASSERT_EQ(presenter->chosen()->name, "laser_on");
    EXPECT_EQ(presenter->runSentence(), QString());
    presenter->setText(presenter->text() + QStringLiteral("\nsend XV,1=0\n"));
    EXPECT_FALSE(presenter->dryRunTrouble().isEmpty()) << "the dry run takes the text";
    EXPECT_EQ(presenter->runTrouble(), QString());
    EXPECT_TRUE(presenter->runSentence().contains(QStringLiteral("as it was saved")));
    presenter->save();
    EXPECT_EQ(presenter->runTrouble(), QString());
    EXPECT_TRUE(presenter->runSentence().contains(QStringLiteral("without a problem")));

    runToTheEnd();
    EXPECT_EQ(presenter->outcome().state, DeviceState::kGood) << presenter->outcome().text.toStdString();
    EXPECT_TRUE(base.isLaserOn());
}

TEST_F(InstructionsTest, WhatIsTypedIsNotSentToTheBaseBeforeItIsSaved) {
    presenter->setText(QStringLiteral("routine own\nsend WV,102=0\nexpect 0.8\n"));
    presenter->save();
    connectTo(instrument::LineDialect::kBus);
    presenter->setText(QStringLiteral("routine own\nnote Not yet.\nsend WV,102=1\nexpect 0.8\n"));
    EXPECT_EQ(presenter->runNote(), QString()) << "of what is saved";
    sent.clear();
    runToTheEnd();
    EXPECT_NE(sent.find("WV,102=0\r"), std::string::npos);
    EXPECT_EQ(sent.find("WV,102=1\r"), std::string::npos);

    presenter->setText(QStringLiteral("routine other\nsend WV,102=1\nexpect 0.8\n"));
    EXPECT_TRUE(presenter->runTrouble().contains(QStringLiteral("other is not saved")));
}

/// The field would show the usual number of the text, and the saved routine would get another one.
TEST_F(InstructionsTest, ASavedRoutineWithOtherNumbersThanTheFieldsIsNotRun) {
    presenter->setText(QStringLiteral("routine own\nsend WV,102={n 0..1}\nexpect 0.8\n"));
    presenter->save();
    connectTo(instrument::LineDialect::kBus);
    EXPECT_EQ(presenter->runTrouble(), QString());
    presenter->setText(QStringLiteral("routine own\nsend WV,102={n 1..1}\nexpect 0.8\n"));
    EXPECT_TRUE(presenter->runTrouble().contains(QStringLiteral("other numbers")));
    sent.clear();
    runToTheEnd();
    EXPECT_EQ(sent.find("WV,"), std::string::npos);
    presenter->save();
    EXPECT_EQ(presenter->runTrouble(), QString());
}

TEST_F(InstructionsTest, AFileThatCannotBeReadIsToldAtTheStartAndNotReplaced) {
    const QByteArray large = "# " + QByteArray(InstructionFile::kLargest, 'x');
    writeElsewhere(large);
    open();
    EXPECT_THAT(newestBar(), testing::HasSubstr("too large"));
    EXPECT_TRUE(presenter->fileSentence().contains(QStringLiteral("cannot be read")));
    presenter->setText(QString::fromUtf8(kOwn));
    presenter->save();
    EXPECT_THAT(newestBar(), testing::HasSubstr("not replaced"));
    EXPECT_EQ(QFile(path()).size(), large.size());
    EXPECT_TRUE(presenter->isModified());

    ASSERT_TRUE(QFile::rename(path(), path() + QStringLiteral(".large")));
    untilFileSays(InstructionFile::shippedText().toUtf8());
    EXPECT_TRUE(messages.bars().empty()) << newestBar();
    EXPECT_EQ(presenter->text().toUtf8(), kOwn) << "what was typed stays";
    presenter->save();
    EXPECT_EQ(QFile(path()).size(), kOwn.size());
}

TEST_F(InstructionsTest, ATableThatCouldNotBeReadAgainIsNotSaved) {
    presenter->setText(QStringLiteral("# ") + QString(InstructionFile::kLargest, u'x'));
    presenter->save();
    EXPECT_THAT(newestBar(), testing::HasSubstr("larger than 1 MB"));
    EXPECT_FALSE(QFile::exists(path()));
    EXPECT_TRUE(presenter->isModified());
}

TEST_F(InstructionsTest, SavingMakesTheUsersCopy) {
    presenter->setText(QString::fromUtf8(kOwn));
    EXPECT_TRUE(presenter->isModified());
    presenter->save();
    EXPECT_FALSE(presenter->isModified());
    QFile copy(path());
    ASSERT_TRUE(copy.open(QIODevice::ReadOnly));
    EXPECT_EQ(copy.readAll(), kOwn);
    EXPECT_NE(file->table().find("own"), nullptr);
}

TEST_F(InstructionsTest, WhatAnotherProgramWritesIsTakenOver) {
    writeElsewhere(kOwn);
    untilFileSays(kOwn);
    EXPECT_EQ(presenter->text().toUtf8(), kOwn);
    ASSERT_NE(file->table().find("own"), nullptr);

    const QByteArray broken = "routine own\nsend pv,77=1\n";
    writeElsewhere(broken);
    untilFileSays(broken);
    EXPECT_FALSE(presenter->table().problems.empty());
    EXPECT_NE(file->table().find("own"), nullptr);
}

TEST_F(InstructionsTest, WhatIsTypedIsNotOverwrittenByAnotherProgram) {
    presenter->setText(QStringLiteral("routine mine\nsend WV,102=1\nexpect 0.8\n"));
    writeElsewhere(kOwn);
    untilFileSays(kOwn);
    EXPECT_TRUE(presenter->text().contains(QStringLiteral("mine")));
    EXPECT_TRUE(presenter->fileSentence().contains(QStringLiteral("Another program")));
    presenter->revert();
    EXPECT_EQ(presenter->text().toUtf8(), kOwn);
    EXPECT_FALSE(presenter->isModified());
}

TEST_F(InstructionsTest, UnsavedTextIsThereAgainAtTheNextStart) {
    presenter->setText(QString::fromUtf8(kOwn));
    clock.advance(2s);
    EXPECT_TRUE(QFile::exists(draftPath()));  // also where the program never gets to its end
    open();
    EXPECT_EQ(presenter->text().toUtf8(), kOwn);
    EXPECT_TRUE(presenter->isModified());
    presenter->save();
    EXPECT_FALSE(QFile::exists(draftPath()));
}

TEST_F(InstructionsTest, ANumberOutsideItsRangeStopsTheRunBeforeItBegins) {
    presenter->choose(QStringLiteral("measuring_mode"));
    ASSERT_EQ(presenter->fields().size(), 1U);
    EXPECT_EQ(presenter->fields()[0].range, QStringLiteral("0 to 4"));
    EXPECT_TRUE(presenter->dryRunTrouble().isEmpty());
    presenter->setField(QStringLiteral("mode"), QStringLiteral("5"));
    EXPECT_FALSE(presenter->fields()[0].is_right);
    EXPECT_TRUE(presenter->dryRunTrouble().contains(QStringLiteral("0 to 4")));
}

TEST_F(InstructionsTest, ADryRunShowsEveryStepAndTouchesNoLine) {
    connectTo(instrument::LineDialect::kBus);
    sent.clear();
    presenter->startDryRun();
    clock.advance(1s);

    EXPECT_EQ(presenter->running(), Running::kNothing);
    EXPECT_EQ(presenter->outcome().state, DeviceState::kGood) << presenter->outcome().text.toStdString();
    EXPECT_EQ(sentSteps().join(u' '), QStringLiteral("WV,102=0 PV,8=9 PV,4=0 WV,102=1 WV,102=0 PV,3=0 WV,102=1"));
    EXPECT_EQ(presenter->steps()[1].received, QStringLiteral("240.8<CR>"));
    EXPECT_EQ(presenter->steps()[2].verdict, QStringLiteral("no reply, may be missing"));
    EXPECT_EQ(sent, "");
    EXPECT_FALSE(base.isLaserOn());
}

TEST_F(InstructionsTest, ADryRunOfAnUnknownProcessFailsUnlessTheTableIsBelieved) {
    presenter->setText(QString::fromUtf8(kOwn));
    presenter->startDryRun();
    clock.advance(1s);
    EXPECT_EQ(presenter->outcome().state, DeviceState::kFailed);
    EXPECT_TRUE(presenter->steps()[0].received.startsWith(QStringLiteral("242.8")));

    presenter->setBelievesTable(true);
    presenter->startDryRun();
    clock.advance(1s);
    EXPECT_EQ(presenter->outcome().state, DeviceState::kGood);
}

TEST_F(InstructionsTest, ItRunsOnTheBusOnly) {
    EXPECT_TRUE(presenter->runTrouble().contains(QStringLiteral("connected")));
    connectTo(instrument::LineDialect::kBus);
    EXPECT_EQ(presenter->runTrouble(), QString());
}

TEST_F(InstructionsTest, ItRunsOnHardwareAfterItsNoteWasConfirmed) {
    connectTo(instrument::LineDialect::kBus);
    sent.clear();
    ASSERT_TRUE(presenter->mustConfirmNote());
    presenter->startRun();
    clock.advance(5s);
    EXPECT_EQ(sent, "");

    presenter->confirmNote();
    presenter->startRun();
    EXPECT_EQ(presenter->running(), Running::kRun);
    clock.advance(10s);
    EXPECT_EQ(presenter->outcome().state, DeviceState::kGood) << presenter->outcome().text.toStdString();
    EXPECT_TRUE(base.isLaserOn());
}

TEST_F(InstructionsTest, CancelGivesTheStreamBack) {
    connectTo(instrument::LineDialect::kBus);
    presenter->confirmNote();
    presenter->startRun();
    clock.advance(30ms);
    presenter->cancel();
    clock.advance(5s);
    EXPECT_EQ(presenter->running(), Running::kNothing);
    EXPECT_EQ(presenter->outcome().state, DeviceState::kWarning);
    EXPECT_TRUE(sent.ends_with("WV,102=1\r"));
    EXPECT_FALSE(base.isLaserOn());
}

TEST_F(InstructionsTest, TheDeskShowsThePointingOfTheStreamAndRefusesToTurn) {
    connectTo(instrument::LineDialect::kBus);
    ASSERT_EQ(desk.connectionState(), ConnectionState::kConnected);
    ASSERT_TRUE(desk.track().newest().has_value());
    EXPECT_DOUBLE_EQ(desk.track().newest()->pointing.ha.gon(), 177.56115);
    std::optional<core::ErrorKind> refused;
    QObject::connect(&desk, &InstrumentDesk::requestFailed, [&](Ticket, const core::Error& error) { refused = error.kind; });
    (void)desk.turnTo({}, core::Angle::fromCc(5));
    clock.advance(1s);
    EXPECT_EQ(refused, core::ErrorKind::kUnsupported);
}

}  // namespace
}  // namespace pmts::app
