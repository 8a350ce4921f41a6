#pragma once

#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/desk/job_desk.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/field/points_model.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/survey/station.hpp"

#include <QObject>
#include <QUndoStack>

namespace pmts::app {

/// The station page as texts, in the current units.
struct StationForm {
    QString name;
    QString easting, northing, height;
    QString instrument_height;
    QString orientation;
};

enum class StationField { kName, kEasting, kNorthing, kHeight, kInstrumentHeight, kOrientation, kBearing, kKnownEasting,
                          kKnownNorthing };

/// Station, instrument height and orientation. A change recomputes the points observed from this station as one undo step.
class StationPresenter : public QObject {
    Q_OBJECT
public:
    StationPresenter(JobDesk& job, PointsModel& points, const InstrumentDesk& instrument, const Preferences& preferences,
                     MessageCentre& messages, QUndoStack& undo, QObject* parent = nullptr);

    [[nodiscard]] const survey::Station& station() const { return station_; }
    [[nodiscard]] StationForm form() const;
    /// Bearing of the line of sight at a circle reading, as text.
    [[nodiscard]] QString bearingText(core::Angle ha) const;
    /// How many points a change of this station would move.
    [[nodiscard]] int pointsObservedHere() const;

public Q_SLOTS:
    /// Reads all fields; nothing changes when one cannot be read, fieldRejected() says which.
    void apply(const pmts::app::StationForm& form);
    /// The telescope points along this bearing now.
    void orientByBearing(const QString& bearing_text);
    /// The telescope points at these known coordinates now.
    void orientToCoordinates(const QString& easting_text, const QString& northing_text);
    void orientToPoint(qint64 row_id);

Q_SIGNALS:
    void stationChanged(const pmts::survey::Station& station);
    void fieldRejected(pmts::app::StationField field, const pmts::core::Error& error);
    void applied(const QString& sentence);  ///< `Station 100 set; 12 points recomputed.`

private:
    class StationStep;
    void change(const survey::Station& next, const QString& text);
    Ticket put(const survey::Station& station);
    void show(const survey::Station& station, const std::vector<survey::Point>& moved);
    void onRequestFailed(Ticket ticket, const core::Error& error);
    bool readLength(const QString& text, StationField field, double& value_m);
    [[nodiscard]] std::vector<survey::Point> recomputed(const survey::Station& station) const;
    void orient(core::Angle bearing);

    JobDesk& job_;
    PointsModel& points_;
    const InstrumentDesk& instrument_;
    const Preferences& preferences_;
    MessageCentre& messages_;
    QUndoStack& undo_;
    survey::Station station_;
    QMap<Ticket, survey::Station> before_;  ///< to take a refused change back
};

}  // namespace pmts::app
