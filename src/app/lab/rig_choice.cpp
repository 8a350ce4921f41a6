#include "pmts/app/lab/rig_choice.hpp"

#include "pmts/camera/scaled_rig.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pmts::app {

namespace {

QString say(const char* text) { return QCoreApplication::translate("RigChoice", text); }

/// Camera controls come back a little rounded.
bool same(const std::optional<double>& made, const std::optional<double>& now) {
    return !made || !now || std::abs(*made - *now) <= 0.01 * std::max(1.0, std::abs(*made));
}

bool sameCamera(const CameraUse& made, const CameraUse& now) {
    return made.isSimulated() == now.isSimulated() &&
           (made.camera.isEmpty() || now.camera.isEmpty() || made.isSimulated() || made.camera == now.camera);
}

QSize sizeOf(const RigProfile& profile) { return {profile.rig.width_px, profile.rig.height_px}; }

bool sameShape(const QSize& a, const QSize& b) {
    return std::abs(a.width() * b.height() - b.width() * a.height()) <= std::max(a.width(), b.width());
}

QString sentenceOf(const RigChoice& choice, const CameraUse& now) {
    const QString& name = choice.profile.name;
    switch (choice.fitness) {
        case RigFitness::kFits: return say("“%1” belongs to this camera and mode.").arg(name);
        case RigFitness::kNominal: return say("The simulated camera aims with its own numbers.");
        case RigFitness::kUnassigned: return say("“%1” was chosen by hand; it belongs to no camera.").arg(name);
        case RigFitness::kOtherFocus:
            return say("“%1” was made with another focus, zoom or pixel format (%2).").arg(name, useText(choice.profile.use.value_or(now)));
        case RigFitness::kScaled: return say("“%1” was made at another size; it is scaled to this one.").arg(name);
        case RigFitness::kOtherShape:
            return say("“%1” was made at a size of another shape; scaling it is a guess.").arg(name);
        case RigFitness::kOtherCamera: return say("No profile belongs to this camera; “%1” is another camera's.").arg(name);
    }
    return {};
}

RigChoice choiceOf(RigProfile profile, RigFitness fitness, const CameraUse& now) {
    if (!now.size.isEmpty() && sizeOf(profile) != now.size) {
        profile.rig = camera::scaledRig(profile.rig, now.size.width(), now.size.height());
    }
    RigChoice choice{.profile = std::move(profile), .fitness = fitness, .sentence = {}};
    choice.sentence = sentenceOf(choice, now);
    return choice;
}

QDateTime ageOf(const RigProfile& profile) { return profile.calibration ? profile.calibration->utc : QDateTime(); }

bool suitsBetter(const RigProfile& one, const RigProfile& other, const QString& chosen, const CameraUse& now) {
    const RigFitness mine = fitnessOf(one, now);
    const RigFitness others = fitnessOf(other, now);
    if (mine != others) {
        return mine < others;
    }
    return other.name != chosen && (one.name == chosen || ageOf(one) > ageOf(other));
}

}  // namespace

RigFitness fitnessOf(const RigProfile& profile, const CameraUse& now) {
    const QSize made = sizeOf(profile);
    if (profile.use && !sameCamera(*profile.use, now)) {
        return RigFitness::kOtherCamera;
    }
    if (!now.size.isEmpty() && made != now.size) {
        return sameShape(made, now.size) ? RigFitness::kScaled : RigFitness::kOtherShape;
    }
    if (!profile.use) {
        return now.isSimulated() ? RigFitness::kOtherCamera : RigFitness::kUnassigned;
    }
    const bool same_format = profile.use->pixel_format.isEmpty() || now.pixel_format.isEmpty() ||
                             profile.use->pixel_format == now.pixel_format;
    return same_format && same(profile.use->focus, now.focus) && same(profile.use->zoom, now.zoom)
               ? RigFitness::kFits
               : RigFitness::kOtherFocus;
}

RigChoice pickRig(const std::vector<RigProfile>& profiles, const QString& chosen, bool automatic, const CameraUse& now) {
    const RigProfile* best = nullptr;
    for (const RigProfile& profile : profiles) {
        const bool is_chosen = profile.name == chosen;
        if (is_chosen && !automatic) {
            return choiceOf(profile, fitnessOf(profile, now), now);
        }
        const bool may = automatic && profile.use && sameCamera(*profile.use, now);
        // A profile of a real camera, chosen earlier, says nothing about the simulated one.
        if ((may || (is_chosen && !now.isSimulated())) && (!best || suitsBetter(profile, *best, chosen, now))) {
            best = &profile;
        }
    }
    return best ? choiceOf(*best, fitnessOf(*best, now), now)
                : choiceOf(simulatedRigProfile(), now.isSimulated() ? RigFitness::kNominal : RigFitness::kOtherCamera, now);
}

QString freeProfileName(const std::vector<RigProfile>& profiles, const CameraUse& use) {
    QString name = use.camera.isEmpty() ? (use.isSimulated() ? simulatedRigProfile().name : say("Camera")) : use.camera;
    if (!use.size.isEmpty()) {
        name += QStringLiteral(" %1x%2").arg(use.size.width()).arg(use.size.height());
    }
    return freeProfileName(profiles, name);
}

QString freeProfileName(const std::vector<RigProfile>& profiles, const QString& wanted) {
    const auto isTaken = [&profiles](const QString& name) {
        return name == simulatedRigProfile().name ||
               std::any_of(profiles.begin(), profiles.end(), [&name](const RigProfile& p) { return p.name == name; });
    };
    QString name = wanted;
    for (int number = 2; isTaken(name); ++number) {
        name = QStringLiteral("%1 %2").arg(wanted).arg(number);
    }
    return name;
}

}  // namespace pmts::app
