#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/line/dry_run.hpp"
#include "pmts/app/line/instruction_file.hpp"
#include "pmts/app/line/instruction_steps.hpp"
#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/desk/message_centre.hpp"

#include <QFutureWatcher>
#include <QObject>
#include <QSet>

namespace pmts::app {

/// A number that the chosen routine takes.
struct RoutineField {
    QString name;
    QString range;  ///< `0 to 4`; empty: any
    QString text;   ///< as typed
    bool is_right = false;
};

/// The laboratory's own instruction table: edited with its problems by line, tried against a simulated base as it stands in the
/// editor, run on the connected bus as it was last saved without a problem. What is typed and not saved survives a crash.
class InstructionsPresenter : public QObject {
    Q_OBJECT
public:
    enum class Running { kNothing, kDryRun, kRun };

    InstructionsPresenter(InstructionFile& file, InstrumentDesk& instrument, MessageCentre& messages, core::Clock& clock,
                          Threading threading = Threading::kOwnThread, QObject* parent = nullptr);
    ~InstructionsPresenter() override;

    // The text.
    [[nodiscard]] const QString& text() const { return text_; }
    [[nodiscard]] bool isModified() const { return text_ != file_.text(); }
    [[nodiscard]] const protocol::InstructionTable& table() const { return table_; }
    /// Where the text comes from and what happened to it.
    [[nodiscard]] QString fileSentence() const;

    // The chosen routine.
    [[nodiscard]] const protocol::TableRoutine* chosen() const;  ///< null: none
    [[nodiscard]] QString note() const;
    [[nodiscard]] std::vector<RoutineField> fields() const;
    [[nodiscard]] bool believesTable() const { return believes_table_; }

    // Running.
    [[nodiscard]] Running running() const { return running_; }
    [[nodiscard]] const std::vector<StepRow>& steps() const { return steps_.rows(); }
    [[nodiscard]] QString dryRunTrouble() const;  ///< why it cannot start; empty: it can
    [[nodiscard]] QString runTrouble() const;
    /// What Run takes when it is not what the editor shows; empty: it is the same.
    [[nodiscard]] QString runSentence() const;
    [[nodiscard]] QString runNote() const;  ///< of the routine that Run takes
    /// The routine's note has not been confirmed in this session: to be shown before it runs on hardware.
    [[nodiscard]] bool mustConfirmNote() const;
    [[nodiscard]] StatusItem outcome() const { return outcome_; }

public Q_SLOTS:
    void setText(const QString& text);
    void save();
    void revert();
    void importFrom(const QString& path);  ///< into the editor, not saved yet
    void exportTo(const QString& path);
    void choose(const QString& routine);
    void setField(const QString& name, const QString& text);
    void setBelievesTable(bool believes);
    void confirmNote();
    void startDryRun();
    void startRun();
    void cancel();

Q_SIGNALS:
    void textChanged();     ///< by anything but setText()
    void tableChanged();    ///< problems, routines, whether it is saved
    void chosenChanged();   ///< routine or its fields
    void runChanged();      ///< what runs, its steps, its outcome, and what may be started

private:
    using Numbers = std::map<std::string, double>;

    void takeDraft();
    void reportFile(const core::Error& error);
    void replaceText(const QString& text);
    void readTable();
    void followFile();
    void keepDraftSoon();
    void keepDraft();
    [[nodiscard]] QString draftPath() const;
    [[nodiscard]] std::optional<double> numberOf(const protocol::TableParameter& parameter) const;
    [[nodiscard]] std::optional<Numbers> numbers() const;
    [[nodiscard]] const protocol::TableRoutine* saved() const;  ///< what Run takes; null: none
    [[nodiscard]] QString numbersTrouble() const;
    [[nodiscard]] QString savedTrouble() const;
    void begin(Running what, const protocol::TableRoutine& routine);
    void finish(const core::Result<instrument::RoutineOutcome>& outcome);
    void wireDesk();

    InstructionFile& file_;
    InstrumentDesk& instrument_;
    MessageCentre& messages_;
    core::Clock& clock_;
    Threading threading_;
    QString text_;
    QString known_;  ///< the file's text when it was last looked at
    protocol::InstructionTable table_;
    bool is_file_newer_ = false;
    bool is_draft_ = false;  ///< found at the start
    core::Timer draft_timer_;
    QString chosen_;
    std::map<QString, QString> typed_;
    QSet<QString> confirmed_;
    bool believes_table_ = false;
    Running running_ = Running::kNothing;
    Ticket ticket_ = 0;
    InstructionSteps steps_;
    StatusItem outcome_;
    QFutureWatcher<instrument::StepOutcome> watcher_;
    std::shared_ptr<std::atomic<bool>> cancel_dry_run_ = std::make_shared<std::atomic<bool>>(false);
    std::shared_ptr<core::Result<instrument::RoutineOutcome>> dry_outcome_;
};

}  // namespace pmts::app
