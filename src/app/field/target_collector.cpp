#include "pmts/app/field/target_collector.hpp"

#include "pmts/app/desk/frame_image.hpp"
#include "pmts/camera/rig_json.hpp"
#include "pmts/geometry/polar.hpp"

#include <QJsonDocument>

#include <algorithm>

namespace pmts::app {

namespace {

bool isInside(const Eigen::Vector2d& px, const camera::Rig& rig) {
    return px.x() >= -0.5 && px.y() >= -0.5 && px.x() <= rig.width_px - 0.5 && px.y() <= rig.height_px - 0.5;
}

QString nameOf(const QString& photo, const QDateTime& utc) {
    return QStringLiteral("%1, %2").arg(photo, utc.toLocalTime().toString(QStringLiteral("d MMM HH:mm:ss")));
}

}  // namespace

TargetCollector::TargetCollector(TargetListModel& targets, LivePresenter& live, JobDesk& job, const PointsModel& points,
                                 const StationPresenter& station, const Preferences& preferences, QObject* parent)
    : QObject(parent), targets_(targets), live_(live), job_(job), points_(points), station_(station),
      preferences_(preferences) {
    connect(&job_, &JobDesk::opened, this, &TargetCollector::onOpened);
    connect(&job_, &JobDesk::photoAdded, this, [this](Ticket, const job::Photo& photo) { onPhotoAdded(photo); });
    connect(&job_, &JobDesk::photoLoaded, this, &TargetCollector::onPhotoLoaded);
    connect(&job_, &JobDesk::requestFailed, this, [this](Ticket ticket, const core::Error& error) {
        if (ticket == load_ticket_) {
            Q_EMIT problemReported(error);
        }
    });
    connect(&live_, &LivePresenter::stillCaptured, this, &TargetCollector::onStill);
    connect(&live_, &LivePresenter::captureWaiting, this, [this](const QString& reason) {
        if (choose_next_ && !reason.isEmpty()) {
            Q_EMIT said(reason);
        }
    });
    connect(&points_, &PointsModel::pointsChanged, this, &TargetCollector::listPoints);
    connect(&targets_, &TargetListModel::targetsChanged, this, &TargetCollector::listPoints);
    connect(&preferences_, &Preferences::unitsChanged, this, &TargetCollector::listPoints);
}

QStringList TargetCollector::stillNames() const {
    QStringList names;
    for (const CollectibleStill& still : stills_) {
        names.append(still.name);
    }
    return names;
}

const CollectibleStill* TargetCollector::still() const {
    return chosen_ >= 0 ? &stills_[static_cast<std::size_t>(chosen_)] : nullptr;
}

CollectibleStill TargetCollector::stillOf(const job::Photo& photo) const {
    const auto rig = camera::rigFromJson(QJsonDocument::fromJson(photo.rig_json.toUtf8()).object());
    return {.name = nameOf(photo.name, photo.utc),
            .frame = {},
            .pointing = photo.pointing,
            .station_name = photo.station_name,
            .rig = rig ? *rig : preferences_.settings().chosenRig().rig,
            .utc = photo.utc,
            .photo_row_id = photo.row_id};
}

void TargetCollector::onOpened(const JobContents& contents) {
    stills_.clear();
    for (const job::Photo& photo : contents.photos) {
        stills_.push_back(stillOf(photo));
    }
    chosen_ = -1;
    Q_EMIT stillsChanged();
    Q_EMIT stillChosen();
    listPoints();
}

void TargetCollector::onStill(const Still& still) {
    stills_.push_back({.name = nameOf(tr("Photo %1").arg(still.number), still.utc),
                       .frame = still.frame,
                       .pointing = still.pointing,
                       .station_name = station_.station().name,
                       .rig = live_.model().rig(),
                       .utc = still.utc,
                       .photo_row_id = 0});
    Q_EMIT stillsChanged();
    if (std::exchange(choose_next_, false)) {
        Q_EMIT said(tr("The still is taken. Pick a point in the table and click its place in the still."));
        chooseStill(static_cast<int>(stills_.size()) - 1);
    }
}

void TargetCollector::onPhotoAdded(const job::Photo& photo) {
    const auto same = std::ranges::find_if(
        stills_, [&photo](const CollectibleStill& still) { return still.photo_row_id == 0 && still.utc == photo.utc; });
    if (same != stills_.end()) {
        same->photo_row_id = photo.row_id;
    } else if (std::ranges::find(stills_, photo.row_id, &CollectibleStill::photo_row_id) == stills_.end()) {
        stills_.push_back(stillOf(photo));
        Q_EMIT stillsChanged();
    }
}

void TargetCollector::capture() {
    choose_next_ = true;
    live_.capture();
}

void TargetCollector::chooseStill(int index) {
    if (index < 0 || index >= static_cast<int>(stills_.size())) {
        return;
    }
    chosen_ = index;
    if (const CollectibleStill& chosen = *still(); !chosen.frame) {
        load_ticket_ = job_.loadPhoto(chosen.photo_row_id);
    }
    Q_EMIT stillChosen();
    listPoints();
}

void TargetCollector::onPhotoLoaded(Ticket ticket, const QImage& image) {
    if (ticket != load_ticket_ || chosen_ < 0) {
        return;
    }
    CollectibleStill& chosen = stills_[static_cast<std::size_t>(chosen_)];
    auto frame = std::make_shared<camera::Frame>(*frameOfImage(image));
    frame->pointing = chosen.pointing;
    chosen.frame = frame;
    Q_EMIT stillChosen();
}

void TargetCollector::listPoints() {
    const QString picked_id = picked_ >= 0 ? shown_[static_cast<std::size_t>(picked_)].id : QString();
    shown_.clear();
    picked_ = -1;
    if (const CollectibleStill* const chosen = still()) {
        const targeting::PixelToPointing model(chosen->rig);
        for (const survey::Point& point : points_.points()) {
            if (point.struck_out || !point.hasCoordinates() || point.station_name != chosen->station_name) {
                continue;
            }
            const geometry::PolarPoint observed{point.observation.pointing, *point.observation.slope_distance_m};
            const auto px = model.pixelForPoint(geometry::stationFromPolar(observed), chosen->pointing);
            if (px && isInside(*px, chosen->rig)) {
                shown_.push_back({.id = point.id, .code = point.code,
                                  .distance_text = preferences_.units().length(observed.slope_distance_m),
                                  .expected_px = {px->x(), px->y()}, .clicked = {}, .observed = observed});
            }
        }
    }
    const bool same_source = still() != nullptr && targets_.source() == still()->name;
    for (std::size_t i = 0; i < shown_.size(); ++i) {
        CollectiblePoint& point = shown_[i];
        const auto found = std::ranges::find(targets_.targets(), point.id, &targeting::ListedTarget::name);
        if (same_source && found != targets_.targets().end()) {
            point.clicked = QPointF(found->px.x(), found->px.y());
        }
        if (point.id == picked_id) {
            picked_ = static_cast<int>(i);
        }
    }
    if (picked_ < 0) {
        pickNext();
    }
    Q_EMIT pointsChanged();
}

void TargetCollector::pickNext() {
    const auto open = std::ranges::find_if(shown_, [](const CollectiblePoint& point) { return !point.clicked; });
    picked_ = open != shown_.end() ? static_cast<int>(open - shown_.begin()) : -1;
}

void TargetCollector::pickPoint(int index) {
    if (index >= 0 && index < static_cast<int>(shown_.size()) && index != picked_) {
        picked_ = index;
        Q_EMIT pointsChanged();
    }
}

void TargetCollector::click(const QPointF& still_px) {
    const CollectibleStill* const chosen = still();
    if (chosen == nullptr || picked_ < 0) {
        Q_EMIT said(chosen == nullptr ? tr("Choose a still first.") : tr("Pick a point in the table first."));
        return;
    }
    if (!targets_.isEmpty() && targets_.source() != chosen->name) {
        Q_EMIT problemReported({.kind = core::ErrorKind::kRefused,
                                .happened = tr("The list holds %n target(s) of %1.", nullptr,
                                               static_cast<int>(targets_.targets().size())).arg(targets_.source()),
                                .remedy = tr("Save it if you need it, then clear it: all targets of a list are in one photo."),
                                .info_code = std::nullopt,
                                .detail = {}});
        return;
    }
    const CollectiblePoint point = shown_[static_cast<std::size_t>(picked_)];
    targets_.put({.name = point.id, .observed = point.observed, .px = {still_px.x(), still_px.y()},
                  .printed_apa = {}, .printed_tpa = {}, .printed_oatpa = {}},
                 chosen->name);
    pickNext();
    Q_EMIT pointsChanged();
    Q_EMIT said(picked_ >= 0 ? tr("%1 is collected. Click %2 now.").arg(point.id, shown_[static_cast<std::size_t>(picked_)].id)
                             : tr("%1 is collected: every point in this still is in the list.").arg(point.id));
}

}  // namespace pmts::app
