#include "settled_match.hpp"

#include "pmts/geometry/polar.hpp"

#include <QCoreApplication>

namespace pmts::targeting {
namespace {

using core::ErrorKind;
using core::Result;

QString sentence(const char* text) { return QCoreApplication::translate("Targeting", text); }

core::Task<Result<camera::FramePtr>> newFrame(FrameAfter frame_after, core::Duration since, int most_frames,
                                              std::stop_token stop) {
    for (int asked = 0; asked < most_frames; ++asked) {
        auto frame = co_await frame_after(since, stop);
        PMTS_CO_TRY(frame);
        if (stop.stop_requested()) {
            co_return core::cancelled();
        }
        if (*frame && (*frame)->captured_at > since) {
            co_return frame;
        }
    }
    co_return core::fail(ErrorKind::kCamera, sentence("The camera gives only old pictures."),
                         sentence("Check the camera, then click the target again."));
}

}  // namespace

core::Task<Result<SettledMatch>> settledMatch(Look look, FrameAfter frame_after, FindPatch find,
                                              std::stop_token stop) {
    core::Duration since = look.since;
    std::optional<Match> last;
    for (int looks = 0; looks < look.most_frames; ++looks) {
        auto frame = co_await newFrame(frame_after, since, look.most_frames, stop);
        PMTS_CO_TRY(frame);
        since = (*frame)->captured_at;
        auto match = co_await find.find(look.patch, *frame, look.expected);
        PMTS_CO_TRY(match);
        if (last && (match->px - last->px).norm() <= look.still_px) {
            match->px = 0.5 * (match->px + last->px);
            match->score = std::min(match->score, last->score);
            co_return SettledMatch{.match = *match, .frame = *frame};
        }
        last = *match;
    }
    co_return core::fail(ErrorKind::kNotReached, sentence("The picture does not come to rest."),
                         sentence("Shield the instrument from wind, or click something that does not move."),
                         "restless");
}

Result<Eigen::Vector2d> carried(const PixelToPointing& model, const Eigen::Vector2d& px,
                                const geometry::Pointing& then, const geometry::Pointing& now, double range_m) {
    const auto ray = model.rayForPixel(px, then);
    PMTS_TRY(ray);
    const auto p_station = geometry::intersectSphere(*ray, range_m);
    PMTS_TRY(p_station);
    return model.pixelForPoint(*p_station, now);
}

Expectation carriedExpectation(PixelToPointing model, geometry::Pointing then, geometry::Pointing now,
                               double range_m, Eigen::Vector2d known_off_px, double radius_px) {
    return {.seen = [model = std::move(model), then, now, range_m,
                     known_off_px](const Eigen::Vector2d& old_px) -> std::optional<Eigen::Vector2d> {
                const auto px = carried(model, old_px, then, now, range_m);
                return px ? std::optional<Eigen::Vector2d>(*px + known_off_px) : std::nullopt;
            },
            .search_radius_px = radius_px};
}

}  // namespace pmts::targeting
