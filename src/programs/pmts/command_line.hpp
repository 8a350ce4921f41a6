#pragma once

#include "pmts/app/desk/workbench.hpp"
#include "pmts/core/result.hpp"
#include "pmts/gui/theme.hpp"

#include <QString>
#include <QStringList>

#include <optional>

namespace pmts {

/// What the command line of `pmts` says.
struct CommandLine {
    app::StartOptions start;
    std::optional<gui::PaletteName> palette;
    QString instrument;  ///< `simulated`, a port, or empty: the last one
    bool camera = true;
    QString rehearsal_folder;  ///< of --unattended
    QSize window_size;         ///< of --size; empty: as remembered
    double text_scale = 0.0;   ///< of --text; 0: as remembered
    bool right_to_left = false;
    bool help = false;
    bool version = false;
};

/// kBadInput naming the argument.
[[nodiscard]] core::Result<CommandLine> commandLineFrom(const QStringList& arguments);

[[nodiscard]] QString helpText();

}  // namespace pmts
