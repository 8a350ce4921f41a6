#include "row_fields.hpp"
#include "rows.hpp"

namespace pmts::job {
namespace {

/// The columns of one of the two pictures.
struct PictureColumns {
    const char *image, *spot_x, *spot_y, *reticle_x, *reticle_y;
};

constexpr PictureColumns kBefore{"before_image", "before_spot_x_px", "before_spot_y_px",
                                 "before_reticle_x_px", "before_reticle_y_px"};
constexpr PictureColumns kAfter{"after_image", "after_spot_x_px", "after_spot_y_px", "after_reticle_x_px",
                                "after_reticle_y_px"};

void setPlace(OGRFeature& row, const char* x, const char* y, const std::optional<QPointF>& px) {
    setNumber(row, x, px ? std::optional(px->x()) : std::nullopt);
    setNumber(row, y, px ? std::optional(px->y()) : std::nullopt);
}

std::optional<QPointF> placeOf(const OGRFeature& row, const char* x, const char* y) {
    const auto x_px = numberOf(row, x);
    const auto y_px = numberOf(row, y);
    return x_px && y_px ? std::optional(QPointF(*x_px, *y_px)) : std::nullopt;
}

void fillPicture(OGRFeature& row, const EvidencePicture& picture, const PictureColumns& columns) {
    setBytes(row, columns.image, picture.encoded_image);
    setPlace(row, columns.spot_x, columns.spot_y, picture.spot_px);
    setPlace(row, columns.reticle_x, columns.reticle_y, picture.reticle_px);
}

EvidencePicture pictureOf(const OGRFeature& row, const PictureColumns& columns) {
    return {.encoded_image = bytesOf(row, columns.image),
            .spot_px = placeOf(row, columns.spot_x, columns.spot_y),
            .reticle_px = placeOf(row, columns.reticle_x, columns.reticle_y)};
}

}  // namespace

void fillEvidence(OGRFeature& row, const Evidence& evidence, qint64 point_row) {
    row.SetField("point_row", static_cast<GIntBig>(point_row));
    setText(row, "method", evidence.method);
    row.SetField("recentred", evidence.recentred ? 1 : 0);
    setPointing(row, evidence.pointing);
    setNumber(row, "residual_x_px", evidence.residual_x_px);
    setNumber(row, "residual_y_px", evidence.residual_y_px);
    setNumber(row, "residual_gon",
              evidence.residual ? std::optional(evidence.residual->gon()) : std::nullopt);
    row.SetField("tolerance_px", evidence.tolerance_px);
    row.SetField("tolerance_gon", evidence.tolerance.gon());
    setNumber(row, "score", evidence.score);
    setNumber(row, "runner_up", evidence.runner_up);
    setNumber(row, "sigma_px", evidence.sigma_px);
    row.SetField("moves", evidence.moves);
    row.SetField("sd_m", evidence.slope_distance_m);
    setText(row, "sd_source", evidence.slope_distance_source);
    setTime(row, "time_utc", evidence.utc);
    fillPicture(row, evidence.before, kBefore);
    fillPicture(row, evidence.after, kAfter);
}

Evidence evidenceOfRow(const OGRFeature& row) {
    Evidence evidence;
    evidence.row_id = row.GetFID();
    evidence.point_row = row.GetFieldAsInteger64("point_row");
    evidence.method = textOf(row, "method");
    evidence.recentred = row.GetFieldAsInteger("recentred") != 0;
    evidence.pointing = pointingOf(row);
    evidence.residual_x_px = numberOf(row, "residual_x_px");
    evidence.residual_y_px = numberOf(row, "residual_y_px");
    if (const auto residual_gon = numberOf(row, "residual_gon")) {
        evidence.residual = core::Angle::fromGon(*residual_gon);
    }
    evidence.tolerance_px = numberOf(row, "tolerance_px").value_or(0.0);
    evidence.tolerance = angleOf(row, "tolerance_gon");
    evidence.score = numberOf(row, "score");
    evidence.runner_up = numberOf(row, "runner_up");
    evidence.sigma_px = numberOf(row, "sigma_px");
    evidence.moves = row.GetFieldAsInteger("moves");
    evidence.slope_distance_m = numberOf(row, "sd_m").value_or(0.0);
    evidence.slope_distance_source = textOf(row, "sd_source");
    evidence.utc = timeOf(row, "time_utc");
    evidence.before = pictureOf(row, kBefore);
    evidence.after = pictureOf(row, kAfter);
    return evidence;
}

}  // namespace pmts::job
