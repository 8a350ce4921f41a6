#pragma once

#include "pmts/app/line/line_event.hpp"
#include "pmts/protocol/units.hpp"

#include <QDateTime>
#include <QMap>
#include <QStringList>

namespace pmts::app {

/// Events of the line in plain language. A value: a copy serves another thread.
struct LineWords {
    std::optional<protocol::WireUnits> units;  ///< label 23, when known
    QMap<QString, QString> names;              ///< of the user, by variableKey()
    QDateTime utc_of_zero;                     ///< of core::Clock; fixed: a clock that is set meanwhile must not move what was

    [[nodiscard]] QDateTime utcOf(core::Duration at) const;
    [[nodiscard]] QString timeOfDay(const LineEvent& event) const;
    [[nodiscard]] QString who(const LineEvent& event) const;
    [[nodiscard]] QString what(const LineEvent& event) const;
    [[nodiscard]] QString answer(const LineEvent& event) const;
    [[nodiscard]] QString outcome(const LineEvent& event) const;  ///< of a transaction
    /// Everything about it, in lines: the panel beside the lanes.
    [[nodiscard]] QStringList details(const LineEvent& event) const;
};

/// `52 ms`, `3.2 s`: a span of time as people say it.
[[nodiscard]] QString spanText(core::Duration span);
/// Bytes of the line with `<CR>` and `<07>` for those that would not show.
[[nodiscard]] QString bytesText(const std::string& bytes);

}  // namespace pmts::app
