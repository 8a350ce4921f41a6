// What the recording presenter calls the next point: ID, code, remark, target height.
#include "desk/message_topics.hpp"
#include "pmts/app/field/recording_presenter.hpp"

namespace pmts::app {

namespace {

constexpr int kCodeButtons = 7;
constexpr int kRecentCodes = 20;

}  // namespace

QString RecordingPresenter::targetHeightText() const {
    return preferences_.units().length(preferences_.settings().target_height_m);
}

QStringList RecordingPresenter::codeButtons() const {
    QStringList codes = points_.codes();
    for (const QString& code : preferences_.settings().recent_codes) {
        if (!codes.contains(code)) {
            codes.append(code);
        }
    }
    return codes.mid(0, kCodeButtons);
}

void RecordingPresenter::onOpened(const JobContents& contents) {
    QString next = contents.meta.value(QStringLiteral("next_point_id"));
    if (next.isEmpty()) {
        next = contents.points.empty() ? QStringLiteral("1") : survey::nextPointId(contents.points.back().id);
    }
    proposeId(next);
    code_ = contents.meta.value(QStringLiteral("last_code"));
    remark_.clear();
    Q_EMIT nextPointChanged();
    Q_EMIT codesChanged();
}

void RecordingPresenter::setPointId(const QString& id) {
    if (!id.trimmed().isEmpty() && id.trimmed() != point_id_) {
        point_id_ = id.trimmed();
        id_is_typed_ = true;
        messages_.solve(kUsedIdTopic);
    }
    Q_EMIT nextPointChanged();
}

/// From here on, the first ID that is not used in the job.
void RecordingPresenter::proposeId(const QString& from) {
    id_is_typed_ = false;
    const QString free = survey::freePointId(from, [this](const QString& id) { return points_.isIdUsed(id); });
    if (free != point_id_) {
        point_id_ = free;
        Q_EMIT nextPointChanged();
    }
}

void RecordingPresenter::setCode(const QString& code) {
    code_ = code.trimmed();
    Q_EMIT nextPointChanged();
}

void RecordingPresenter::setRemark(const QString& remark) {
    remark_ = remark;
    Q_EMIT nextPointChanged();
}

void RecordingPresenter::rememberCode(const QString& code) {
    if (code.isEmpty() || preferences_.settings().recent_codes.contains(code)) {
        return;
    }
    Settings next = preferences_.settings();
    next.recent_codes.prepend(code);
    next.recent_codes = next.recent_codes.mid(0, kRecentCodes);
    preferences_.set(next);
}

void RecordingPresenter::setTargetHeightText(const QString& text) {
    const auto height_m = preferences_.units().parseLengthM(text);
    if (!height_m) {
        Q_EMIT targetHeightRejected(height_m.error());
        return;
    }
    Settings next = preferences_.settings();
    next.target_height_m = *height_m;
    preferences_.set(next);
    if (observation_ && readings_.shot != ShotState::kRecording && readings_.shot != ShotState::kRecorded) {
        observation_->target_height_m = *height_m;
        reconvert();
    }
    Q_EMIT nextPointChanged();
}

}  // namespace pmts::app
