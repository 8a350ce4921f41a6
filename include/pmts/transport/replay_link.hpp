#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/transport/byte_link.hpp"
#include "pmts/transport/session_log.hpp"

#include <memory>

namespace pmts::transport {

struct ReplaySettings {
    double speed = 1.0;  ///< 2: answers come twice as fast as recorded
    QString name = QStringLiteral("session");
};

/// Plays the instrument's side of a recorded session: each write gets the recorded answer, with the recorded
/// delays. Checked leniently: a write that is not the next of the log may repeat an earlier one (a poll) or
/// skip forward; one that the log does not hold gets no answer and is kept in unexpectedWrites(). The clock
/// outlives the link.
class ReplayLink final : public ByteLink {
public:
    ReplayLink(Session session, core::Clock& clock, ReplaySettings settings = {});
    ~ReplayLink() override;
    /// The last session of a log file.
    [[nodiscard]] static core::Result<std::unique_ptr<ReplayLink>> fromFile(const QString& path,
                                                                            core::Clock& clock,
                                                                            double speed = 1.0);

    [[nodiscard]] core::Result<void> open() override;  ///< from the beginning
    void close() override;
    [[nodiscard]] bool isOpen() const override;
    void write(std::string_view bytes) override;
    [[nodiscard]] QString description() const override;  ///< `replay of x.log`

    [[nodiscard]] std::vector<std::string> unexpectedWrites() const;
    [[nodiscard]] bool isAtEnd() const;  ///< the last recorded write has been answered

private:
    class Player;
    std::shared_ptr<Player> player_;
};

}  // namespace pmts::transport
