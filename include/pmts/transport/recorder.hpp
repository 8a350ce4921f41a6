#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/transport/tap_link.hpp"

#include <QFile>

#include <memory>

namespace pmts::transport {

/// A link that writes every byte of both directions into a session log (session_log.hpp), each open() a new
/// session. The log is appended to and flushed per line. A full disk ends the recording, never the link.
class Recorder final : public TapLink {
public:
    Recorder(std::unique_ptr<ByteLink> inner, core::Clock& clock, QString log_path);

    [[nodiscard]] core::Result<void> open() override;
    void close() override;

    [[nodiscard]] bool isRecording() const { return log_.isOpen(); }

private:
    void beginSession();
    void record(Direction direction, std::string_view bytes);
    void writeLine(const std::string& line);

    core::Clock& clock_;
    QFile log_;
    core::Duration began_at_{0};
};

}  // namespace pmts::transport
