#pragma once

#include "pmts/app/desk/threading.hpp"

#include <QUndoCommand>
#include <QUndoStack>

#include <memory>

namespace pmts::app {

/// An undo step that is shown at once and written to the job, which may refuse it later: see takeBackRefused().
class JobStep : public QUndoCommand {
public:
    /// What became of the step's newest request.
    struct Fate {
        Ticket ticket = 0;
        bool forward = true;     ///< the request was a redo
        bool only_move = false;  ///< the next undo or redo only moves the stack's place
        bool refused = false;    ///< never happened: it leaves the stack when the stack comes to it
    };

    /// `already_done`: its push does nothing, the change has happened.
    JobStep(const QString& text, bool already_done);

    void redo() final;
    void undo() final;
    [[nodiscard]] Fate& fate() const { return *fate_; }

protected:
    /// Shows the change, or takes it back, and asks the job to write it.
    virtual Ticket write(bool forward) = 0;

private:
    std::unique_ptr<Fate> fate_ = std::make_unique<Fate>();
};

/// The job refused this request: a step that did not happen leaves the stack, one whose undo failed is done again.
void takeBackRefused(QUndoStack& undo, Ticket ticket);

}  // namespace pmts::app
