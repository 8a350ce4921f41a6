#include "job_step.hpp"

#include <utility>

namespace pmts::app {

namespace {

/// Null when the stack's step at this place is of another kind, or there is none.
JobStep::Fate* fateAt(const QUndoStack& undo, int index) {
    const auto* step = dynamic_cast<const JobStep*>(undo.command(index));
    return step ? &step->fate() : nullptr;
}

void dropRefusedTop(QUndoStack& undo) {
    for (auto* top = fateAt(undo, undo.index() - 1); top && top->refused; top = fateAt(undo, undo.index() - 1)) {
        undo.undo();  // obsolete: the stack deletes it
    }
}

}  // namespace

JobStep::JobStep(const QString& text, bool already_done) : QUndoCommand(text) { fate_->only_move = already_done; }

void JobStep::redo() {
    if (!std::exchange(fate_->only_move, false)) {
        fate_->forward = true;
        fate_->ticket = write(true);
    }
}

void JobStep::undo() {
    if (fate_->refused) {
        setObsolete(true);
    } else {
        fate_->forward = false;
        fate_->ticket = write(false);
    }
}

void takeBackRefused(QUndoStack& undo, Ticket ticket) {
    for (int i = 0; i < undo.count(); ++i) {
        JobStep::Fate* const fate = fateAt(undo, i);
        if (!fate || fate->ticket != ticket) {
            continue;
        }
        if (fate->forward) {
            fate->refused = true;
            return dropRefusedTop(undo);
        }
        if (i == undo.index()) {
            fate->only_move = true;
            undo.redo();
        }
        return;
    }
}

}  // namespace pmts::app
