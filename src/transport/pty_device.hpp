#pragma once

#include "pmts/core/result.hpp"
#include "pmts/transport/pty_link.hpp"

#include <QString>

namespace pmts::transport {

/// A file descriptor that is closed with its owner.
class FileDescriptor {
public:
    FileDescriptor() = default;
    explicit FileDescriptor(int fd) : fd_(fd) {}
    FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept;
    ~FileDescriptor() { reset(); }

    [[nodiscard]] int get() const { return fd_; }
    [[nodiscard]] bool isOpen() const { return fd_ >= 0; }
    void reset();

private:
    int fd_ = -1;
};

/// Both sides of a raw pseudo-terminal. The slave is kept open, so that the master never sees a hang-up
/// (which it would report for ever) when a client leaves.
struct PtyDevice {
    FileDescriptor master;  ///< non-blocking
    FileDescriptor slave;
    QString slave_name;

    /// Raw and free again, whatever the last client has set, and without bytes it left unread.
    void resetLine() const;
    [[nodiscard]] std::optional<PtyClientLine> line() const;  ///< as the client has set it
};

[[nodiscard]] core::Result<PtyDevice> openPtyDevice();

/// Makes `path` a symbolic link to `target` in one step. Replaces a link, never a file.
[[nodiscard]] core::Result<void> placeLink(const QString& path, const QString& target);
/// Removes the link unless it points somewhere else by now.
void removeLink(const QString& path, const QString& target);

}  // namespace pmts::transport
