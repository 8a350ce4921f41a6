#pragma once

#include "pmts/protocol/line_capture.hpp"

#include <cstddef>

namespace pmts::protocol {

/// Asks a Progress now and then, so that a loop of millions of turns does not wait for it. A stop is remembered.
class Watch {
public:
    static constexpr std::size_t kTurns = std::size_t{1} << 16;

    explicit Watch(const Progress& progress) : progress_(progress) {}

    /// What follows is this part of the work.
    void setStage(double begin, double end) {
        begin_ = begin;
        end_ = end;
    }
    /// Asks at every 65 536th turn; `at` of `size` is done in this stage.
    [[nodiscard]] bool goesOn(std::size_t turn, std::size_t at, std::size_t size) {
        if (turn % kTurns == 0 && !stopped_ && progress_) {
            stopped_ = !progress_(begin_ + (end_ - begin_) * static_cast<double>(at) / static_cast<double>(size));
        }
        return !stopped_;
    }
    [[nodiscard]] bool hasStopped() const { return stopped_; }

private:
    const Progress& progress_;
    double begin_ = 0.0, end_ = 1.0;
    bool stopped_ = false;
};

}  // namespace pmts::protocol
