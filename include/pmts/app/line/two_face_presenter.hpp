#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/desk/job_desk.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/field/points_model.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/app/field/station_presenter.hpp"
#include "pmts/geometry/two_faces.hpp"

#include <QObject>

#include <optional>

namespace pmts::app {

enum class TwoFaceStep {
    kFirst,      ///< aim at the point and measure
    kMeasuring,
    kTurning,
    kSecond,     ///< aim again in the other face and measure
    kDone,       ///< differences are shown; record or discard
    kRecording,
};

/// One point measured in both faces (features M11): mean, differences, and their check against the limits. Recorded as
/// the mean; the readings and blocks of both faces stay in the observation's raw reply.
class TwoFacePresenter : public QObject {
    Q_OBJECT
public:
    TwoFacePresenter(InstrumentDesk& instrument, JobDesk& job, PointsModel& points, const StationPresenter& station,
                     const Preferences& preferences, MessageCentre& messages, QObject* parent = nullptr);

    [[nodiscard]] TwoFaceStep step() const { return step_; }
    [[nodiscard]] bool isBusy() const {
        return step_ == TwoFaceStep::kMeasuring || step_ == TwoFaceStep::kTurning || step_ == TwoFaceStep::kRecording;
    }
    /// What is being written into the job cannot be cancelled.
    [[nodiscard]] bool canCancel() const { return isBusy() && step_ != TwoFaceStep::kRecording; }
    [[nodiscard]] QString instruction() const;
    /// Differences and mean in words, and whether they are within the limits.
    [[nodiscard]] StatusItem outcome() const;
    [[nodiscard]] std::optional<geometry::FacePair> pair() const;
    [[nodiscard]] QString proposedId() const;

public Q_SLOTS:
    void measure();  ///< the first or the second face
    /// An ID that is used in the job is asked about first: the second time records.
    void record(const QString& id, const QString& code);
    void discard();
    void cancel();

Q_SIGNALS:
    void changed();
    void recorded(const QString& id);

private:
    void onShot(Ticket ticket, const instrument::DistanceShot& shot);
    void onFailed(Ticket ticket, const core::Error& error);
    void setStep(TwoFaceStep step);
    [[nodiscard]] bool asksAboutId(const QString& id);
    [[nodiscard]] geometry::FaceDifference unexplained(const geometry::FacePair& pair) const;
    [[nodiscard]] survey::Observation meanObservation() const;

    InstrumentDesk& instrument_;
    JobDesk& job_;
    PointsModel& points_;
    const StationPresenter& station_;
    const Preferences& preferences_;
    MessageCentre& messages_;
    TwoFaceStep step_ = TwoFaceStep::kFirst;
    std::optional<instrument::DistanceShot> first_, second_;
    QString asked_id_;  ///< used in the job, and the surveyor has been told
    Ticket ticket_ = 0;
};

}  // namespace pmts::app
