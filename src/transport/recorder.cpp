#include "pmts/transport/recorder.hpp"

#include "pmts/core/logging.hpp"

namespace pmts::transport {
namespace {

/// Closes a line that a killed program left half written, so that it can never be read as whole.
constexpr const char* kBreakOff = "\\!\\!\n";

bool endsInsideALine(const QString& path) {
    QFile log(path);
    char last = '\n';
    return log.open(QIODevice::ReadOnly) && !log.isSequential() && log.size() > 0 &&
           log.seek(log.size() - 1) && log.getChar(&last) && last != '\n';
}

}  // namespace

Recorder::Recorder(std::unique_ptr<ByteLink> inner, core::Clock& clock, QString log_path)
    : TapLink(std::move(inner), [this](Direction direction, std::string_view bytes) { record(direction, bytes); }),
      clock_(clock), log_(std::move(log_path)) {}

core::Result<void> Recorder::open() {
    if (isOpen()) {
        return {};
    }
    PMTS_TRY(TapLink::open());
    beginSession();
    return {};
}

void Recorder::close() {
    TapLink::close();
    log_.close();
}

void Recorder::beginSession() {
    const bool broken_off = endsInsideALine(log_.fileName());
    began_at_ = clock_.now();
    if (!log_.open(QIODevice::WriteOnly | QIODevice::Append)) {
        qCWarning(core::logTransport) << "no session log:" << log_.fileName() << log_.errorString();
        return;
    }
    const std::string start = broken_off ? kBreakOff : log_.size() == 0 ? "# PMTS session log 1\n" : "";
    writeLine(start + "@ " + clock_.utcNow().toString(Qt::ISODateWithMs).toStdString() + ' ' +
              description().toStdString() + '\n');
}

void Recorder::record(Direction direction, std::string_view bytes) {
    if (log_.isOpen()) {
        writeLine(sessionLine(
            {.at = clock_.now() - began_at_, .direction = direction, .bytes = std::string(bytes)}));
    }
    if (direction == Direction::kLost) {
        log_.close();
    }
}

void Recorder::writeLine(const std::string& line) {
    const auto size = static_cast<qint64>(line.size());
    if (log_.write(line.data(), size) != size || !log_.flush()) {
        qCWarning(core::logTransport)
            << "the session log ends here:" << log_.fileName() << log_.errorString();
        log_.close();
    }
}

}  // namespace pmts::transport
