#pragma once

#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/desk/job_desk.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/settings/preferences.hpp"

#include <QObject>
#include <QSet>

#include <functional>
#include <optional>

namespace pmts::app {

/// What becomes of the blocks nobody asked for: offered, recorded or left alone, as the setting says.
class BlockIntake : public QObject {
    Q_OBJECT
public:
    /// A point of this observation, named as the next one would be.
    using MakePoint = std::function<survey::Point(const survey::Observation& observation)>;

    BlockIntake(InstrumentDesk& instrument, JobDesk& job, const Preferences& preferences, MessageCentre& messages,
                const core::Clock& clock, MakePoint make_point, QObject* parent = nullptr);

    [[nodiscard]] const std::optional<instrument::UnsolicitedBlock>& offered() const { return offered_; }
    /// True once for each request that recorded a block.
    bool takeTicket(Ticket ticket) { return tickets_.remove(ticket); }
    void accept();
    void dismiss();

Q_SIGNALS:
    void offerChanged(const QString& sentence);  ///< empty when it was taken or dismissed

private:
    void onBlock(const instrument::UnsolicitedBlock& block);
    void onJobFailed(Ticket ticket, const core::Error& error);
    void sayWhatIsMissing(const instrument::UnsolicitedBlock& block);
    /// What the circles say where they say something else than a block.
    [[nodiscard]] std::optional<geometry::Pointing> contradiction(const geometry::Pointing& said) const;
    void sayThatItIsDamaged(const instrument::UnsolicitedBlock& block, const geometry::Pointing& circles);
    void offer(const instrument::UnsolicitedBlock& block, const QString& source);
    void record(const instrument::UnsolicitedBlock& block, const QString& source);
    void endOffer();
    [[nodiscard]] bool isOfOwnShot() const;
    [[nodiscard]] QString sourceOfNext();
    [[nodiscard]] survey::Point pointOf(const instrument::UnsolicitedBlock& block, const QString& source) const;

    InstrumentDesk& instrument_;
    JobDesk& job_;
    const Preferences& preferences_;
    MessageCentre& messages_;
    const core::Clock& clock_;
    MakePoint make_point_;
    std::optional<instrument::UnsolicitedBlock> offered_;
    QString offered_source_;
    std::optional<core::Duration> last_at_;  ///< when the newest block came, to the nearest circle reading
    QSet<Ticket> tickets_;
};

}  // namespace pmts::app
