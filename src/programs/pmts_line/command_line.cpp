#include "command_line.hpp"

#include <QCommandLineParser>
#include <QMap>
#include <QRegularExpression>

namespace pmts::line {
namespace {

const QCommandLineOption kHelp({QStringLiteral("h"), QStringLiteral("help")}, QStringLiteral("Shows this text."));
const QCommandLineOption kVersion(QStringLiteral("version"), QStringLiteral("Shows the version."));
const QCommandLineOption kFormat(QStringLiteral("format"),
                                 QStringLiteral("runs, csv, vcd, samples, session or bytes; told from the file when left out."),
                                 QStringLiteral("NAME"));
const QCommandLineOption kRate(QStringLiteral("rate"), QStringLiteral("Samples each second, where the file does not say."),
                               QStringLiteral("HZ"));
const QCommandLineOption kLine(QStringLiteral("line"), QStringLiteral("Line to decode, 0 is the first; else the busiest."),
                               QStringLiteral("N"));
const QCommandLineOption kBaud(QStringLiteral("baud"), QStringLiteral("Bits each second; found when left out."),
                               QStringLiteral("N"));
const QCommandLineOption kForm(QStringLiteral("form"),
                               QStringLiteral("Data bits, parity, stop: 8N1, 7E1; found when left out."),
                               QStringLiteral("FORM"));
const QCommandLineOption kInverted(QStringLiteral("inverted"), QStringLiteral("With --form: the line rests low."));
const QCommandLineOption kMostFirst(QStringLiteral("msb"), QStringLiteral("With --form: the most significant bit first."));
const QCommandLineOption kTimes(QStringLiteral("times"), QStringLiteral("Shows when each line was said, and which way."));
const QCommandLineOption kText(QStringLiteral("text"), QStringLiteral("What to search: text, <CR>, or bytes such as 0D 41."),
                               QStringLiteral("TEXT"));
const QCommandLineOption kName(QStringLiteral("name"), QStringLiteral("Name of the routine that is written."),
                               QStringLiteral("NAME"), QStringLiteral("seen"));
const QCommandLineOption kHex(QStringLiteral("hex"), QStringLiteral("Shows bytes as hexadecimal numbers too."));
const QCommandLineOption kPanel(QStringLiteral("panel"), QStringLiteral("What the panel showed: 86.33.06 or 96.1684."),
                                QStringLiteral("TEXT"));

tl::unexpected<core::Error> refuse(const QString& happened) {
    return core::fail(core::ErrorKind::kBadInput, happened, QStringLiteral("Try pmts-line --help."));
}

core::Result<std::optional<double>> positive(const QCommandLineParser& parser, const QCommandLineOption& option) {
    if (!parser.isSet(option)) {
        return std::optional<double>();
    }
    bool ok = false;
    const double value = parser.value(option).toDouble(&ok);
    if (!ok || value <= 0.0) {
        return refuse(QStringLiteral("--%1 wants a positive number.").arg(option.names().constFirst()));
    }
    return std::optional<double>(value);
}

core::Result<void> readForm(const QCommandLineParser& parser, Request& request) {
    if (!parser.isSet(kForm)) {
        return {};
    }
    static const QRegularExpression kPattern(QStringLiteral("^([78])([NEO])1$"));
    const auto match = kPattern.match(parser.value(kForm).toUpper());
    if (!match.hasMatch()) {
        return refuse(QStringLiteral("--form wants 8N1, 8E1, 8O1, 7N1, 7E1 or 7O1."));
    }
    request.form = protocol::Framing{
        .idle_high = !parser.isSet(kInverted),
        .data_bits = match.captured(1).toInt(),
        .parity = static_cast<protocol::LineParity>(QStringLiteral("NEO").indexOf(match.captured(2))),
        .least_significant_first = !parser.isSet(kMostFirst)};
    return {};
}

core::Result<void> readFormat(const QCommandLineParser& parser, Request& request) {
    using protocol::CaptureFormat;
    static const QMap<QString, CaptureFormat> kFormats{{QStringLiteral("runs"), CaptureFormat::kRunText},
                                                       {QStringLiteral("csv"), CaptureFormat::kCsv},
                                                       {QStringLiteral("vcd"), CaptureFormat::kVcd},
                                                       {QStringLiteral("samples"), CaptureFormat::kSamples},
                                                       {QStringLiteral("session"), CaptureFormat::kSession},
                                                       {QStringLiteral("bytes"), CaptureFormat::kBytes}};
    if (parser.isSet(kFormat)) {
        if (!kFormats.contains(parser.value(kFormat))) {
            return refuse(QStringLiteral("There is no format “%1”.").arg(parser.value(kFormat)));
        }
        request.format = kFormats.value(parser.value(kFormat));
    }
    return {};
}

core::Result<void> readPositions(const QCommandLineParser& parser, Request& request) {
    static const QMap<QString, Command> kCommands{{QStringLiteral("decode"), Command::kDecode},
                                                  {QStringLiteral("pins"), Command::kPins},
                                                  {QStringLiteral("correlate"), Command::kCorrelate},
                                                  {QStringLiteral("search"), Command::kSearch},
                                                  {QStringLiteral("table"), Command::kTable}};
    const QStringList words = parser.positionalArguments();
    if (words.size() != 2 || !kCommands.contains(words[0])) {
        return refuse(QStringLiteral("Say what to do with which file: decode, pins, correlate, search or table FILE."));
    }
    request.command = kCommands.value(words[0]);
    request.path = words[1];
    request.panel = parser.value(kPanel);
    if (request.command == Command::kCorrelate && request.panel.isEmpty()) {
        return refuse(QStringLiteral("correlate wants --panel: what the panel showed."));
    }
    request.wanted = parser.value(kText);
    if (request.command == Command::kSearch && request.wanted.isEmpty()) {
        return refuse(QStringLiteral("search wants --text: what to look for."));
    }
    request.routine = parser.value(kName);
    return {};
}

core::Result<void> readLine(const QCommandLineParser& parser, Request& request) {
    if (parser.isSet(kLine)) {
        bool ok = false;
        request.line = parser.value(kLine).toInt(&ok);
        if (!ok || *request.line < 0 || *request.line > 31) {
            return refuse(QStringLiteral("--line wants a number from 0 to 31."));
        }
    }
    return {};
}

}  // namespace

core::Result<Request> readCommandLine(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Reads captures of serial lines: which pins carry data, what was said, and what it means."));
    parser.addOptions({kHelp, kVersion, kFormat, kRate, kLine, kBaud, kForm, kInverted, kMostFirst, kHex, kTimes, kPanel, kText, kName});
    parser.addPositionalArgument(QStringLiteral("command"), QStringLiteral("decode, pins, correlate, search or table"));
    parser.addPositionalArgument(QStringLiteral("file"),
                                 QStringLiteral("Runs as text, CSV, VCD, samples, a sigrok session (.sr), a log of\nPMTS's recorder, or stored bytes."));
    if (!parser.parse(arguments)) {
        return refuse(parser.errorText() + QLatin1Char('.'));
    }
    Request request;
    if (parser.isSet(kHelp)) {
        request.text = parser.helpText();
        return request;
    }
    if (parser.isSet(kVersion)) {
        request.text = QStringLiteral("pmts-line " PMTS_VERSION "\n");
        return request;
    }
    PMTS_TRY(readPositions(parser, request));
    PMTS_TRY(readFormat(parser, request));
    PMTS_TRY(readForm(parser, request));
    PMTS_TRY(readLine(parser, request));
    const auto rate = positive(parser, kRate);
    PMTS_TRY(rate);
    const auto baud = positive(parser, kBaud);
    PMTS_TRY(baud);
    request.samples_per_s = *rate;
    request.baud = *baud;
    request.hex = parser.isSet(kHex);
    request.times = parser.isSet(kTimes);
    return request;
}

}  // namespace pmts::line
