#pragma once

#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/line/instrument_health.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/desk/log_model.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/field/range_keeper.hpp"
#include "pmts/app/line/timeline.hpp"
#include "pmts/blackbox/run.hpp"

#include <QObject>
#include <QPointer>

#include <memory>
#include <vector>

namespace pmts::app {

class ReplaySource;
class UnaskedBytes;
struct UnaskedPiece;

/// Where a recording is shown: the presenters that show devices otherwise.
struct ReplayStage {
    InstrumentDesk& instrument;
    LivePresenter& live;
    LogModel& log;
    MessageCentre& messages;
    Timeline& timeline;
    RangeKeeper& range;
    InstrumentHealth* health = nullptr;  ///< where the air is shown
};

/// Plays a black box file into the windows as it was: live view, readings, log, time line, messages. Sends nothing: the
/// links of a replay cannot be opened.
class ReplayPresenter : public QObject {
    Q_OBJECT
public:
    /// What is shown at once after a jump: enough for the log and the time line.
    static constexpr core::Duration kShownBefore = std::chrono::minutes(5);

    /// Stage and clock outlive it.
    ReplayPresenter(const ReplayStage& stage, core::Clock& clock, QObject* parent = nullptr);
    ~ReplayPresenter() override;

    /// Reads the file and the others of its run in the pool, and plays them as one from the beginning of this file; opened()
    /// or failed() follows.
    void open(const QString& path, double speed = 1.0);
    void take(std::shared_ptr<const blackbox::Run> run, double speed);

    [[nodiscard]] bool isOpen() const { return run_ != nullptr; }
    [[nodiscard]] bool isPlaying() const { return playing_; }
    [[nodiscard]] bool isAtEnd() const { return isOpen() && next_ == run_->places().size(); }
    [[nodiscard]] double speed() const { return speed_; }
    [[nodiscard]] core::Duration position() const { return now_ - begin_; }  ///< from the beginning
    [[nodiscard]] core::Duration length() const { return end_ - begin_; }
    [[nodiscard]] QDateTime utc() const;  ///< time of day that is shown
    [[nodiscard]] QString lastAction() const { return last_action_; }
    /// `Damaged places of the file, passed over: 2.`; empty when there is none.
    [[nodiscard]] QString damageText() const;

    /// A link that cannot be opened, with the sentence why.
    [[nodiscard]] static std::unique_ptr<transport::ByteLink> barredLink();

public Q_SLOTS:
    void play();
    void pause();
    void setSpeed(double speed);  ///< > 0
    void seek(pmts::core::Duration position);

Q_SIGNALS:
    void opened();
    void failed(const pmts::core::Error& error);
    void moved();  ///< position, or what was clicked
    void playingChanged(bool playing);

private:
    void step();
    void goOn();
    void playUntil(core::Duration moment);
    void catchUp();
    void forgetShown();
    void showStanding(std::size_t before);
    using Place = blackbox::Run::Place;
    void apply(const Place& place);
    void applyFrame(const Place& place);
    void applySession(const Place& place);
    void applyReading(core::Duration at, const QCborMap& map);
    void applyTransaction(const QCborMap& map);
    void applyBytes(core::Duration at, const QCborMap& map);
    void applyAir(core::Duration at, const QCborMap& map);
    void applyLost(core::Duration at, const QCborMap& map);
    void showUnasked(const std::vector<UnaskedPiece>& pieces);
    /// What came until then and no transaction that is still to come takes for its answer.
    void showDecided(core::Duration until);
    void applyConnection(const QCborMap& map);
    void applyMessage(const QCborMap& map);
    void showMoment();

    ReplayStage stage_;
    core::Clock& clock_;
    QPointer<ReplaySource> source_;
    std::shared_ptr<const blackbox::Run> run_;
    std::vector<core::Duration> due_;  ///< of each entry: never before the one in front of it
    QDateTime utc_of_zero_;
    core::Duration begin_{0}, end_{0}, now_{0};
    std::size_t next_ = 0;
    core::Duration stepped_at_{0};
    double speed_ = 1.0;
    bool playing_ = false;
    bool catching_up_ = false;  ///< a jump is being shown, in pieces
    core::Timer timer_;
    QString last_action_;
    std::unique_ptr<UnaskedBytes> unasked_;
    std::size_t ahead_ = 0;            ///< the next transaction
    core::Duration ahead_sent_at_{0};  ///< when it was sent
    QString instrument_port_;
    std::uint64_t lost_ = 0;     ///< records, told so far
    std::optional<geometry::Pointing> pointing_;
    std::vector<Message> bars_;  ///< as recorded: what the presenters here say of the connection does not count
};

}  // namespace pmts::app
