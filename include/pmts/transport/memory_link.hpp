#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/transport/byte_link.hpp"

#include <memory>
#include <optional>

namespace pmts::transport {

/// What a bad line does to the bytes of one direction. The same seed gives the same faults for the same
/// bytes.
struct LineFaults {
    unsigned seed = 1;
    double lost = 0.0;          ///< probability of a byte to vanish
    double garbled = 0.0;       ///< probability of a byte to arrive with one bit turned
    double doubled = 0.0;       ///< probability of a byte to arrive twice
    double late = 0.0;          ///< probability of a write to arrive late
    core::Duration late_by{0};  ///< and by how much; later bytes never overtake it
};

struct MemoryPairSettings {
    std::optional<double>
        baud;  ///< pace of both directions, ten bits a byte; absent: at the next turn of the event loop
    LineFaults first_to_second;
    LineFaults second_to_first;
};

/// One end of a line in memory. Both ends live on one thread and may go away in any order.
class MemoryLink final : public ByteLink {
public:
    ~MemoryLink() override;

    [[nodiscard]] core::Result<void> open() override;  ///< fails with kPortUnavailable while unplugged
    void close() override;
    [[nodiscard]] bool isOpen() const override;
    /// Bytes written while the other end is closed vanish, as on a wire.
    void write(std::string_view bytes) override;
    [[nodiscard]] core::Result<void> setBreak(bool on) override;
    [[nodiscard]] QString description() const override;

    std::function<void()> on_break;  ///< the other end began a BREAK
    void unplug();  ///< both open ends lose the link, once each; bytes on the way are lost
    void plug();    ///< both ends may be opened again

private:
    class Wire;
    MemoryLink(std::shared_ptr<Wire> wire, int end);
    friend struct MemoryPair makeMemoryPair(core::Clock& clock, MemoryPairSettings settings);

    std::shared_ptr<Wire> wire_;
    int end_;
};

struct MemoryPair {
    std::unique_ptr<MemoryLink> first;
    std::unique_ptr<MemoryLink> second;
};

/// Two closed ends of one line. The clock outlives both.
[[nodiscard]] MemoryPair makeMemoryPair(core::Clock& clock, MemoryPairSettings settings = {});

}  // namespace pmts::transport
