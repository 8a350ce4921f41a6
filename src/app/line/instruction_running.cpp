// The chosen routine of the instruction table: its numbers, the dry run, the run on the bus.
#include "pmts/app/line/instructions_presenter.hpp"

#include <QLocale>
#include <QPromise>
#include <QThreadPool>

namespace pmts::app {
namespace {

QString shown(const std::string& text) { return QString::fromStdString(text); }

QString number(double value) { return QString::number(value, 'g', 9); }

QString rangeText(const protocol::TableParameter& parameter) {
    return parameter.least ? InstructionsPresenter::tr("%1 to %2").arg(number(*parameter.least), number(*parameter.most))
                           : QString();
}

QString reasonOf(const core::Error& error) {
    return error.kind == core::ErrorKind::kCancelled ? InstructionsPresenter::tr("Cancelled.") : error.sentence();
}

}  // namespace

void InstructionsPresenter::wireDesk() {
    connect(&instrument_, &InstrumentDesk::connectionChanged, this, &InstructionsPresenter::runChanged);
    connect(&instrument_, &InstrumentDesk::routineStepBegan, this, [this](Ticket ticket, std::size_t index) {
        if (ticket == ticket_) {
            steps_.setRunning(index);
            Q_EMIT runChanged();
        }
    });
    connect(&instrument_, &InstrumentDesk::routineStepped, this, [this](Ticket ticket, const instrument::StepOutcome& step) {
        if (ticket == ticket_) {
            steps_.take(step);
            Q_EMIT runChanged();
        }
    });
    connect(&instrument_, &InstrumentDesk::routineRan, this, [this](Ticket ticket, const instrument::RoutineOutcome& outcome) {
        if (ticket == ticket_) {
            finish(outcome);
        }
    });
    connect(&instrument_, &InstrumentDesk::requestFailed, this, [this](Ticket ticket, const core::Error& error) {
        if (ticket == ticket_ && running_ == Running::kRun) {
            finish(tl::unexpected(error));
        }
    });
    connect(&watcher_, &QFutureWatcherBase::resultReadyAt, this, [this](int index) {
        steps_.take(watcher_.resultAt(index));
        Q_EMIT runChanged();
    });
    connect(&watcher_, &QFutureWatcherBase::finished, this, [this] { finish(*dry_outcome_); });
}

const protocol::TableRoutine* InstructionsPresenter::chosen() const { return table_.find(chosen_.toStdString()); }

QString InstructionsPresenter::note() const { return chosen() == nullptr ? QString() : shown(chosen()->note); }

void InstructionsPresenter::choose(const QString& routine) {
    if (routine == chosen_ || running_ != Running::kNothing) {
        return;
    }
    chosen_ = routine;
    steps_.clear();
    outcome_ = {};
    Q_EMIT chosenChanged();
    Q_EMIT runChanged();
}

std::optional<double> InstructionsPresenter::numberOf(const protocol::TableParameter& parameter) const {
    const auto typed = typed_.find(shown(parameter.name));
    if (typed == typed_.end()) {
        return parameter.least;
    }
    bool is_number = false;
    double value = QLocale().toDouble(typed->second, &is_number);
    if (!is_number) {
        value = QLocale::c().toDouble(typed->second, &is_number);
    }
    const bool fits = is_number && value >= parameter.least.value_or(value) && value <= parameter.most.value_or(value);
    return fits ? std::optional(value) : std::nullopt;
}

std::vector<RoutineField> InstructionsPresenter::fields() const {
    std::vector<RoutineField> all;
    if (chosen() == nullptr) {
        return all;
    }
    for (const auto& parameter : chosen()->parameters()) {
        const QString name = shown(parameter.name);
        const auto typed = typed_.find(name);
        const QString usual = parameter.least ? number(*parameter.least) : QString();
        all.push_back({.name = name,
                       .range = rangeText(parameter),
                       .text = typed == typed_.end() ? usual : typed->second,
                       .is_right = numberOf(parameter).has_value()});
    }
    return all;
}

void InstructionsPresenter::setField(const QString& name, const QString& text) {
    typed_[name] = text.trimmed();
    Q_EMIT chosenChanged();
    Q_EMIT runChanged();
}

void InstructionsPresenter::setBelievesTable(bool believes) { believes_table_ = believes; }

std::optional<InstructionsPresenter::Numbers> InstructionsPresenter::numbers() const {
    Numbers all;
    for (const auto& parameter : chosen()->parameters()) {
        const auto value = numberOf(parameter);
        if (!value) {
            return std::nullopt;
        }
        all[parameter.name] = *value;
    }
    return all;
}

const protocol::TableRoutine* InstructionsPresenter::saved() const { return file_.table().find(chosen_.toStdString()); }

QString InstructionsPresenter::runNote() const { return saved() == nullptr ? QString() : shown(saved()->note); }

QString InstructionsPresenter::numbersTrouble() const {
    if (running_ != Running::kNothing) {
        return tr("A routine is running.");
    }
    if (chosen() == nullptr) {
        return tr("The table has no routine.");
    }
    for (const auto& field : fields()) {
        if (!field.is_right) {
            return field.range.isEmpty() ? tr("The number \"%1\" is missing.").arg(field.name)
                                         : tr("The number \"%1\" goes from %2.").arg(field.name, field.range);
        }
    }
    return {};
}

QString InstructionsPresenter::dryRunTrouble() const {
    if (!table_.problems.empty()) {
        return tr("The table has problems: line %1.").arg(table_.problems.front().line);
    }
    return numbersTrouble();
}

/// The fields are those of the text: the numbers in them must mean the same to the saved table.
QString InstructionsPresenter::savedTrouble() const {
    if (saved() == nullptr) {
        return file_.problems().empty() ? tr("%1 is not saved yet.").arg(chosen_)
                                        : tr("The saved table has problems: line %1.").arg(file_.problems().front().line);
    }
    return saved()->parameters() == chosen()->parameters() ? QString() : tr("The saved %1 takes other numbers than this text.").arg(chosen_);
}

QString InstructionsPresenter::runSentence() const {
    if (saved() == nullptr || (!isModified() && file_.problems().empty())) {
        return {};
    }
    return isModified() ? tr("Run takes the table as it was saved, not this text.")
                        : tr("Run takes the last table that was saved without a problem.");
}

QString InstructionsPresenter::runTrouble() const {
    if (const QString trouble = numbersTrouble(); !trouble.isEmpty()) {
        return trouble;
    }
    if (const QString trouble = savedTrouble(); !trouble.isEmpty()) {
        return trouble;
    }
    if (instrument_.connectionState() != ConnectionState::kConnected) {
        return tr("No instrument is connected.");
    }
    if (instrument_.choice().dialect != instrument::LineDialect::kBus) {
        return tr("The connected line is the external interface, not the bus under the panel.");
    }
    return {};
}

bool InstructionsPresenter::mustConfirmNote() const {
    return !runNote().isEmpty() && !confirmed_.contains(chosen_ + u'\n' + runNote());
}

void InstructionsPresenter::confirmNote() { confirmed_.insert(chosen_ + u'\n' + runNote()); }

void InstructionsPresenter::begin(Running what, const protocol::TableRoutine& routine) {
    running_ = what;
    outcome_ = {.state = DeviceState::kBusy,
                .text = what == Running::kDryRun ? tr("Dry run of %1").arg(chosen_) : tr("%1 runs").arg(chosen_),
                .details = {}};
    steps_.begin(routine, numbers().value_or(Numbers()));
    Q_EMIT runChanged();
}

void InstructionsPresenter::startDryRun() {
    if (!dryRunTrouble().isEmpty()) {
        return;
    }
    begin(Running::kDryRun, *chosen());
    cancel_dry_run_ = std::make_shared<std::atomic<bool>>(false);
    dry_outcome_ = std::make_shared<core::Result<instrument::RoutineOutcome>>(core::cancelled());
    const auto promise = std::make_shared<QPromise<instrument::StepOutcome>>();
    watcher_.setFuture(promise->future());
    promise->start();
    const DryRunOrder order{.routine = *chosen(), .numbers = *numbers(), .believes_table = believes_table_};
    const auto work = [promise, order, cancelled = cancel_dry_run_, outcome = dry_outcome_] {
        *outcome = dryRun(order, *cancelled, [&promise](const instrument::StepOutcome& step) { promise->addResult(step); });
        promise->finish();
    };
    if (threading_ == Threading::kOwnThread) {
        QThreadPool::globalInstance()->start(work);
    } else {
        work();
    }
}

void InstructionsPresenter::startRun() {
    if (!runTrouble().isEmpty() || mustConfirmNote()) {
        return;
    }
    const protocol::TableRoutine routine = *saved();
    begin(Running::kRun, routine);
    ticket_ = instrument_.runRoutine(routine, *numbers());
}

void InstructionsPresenter::cancel() {
    if (running_ == Running::kDryRun) {
        *cancel_dry_run_ = true;
    } else if (running_ == Running::kRun) {
        outcome_.details = tr("Waiting for the step on the line.");
        instrument_.cancel(ticket_);
        Q_EMIT runChanged();
    }
}

void InstructionsPresenter::finish(const core::Result<instrument::RoutineOutcome>& outcome) {
    const bool was_dry = std::exchange(running_, Running::kNothing) == Running::kDryRun;
    if (outcome) {
        outcome_ = {.state = DeviceState::kGood,
                    .text = was_dry ? tr("The dry run of %1 went well.").arg(chosen_) : tr("%1 went well.").arg(chosen_),
                    .details = {}};
    } else {
        const bool cancelled = outcome.error().kind == core::ErrorKind::kCancelled;
        outcome_ = {.state = cancelled ? DeviceState::kWarning : DeviceState::kFailed,
                    .text = reasonOf(outcome.error()),
                    .details = {}};
    }
    Q_EMIT runChanged();
}

}  // namespace pmts::app
