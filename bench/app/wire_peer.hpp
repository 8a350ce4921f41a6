#pragma once

#include "pmts/core/clock.hpp"

#include <QObject>
#include <QString>
#include <QThread>

#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace pmts::bench {

/// The simulated instrument on a thread of its own, which notes when a command's first byte reached it.
class WirePeer {
public:
    WirePeer();
    ~WirePeer();

    [[nodiscard]] QString portPath() const { return port_path_; }
    /// From now on the next command that begins with `prefix` is noted.
    void watchFor(const std::string& prefix);
    [[nodiscard]] std::optional<core::Duration> arrival() const;

private:
    class Instrument;
    void note(std::string_view bytes, core::Duration at);

    QThread thread_;
    QObject context_;
    std::unique_ptr<Instrument> instrument_;
    QString port_path_;
    mutable std::mutex mutex_;
    std::string prefix_;
    std::string line_;               ///< what has come of the present command
    core::Duration line_began_{0};
    std::optional<core::Duration> arrival_;
};

}  // namespace pmts::bench
