#include "pmts/instrument/line_probe.hpp"

#include "scripted_instrument.hpp"

namespace pmts::instrument {
namespace {

using transport::Parity;
using transport::SerialSettings;

/// Ports with something at the other end that understands one line setting.
class LineProbeTest : public testing::Test {
protected:
    LineProbeTest() {
        probe.on_step = [this](const ProbeStep& step) { steps.push_back(step); };
    }

    std::unique_ptr<transport::ByteLink> make(const SerialSettings& line) {
        auto link = std::make_unique<test::ScriptedLink>(clock);
        link->close();
        link->unavailable = line.port_name == QStringLiteral("taken");
        const bool is_right = (only_on.isEmpty() || line.port_name == only_on) && line.baud == right.baud &&
                              line.data_bits == right.data_bits && line.parity == right.parity;
        link->respond = [this, is_right](const std::string& command) { return answer(command, is_right); };
        return link;
    }
    virtual std::optional<std::string> answer(const std::string& command, bool is_right) {
        sent.insert(command);
        return is_right && command.starts_with("RG") ? std::optional(reply) : wrong_reply;
    }
    ProbeOutcome run(std::vector<QString> ports = {QStringLiteral("A")}) {
        const auto outcome = test::runToEnd(probe.run(std::move(ports), stop.get_token()), clock, 1000s);
        return outcome && *outcome ? **outcome : ProbeOutcome();
    }

    core::VirtualClock clock;
    SerialSettings right{.port_name = {}, .baud = 4800};
    QString only_on;  ///< empty: the instrument answers on every port
    std::string reply = "79=62\r\n>";
    std::optional<std::string> wrong_reply;
    std::set<std::string> sent;
    std::vector<ProbeStep> steps;
    std::stop_source stop;
    LineProbe probe{[this](const SerialSettings& line) { return make(line); }, clock};
};

TEST_F(LineProbeTest, TheUsualSettingIsTriedFirstAndEveryOneOfThePageIsThere) {
    const auto lines = LineProbe::usualLines();
    EXPECT_EQ(lines.front().lineText(), QStringLiteral("9600 8N1"));
    EXPECT_EQ(lines[1].lineText(), QStringLiteral("4800 8N1"));
    for (const int baud : {300, 1200, 2400, 4800, 9600, 19200}) {
        for (const char* const framing : {"8N1", "7E1", "7O1", "8E1", "8O1", "8N2"}) {
            const QString wanted = QStringLiteral("%1 %2").arg(baud).arg(QLatin1String(framing));
            EXPECT_EQ(std::ranges::count(lines, wanted, &SerialSettings::lineText), 1) << wanted.toStdString();
        }
    }
}

TEST_F(LineProbeTest, FindsAnInstrumentAt4800AfterSilenceAt9600) {
    const auto outcome = run();
    ASSERT_TRUE(outcome.found.has_value());
    EXPECT_EQ(outcome.found->line.lineText(), QStringLiteral("4800 8N1"));
    EXPECT_EQ(outcome.found->evidence.label_79, 62);
    EXPECT_EQ(steps.size(), 2U) << "it stops where it has found one";
    EXPECT_EQ(steps.front().of, 36);
}

TEST_F(LineProbeTest, SendsNothingThatChangesAnInstrument) {
    right.baud = 50;
    (void)run();
    EXPECT_EQ(sent, (std::set<std::string>{"\r", "RG,79\r"}));
}

TEST_F(LineProbeTest, AMissingEndMarkIsFoundOutByItsSilence) {
    reply = "79=0\r\n";
    const auto outcome = run();
    ASSERT_TRUE(outcome.found.has_value());
    EXPECT_EQ(outcome.found->evidence.label_79, 0);
    EXPECT_FALSE(outcome.found->evidence.end_mark.has_value());
}

TEST_F(LineProbeTest, TextUnderAParityBitIsTriedNextWithThatFraming) {
    right = {.port_name = {}, .baud = 9600, .data_bits = 7, .parity = Parity::kOdd};
    // 20 CR LF > in seven bits with odd parity, read as eight without
    wrong_reply = "\x32\xb0\x0d\x8a\x3e";
    const auto outcome = run();
    ASSERT_TRUE(outcome.found.has_value());
    EXPECT_EQ(outcome.found->line.lineText(), QStringLiteral("9600 7O1"));
    EXPECT_EQ(steps.size(), 2U);
}

TEST_F(LineProbeTest, ATakenPortIsSaidAndTheNextOneIsLookedAt) {
    const auto outcome = run({QStringLiteral("taken"), QStringLiteral("B")});
    ASSERT_EQ(outcome.ports.size(), 2U);
    EXPECT_EQ(outcome.ports[0].trouble->kind, ErrorKind::kPortUnavailable);
    ASSERT_TRUE(outcome.found.has_value());
    EXPECT_EQ(outcome.found->line.port_name, QStringLiteral("B"));
}

TEST_F(LineProbeTest, TheLikelySettingsOfEveryPortComeBeforeTheUnlikelyOnesOfTheFirst) {
    only_on = QStringLiteral("C");
    const auto outcome = run({QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("C")});
    ASSERT_TRUE(outcome.found.has_value());
    EXPECT_EQ(outcome.found->line.port_name, QStringLiteral("C"));
    EXPECT_EQ(steps.size(), 6U) << "9600 and 4800 on three ports";
    EXPECT_EQ(steps.front().of, 108);
}

TEST_F(LineProbeTest, TheMostTellingOfASilentAndGarbledPortIsKept) {
    right.baud = 50;
    const auto silent = run();
    ASSERT_EQ(silent.ports.size(), 1U);
    EXPECT_EQ(silent.ports[0].evidence.symptom, LineSymptom::kSilent);
    EXPECT_EQ(steps.size(), 36U);
    wrong_reply = "\x80\xf8\x80";
    EXPECT_EQ(run().ports.at(0).evidence.symptom, LineSymptom::kGarbled);
}

TEST_F(LineProbeTest, CancelEndsItAtOnce) {
    right.baud = 50;
    probe.on_step = [this](const ProbeStep& step) {
        if (step.done == 3) {
            stop.request_stop();
        }
    };
    const auto outcome = test::runToEnd(probe.run({QStringLiteral("A")}, stop.get_token()), clock, 1000s);
    ASSERT_TRUE(outcome.has_value());
    ASSERT_FALSE(outcome->has_value());
    EXPECT_EQ(outcome->error().kind, ErrorKind::kCancelled);
    EXPECT_LT(clock.now(), 10s);
}

/// What is plugged in is no instrument.
class StrangerTest : public LineProbeTest {
protected:
    std::optional<std::string> answer(const std::string& command, bool) override { return strange(command); }

    std::function<std::optional<std::string>(const std::string&)> strange;
};

TEST_F(StrangerTest, ALoopedCableIsToldFromAModemThatEchoes) {
    strange = [](const std::string& command) { return command; };
    EXPECT_EQ(run().ports.at(0).evidence.symptom, LineSymptom::kEcho);
    strange = [](const std::string& command) { return command == "AT\r" ? "AT\r\r\nOK\r\n" : command; };
    const auto modem = run();
    EXPECT_EQ(modem.ports.at(0).evidence.symptom, LineSymptom::kModem);
    EXPECT_FALSE(modem.found.has_value());
}

}  // namespace
}  // namespace pmts::instrument
