#include "pmts/app/field/evidence_presenter.hpp"

#include <cmath>

namespace pmts::app {

namespace {

const QString kTopic = QStringLiteral("evidence");

QString say(const char* sentence) { return EvidencePresenter::tr(sentence); }

QString pixels(double px) { return say("%1 px").arg(px, 0, 'f', 2); }

QString timeText(const QDateTime& utc) {
    return utc.isValid() ? utc.toUTC().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")) + say(" UTC")
                         : QString();
}

std::optional<double> residualPx(const job::Evidence& evidence) {
    return evidence.residual_x_px && evidence.residual_y_px
               ? std::optional(std::hypot(*evidence.residual_x_px, *evidence.residual_y_px))
               : std::nullopt;
}

QString residualText(const job::Evidence& evidence, const UnitFormat& units) {
    QStringList parts;
    if (const auto px = residualPx(evidence)) {
        parts += pixels(*px);
    }
    if (evidence.residual) {
        parts += units.angle(*evidence.residual);
    }
    return parts.join(QStringLiteral("  =  "));
}

QString verdictOf(const job::Evidence& evidence, const UnitFormat& units) {
    const QString residual = residualText(evidence, units);
    if (residual.isEmpty()) {
        return say("Aimed by %1 without looking again: no picture says where the telescope came to point.")
            .arg(evidence.method);
    }
    const QString moves = evidence.moves == 1 ? say("one move") : say("%1 moves").arg(evidence.moves);
    return say("After %1 the spot was %2 off the reticle.").arg(moves, residual);
}

std::vector<EvidenceLine> placeLines(const survey::Point& point, const UnitFormat& units) {
    if (!hasCoordinates(point)) {
        return {{say("Place"), point.observation.absurd_reason.isEmpty()
                                   ? say("no distance was measured")
                                   : say("absurd: %1").arg(point.observation.absurd_reason)}};
    }
    const survey::Coordinates& at = point.coordinates;
    const auto line = [&](const QString& label, double metres, double sigma_m) {
        return EvidenceLine{label, units.length(metres) + QStringLiteral("   ") + units.precision(sigma_m)};
    };
    return {line(say("E"), at.e_m, at.sigma_e_m), line(say("N"), at.n_m, at.sigma_n_m),
            line(say("H"), at.h_m, at.sigma_h_m)};
}

std::vector<EvidenceLine> observationLines(const survey::Observation& shot, const UnitFormat& units) {
    std::vector<EvidenceLine> lines{{say("HA"), units.direction(shot.pointing.ha)},
                                    {say("VA"), units.angle(shot.pointing.va)}};
    if (shot.slope_distance_m) {
        lines.push_back(
            {say("SD"), units.length(*shot.slope_distance_m) + QStringLiteral("   ") + shot.edm_mode});
    }
    lines.push_back({say("Target height"), units.length(shot.target_height_m)});
    lines.push_back({say("Measured"), timeText(shot.utc)});
    return lines;
}

std::vector<EvidenceLine> matchLines(const job::Evidence& evidence, const UnitFormat& units) {
    std::vector<EvidenceLine> lines;
    if (evidence.residual_x_px && evidence.residual_y_px) {
        lines.push_back(
            {say("Residual, right and down"),
             pixels(*evidence.residual_x_px) + QStringLiteral(",  ") + pixels(*evidence.residual_y_px)});
    }
    if (const QString residual = residualText(evidence, units); !residual.isEmpty()) {
        lines.push_back({say("Residual"), residual});
        lines.push_back(
            {say("Tolerance"),
             say("%1 or %2").arg(pixels(evidence.tolerance_px), units.angle(evidence.tolerance))});
    }
    if (evidence.score) {
        lines.push_back({say("Match score"), QString::number(*evidence.score, 'f', 3)});
    }
    if (evidence.runner_up) {
        lines.push_back({say("Best of anything else"), QString::number(*evidence.runner_up, 'f', 3)});
    }
    if (evidence.sigma_px) {
        lines.push_back({say("Match, one sigma"), say("%1 px").arg(*evidence.sigma_px, 0, 'f', 3)});
    }
    return lines;
}

std::vector<EvidenceLine> aimingLines(const job::Evidence& evidence, const UnitFormat& units) {
    std::vector<EvidenceLine> lines{{say("Method"), evidence.recentred
                                                        ? say("%1, re-centred").arg(evidence.method)
                                                        : say("%1, open loop").arg(evidence.method)}};
    if (const QString error = EvidencePresenter::knownError(evidence.method); !error.isEmpty()) {
        lines.push_back({say("Known error"), error});
    }
    for (EvidenceLine& line : matchLines(evidence, units)) {
        lines.push_back(std::move(line));
    }
    lines.push_back({say("Moves"), QString::number(evidence.moves)});
    lines.push_back(
        {say("Circles after the last"),
         say("HA %1, VA %2").arg(units.direction(evidence.pointing.ha), units.angle(evidence.pointing.va))});
    lines.push_back({say("Reticle drawn for"), say("%1 (%2)").arg(units.length(evidence.slope_distance_m),
                                                                  evidence.slope_distance_source)});
    lines.push_back({say("Aimed"), timeText(evidence.utc)});
    return lines;
}

QString subtitleOf(const survey::Point& point) {
    QStringList parts;
    for (const QString& part : {point.code, point.remark}) {
        if (!part.isEmpty()) {
            parts += part;
        }
    }
    parts += say("station %1").arg(point.station_name);
    if (point.struck_out) {
        parts += say("struck out");
    }
    return parts.join(QStringLiteral("  ·  "));
}

EvidenceThumbnail thumbnailOf(const job::EvidencePicture& picture, const QString& caption) {
    return {.caption = caption,
            .image = QImage::fromData(picture.encoded_image),
            .spot_px = picture.spot_px,
            .reticle_px = picture.reticle_px};
}

}  // namespace

EvidencePresenter::EvidencePresenter(JobDesk& job, const PointsModel& points, const Preferences& preferences,
                                     MessageCentre& messages, QObject* parent)
    : QObject(parent), job_(job), points_(points), preferences_(preferences), messages_(messages) {
    connect(&job_, &JobDesk::evidenceLoaded, this, &EvidencePresenter::onLoaded);
    connect(&job_, &JobDesk::opened, this, &EvidencePresenter::forget);
    connect(&job_, &JobDesk::closed, this, &EvidencePresenter::forget);
    connect(&job_, &JobDesk::requestFailed, this, [this](Ticket ticket, const core::Error& error) {
        if (ticket == ticket_) {
            messages_.report(error, MessageAction::kOpenJob, kTopic);
        }
    });
    connect(&points_, &PointsModel::pointsChanged, this, &EvidencePresenter::sheetChanged);
    connect(&preferences_, &Preferences::unitsChanged, this, &EvidencePresenter::sheetChanged);
}

QString EvidencePresenter::knownError(const QString& method) {
    const QString name = method.toLower();
    if (name == u"apa") {
        return tr("up to 1.47 gon on the thesis's photo");
    }
    if (name == u"tpa") {
        return tr("up to 1.76 gon on the thesis's photo: no distortion, no offset");
    }
    if (name == u"oatpa") {
        return tr("up to 1.71 gon on the thesis's photo: no distortion");
    }
    if (name.contains(u"rectified")) {
        return tr("up to 0.06 gon on the thesis's photo: angles are added");
    }
    return name == u"rigorous" ? tr("that of the calibrated rig: below 0.5 px open loop") : QString();
}

void EvidencePresenter::load(qint64 point_row) { ticket_ = job_.loadEvidence(point_row); }

void EvidencePresenter::onLoaded(Ticket ticket, qint64 point_row,
                                 const std::optional<job::Evidence>& evidence) {
    const survey::Point* const point = points_.find(point_row);
    if (ticket != ticket_ || !point) {
        return;
    }
    ticket_ = 0;
    messages_.solve(kTopic);
    if (!evidence) {
        messages_.toast(tr("Point %1 was not aimed by image: there is no evidence of it.").arg(point->id));
        return;
    }
    evidence_ = evidence;
    Q_EMIT sheetChanged();
    Q_EMIT loaded();
}

void EvidencePresenter::forget() {
    ticket_ = 0;
    evidence_.reset();
    Q_EMIT sheetChanged();
}

std::optional<EvidenceSheet> EvidencePresenter::sheet() const {
    const survey::Point* const point = evidence_ ? points_.find(evidence_->point_row) : nullptr;
    if (!point) {
        return std::nullopt;
    }
    const UnitFormat& units = preferences_.units();
    return EvidenceSheet{.point_row = point->row_id,
                         .job_name = job_.name(),
                         .point_id = point->id,
                         .subtitle = subtitleOf(*point),
                         .verdict = verdictOf(*evidence_, units),
                         .place = placeLines(*point, units),
                         .observation = observationLines(point->observation, units),
                         .aiming = aimingLines(*evidence_, units),
                         .before = thumbnailOf(evidence_->before, tr("Before: as it was clicked")),
                         .after = thumbnailOf(evidence_->after, tr("After the last move"))};
}

}  // namespace pmts::app
