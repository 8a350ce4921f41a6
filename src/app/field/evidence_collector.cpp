#include "pmts/app/field/evidence_collector.hpp"

#include "pmts/app/desk/frame_image.hpp"
#include "pmts/geometry/polar.hpp"

#include <algorithm>

namespace pmts::app {

namespace {

constexpr QSize kThumbnail(240, 180);
constexpr core::Angle kSameTarget = core::Angle::fromMgon(10);  ///< servo and reading noise stay well below

/// As the job keeps it, the same in every language.
QString keptName(targeting::Method method) {
    switch (method) {
        case targeting::Method::kApa: return QStringLiteral("APA");
        case targeting::Method::kTpa: return QStringLiteral("TPA");
        case targeting::Method::kOatpa: return QStringLiteral("OATPA");
        case targeting::Method::kRectifiedOatpa: return QStringLiteral("rectified OATPA");
        case targeting::Method::kRigorous: break;
    }
    return QStringLiteral("rigorous");
}

QString keptName(RangeSource source) {
    switch (source) {
        case RangeSource::kMeasured: return QStringLiteral("measured");
        case RangeSource::kPlane: return QStringLiteral("plane");
        case RangeSource::kPlanned: return QStringLiteral("planned");
        case RangeSource::kLastShot: return QStringLiteral("last shot");
        case RangeSource::kAssumed: break;
    }
    return QStringLiteral("assumed");
}

/// A part of a picture and the way from its pixels to the part's.
struct Cutting {
    QImage image;
    QPointF origin;

    Cutting(const camera::FramePtr& frame, const QPointF& middle_px) {
        const QImage whole = imageOfFrame(frame);
        QRect part(QPoint(), kThumbnail);
        part.moveCenter(middle_px.toPoint());
        part.moveLeft(std::clamp(part.left(), 0, std::max(0, whole.width() - part.width())));
        part.moveTop(std::clamp(part.top(), 0, std::max(0, whole.height() - part.height())));
        image = whole.copy(part.intersected(whole.rect()));
        origin = part.topLeft();
    }
    [[nodiscard]] std::optional<QPointF> inside(const std::optional<QPointF>& px) const {
        const bool is_inside = px && QRectF(image.rect()).contains(*px - origin);
        return is_inside ? std::optional(*px - origin) : std::nullopt;
    }
};

QPointF pointF(const Eigen::Vector2d& px) { return {px.x(), px.y()}; }

}  // namespace

EvidenceCollector::EvidenceCollector(const TargetingPresenter& targeting, const LivePresenter& live,
                                     const Preferences& preferences, const core::Clock& clock)
    : targeting_(targeting), live_(live), preferences_(preferences), clock_(clock) {}

const Target* EvidenceCollector::targetOf(const geometry::Pointing& shot) const {
    const auto& target = targeting_.target();
    const bool was_reached = target && target->click && target->state == MoveState::kArrived &&
                             geometry::separation(target->pointing, shot) <= kSameTarget;
    return was_reached ? &*target : nullptr;
}

std::optional<EvidenceShots> EvidenceCollector::collect(const geometry::Pointing& shot) const {
    if (!live_.scene().frame) {
        return std::nullopt;
    }
    EvidenceShots shots;
    shots.evidence.method = QStringLiteral("eye");
    shots.evidence.pointing = shot;
    shots.evidence.utc = clock_.utcNow();
    shots.evidence.slope_distance_m = live_.scene().range.slope_distance_m;
    shots.evidence.slope_distance_source = keptName(live_.scene().range.source);
    const Target* const target = targetOf(shot);
    if (target) {
        addClick(shots, *target);
    }
    if (target && target->proof) {
        addProof(shots, *target->proof);
    } else {
        addPicture(shots, shot);
    }
    return shots;
}

void EvidenceCollector::addClick(EvidenceShots& shots, const Target& target) const {
    const AimingSettings& aiming = preferences_.settings().aiming;
    shots.evidence.method = keptName(target.method);
    shots.evidence.moves = 1;
    shots.evidence.pointing = target.pointing;
    shots.evidence.tolerance_px = aiming.tolerance_px;
    shots.evidence.tolerance = aiming.tolerance;
    shots.evidence.slope_distance_m = target.range.slope_distance_m;
    shots.evidence.slope_distance_source = keptName(target.range.source);
    const QPointF spot_px = pointF(target.click->px);
    const Cutting before(target.click->frame, spot_px);
    shots.before = before.image;
    shots.evidence.before.spot_px = before.inside(spot_px);
    shots.evidence.before.reticle_px = before.inside(live_.reticleFor(target.click->at));
}

void EvidenceCollector::addProof(EvidenceShots& shots, const targeting::Recentred& proof) const {
    job::Evidence& evidence = shots.evidence;
    evidence.recentred = true;
    evidence.residual_x_px = proof.residual_px.x();
    evidence.residual_y_px = proof.residual_px.y();
    evidence.residual = proof.residual;
    evidence.score = proof.score;
    evidence.runner_up = proof.runner_up;
    evidence.sigma_px = proof.sigma_px;
    evidence.moves = proof.moves;
    const QPointF spot_px = pointF(proof.spot_px);
    const Cutting after(proof.after, spot_px);
    shots.after = after.image;
    evidence.after.spot_px = after.inside(spot_px);
    evidence.after.reticle_px = after.inside(spot_px - pointF(proof.residual_px));
}

void EvidenceCollector::addPicture(EvidenceShots& shots, const geometry::Pointing& shot) const {
    const auto reticle_px = live_.reticleFor(shot);
    const camera::FramePtr& frame = live_.scene().frame;
    const Cutting after(frame, reticle_px.value_or(QPointF(frame->image.cols, frame->image.rows) / 2));
    shots.after = after.image;
    shots.evidence.after.reticle_px = after.inside(reticle_px);
}

}  // namespace pmts::app
