#pragma once

#include <QSettings>

namespace pmts::app {

/// What the black box keeps, and how much of it.
struct BlackBoxSettings {
    bool on = true;
    int kept_mb = 300;              ///< all its files together; the oldest goes first
    double frames_per_s = 1.0;      ///< pictures kept of the live view; 0: none

    [[nodiscard]] bool operator==(const BlackBoxSettings&) const = default;

    /// What is missing or out of range keeps its default.
    void load(const QSettings& file);
    void save(QSettings& file) const;
};

}  // namespace pmts::app
