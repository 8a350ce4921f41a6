#include "pmts/transport/memory_link.hpp"

#include "pmts/core/task.hpp"
#include "timed_queue.hpp"

#include <array>
#include <cmath>
#include <random>

namespace pmts::transport {
namespace {

constexpr double kBitsPerByte = 10.0;

/// One direction: a bad line in front of a slow one.
class OneWay {
public:
    OneWay(core::Clock& clock, std::optional<double> baud, const LineFaults& faults,
           TimedQueue<char>::Deliver deliver)
        : clock_(clock), faults_(faults), random_(faults.seed), queue_(clock, std::move(deliver)) {
        if (baud) {
            time_per_byte_ = core::Duration(std::llround(kBitsPerByte / *baud * 1e9));
        }
    }

    void send(std::string_view bytes) {
        core::Duration free_at = std::max(clock_.now(), free_at_);
        if (happens(faults_.late)) {
            free_at += faults_.late_by;
        }
        for (const char byte : bytes) {
            free_at += time_per_byte_;  // a lost byte has taken its time on the line
            sendByte(free_at, byte);
        }
        free_at_ = free_at;
    }

    void clear() { queue_.clear(); }

private:
    void sendByte(core::Duration due, char byte) {
        if (happens(faults_.lost)) {
            return;
        }
        if (happens(faults_.garbled)) {
            byte = static_cast<char>(byte ^ (1 << std::uniform_int_distribution<int>(0, 7)(random_)));
        }
        queue_.push(due, byte);
        if (happens(faults_.doubled)) {
            queue_.push(due, byte);
        }
    }

    bool happens(double probability) {
        return probability > 0.0 && std::uniform_real_distribution<double>(0.0, 1.0)(random_) < probability;
    }

    core::Clock& clock_;
    LineFaults faults_;
    std::mt19937 random_;
    core::Duration time_per_byte_{0};
    core::Duration free_at_{0};
    TimedQueue<char> queue_;
};

}  // namespace

class MemoryLink::Wire : public std::enable_shared_from_this<Wire> {
public:
    Wire(core::Clock& clock, const MemoryPairSettings& settings)
        : to_second_(clock, settings.baud, settings.first_to_second, deliverTo(1)),
          to_first_(clock, settings.baud, settings.second_to_first, deliverTo(0)) {}

    struct End {
        MemoryLink* link = nullptr;  ///< absent once it is destroyed
        bool open = false;
        bool owes_loss = false;
    };

    End& end(int index) { return ends_.at(static_cast<std::size_t>(index)); }
    OneWay& directionFrom(int index) { return index == 0 ? to_second_ : to_first_; }
    OneWay& directionTo(int index) { return directionFrom(1 - index); }
    [[nodiscard]] bool isPlugged() const { return plugged_; }

    void setPlugged(bool plugged) {
        plugged_ = plugged;
        for (int index = 0; index < 2 && !plugged; ++index) {
            directionTo(index).clear();
            if (std::exchange(end(index).open, false)) {
                end(index).owes_loss = true;
                core::post([wire = weak_from_this(), index] {
                    if (const auto self = wire.lock()) {
                        self->reportLoss(index);
                    }
                });
            }
        }
    }

    void breakTo(int index) {
        core::post([wire = weak_from_this(), index] {
            const auto self = wire.lock();
            if (self && self->end(index).open && self->end(index).link->on_break) {
                self->end(index).link->on_break();
            }
        });
    }

private:
    TimedQueue<char>::Deliver deliverTo(int index) {
        return [this, index](const std::vector<char>& bytes) {
            const End& receiver = end(index);
            if (receiver.link != nullptr && receiver.open && receiver.link->on_received) {
                const auto receive = receiver.link->on_received;  // it may destroy the link
                receive({bytes.data(), bytes.size()});
            }
        };
    }

    void reportLoss(int index) {
        if (!std::exchange(end(index).owes_loss, false) || end(index).link == nullptr ||
            !end(index).link->on_lost) {
            return;
        }
        const auto report = end(index).link->on_lost;
        report({.kind = core::ErrorKind::kLinkLost,
                .happened = QStringLiteral("The connection in memory was unplugged."),
                .remedy = QStringLiteral("Plug it in again."),
                .info_code = std::nullopt,
                .detail = {}});
    }

    std::array<End, 2> ends_;
    bool plugged_ = true;
    OneWay to_second_;
    OneWay to_first_;
};

MemoryLink::MemoryLink(std::shared_ptr<Wire> wire, int end) : wire_(std::move(wire)), end_(end) {
    wire_->end(end_).link = this;
}

MemoryLink::~MemoryLink() { wire_->end(end_) = {}; }

core::Result<void> MemoryLink::open() {
    if (!wire_->isPlugged()) {
        return core::fail(core::ErrorKind::kPortUnavailable,
                          QStringLiteral("The connection in memory is unplugged."),
                          QStringLiteral("Plug it in, then connect again."));
    }
    if (!isOpen()) {
        wire_->directionTo(end_).clear();
        wire_->end(end_).open = true;
        wire_->end(end_).owes_loss = false;
    }
    return {};
}

void MemoryLink::close() {
    wire_->end(end_).open = false;
    wire_->end(end_).owes_loss = false;
}

bool MemoryLink::isOpen() const { return wire_->end(end_).open; }

void MemoryLink::write(std::string_view bytes) {
    if (isOpen()) {
        wire_->directionFrom(end_).send(bytes);
    }
}

core::Result<void> MemoryLink::setBreak(bool on) {
    if (on && isOpen()) {
        wire_->breakTo(1 - end_);
    }
    return {};
}

QString MemoryLink::description() const { return QStringLiteral("memory"); }

void MemoryLink::unplug() { wire_->setPlugged(false); }

void MemoryLink::plug() { wire_->setPlugged(true); }

MemoryPair makeMemoryPair(core::Clock& clock, MemoryPairSettings settings) {
    const auto wire = std::make_shared<MemoryLink::Wire>(clock, settings);
    return {.first = std::unique_ptr<MemoryLink>(new MemoryLink(wire, 0)),
            .second = std::unique_ptr<MemoryLink>(new MemoryLink(wire, 1))};
}

}  // namespace pmts::transport
