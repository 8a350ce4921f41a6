#include "pmts/targeting/spot_sweep.hpp"

#include "guarded_turn.hpp"
#include "pmts/geometry/polar.hpp"
#include "settled_match.hpp"

#include <QCoreApplication>

namespace pmts::targeting {
namespace {

using core::ErrorKind;
using core::Result;
using geometry::Pointing;

constexpr double kOtherFace_px = 1e4;  // further than any sighting of the same face

QString sentence(const char* text) { return QCoreApplication::translate("Targeting", text); }

/// Trouble of one pointing; anything else is trouble of the whole sweep.
bool isOfThePointing(const core::Error& error) {
    return error.kind == ErrorKind::kNotReached || error.kind == ErrorKind::kUndefined ||
           error.kind == ErrorKind::kLimit;
}

/// Matches that another look of the spot may mend.
bool looksDifferent(const core::Error& error) {
    return error.detail.startsWith(QLatin1String("lost")) || error.detail.startsWith(QLatin1String("torn")) ||
           error.detail.startsWith(QLatin1String("ambiguous"));
}

}  // namespace

/// Where and how the spot was seen.
struct SpotSweep::Known {
    Pointing at;
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    camera::FramePtr frame;
};

struct SpotSweep::Course {
    Click click;
    Patch patch;
    std::vector<Pointing> pointings;
    std::vector<Known> known;  ///< the click first
    SweepOutcome outcome;
    int misses_in_a_row = 0;
};

SpotSweep::SpotSweep(instrument::TotalStation& station, FrameAfter frame_after, FindPatch find,
                     PixelToPointing model, core::Clock& clock, SweepSettings settings)
    : station_(station),
      frame_after_(std::move(frame_after)),
      find_(std::move(find)),
      model_(std::move(model)),
      clock_(clock),
      settings_(settings) {}

core::Task<Result<Pointing>> SpotSweep::turn(Pointing target, std::stop_token stop) const {
    return guardedTurn(station_, may_turn, target, settings_.turn_tolerance, std::move(stop));
}

/// The sighting whose promise for this pointing moves the spot least: there the model's errors matter least. One
/// of the other face is upside down and shows what is wrong with the camera's rotations twice.
Result<SpotSweep::Known> SpotSweep::nearest(const Course& course, const Pointing& at) const {
    std::optional<Known> best;
    double least_px = std::numeric_limits<double>::infinity();
    for (const Known& known : course.known) {
        const auto px = carried(model_, known.px, known.at, at, course.click.slope_distance_m);
        if (!px) {
            continue;
        }
        const bool upside_down = geometry::isFaceTwo(known.at) != geometry::isFaceTwo(at);
        const double moved_px = (*px - known.px).norm() + (upside_down ? kOtherFace_px : 0.0);
        if (moved_px < least_px) {
            least_px = moved_px;
            best = known;
        }
    }
    if (!best) {
        return core::fail(ErrorKind::kNotReached, sentence("From here the spot cannot be in the picture."),
                          sentence("Choose smaller turns."), "outside");
    }
    return *best;
}

core::Task<Result<SpotSighting>> SpotSweep::sight(std::shared_ptr<Course> course, std::size_t index,
                                                  std::stop_token stop) {
    auto arrived = co_await turn(course->pointings[index], stop);
    PMTS_CO_TRY(arrived);
    const auto base = nearest(*course, *arrived);
    PMTS_CO_TRY(base);
    const Click& click = course->click;
    const auto promised = carried(model_, base->px, base->at, *arrived, click.slope_distance_m);
    PMTS_CO_TRY(promised);
    const auto by_click = carried(model_, click.px, click.at, *arrived, click.slope_distance_m);
    PMTS_CO_TRY(by_click);
    const core::Duration since = clock_.now();
    const Look look{.patch = course->patch,
                    .expected = carriedExpectation(model_, click.at, *arrived, click.slope_distance_m,
                                                   *promised - *by_click, settings_.search_radius_px),
                    .since = since,
                    .still_px = settings_.still_px,
                    .most_frames = settings_.most_frames};
    auto looking = settledMatch(look, frame_after_, find_, stop);
    auto settled = co_await looking;
    bool relayed = false;
    if (!settled && looksDifferent(settled.error()) && base->frame != click.frame) {
        auto taken = co_await find_.take(base->frame, base->px);
        PMTS_CO_TRY(taken);
        Look again = look;
        again.patch = *taken;
        again.expected = carriedExpectation(model_, base->at, *arrived, click.slope_distance_m,
                                            Eigen::Vector2d::Zero(), settings_.search_radius_px);
        auto looking_again = settledMatch(again, frame_after_, find_, stop);
        settled = co_await looking_again;
        relayed = true;
    }
    PMTS_CO_TRY(settled);
    course->known.push_back({*arrived, settled->match.px, settled->frame});
    co_return SpotSighting{.index = index,
                           .at = *arrived,
                           .px = settled->match.px,
                           .score = settled->match.score,
                           .sigma_px = settled->match.sigma_px,
                           .frame = settled->frame,
                           .relayed = relayed};
}

/// Takes a sighting or a miss into the outcome; fails when the sweep must end.
Result<void> SpotSweep::keep(Course& course, std::size_t index, const Result<SpotSighting>& sighted) const {
    SweepStep step{.done = index + 1, .of = course.pointings.size(), .sighting = {}, .missed = {}};
    if (sighted) {
        course.misses_in_a_row = 0;
        step.sighting = *sighted;
        course.outcome.sightings.push_back(*sighted);
    } else if (isOfThePointing(sighted.error())) {
        step.missed = MissedPointing{index, sighted.error()};
        course.outcome.missed.push_back(*step.missed);
        if (++course.misses_in_a_row >= settings_.most_misses) {
            return core::fail(ErrorKind::kNotReached,
                              sentence("The spot was not found from %1 pointings in a row: %2")
                                  .arg(course.misses_in_a_row)
                                  .arg(sighted.error().happened),
                              sentence("Click a sharp spot with nothing similar near it, then start again."),
                              "misses");
        }
    } else {
        return tl::unexpected(sighted.error());
    }
    if (on_step) {
        on_step(step);
    }
    return {};
}

core::Task<Result<SweepOutcome>> SpotSweep::run(Click click, std::vector<Pointing> pointings, std::stop_token stop) {
    std::optional<Patch> patch = click.patch;
    if (!patch) {
        auto taken = co_await find_.take(click.frame, click.px);
        PMTS_CO_TRY(taken);
        patch = *taken;
    }
    const auto course = std::make_shared<Course>();
    course->patch = *patch;
    course->pointings = std::move(pointings);
    course->known.push_back({click.at, click.px, click.frame});
    for (const SpotSighting& sighting : seen_before) {
        if (sighting.frame) {
            course->known.push_back({sighting.at, sighting.px, sighting.frame});
        }
    }
    course->click = std::move(click);
    Result<void> kept;
    for (std::size_t index = 0; kept && index < course->pointings.size(); ++index) {
        auto sighting = sight(course, index, stop);
        const auto sighted = co_await sighting;
        kept = keep(*course, index, sighted);
    }
    if (!kept && kept.error().kind != ErrorKind::kNotReached) {
        co_return tl::unexpected(kept.error());
    }
    if (settings_.come_back) {
        auto back = co_await turn(course->click.at, stop);
        PMTS_CO_TRY(back);
    }
    PMTS_CO_TRY(kept);
    co_return course->outcome;
}

}  // namespace pmts::targeting
