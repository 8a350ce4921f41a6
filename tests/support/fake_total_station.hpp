#pragma once

#include "pmts/instrument/total_station.hpp"
#include "pmts/simulator/world.hpp"

#include <algorithm>
#include <random>

namespace pmts::test {

/// An instrument without a wire: it turns the simulator's true pointing in the time motors need, stops a
/// little off (servo) and reads a little wrong (circles). What targeting never asks for is refused.
class FakeTotalStation final : public instrument::TotalStation {
public:
    struct Habits {
        double servo_cc = 4.0;    ///< stops up to this far off
        double reading_cc = 1.0;  ///< one sigma
        unsigned seed = 1;
    };

    FakeTotalStation(core::Clock& clock, std::shared_ptr<simulator::TruePointing> truth, Habits habits)
        : clock_(clock), truth_(std::move(truth)), habits_(habits), random_(habits.seed) {}
    FakeTotalStation(core::Clock& clock, std::shared_ptr<simulator::TruePointing> truth)
        : FakeTotalStation(clock, std::move(truth), Habits{}) {}

    [[nodiscard]] geometry::Pointing reading() {
        const geometry::Pointing truth = truth_->at(clock_.now());
        std::normal_distribution<double> noise(0.0, 1.0);
        return {truth.ha + core::Angle::fromCc(habits_.reading_cc * noise(random_)),
                truth.va + core::Angle::fromCc(habits_.reading_cc * noise(random_))};
    }

    int turns = 0;
    std::optional<core::Error> refuse_next_turn;

    core::Task<core::Result<geometry::Pointing>> readPointing(std::stop_token) override {
        co_return reading();
    }
    core::Task<core::Result<geometry::Pointing>> turnTo(geometry::Pointing target, core::Angle,
                                                        std::stop_token stop) override {
        if (refuse_next_turn) {
            co_return tl::unexpected(*std::exchange(refuse_next_turn, std::nullopt));
        }
        ++turns;
        const core::Duration arrives_at = start(target);
        auto slept = co_await core::sleepFor(clock_, arrives_at - clock_.now(), stop);
        if (!slept) {
            truth_->place(truth_->at(clock_.now()));
            co_return tl::unexpected(slept.error());
        }
        co_return reading();
    }
    void stop() override { truth_->place(truth_->at(clock_.now())); }

    core::Task<core::Result<instrument::Identity>> connectTo(std::stop_token) override {
        co_return unsupported();
    }
    core::Task<core::Result<geometry::Pointing>> turnHorizontal(core::Angle, core::Angle,
                                                                std::stop_token) override {
        co_return unsupported();
    }
    core::Task<core::Result<geometry::Pointing>> turnVertical(core::Angle, core::Angle,
                                                              std::stop_token) override {
        co_return unsupported();
    }
    core::Task<core::Result<instrument::DistanceShot>> measureDistance(std::stop_token) override {
        co_return unsupported();
    }
    core::Task<core::Result<void>> setMode(instrument::EdmMode) override { co_return unsupported(); }
    instrument::EdmMode mode() const override { return instrument::EdmMode::kStd; }
    core::Task<core::Result<bool>> testSignal(std::stop_token) override { co_return unsupported(); }
    core::Task<core::Result<QString>> get(int, std::stop_token) override { co_return unsupported(); }
    core::Task<core::Result<void>> set(int, QString, std::stop_token) override { co_return unsupported(); }

private:
    static tl::unexpected<core::Error> unsupported() {
        return core::fail(core::ErrorKind::kUnsupported, QStringLiteral("This instrument only turns."));
    }

    core::Duration start(const geometry::Pointing& target) {
        const geometry::Pointing now = truth_->at(clock_.now());
        std::uniform_real_distribution<double> off_cc(-habits_.servo_cc, habits_.servo_cc);
        const auto axis = [&](core::Angle from, core::Angle to) {
            const core::Angle way = core::normalizedSigned(to - from) + core::Angle::fromCc(off_cc(random_));
            return simulator::AxisMotion{
                .start_gon = from.gon(), .end_gon = from.gon() + way.gon(), .started_at = clock_.now()};
        };
        const auto ha = axis(now.ha, target.ha);
        const auto va = axis(now.va, target.va);
        truth_->setMotion(ha, va);
        return std::max(ha.endsAt(), va.endsAt());
    }

    core::Clock& clock_;
    std::shared_ptr<simulator::TruePointing> truth_;
    Habits habits_;
    std::mt19937 random_;
};

}  // namespace pmts::test
