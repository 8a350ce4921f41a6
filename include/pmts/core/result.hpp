#pragma once

#include <QString>
#include <tl/expected.hpp>

#include <optional>
#include <utility>

namespace pmts::core {

/// What kind of trouble it is: what the program does next hangs on this, never on a text.
enum class ErrorKind {
    kCancelled,        ///< somebody pressed Cancel or Stop, or the owner went away
    kTimeOut,          ///< no answer within the limit
    kLinkLost,         ///< cable pulled, device gone, port closed under us
    kPortUnavailable,  ///< the port cannot be opened: missing, busy, no permission
    kNotConnected,     ///< a command was given without an instrument
    kRefused,          ///< the deny list or a mode of control forbids it
    kDevice,           ///< the instrument answered with an info code
    kProtocol,         ///< the answer was not understood
    kAbsurdPoint,      ///< no distance within the wait limit; the shot is not used
    kNotReached,       ///< the motion ended outside its tolerance
    kLimit,            ///< outside the motion limits or the value's range
    kUndefined,        ///< geometry without a solution (plumb line, no intersection, behind the camera)
    kBadInput,         ///< a person typed or a file held something that cannot be read
    kFile,             ///< read-only, full, damaged, foreign, opened twice
    kCamera,           ///< camera missing, busy, unplugged, silent
    kUnsupported,      ///< this device or dialect cannot do it
};

/// Expected trouble as a value. Both sentences are for the surveyor; `info_code` and `detail` are for the log.
struct Error {
    ErrorKind kind = ErrorKind::kProtocol;
    QString happened;              ///< one sentence: what happened
    QString remedy;                ///< one sentence: what to do; empty when there is nothing to do
    std::optional<int> info_code;  ///< the instrument's own code without its device suffix
    QString detail;                ///< raw evidence: bytes, path, errno text

    /// Both sentences, for a message bar.
    [[nodiscard]] QString sentence() const { return remedy.isEmpty() ? happened : happened + u' ' + remedy; }
};

template <class T>
using Result = tl::expected<T, Error>;

[[nodiscard]] inline tl::unexpected<Error> fail(ErrorKind kind, QString happened, QString remedy = {},
                                                QString detail = {}) {
    return tl::unexpected(
        Error{kind, std::move(happened), std::move(remedy), std::nullopt, std::move(detail)});
}

[[nodiscard]] inline tl::unexpected<Error> cancelled() {
    return fail(ErrorKind::kCancelled, QStringLiteral("The action was cancelled."));
}

}  // namespace pmts::core

/// Returns the error of a Result<T> from the enclosing function, or drops its value.
#define PMTS_TRY(expression)                                               \
    do {                                                                   \
        auto pmts_outcome = (expression);                                  \
        if (!pmts_outcome) {                                               \
            return ::tl::unexpected(std::move(pmts_outcome).error());      \
        }                                                                  \
    } while (false)

/// The same inside a coroutine. gcc 12 destroys the temporaries of an awaited call twice, so name the task first:
/// auto sending = line.execute(...); PMTS_CO_TRY(co_await sending);
#define PMTS_CO_TRY(expression)                                            \
    do {                                                                   \
        auto pmts_outcome = expression;                                    \
        if (!pmts_outcome) {                                               \
            co_return ::tl::unexpected(std::move(pmts_outcome).error());   \
        }                                                                  \
    } while (false)
