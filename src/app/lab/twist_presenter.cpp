#include "pmts/app/lab/twist_presenter.hpp"


#include <algorithm>
#include <cmath>
#include <numeric>

namespace pmts::app {

namespace {

constexpr std::size_t kRecent = 3;
constexpr double kSeenAgain_gon = 0.02;  ///< farther, the camera is being turned: the old pictures say nothing
constexpr int kDrawnPlaces = 40;
constexpr double kCrooked_px = 0.5;

double medianOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace

TwistPresenter::TwistPresenter(LivePresenter& live, InstrumentDesk& instrument, Preferences& preferences, MessageCentre& messages,
                               Threading threading, QObject* parent)
    : QObject(parent), live_(live), instrument_(instrument), preferences_(preferences), messages_(messages),
      threading_(threading), frames_(live, instrument) {
    connect(&frames_, &StandingFrames::stood, this, &TwistPresenter::look);
    connect(&instrument_, &InstrumentDesk::connectionChanged, this, &TwistPresenter::changed);
}

void TwistPresenter::setActive(bool active) {
    is_active_ = active;
    frames_.setWanted(active);
    if (!active) {
        is_verifying_ = false;
        line_.clear();
    }
    Q_EMIT changed();
}

DeviceState TwistPresenter::state() const {
    if (is_verifying_) {
        return DeviceState::kBusy;
    }
    if (is_proved_) {
        return DeviceState::kGood;
    }
    if (!twist_) {
        return trouble_.isEmpty() ? DeviceState::kIdle : DeviceState::kFailed;
    }
    return isUpright() ? DeviceState::kGood : DeviceState::kWarning;
}

bool TwistPresenter::isUpright() const {
    const core::Angle known = is_known_ ? live_.model().rig().mount.twist : core::Angle();
    return twist_ && core::abs(*twist_ - known) <= tolerance_;
}

QString TwistPresenter::step() const {
    if (instrument_.connectionState() != ConnectionState::kConnected) {
        return tr("Connect the instrument: how a plumb line appears depends on the tilt.");
    }
    if (is_verifying_) {
        return tr("Leave everything alone: picture %1 of %2.").arg(proofs_gon_.size() + 1).arg(kProofs);
    }
    if (!twist_ && is_proved_) {
        return tr("The twist is verified. Bring the plumb line into the picture to look again.");
    }
    if (!twist_) {
        return trouble_.isEmpty() ? tr("Turn until the plumb line runs through the picture from top to bottom.") : trouble_;
    }
    if (newest_ && newest_->unrest_px > kCrooked_px) {
        return tr("The line looks bent by %1 px: let it come to rest, or calibrate the lens first.").arg(newest_->unrest_px, 0, 'f', 1);
    }
    if (isUpright()) {
        if (is_known_) {
            return tr("The rig knows this twist. Go on with the parallax.");
        }
        return is_proved_ ? tr("The camera is upright. Go on with the parallax.") : tr("Good. Tighten the screw, then press Verify.");
    }
    const QString amount = preferences_.units().angle(core::abs(*twist_));
    return twist_->gon() > 0 ? tr("Turn the camera anticlockwise by %1, seen from behind.").arg(amount)
                             : tr("Turn the camera clockwise by %1, seen from behind.").arg(amount);
}

QString TwistPresenter::twistText() const {
    return twist_ ? QStringLiteral("%1%2 mgon").arg(twist_->gon() > 0 ? QStringLiteral("+") : QString()).arg(twist_->mgon(), 0, 'f', 1)
                  : QStringLiteral("–");
}

QString TwistPresenter::qualityText() const {
    return newest_ && twist_ ? tr("± %1 mgon, line straight to %2 px").arg(newest_->sigma.mgon(), 0, 'f', 1).arg(newest_->unrest_px, 0, 'f', 2)
                             : QString();
}

QString TwistPresenter::proofText() const { return proof_text_; }

void TwistPresenter::setTolerance(core::Angle tolerance) {
    tolerance_ = std::clamp(tolerance, core::Angle::fromMgon(1), core::Angle::fromGon(1));
    is_proved_ = false;
    Q_EMIT changed();
}

void TwistPresenter::click(const QPointF& frame_px) {
    clicked_px_ = Eigen::Vector2d(frame_px.x(), frame_px.y());
    recent_gon_.clear();
}

void TwistPresenter::forgetClick() { clicked_px_.reset(); }

void TwistPresenter::verify() {
    is_verifying_ = true;
    is_proved_ = false;
    proofs_gon_.clear();
    proof_text_.clear();
    Q_EMIT changed();
}

/// One picture at a time: the next one that stands after the answer is looked at.
void TwistPresenter::look(const camera::FramePtr& frame) {
    if (is_looking_) {
        return;
    }
    is_looking_ = true;
    inPool(
        threading_, this,
        [frame, rig = live_.model().rig(), clicked = clicked_px_]() -> core::Result<Measured> {
            auto line = calibration::findPlumbLine(frame->image, rig.lens, clicked);
            PMTS_TRY(line);
            const auto twist = calibration::twistFromLine(*line, rig, *frame->pointing);
            PMTS_TRY(twist);
            return Measured{*std::move(line), *twist};
        },
        [this](const core::Result<Measured>& measured) { show(measured); });
}

void TwistPresenter::show(const core::Result<Measured>& measured) {
    is_looking_ = false;
    if (!is_active_) {
        return;
    }
    line_.clear();
    if (!measured) {
        trouble_ = measured.error().sentence();
        twist_.reset();
        newest_.reset();
        recent_gon_.clear();
        is_verifying_ = false;  // a proof of before stays: the line has only left the picture
        Q_EMIT changed();
        return;
    }
    trouble_.clear();
    newest_ = measured->twist;
    const double now_gon = measured->twist.twist.gon();
    if (!recent_gon_.empty() && std::abs(recent_gon_.back() - now_gon) > kSeenAgain_gon) {
        recent_gon_.clear();
        is_proved_ = false;
    }
    recent_gon_.push_back(now_gon);
    if (recent_gon_.size() > kRecent) {
        recent_gon_.pop_front();
    }
    twist_ = core::Angle::fromGon(medianOf({recent_gon_.begin(), recent_gon_.end()}));
    is_known_ = is_known_ && core::abs(*twist_ - live_.model().rig().mount.twist) <= tolerance_;  // else somebody turned it since
    const auto& places = measured->line.places_px;
    const std::size_t step = std::max<std::size_t>(1, places.size() / kDrawnPlaces);
    for (std::size_t i = 0; i < places.size(); i += step) {
        line_.emplace_back(places[i].x(), places[i].y());
    }
    line_.emplace_back(places.back().x(), places.back().y());
    if (is_verifying_) {
        addProof(measured->twist.twist);
    }
    Q_EMIT changed();
}

void TwistPresenter::addProof(core::Angle twist) {
    proofs_gon_.push_back(twist.gon());
    const auto n = static_cast<double>(proofs_gon_.size());
    if (proofs_gon_.size() < kProofs) {
        return;
    }
    is_verifying_ = false;
    const double mean = std::accumulate(proofs_gon_.begin(), proofs_gon_.end(), 0.0) / n;
    double squares = 0;
    for (const double value : proofs_gon_) {
        squares += (value - mean) * (value - mean);
    }
    const double known_gon = is_known_ ? live_.model().rig().mount.twist.gon() : 0.0;
    is_proved_ = std::abs(mean - known_gon) <= tolerance_.gon();
    const QString number = QStringLiteral("%1 ± %2 mgon").arg(1000 * mean, 0, 'f', 1).arg(1000 * std::sqrt(squares / (n - 1)), 0, 'f', 1);
    proof_text_ = is_proved_ ? tr("Verified: %1 in %2 pictures.").arg(number).arg(kProofs)
                             : tr("Not upright: %1 in %2 pictures.").arg(number).arg(kProofs);
    twist_ = core::Angle::fromGon(mean);
    if (is_proved_ && core::abs(*twist_ - live_.model().rig().mount.twist) > tolerance_) {
        const QString proof = proof_text_;
        accept();  // turned upright by hand: the rig still has the twist of before
        proof_text_ = tr("%1 The rig knows it.").arg(proof);
    }
}

void TwistPresenter::accept() {
    if (!twist_) {
        return;
    }
    camera::Rig rig = live_.model().rig();
    rig.mount.twist = *twist_;
    CalibrationRecord record;
    record.method = CalibrationMethod::kMounting;
    record.rms_px = newest_ ? newest_->unrest_px : 0.0;
    record.remark = tr("twist from a plumb line: %1").arg(twistText());
    if (newest_) {
        record.standard_deviations["twist [rad]"] = newest_->sigma.rad();
    }
    keepMeasuredRig(live_, preferences_, messages_, rig, record);
    is_known_ = true;
    proof_text_ = tr("The rig now has a twist of %1; aiming takes it into account.").arg(twistText());
    Q_EMIT changed();
}

}  // namespace pmts::app
