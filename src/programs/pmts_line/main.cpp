#include "reports.hpp"

#include <QCoreApplication>

#include <cstdio>
#include <unistd.h>

namespace {

using namespace pmts;

constexpr int kBadArguments = 2, kNothingFound = 1;

void print(const QString& text, std::FILE* to = stdout) { std::fputs(text.toLocal8Bit().constData(), to); }

int complain(const core::Error& error, int code) {
    print(QStringLiteral("pmts-line: %1\n").arg(error.sentence()), stderr);
    return code;
}

/// A line on stderr that is written over, where somebody looks at it.
protocol::Progress progressLine() {
    if (isatty(fileno(stderr)) == 0) {
        return {};
    }
    return [last = -1](double share) mutable {
        if (const int percent = static_cast<int>(100.0 * share); percent != last) {
            last = percent;
            print(percent < 100 ? QStringLiteral("\rpmts-line: %1 %").arg(percent) : QStringLiteral("\r                 \r"), stderr);
        }
        return true;
    };
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
    const auto report = line::reportOf(*request, progressLine());
    if (!report) {
        return complain(report.error(), kNothingFound);
    }
    print(*report);
    return 0;
}
