#include "pmts/targeting/recentring.hpp"

#include "guarded_turn.hpp"
#include "local_motion.hpp"
#include "pmts/geometry/polar.hpp"
#include "settled_match.hpp"

#include <QCoreApplication>

namespace pmts::targeting {
namespace {

using core::ErrorKind;
using core::Result;
using geometry::Pointing;

QString sentence(const char* text) { return QCoreApplication::translate("Targeting", text); }

tl::unexpected<core::Error> movesUsedUp(const Recentred& last) {
    return core::fail(ErrorKind::kNotReached,
                      sentence("After %1 moves the target is still %2 px off the reticle.")
                          .arg(last.moves)
                          .arg(last.residual_px.norm(), 0, 'f', 2),
                      sentence("Check the rig profile, then click the target again."), "moves");
}

tl::unexpected<core::Error> movesAway(double residual_px) {
    return core::fail(ErrorKind::kNotReached,
                      sentence("The target moves away from the reticle (%1 px).").arg(residual_px, 0, 'f', 1),
                      sentence("Check the rig profile, above all the kind of mount."), "diverged");
}

}  // namespace

/// What a re-centring knows while it runs.
struct Recentring::Search {
    Click click;
    Patch patch;
    LocalMotion motion;
    Pointing at;  ///< readings after the last move
    core::Duration arrived_at{0};
    int moves = 0;
    Eigen::Vector2d predicted_px = Eigen::Vector2d::Zero();  ///< by the rig model, before the look
    double radius_px = 0;
    Match match;  ///< of the last look
    camera::FramePtr frame;
};

Recentring::Recentring(instrument::TotalStation& station, FrameAfter frame_after, FindPatch find,
                       PixelToPointing model, core::Clock& clock, RecentringSettings settings)
    : station_(station),
      frame_after_(std::move(frame_after)),
      find_(std::move(find)),
      model_(std::move(model)),
      clock_(clock),
      settings_(settings) {}

void Recentring::report(RecentringStep step) const {
    if (on_step) {
        on_step(step);
    }
}

bool Recentring::isSettled(const Recentred& step) const {
    return step.residual_px.norm() <= settings_.tolerance_px || step.residual <= settings_.tolerance;
}

Result<Recentred> Recentring::judged(const Search& search) const {
    const auto reticle = model_.reticlePixel(search.at, search.click.slope_distance_m);
    PMTS_TRY(reticle);
    const auto spot = model_.pointingForPixel(search.match.px, search.at, search.click.slope_distance_m);
    PMTS_TRY(spot);
    return Recentred{.pointing = search.at,
                     .residual_px = search.match.px - *reticle,
                     .residual = geometry::separation(*spot, search.at),
                     .score = search.match.score,
                     .runner_up = search.match.runner_up,
                     .sigma_px = search.match.sigma_px,
                     .moves = search.moves,
                     .before = search.click.frame,
                     .after = search.frame,
                     .spot_px = search.match.px};
}

Result<Pointing> Recentring::nextTarget(const Search& search) const {
    const auto reticle = model_.reticlePixel(search.at, search.click.slope_distance_m);
    PMTS_TRY(reticle);
    const Eigen::Vector2d off_px = search.motion.asModelled(search.match.px - *reticle);
    return pointingOf(*reticle + off_px, search.at, search.click.slope_distance_m);
}

/// In the face the telescope is in.
Result<Pointing> Recentring::pointingOf(const Eigen::Vector2d& px, const Pointing& at, double range_m) const {
    return model_.pointingForPixel(px, at, range_m).map([&at](const Pointing& pointing) {
        return geometry::inFaceOf(at, pointing);
    });
}

core::Task<Result<Pointing>> Recentring::move(Pointing target, std::stop_token stop) const {
    return guardedTurn(station_, may_turn, target, settings_.turn_tolerance, std::move(stop));
}

/// Finds the patch in settled frames after the arrival.
core::Task<Result<void>> Recentring::look(std::shared_ptr<Search> search, std::stop_token stop) {
    const Click& click = search->click;
    const auto predicted = carried(model_, click.px, click.at, search->at, click.slope_distance_m);
    PMTS_CO_TRY(predicted);
    const Look order{.patch = search->patch,
                     .expected = carriedExpectation(model_, click.at, search->at, click.slope_distance_m,
                                                    search->predicted_px - *predicted, search->radius_px),
                     .since = search->arrived_at,
                     .still_px = settings_.still_px,
                     .most_frames = settings_.most_frames};
    auto looking = settledMatch(order, frame_after_, find_, stop);
    const auto settled = co_await looking;
    PMTS_CO_TRY(settled);
    search->match = settled->match;
    search->frame = settled->frame;
    co_return Result<void>();
}

core::Task<Result<Recentred>> Recentring::turnTo(Click click, std::stop_token stop) {
    std::optional<Patch> patch = click.patch;
    if (!patch) {
        auto taken = co_await find_.take(click.frame, click.px);
        PMTS_CO_TRY(taken);
        patch = *taken;
    }
    auto target = click.first_target ? Result<Pointing>(*click.first_target)
                                     : pointingOf(click.px, click.at, click.slope_distance_m);
    PMTS_CO_TRY(target);
    const auto search = std::make_shared<Search>();
    search->click = click;
    search->patch = *patch;
    search->at = click.at;
    search->radius_px = settings_.search_radius_px;
    search->match.px = click.px;
    std::optional<Recentred> before;
    while (search->moves < settings_.most_moves) {
        const Eigen::Vector2d from_px = search->match.px;
        const Pointing from = search->at;
        ++search->moves;
        report({.stage = RecentringStage::kTurning, .move = search->moves, .target = *target, .matched = {}});
        auto arrived = co_await move(*target, stop);
        PMTS_CO_TRY(arrived);
        search->at = *arrived;
        search->arrived_at = clock_.now();
        const auto predicted = carried(model_, from_px, from, search->at, click.slope_distance_m);
        PMTS_CO_TRY(predicted);
        search->predicted_px = *predicted;
        report({.stage = RecentringStage::kLooking, .move = search->moves, .target = *target, .matched = {}});
        auto looking = look(search, stop);
        PMTS_CO_TRY(co_await looking);
        search->motion.learn(*predicted - from_px, search->match.px - from_px);
        search->radius_px = std::min(search->radius_px, 24.0);
        auto step = judged(*search);
        PMTS_CO_TRY(step);
        report(
            {.stage = RecentringStage::kMatched, .move = search->moves, .target = *target, .matched = *step});
        if (isSettled(*step)) {
            co_return *step;
        }
        if (before && step->residual_px.norm() > before->residual_px.norm() + settings_.tolerance_px) {
            co_return movesAway(step->residual_px.norm());
        }
        before = *step;
        target = nextTarget(*search);
        PMTS_CO_TRY(target);
    }
    co_return movesUsedUp(*before);
}

}  // namespace pmts::targeting
