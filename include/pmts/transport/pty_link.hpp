#pragma once

#include "pmts/transport/byte_link.hpp"

#include <memory>
#include <optional>

namespace pmts::transport {

/// How the client has set its port. A pty keeps neither even parity nor seven data bits.
struct PtyClientLine {
    int baud = 9600;
    bool odd_parity = false;
    bool two_stop_bits = false;

    [[nodiscard]] bool operator==(const PtyClientLine&) const = default;
};

/// The instrument's end of a pseudo-terminal: another program opens slaveName() as if it were a serial port.
/// Clients may come, go and come back; while none is there, written bytes vanish, and a new one finds no
/// stale bytes. close() is the cable pulled: clients see their port disappear.
class PtyLink final : public ByteLink {
public:
    /// `link_path`: a symbolic link to the slave, made in open() and removed in close(); empty for none.
    explicit PtyLink(QString link_path = {});
    ~PtyLink() override;

    /// Fails with kPortUnavailable: no pty left, or link_path exists and is not a symbolic link.
    [[nodiscard]] core::Result<void> open() override;
    void close() override;
    [[nodiscard]] bool isOpen() const override;
    void write(std::string_view bytes) override;
    [[nodiscard]] QString description() const override;

    [[nodiscard]] QString slaveName() const;  ///< `/dev/pts/3`; empty while closed
    [[nodiscard]] bool hasClient() const;     ///< somebody has the slave open, as far as known
    [[nodiscard]] std::optional<PtyClientLine> clientLine() const;  ///< absent while closed or at an unusual speed

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace pmts::transport
