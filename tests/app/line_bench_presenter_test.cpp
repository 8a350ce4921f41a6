#include "pmts/app/line/line_bench_presenter.hpp"

#include "pmts/protocol/instruction_table.hpp"
#include "protocol/sampled_line.hpp"
#include "support/matchers.hpp"
#include "support/run_until.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace pmts::app {
namespace {

using protocol::TalkSide;
using protocol::test::samplesOf;
using testing::HasSubstr;

constexpr std::string_view kBlock = "A,166=96.16838\rA,165=177.56115\x04";

class LineBenchTest : public testing::Test {
protected:
    [[nodiscard]] QString path(const char* name) const { return folder.filePath(QLatin1String(name)); }
    QString write(const char* name, std::string_view bytes) const {
        QFile file(path(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes.data(), static_cast<qint64>(bytes.size()));
        return file.fileName();
    }
    static QString thesis() { return QStringLiteral(PMTS_TEST_DATA "/bus-capture.txt"); }
    /// Ends with the work in the pool, by its signal.
    void finish() {
        EXPECT_TRUE(test::runUntil([this] { return !bench.isBusy(); }));
    }
    void import(const QString& file) {
        bench.import(file);
        finish();
    }
    [[nodiscard]] std::string cell(int row, TalkModel::Column column) {
        return bench.talk().index(row, column).data().toString().toStdString();
    }
    [[nodiscard]] std::string newestBar() const {
        return messages.bars().empty() ? std::string() : messages.bars().back().happened.toStdString();
    }
    /// Commands on line 0, replies on line 1, as two probes under the control unit see the program of page 5.3.
    QString laserProgram() const {
        std::string to, from;
        const auto add = [&](std::string_view command, std::string_view reply) {
            const protocol::test::Sampling quick{.samples_per_bit = 4.0};
            to += samplesOf(command, quick);
            from.resize(to.size(), '\x01');
            from += samplesOf(reply, quick);
            to.resize(from.size(), '\x01');
        };
        add("WV,102=0\r", "0.8\x04");
        add("PV,8=9\r", "240.8\x04");
        add("WV,102=1\r", "0.8\x04");
        std::string both = to;
        for (std::size_t i = 0; i < both.size(); ++i) {
            both[i] = static_cast<char>(to[i] | (from[i] << 1));
        }
        return write("laser.bin", both);
    }

    QTemporaryDir folder;
    MessageCentre messages;
    LineBenchPresenter bench{messages, folder.path(), Threading::kCallersThread};
};

TEST_F(LineBenchTest, CaptureOfTheThesisIsReadWithItsSlips) {
    import(thesis());
    ASSERT_TRUE(bench.findings());
    EXPECT_EQ(bench.state(), DeviceState::kGood);
    EXPECT_EQ(cell(0, TalkModel::kText), "A,166=96.16838<CR>");
    EXPECT_EQ(cell(1, TalkModel::kText), "A,165=177.56115<EOT>");
    EXPECT_EQ(cell(1, TalkModel::kHex), "41 2C 31 36 35 3D 31 37 37 2E 35 36 31 31 35 04");
    EXPECT_THAT(bench.summary().toStdString(), HasSubstr("serial port"));
}

TEST_F(LineBenchTest, PanelsReadingFindsItsVariable) {
    import(thesis());
    bench.correlate(QStringLiteral("86.33.06"));
    finish();
    ASSERT_FALSE(bench.matches().empty());
    EXPECT_EQ(bench.matches().front().stream.variable, 166);
    EXPECT_EQ(bench.matches().front().units, QStringLiteral("gon, shown as d.mm.ss"));
    bench.correlate(QStringLiteral("eighty"));
    finish();
    EXPECT_TRUE(bench.matches().empty());
    EXPECT_THAT(bench.matchSentence().toStdString(), HasSubstr("86.33.06"));
}

TEST_F(LineBenchTest, NameOfAVariableIsKeptInTheDataFolder) {
    bench.nameVariable(variableKey('A', 166), QStringLiteral("VA in gon"));
    const LineBenchPresenter later(messages, folder.path());
    EXPECT_EQ(later.names().of(QStringLiteral("A,166")), QStringLiteral("VA in gon"));
    bench.nameVariable(QStringLiteral("A,166"), QString());
    const LineBenchPresenter last(messages, folder.path());
    EXPECT_TRUE(last.names().all().isEmpty());
}

TEST_F(LineBenchTest, TwoLinesBecomeADialogueAndATableThatIsAccepted) {
    import(laserProgram());
    ASSERT_TRUE(bench.findings());
    EXPECT_EQ(bench.findings()->lines[0].side, TalkSide::kToInstrument);
    EXPECT_EQ(bench.findings()->lines[1].side, TalkSide::kFromInstrument);
    EXPECT_EQ(cell(1, TalkModel::kText), "0.8<EOT>");
    bench.nameVariable(QStringLiteral("A,166"), QStringLiteral("VA in gon"));
    const QString target = bench.suggestedTablePath(QStringLiteral("laser_seen"));
    EXPECT_TRUE(QFileInfo(target).dir().exists());
    bench.saveTable(target, QStringLiteral("laser_seen"));
    finish();
    QFile file(target);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << newestBar();
    const std::string text = file.readAll().toStdString();
    EXPECT_THAT(text, HasSubstr("# A,166 = VA in gon"));
    const auto table = protocol::readInstructionTable(text);
    EXPECT_TRUE(table.problems.empty());
    ASSERT_NE(table.find("laser_seen"), nullptr);
    EXPECT_EQ(table.find("laser_seen")->steps.size(), 3U);
}

TEST_F(LineBenchTest, NamesAloneAreSavedAndSaidToBeAlone) {
    import(thesis());
    bench.nameVariable(QStringLiteral("A,166"), QStringLiteral("VA in gon"));
    QString toast;
    QObject::connect(&messages, &MessageCentre::toastShown, [&toast](const Message& message) { toast = message.happened; });
    bench.saveTable(path("x.txt"), QStringLiteral("x"));
    finish();
    EXPECT_TRUE(QFile::exists(path("x.txt")));
    EXPECT_THAT(toast.toStdString(), HasSubstr("holds no commands"));
}

TEST_F(LineBenchTest, TableWithoutCommandsOrNamesIsRefusedWithASentence) {
    import(thesis());
    bench.saveTable(path("x.txt"), QStringLiteral("x"));
    finish();
    EXPECT_EQ(bench.state(), DeviceState::kFailed);
    EXPECT_THAT(newestBar(), HasSubstr("no commands"));
    EXPECT_FALSE(QFile::exists(path("x.txt")));
}

TEST_F(LineBenchTest, NameThatIsNoneOfARoutineIsRefused) {
    import(laserProgram());
    bench.saveTable(path("x.txt"), QStringLiteral("laser on!"));
    finish();
    EXPECT_THAT(newestBar(), HasSubstr("laser on!"));
    EXPECT_FALSE(QFile::exists(path("x.txt")));
}

TEST_F(LineBenchTest, LogOfTheOwnRecorderSaysBothWays) {
    import(write("session.log", "# PMTS session log 1\n@ 2026-06-01T06:00:00.000Z /dev/ttyUSB0 at 9600 8N1\n"
                                "       0.000 > RG,7\\r\n      52.083 < 7=10.2345\\r\\n>\n      90.000 ! The port has gone.\n"));
    ASSERT_TRUE(bench.findings()) << newestBar();
    EXPECT_EQ(cell(0, TalkModel::kText), "RG,7<CR>");
    EXPECT_THAT(cell(0, TalkModel::kSide), HasSubstr("to"));
    EXPECT_EQ(cell(1, TalkModel::kTime), "0.052083 s");
    ASSERT_EQ(bench.findings()->values.size(), 1U);
    EXPECT_EQ(bench.findings()->values[0].variable, 7);
}

TEST_F(LineBenchTest, StoredBytesAreReadAsTheyAre) {
    import(write("terminal.raw", std::string(kBlock)));
    ASSERT_TRUE(bench.findings()) << newestBar();
    EXPECT_EQ(bench.findings()->values.size(), 2U);
    EXPECT_FALSE(bench.findings()->signal);
}

TEST_F(LineBenchTest, FlippedSamplesAreMarkedInTextAndBytesWhereTheyCannotBeTold) {
    std::string text;
    for (int i = 0; i < 40; ++i) {
        text += kBlock;
    }
    import(write("noisy.bin", samplesOf(text, {.samples_per_bit = 5.0, .flipped = 0.02})));
    ASSERT_TRUE(bench.findings());
    EXPECT_EQ(bench.state(), DeviceState::kWarning);
    EXPECT_GT(bench.findings()->unsure, 0U);
    int marked = 0;
    for (int row = 0; row < bench.talk().rowCount(); ++row) {
        const bool doubtful = bench.talk().index(row, 0).data(TalkModel::kIsDoubtful).toBool();
        marked += doubtful ? 1 : 0;
        EXPECT_EQ(doubtful, cell(row, TalkModel::kText).find("[?") != std::string::npos);
        EXPECT_EQ(doubtful, cell(row, TalkModel::kHex).find('?') != std::string::npos);
    }
    EXPECT_GT(marked, 0);
    QSignalSpy places(&bench, &LineBenchPresenter::searched);
    bench.search(QStringLiteral("[?"), true);
    const auto first = places.back().front().toLongLong();
    ASSERT_GE(first, 0);
    EXPECT_FALSE(bench.findings()->characters[static_cast<std::size_t>(first)].isSure());
    for (const auto& value : bench.findings()->values) {
        EXPECT_TRUE(value.value == 96.16838 || value.value == 177.56115) << value.value;
    }
}

TEST_F(LineBenchTest, FramingByHandGoesBeforeWhatWasFound) {
    import(write("line.bin", samplesOf(kBlock, {})));
    ASSERT_TRUE(bench.findings());
    protocol::Framing wrong = *bench.findings()->lines[0].framing;
    wrong.least_significant_first = false;
    bench.setFraming(0, wrong);
    finish();
    EXPECT_NE(cell(0, TalkModel::kText), "A,166=96.16838<CR>");
    bench.useFound(0, 0);
    finish();
    EXPECT_EQ(cell(0, TalkModel::kText), "A,166=96.16838<CR>");
    EXPECT_TRUE(bench.findings()->lines[0].score().has_value());
}

TEST_F(LineBenchTest, RateThatTheFileDoesNotSayNamesTheBaud) {
    const QString file = write("line.bin", samplesOf(kBlock, {.samples_per_bit = 10.0}));
    bench.importAs(file, {}, 96'000.0);
    finish();
    ASSERT_TRUE(bench.findings());
    EXPECT_NEAR(*bench.findings()->baudOf(*bench.findings()->lines[0].framing), 9600.0, 100.0);
}

TEST_F(LineBenchTest, SearchGoesForwardBackAndRound) {
    import(thesis());
    QSignalSpy places(&bench, &LineBenchPresenter::searched);
    const auto at = [&places] { return places.back().front().toLongLong(); };
    bench.search(QStringLiteral("A,16"), true);
    EXPECT_EQ(at(), 0);
    bench.search(QStringLiteral("A,16"), true);
    EXPECT_EQ(at(), 15);
    bench.search(QStringLiteral("A,16"), true);
    EXPECT_EQ(at(), 0) << "round the end";
    bench.search(QStringLiteral("A,16"), false);
    EXPECT_EQ(at(), 15);
    bench.search(QStringLiteral("0D 41"), true);
    EXPECT_EQ(at(), 14);
    bench.search(QStringLiteral("laser"), true);
    EXPECT_EQ(at(), -1);
    EXPECT_THAT(bench.searchSentence().toStdString(), HasSubstr("laser"));
}

TEST_F(LineBenchTest, FileThatHoldsNothingGivesASentenceAndKeepsWhatWasShown) {
    import(thesis());
    const auto shown = bench.findings();
    import(path("nothing.sr"));
    EXPECT_EQ(bench.state(), DeviceState::kFailed);
    EXPECT_THAT(newestBar(), HasSubstr("cannot be read"));
    import(write("photo.zip", "PK\x03\x04 something else"));
    EXPECT_THAT(newestBar(), HasSubstr("no sigrok session"));
    import(write("rest.bin", std::string(5000, '\x01')));
    EXPECT_THAT(newestBar(), HasSubstr("No line of this capture moves"));
    import(write("empty.txt", ""));
    EXPECT_FALSE(newestBar().empty());
    EXPECT_EQ(bench.findings(), shown);
}

TEST_F(LineBenchTest, CancelledReadingChangesNothing) {
    import(thesis());
    const auto shown = bench.findings();
    bench.import(write("line.bin", samplesOf(kBlock, {})));
    EXPECT_EQ(bench.state(), DeviceState::kBusy);
    EXPECT_THAT(bench.reason().toStdString(), HasSubstr("line.bin"));
    bench.cancel();
    finish();
    EXPECT_EQ(bench.findings(), shown);
    EXPECT_EQ(bench.state(), DeviceState::kGood);
}

}  // namespace
}  // namespace pmts::app
