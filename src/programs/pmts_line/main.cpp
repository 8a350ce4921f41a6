#include "capture_file.hpp"
#include "reports.hpp"

#include <QCoreApplication>

#include <cstdio>

namespace {

using namespace pmts;

constexpr int kBadArguments = 2, kNothingFound = 1;

void print(const QString& text, std::FILE* to = stdout) { std::fputs(text.toLocal8Bit().constData(), to); }

int complain(const core::Error& error, int code) {
    print(QStringLiteral("pmts-line: %1\n").arg(error.sentence()), stderr);
    return code;
}

core::Result<QString> reportOf(const line::Request& request) {
    const auto capture = line::readCapture(request.path, request.format, request.samples_per_s);
    PMTS_TRY(capture);
    switch (request.command) {
        case line::Command::kPins:
            return line::pinReport(*capture);
        case line::Command::kCorrelate:
            return line::correlationReport(*capture, request);
        case line::Command::kDecode:
            break;
    }
    return line::decodeReport(*capture, request);
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication app(argc, argv);
    const auto request = line::readCommandLine(QCoreApplication::arguments());
    if (!request) {
        return complain(request.error(), kBadArguments);
    }
    if (request->text) {
        print(*request->text);
        return 0;
    }
    const auto report = reportOf(*request);
    if (!report) {
        return complain(report.error(), kNothingFound);
    }
    print(*report);
    return 0;
}
