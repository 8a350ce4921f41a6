#pragma once

#include "pmts/app/field/evidence_shots.hpp"
#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/desk/job_desk.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/field/points_model.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/app/field/range_keeper.hpp"
#include "pmts/app/field/station_presenter.hpp"

#include <QObject>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>

namespace pmts::app {

class BlockIntake;

/// What is known about the shot on the desk.
enum class ShotState {
    kNone,       ///< nothing measured since the last turn
    kMeasuring,
    kMeasured,   ///< distance, not converted
    kConverted,  ///< E, N, H known
    kAbsurd,     ///< no distance within the limit; may be recorded as such, with its reason
    kRecording,
    kRecorded,
    kKept,       ///< recording failed: the shot is kept, try again
};

/// The big digits. Texts are in the current units; empty when there is nothing to show.
struct Readings {
    QString ha, va;                  ///< live circle readings
    QString sd, mode, time_taken;    ///< of the shot
    QString easting, northing, height, precision;
    QString angle_unit, length_unit;
    ShotState shot = ShotState::kNone;
    bool shot_is_elsewhere = false;  ///< the telescope has turned since: shown as old
    QString sentence;                ///< what is missing or wrong: `Measure first (D).`
};

/// Measure, convert, record; what the next point is called.
class RecordingPresenter : public QObject {
    Q_OBJECT
public:
    RecordingPresenter(InstrumentDesk& instrument, JobDesk& job, PointsModel& points, const StationPresenter& station,
                       RangeKeeper& range, Preferences& preferences, MessageCentre& messages, const core::Clock& clock,
                       QObject* parent = nullptr);
    ~RecordingPresenter() override;

    [[nodiscard]] const Readings& readings() const { return readings_; }
    [[nodiscard]] QString pointId() const { return point_id_; }
    [[nodiscard]] QString code() const { return code_; }
    [[nodiscard]] QString remark() const { return remark_; }
    [[nodiscard]] QString targetHeightText() const;
    [[nodiscard]] instrument::EdmMode mode() const;
    [[nodiscard]] static QStringList modeNames();  ///< in the order of EdmMode
    /// Seven codes for the buttons, most used first.
    [[nodiscard]] QStringList codeButtons() const;
    [[nodiscard]] bool isBusy() const { return readings_.shot == ShotState::kMeasuring || readings_.shot == ShotState::kRecording; }
    [[nodiscard]] const std::optional<instrument::UnsolicitedBlock>& offeredBlock() const;

    /// Asked when a shot is made; what it answers is recorded with the point.
    std::function<std::optional<EvidenceShots>(const geometry::Pointing& shot)> collect_evidence;

public Q_SLOTS:
    void measure();    ///< D
    void convert();    ///< M; says what is missing
    /// R; refuses the same shot a second time and says so. An ID that is used in the job is asked about first: the
    /// second R records.
    void record();
    void recordAgain();  ///< the same shot once more, on purpose, under the next ID
    void all();        ///< Space: measure, convert, record
    void cancel();
    void setPointId(const QString& id);
    void setCode(const QString& code);
    void setRemark(const QString& remark);
    void setTargetHeightText(const QString& text);
    void setMode(pmts::instrument::EdmMode mode);
    void acceptBlock();
    void dismissBlock();

Q_SIGNALS:
    void readingsChanged();      ///< take readings()
    void nextPointChanged();     ///< ID, code, remark or target height
    void modeChanged(pmts::instrument::EdmMode mode);
    void codesChanged();
    void pointRecorded(const pmts::survey::Point& point);
    void targetHeightRejected(const pmts::core::Error& error);
    void blockOffered(const QString& sentence);  ///< empty when it was taken or dismissed

private:
    void onPointing(const TimedPointing& reading);
    void onShot(Ticket ticket, const instrument::DistanceShot& shot);
    void onInstrumentFailed(Ticket ticket, const core::Error& error);
    void onRecorded(Ticket ticket, const survey::Point& point);
    void onJobFailed(Ticket ticket, const core::Error& error);
    void onOpened(const JobContents& contents);
    void onModeSet(Ticket ticket, instrument::EdmMode mode);
    void keepAbsurd(const core::Error& error);
    void submitShot();
    void submit(const survey::Point& point);
    [[nodiscard]] bool isKeptOfElsewhere() const;
    [[nodiscard]] bool asksAboutId();
    void proposeId(const QString& from);
    void rememberCode(const QString& code);
    void say(const QString& sentence);
    void setShot(ShotState state, const QString& sentence);
    void refreshTexts();
    void reconvert();
    [[nodiscard]] survey::Point pointOf(const survey::Observation& observation) const;
    [[nodiscard]] survey::Point pointOfBlock(survey::Observation observation) const;

    InstrumentDesk& instrument_;
    JobDesk& job_;
    PointsModel& points_;
    const StationPresenter& station_;
    RangeKeeper& range_;
    Preferences& preferences_;
    MessageCentre& messages_;
    const core::Clock& clock_;
    Readings readings_;
    QString point_id_ = QStringLiteral("1");
    bool id_is_typed_ = false;  ///< by hand; a proposed one gives way when it gets used
    QString asked_id_;          ///< used in the job, and the surveyor has been told
    QString code_;
    QString remark_;
    std::optional<survey::Observation> observation_;
    std::optional<EvidenceShots> evidence_;
    std::optional<survey::Coordinates> coordinates_;
    Ticket measure_ticket_ = 0;
    Ticket mode_ticket_ = 0;
    Ticket record_ticket_ = 0;
    std::unique_ptr<BlockIntake> blocks_;  ///< those nobody asked for
    QString recorded_id_;
    std::optional<geometry::Pointing> pointing_;
    bool record_after_ = false;  ///< the Space key: go on to convert and record
    bool all_after_ = false;     ///< Space found a kept shot of another target: that one first, then this target
    bool drop_asked_ = false;    ///< the surveyor knows that measuring drops the kept shot
    survey::Point submitted_;    ///< the latest one that went to the job: what a kept shot is called
};

}  // namespace pmts::app
