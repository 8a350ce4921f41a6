#include "pmts/app/field/range_presenter.hpp"

#include "pmts/app/desk/live_presenter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::app {

namespace {

constexpr double kNearest_m = 1.0;
constexpr double kFarthest_m = 1000.0;

double rangeAtStep(int step) {
    return kNearest_m * std::pow(kFarthest_m / kNearest_m, static_cast<double>(step) / RangePresenter::kDepthSteps);
}

int stepOf(double range_m) {
    const double part = std::log(range_m / kNearest_m) / std::log(kFarthest_m / kNearest_m);
    return std::clamp(static_cast<int>(std::lround(part * RangePresenter::kDepthSteps)), 0, RangePresenter::kDepthSteps);
}

}  // namespace

RangePresenter::RangePresenter(RangeKeeper& range, Preferences& preferences, QObject* parent)
    : QObject(parent), range_(range), preferences_(preferences) {
    connect(&range_, &RangeKeeper::changed, this, &RangePresenter::changed);
    connect(&preferences_, &Preferences::changed, this, &RangePresenter::changed);
}

QString RangePresenter::text(Field field) const {
    const Settings& settings = preferences_.settings();
    switch (field) {
        case Field::kAssumed: return settings.units.length(settings.assumed_range_m);
        case Field::kNear: return settings.units.length(settings.image_tools.parallax_near_m);
        case Field::kFar: break;
    }
    return settings.units.length(settings.image_tools.parallax_far_m);
}

QString RangePresenter::inUseText() const {
    if (range_.plane()) {
        return tr("from the plane of the chosen points");
    }
    return rangeText(range_.rangeAt(std::nullopt), preferences_.units());
}

bool RangePresenter::hasShot() const {
    return range_.plane() || range_.rangeAt(std::nullopt).source != RangeSource::kAssumed;
}

core::Result<double> RangePresenter::rangeFrom(const QString& text) const {
    const auto range_m = preferences_.units().parseLengthM(text);
    PMTS_TRY(range_m);
    constexpr double kLeast = ImageToolSettings::kShortest_m;
    constexpr double kMost = ImageToolSettings::kLongest_m;
    if (!(*range_m >= kLeast && *range_m <= kMost)) {
        const UnitFormat& units = preferences_.units();
        return core::fail(core::ErrorKind::kLimit, tr("A range of “%1” is not possible.").arg(text),
                          tr("Type a length from %1 to %2.").arg(units.length(kLeast), units.length(kMost)));
    }
    return *range_m;
}

void RangePresenter::setTexts(const QString& assumed, const QString& near_end, const QString& far_end) {
    const std::array<std::pair<Field, QString>, 3> typed{
        {{Field::kAssumed, assumed}, {Field::kNear, near_end}, {Field::kFar, far_end}}};
    std::array<double, 3> range_m{};
    for (std::size_t i = 0; i < typed.size(); ++i) {
        const auto read_m = rangeFrom(typed[i].second);
        if (!read_m) {
            Q_EMIT rejected(typed[i].first, read_m.error());
            return;
        }
        range_m[i] = *read_m;
    }
    if (range_m[1] >= range_m[2]) {
        Q_EMIT rejected(Field::kFar, {.kind = core::ErrorKind::kLimit,
                                      .happened = tr("The far end is not farther than the near end."),
                                      .remedy = tr("Type a longer range for the far end."),
                                      .info_code = std::nullopt,
                                      .detail = {}});
        return;
    }
    Settings next = preferences_.settings();
    next.assumed_range_m = range_m[0];
    next.image_tools.parallax_near_m = range_m[1];
    next.image_tools.parallax_far_m = range_m[2];
    preferences_.set(next);
    if (range_.assumed() != range_m[0]) {
        range_.setAssumed(range_m[0]);
    }
    Q_EMIT accepted();
}

void RangePresenter::forgetShot() { range_.forgetAll(); }

void RangePresenter::setDepthSteps(int near_step, int far_step) {
    Settings next = preferences_.settings();
    DepthFilter& depth = next.image_tools.depth;
    depth.near_m = near_step <= 0 ? std::nullopt : std::optional(rangeAtStep(near_step));
    depth.far_m = far_step >= kDepthSteps ? std::nullopt : std::optional(rangeAtStep(far_step));
    preferences_.set(next);
}

int RangePresenter::nearStep() const {
    const auto& near_m = preferences_.settings().image_tools.depth.near_m;
    return near_m ? stepOf(*near_m) : 0;
}

int RangePresenter::farStep() const {
    const auto& far_m = preferences_.settings().image_tools.depth.far_m;
    return far_m ? stepOf(*far_m) : kDepthSteps;
}

QString RangePresenter::nearText() const {
    const auto& near_m = preferences_.settings().image_tools.depth.near_m;
    return near_m ? tr("from %1").arg(shortRangeText(*near_m, preferences_.units())) : tr("from the instrument");
}

QString RangePresenter::farText() const {
    const auto& far_m = preferences_.settings().image_tools.depth.far_m;
    return far_m ? tr("to %1").arg(shortRangeText(*far_m, preferences_.units())) : tr("no end");
}

}  // namespace pmts::app
