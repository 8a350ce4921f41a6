#include "manual_client.hpp"

#include "support/child_program.hpp"
#include "support/matchers.hpp"

#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace pmts::simulator {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// The program as a stranger starts it, fifty times as fast as the real thing. Another process knows no virtual clock:
/// every wait ends with the bytes or the exit it is for; ctest ends a program that hangs.
class ManualClientTest : public testing::Test {
protected:
    void TearDown() override { stop(); }

    QString link() const { return folder_.filePath(QStringLiteral("geodimeter")); }
    std::string port() const { return link().toStdString(); }

    /// The line it says when it serves.
    QString serve(const QStringList& more = {}) {
        QStringList arguments{"--link", link(), "--time-scale", "50", "--seed", "3", "--scene", oneWall()};
        program_.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        program_.start(QStringLiteral(PMTS_SIM_PROGRAM), arguments + more);
        return nextLine();
    }
    /// A scene that is quickly painted: a wall 20 m north.
    QString oneWall() const {
        const QString path = folder_.filePath(QStringLiteral("wall.json"));
        QFile file(path);
        file.open(QIODevice::WriteOnly);
        file.write(R"({"format": "pmts-scene", "panels": [{"name": "wall", "origin_m": [-15, 20, -5],
                       "right_m": [30, 0, 0], "up_m": [0, 0, 10],
                       "texture": {"kind": "plaster", "texel_m": 0.5, "seed": 4}}]})");
        return path;
    }
    QString nextLine() { return test::nextLineOf(program_); }
    int stop(int signal = SIGTERM) {
        if (program_.state() == QProcess::NotRunning) {
            return program_.exitCode();
        }
        ::kill(static_cast<pid_t>(program_.processId()), signal);
        test::awaitEnd(program_);
        return program_.exitStatus() == QProcess::NormalExit ? program_.exitCode() : -1;
    }
    /// Exit code and complaint of a call that cannot work.
    std::pair<int, std::string> refused(const QStringList& arguments) {
        QProcess call;
        call.start(QStringLiteral(PMTS_SIM_PROGRAM), arguments);
        test::awaitEnd(call);
        EXPECT_NE(call.error(), QProcess::FailedToStart);
        return {call.exitCode(), call.readAllStandardError().toStdString()};
    }

private:
    QTemporaryDir folder_;
    QProcess program_;
};

TEST_F(ManualClientTest, SaysWhereItServes) {
    const QString said = serve();
    EXPECT_EQ(said, QStringLiteral("pmts-sim: serving a Geodimeter on %1 -> %2")
                        .arg(link(), QFile::symLinkTarget(link())));
    EXPECT_THAT(QFile::symLinkTarget(link()).toStdString(), StartsWith("/dev/pts/"));
}

/// A cable from one port to the other, until so many answers have passed to the control unit.
void join(const std::string& panel_port, const std::string& instrument_port, int answers) {
    const auto open_raw = [](const std::string& port) {
        const int fd = ::open(port.c_str(), O_RDWR | O_NOCTTY);
        termios raw{};
        tcgetattr(fd, &raw);
        cfmakeraw(&raw);
        tcsetattr(fd, TCSANOW, &raw);
        return fd;
    };
    std::array<pollfd, 2> ends{{{open_raw(panel_port), POLLIN, 0}, {open_raw(instrument_port), POLLIN, 0}}};
    std::array<char, 256> bytes{};
    constexpr int kWithoutLimit = -1;
    while (answers > 0 && ::poll(ends.data(), ends.size(), kWithoutLimit) > 0 &&
           ((ends[0].revents | ends[1].revents) & (POLLHUP | POLLERR)) == 0) {
        for (std::size_t from = 0; from < 2; ++from) {
            const auto size = (ends[from].revents & POLLIN) != 0 ? ::read(ends[from].fd, bytes.data(), bytes.size()) : 0;
            if (size > 0 && ::write(ends[1 - from].fd, bytes.data(), static_cast<std::size_t>(size)) == size) {
                answers -= from == 1 ? static_cast<int>(std::count(bytes.begin(), bytes.begin() + size, '>')) : 0;
            }
        }
    }
    ::close(ends[0].fd);
    ::close(ends[1].fd);
    EXPECT_LE(answers, 0);
}

TEST_F(ManualClientTest, AControlUnitOnTheSecondPortGetsItsAnswersThroughACable) {
    const QString panel = link() + QStringLiteral("-panel");
    serve({"--panel-link", panel});
    EXPECT_TRUE(nextLine().startsWith(QStringLiteral("pmts-sim: a control unit on %1 -> /dev/pts/").arg(panel)));
    join(panel.toStdString(), port(), 20);
    EXPECT_EQ(stop(), 0);
    const auto counts = QRegularExpression(QStringLiteral("asked (\\d+) times: (\\d+) answered, 0 unanswered, 0 foreign"))
                            .match(nextLine());

    ASSERT_TRUE(counts.hasMatch());
    EXPECT_GE(counts.captured(2).toInt(), 19);
    EXPECT_FALSE(QFile::exists(panel));
}

TEST_F(ManualClientTest, StartsInGonMetreCelsiusMbar) {
    serve();
    ManualClient client(port());
    EXPECT_THAT(client.ask("RG,23"), ElementsAre("23=1111"));
    EXPECT_THAT(client.ask("RG,79"), ElementsAre("79=62"));
    EXPECT_THAT(client.ask("RG,55"), ElementsAre("55=620123"));
}

TEST_F(ManualClientTest, TurnsWithTwoTargetsAndWs) {
    serve();
    ManualClient client(port());
    EXPECT_TRUE(client.accepts("WG,26=96.1684"));
    EXPECT_TRUE(client.accepts("WG,27=377.5612"));
    EXPECT_TRUE(client.accepts("WS=PH02V02"));
    // Tolerance 2 cc, and four sigma of the circle's 3 cc.
    EXPECT_NEAR(std::stod(ManualClient::label(client.ask("RG,7"), "7")), 377.5612, 14e-4);
    EXPECT_NEAR(std::stod(ManualClient::label(client.ask("RG,8"), "8")), 96.1684, 14e-4);
}

TEST_F(ManualClientTest, PollsUntilTheDistanceIsThere) {
    serve();
    ManualClient client(port());
    EXPECT_TRUE(client.accepts("WG,56=22"));
    EXPECT_TRUE(client.accepts("WG,74=1000"));
    EXPECT_THAT(client.ask("RG,30"), ElementsAre("30=5.34"));
    EXPECT_TRUE(client.accepts("PG,3=0"));
    EXPECT_TRUE(client.accepts("TG"));
    std::vector<std::string> answer;
    int polls = 0;
    while (ManualClient::label(answer, "9").empty()) {
        answer = client.ask("RG");  // the next question as soon as the last one is answered
        ++polls;
    }
    EXPECT_GT(polls, 1) << "a distance takes 5 s";
    ASSERT_EQ(answer.size(), 4U);
    EXPECT_EQ(answer[0], "0");
    EXPECT_NEAR(std::stod(ManualClient::label(answer, "9")), 20.0, 0.013);  // four sigma of 3 mm + 3 ppm
    EXPECT_THAT(client.ask("RG"), ElementsAre("3"));
}

TEST_F(ManualClientTest, AnswersItsMistakesWithInfoCodes) {
    serve();
    ManualClient client(port());
    EXPECT_THAT(client.ask("rg"), ElementsAre("30"));
    EXPECT_THAT(client.ask("WG,120=1"), ElementsAre("20"));
    EXPECT_THAT(client.ask("WG,26=north"), ElementsAre("35"));
    EXPECT_THAT(client.ask("OM=NONE"), ElementsAre("32"));
}

TEST_F(ManualClientTest, NextClientFindsAFreshLine) {
    serve();
    {
        ManualClient first(port());
        EXPECT_TRUE(first.accepts("WG,5=FIRST"));
    }
    ManualClient second(port());
    EXPECT_THAT(second.ask("RG,5"), ElementsAre("5=FIRST"));
}

TEST_F(ManualClientTest, OptionsReachTheInstrument) {
    serve({QStringLiteral("--units"), QStringLiteral("1112"), QStringLiteral("--fault"),
           QStringLiteral("info=197"), QStringLiteral("stray_end_marks,on=RG")});
    ManualClient client(port());
    EXPECT_THAT(client.ask("RG,23"), ElementsAre());  // a stray mark, then the refusal
    EXPECT_THAT(client.ask("RG,23"), ElementsAre());
}

TEST_F(ManualClientTest, PulledCableComesBackBehindTheSameLink) {
    serve({QStringLiteral("--fault"), QStringLiteral("unplug=10")});
    EXPECT_THAT(nextLine().toStdString(),
                StartsWith("pmts-sim: serving a Geodimeter on " + port() + " -> /dev/pts/"));
    ManualClient client(port());
    EXPECT_THAT(client.ask("RG,23"), ElementsAre("23=1111"));
}

TEST_F(ManualClientTest, LeavesCleanlyAndTakesItsLinkAway) {
    for (const int signal : {SIGINT, SIGTERM}) {
        serve();
        EXPECT_TRUE(QFileInfo(link()).isSymLink());
        EXPECT_EQ(stop(signal), 0);
        EXPECT_FALSE(QFileInfo(link()).isSymLink());
    }
}

TEST_F(ManualClientTest, RefusesBadArgumentsInASentence) {
    const std::vector<std::pair<QStringList, const char*>> calls{
        {{"--seed", "x"}, "--seed takes a number"},
        {{"--bogus"}, "bogus"},
        {{"--time-scale", "0"}, "time scale"},
        {{"--units", "9999"}, "unit status"},
        {{"--output", "loud"}, "no output"},
        {{"--fault", "earthquake"}, "earthquake"},
        {{"--scene", "/nowhere.json"}, "/nowhere.json"},
        {{"stray"}, "stray"},
        {{"--link", "/proc/version"}, "/proc/version"},
        {{"--link"}, "link"},
        {{"--baud", "-1"}, "baud"},
        {{"--line", "4800"}, "--line takes a setting"}};
    for (const auto& [arguments, named] : calls) {
        const auto [code, complaint] = refused(arguments);
        EXPECT_NE(code, 0) << named;
        EXPECT_THAT(complaint, StartsWith("pmts-sim: "));
        EXPECT_THAT(complaint, HasSubstr(named));
    }
}

}  // namespace
}  // namespace pmts::simulator
