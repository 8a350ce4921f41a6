#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/transport/byte_link.hpp"
#include "pmts/transport/session_log.hpp"

#include <QFile>

#include <memory>

namespace pmts::transport {

/// A link that writes every byte of both directions into a session log (session_log.hpp), each open() a new
/// session. The log is appended to and flushed per line. A full disk ends the recording, never the link.
class Recorder final : public ByteLink {
public:
    Recorder(std::unique_ptr<ByteLink> inner, core::Clock& clock, QString log_path);
    ~Recorder() override;

    [[nodiscard]] core::Result<void> open() override;
    void close() override;
    [[nodiscard]] bool isOpen() const override { return inner_->isOpen(); }
    void write(std::string_view bytes) override;
    [[nodiscard]] core::Result<void> setControlLines(const ControlLines& lines) override {
        return inner_->setControlLines(lines);
    }
    [[nodiscard]] QString description() const override { return inner_->description(); }

    [[nodiscard]] bool isRecording() const { return log_.isOpen(); }
    [[nodiscard]] ByteLink& inner() { return *inner_; }

private:
    void beginSession();
    void record(Direction direction, std::string_view bytes);
    void writeLine(const std::string& line);

    std::unique_ptr<ByteLink> inner_;
    core::Clock& clock_;
    QFile log_;
    core::Duration began_at_{0};
};

}  // namespace pmts::transport
