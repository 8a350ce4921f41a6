#include "pmts/app/lab/profiles_presenter.hpp"

#include "pmts/camera/lens_difference.hpp"
#include "pmts/camera/lens_file.hpp"
#include "pmts/camera/scaled_rig.hpp"
#include "pmts/protocol/labels.hpp"

#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace pmts::app {

namespace {

const QString kTopic = QStringLiteral("rig_care");

RigProfile* profileIn(Settings& settings, const QString& name) {
    const auto found = std::ranges::find_if(settings.rig_profiles, [&](const RigProfile& p) { return p.name == name; });
    return found == settings.rig_profiles.end() ? nullptr : &*found;
}

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

ProfilesPresenter::ProfilesPresenter(Preferences& preferences, LivePresenter& live, InstrumentDesk& instrument,
                                     MessageCentre& messages, const core::Clock& clock, QObject* parent)
    : QObject(parent), preferences_(preferences), live_(live), instrument_(instrument), messages_(messages), clock_(clock) {
    connect(&live_, &LivePresenter::rigChoiceChanged, this, &ProfilesPresenter::judge);
    connect(&preferences_, &Preferences::changed, this, &ProfilesPresenter::judge);
    connect(&instrument_, &InstrumentDesk::recentringStepped, this,
            [this](Ticket, const targeting::RecentringStep& step) { watchMove(step); });
    connect(&instrument_, &InstrumentDesk::labelRead, this, [this](Ticket ticket, int, const QString& data) {
        bool is_number = false;
        const double read_c = data.toDouble(&is_number);
        if (ticket == temperature_ticket_ && is_number) {
            setTemperature(read_c);
        }
    });
    connect(&instrument_, &InstrumentDesk::requestFailed, this, [this](Ticket ticket, const core::Error& error) {
        if (ticket == temperature_ticket_ && ticket != 0) {
            messages_.warn(tr("The instrument gives no temperature."), tr("Type it."), MessageAction::kNone, QStringLiteral("temperature"));
            qWarning("%s", qPrintable(error.sentence()));
        }
    });
}

// What speaks against a profile -------------------------------------------------------------------------------------

QStringList ProfilesPresenter::concernsOf(const RigProfile& profile) const {
    const RigCareSettings& care = preferences_.settings().rig_care;
    QStringList concerns;
    if (!profile.knock_sign.isEmpty()) {
        concerns.append(tr("The camera may have been knocked: %1").arg(profile.knock_sign));
    }
    if (profile.calibration && profile.calibration->utc.isValid()) {
        const qint64 days = profile.calibration->utc.daysTo(clock_.utcNow());
        if (days > care.age_limit_days) {
            concerns.append(tr("The calibration is %1 days old.").arg(days));
        }
    }
    if (profile.calibration && profile.calibration->temperature_c && temperature_c_) {
        const double apart_c = std::abs(*temperature_c_ - *profile.calibration->temperature_c);
        if (apart_c > care.temperature_limit_c) {
            concerns.append(tr("It was calibrated at %1 °C; it is %2 °C now.").arg(*profile.calibration->temperature_c, 0, 'f', 0)
                                .arg(*temperature_c_, 0, 'f', 0));
        }
    }
    return concerns;
}

QStringList ProfilesPresenter::concerns() const {
    const RigChoice choice = inUse();
    QStringList all = concernsOf(choice.profile);
    if (choice.deservesWarning()) {
        all.prepend(choice.sentence);
    }
    return all;
}

DeviceState ProfilesPresenter::state() const {
    return concerns().isEmpty() ? DeviceState::kGood : DeviceState::kWarning;
}

void ProfilesPresenter::judge() {
    const QString now = live_.source() ? concerns().join(u' ') : QString();
    if (now != said_) {
        said_ = now;
        if (now.isEmpty()) {
            messages_.solve(kTopic);
        } else {
            messages_.warn(now, tr("Check the camera, or calibrate it again."), MessageAction::kCheckRig, kTopic);
        }
    }
    Q_EMIT changed();
}

/// The spot after the first move, before any picture helped: where the rig alone would have aimed. A camera that was knocked
/// misses to the same side every time.
void ProfilesPresenter::watchMove(const targeting::RecentringStep& step) {
    if (step.stage != targeting::RecentringStage::kMatched || step.move != 1 || !step.matched ||
        live_.rangeFor(step.target).source == RangeSource::kAssumed) {
        return;  // with an assumed range the parallax may be the reason
    }
    const RigCareSettings& care = preferences_.settings().rig_care;
    left_over_px_.push_back(step.matched->residual_px);
    while (static_cast<int>(left_over_px_.size()) > care.knock_moves) {
        left_over_px_.pop_front();
    }
    if (static_cast<int>(left_over_px_.size()) < care.knock_moves) {
        return;
    }
    std::vector<double> across, down;
    for (const Eigen::Vector2d& px : left_over_px_) {
        across.push_back(px.x());
        down.push_back(px.y());
    }
    const double median_px = std::hypot(medianOf(across), medianOf(down));
    if (median_px > care.knock_limit_px) {
        left_over_px_.clear();
        const QString sentence = tr("The last %1 moves missed by %2 px to the same side.").arg(care.knock_moves).arg(median_px, 0, 'f', 1);
        const QString name = inUse().profile.name;
        if (preferences_.settings().profileNamed(name)) {
            preferences_.setKnockSign(name, sentence);
        } else {
            messages_.warn(tr("The camera may have been knocked: %1").arg(sentence), tr("Check the camera, or calibrate it again."),
                           MessageAction::kCheckRig, kTopic);
        }
    }
}

// The list ----------------------------------------------------------------------------------------------------------

ProfileRow ProfilesPresenter::rowOf(const RigProfile& profile) const {
    const QSize size(profile.rig.width_px, profile.rig.height_px);
    const QStringList concerns = concernsOf(profile);
    ProfileRow row{.name = profile.name,
                   .camera = profile.use ? (profile.use->camera.isEmpty() ? tr("Simulated camera") : profile.use->camera) : tr("any"),
                   .mode = QStringLiteral("%1x%2 %3").arg(size.width()).arg(size.height())
                               .arg(profile.use ? profile.use->pixel_format : QString()).trimmed(),
                   .method = profile.calibration ? methodText(profile.calibration->method) : tr("not calibrated"),
                   .age = {},
                   .rms = {},
                   .state = !concerns.isEmpty() ? DeviceState::kWarning : profile.calibration ? DeviceState::kGood : DeviceState::kIdle,
                   .state_text = concerns.isEmpty() ? tr("good") : concerns.join(u' '),
                   .in_use = profile.name == inUse().profile.name,
                   .has_previous = profile.previous.has_value()};
    if (profile.calibration) {
        const qint64 days = profile.calibration->utc.daysTo(clock_.utcNow());
        row.age = days == 0 ? tr("today") : tr("%n day(s)", nullptr, static_cast<int>(days));
        row.rms = tr("%1 px").arg(profile.calibration->held_out_px.value_or(profile.calibration->rms_px), 0, 'f', 3);
    }
    return row;
}

std::vector<ProfileRow> ProfilesPresenter::rows() const {
    std::vector<ProfileRow> rows;
    for (const RigProfile& profile : preferences_.settings().rig_profiles) {
        rows.push_back(rowOf(profile));
    }
    ProfileRow nominal = rowOf(simulatedRigProfile());
    nominal.camera = tr("Simulated camera");
    nominal.state_text = tr("the simulated camera's own numbers");
    rows.push_back(nominal);
    return rows;
}

void ProfilesPresenter::edit(const std::function<void(Settings&)>& change) {
    Settings next = preferences_.settings();
    change(next);
    preferences_.set(next);
}

void ProfilesPresenter::setLimits(const RigCareSettings& limits) {
    edit([&](Settings& next) { next.rig_care = limits; });
    judge();
}

void ProfilesPresenter::use(const QString& name) {
    edit([&](Settings& next) {
        next.rig_profile = name;
        next.pick_rig = true;
        next.pick_rig = next.rigFor(live_.cameraUse()).profile.name == name;
    });
}

void ProfilesPresenter::setPicksByItself(bool on) {
    edit([on](Settings& next) { next.pick_rig = on; });
}

void ProfilesPresenter::rename(const QString& from, const QString& to) {
    const QString wanted = to.trimmed();
    const auto& profiles = preferences_.settings().rig_profiles;
    if (wanted == from || !preferences_.settings().profileNamed(from)) {
        return;
    }
    if (wanted.isEmpty() || freeProfileName(profiles, wanted) != wanted) {
        messages_.warn(tr("The profile keeps its name."), tr("Give it a name that no other has."), MessageAction::kNone, QStringLiteral("rig"));
        return;
    }
    edit([&](Settings& next) {
        profileIn(next, from)->name = wanted;
        if (next.rig_profile == from) {
            next.rig_profile = wanted;
        }
    });
}

void ProfilesPresenter::duplicate(const QString& name) {
    const Settings& settings = preferences_.settings();
    RigProfile copy = settings.profileNamed(name) ? *settings.profileNamed(name) : simulatedRigProfile();
    copy.name = freeProfileName(settings.rig_profiles, tr("%1 copy").arg(name));
    copy.use.reset();  // else two would claim the same camera
    edit([&](Settings& next) { next.rig_profiles.push_back(copy); });
}

void ProfilesPresenter::remove(const QString& name) {
    edit([&](Settings& next) {
        std::erase_if(next.rig_profiles, [&](const RigProfile& profile) { return profile.name == name; });
        if (next.rig_profile == name) {
            next.rig_profile.clear();
        }
    });
    messages_.toast(tr("“%1” is deleted.").arg(name));
}

void ProfilesPresenter::goBack(const QString& name) {
    if (preferences_.goBackToPreviousRig(name)) {
        messages_.toast(tr("“%1” has its earlier calibration again.").arg(name));
    }
}

// Files -------------------------------------------------------------------------------------------------------------

void ProfilesPresenter::exportTo(const QString& name, const QString& path) {
    const Settings& settings = preferences_.settings();
    const RigProfile profile = settings.profileNamed(name) ? *settings.profileNamed(name) : simulatedRigProfile();
    const bool whole = path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive);
    const auto written = whole ? saveRigProfile(profile, path)
                               : camera::lensToFile(profile.rig.lens, profile.rig.width_px, profile.rig.height_px, path);
    if (!written) {
        messages_.report(written.error(), MessageAction::kNone, QStringLiteral("rig"));
    } else {
        messages_.toast(tr("“%1” is written.").arg(QFileInfo(path).fileName()));
    }
}

void ProfilesPresenter::importFrom(const QString& path) {
    if (!path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive)) {
        return importLens(path);
    }
    auto profile = loadRigProfile(path);
    if (!profile) {
        messages_.report(profile.error(), MessageAction::kNone, QStringLiteral("rig"));
        return;
    }
    const QString wanted = profile->name.trimmed().isEmpty() ? QFileInfo(path).completeBaseName() : profile->name;
    profile->name = freeProfileName(preferences_.settings().rig_profiles, wanted);
    edit([&](Settings& next) { next.rig_profiles.push_back(*profile); });
    messages_.toast(tr("“%1” is imported.").arg(profile->name));
}

void ProfilesPresenter::importLens(const QString& path) {
    const auto file = camera::lensFromFile(path);
    if (!file) {
        messages_.report(file.error(), MessageAction::kNone, QStringLiteral("rig"));
        return;
    }
    RigProfile profile = inUse().profile;
    if (file->width_px > 0 && file->height_px > 0) {
        profile.rig = camera::scaledRig(profile.rig, file->width_px, file->height_px);
    }
    const auto rig = camera::withLens(profile.rig, file->lens);
    if (!rig) {
        messages_.report(rig.error(), MessageAction::kNone, QStringLiteral("rig"));
        return;
    }
    const QString name = freeProfileName(preferences_.settings().rig_profiles, QFileInfo(path).completeBaseName());
    CalibrationRecord record{.method = CalibrationMethod::kImported, .utc = clock_.utcNow()};
    record.remark = file->note;
    RigProfile imported{.name = name, .rig = *rig};
    imported.calibration = record;
    edit([&](Settings& next) { next.rig_profiles.push_back(imported); });
    if (file->note.isEmpty()) {
        messages_.toast(tr("“%1” is imported with the mount of the rig in use.").arg(name));
    } else {
        messages_.warn(tr("“%1” is imported.").arg(name), file->note, MessageAction::kNone, QStringLiteral("rig"));
    }
}

// Temperature -------------------------------------------------------------------------------------------------------

void ProfilesPresenter::setTemperature(const std::optional<double>& temperature_c) {
    temperature_c_ = temperature_c;
    judge();
}

void ProfilesPresenter::readTemperature() { temperature_ticket_ = instrument_.readLabel(protocol::kTemperature); }

}  // namespace pmts::app
