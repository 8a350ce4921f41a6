#pragma once

#include <QSettings>

namespace pmts::app {

/// An enumerator kept as its number; one that this version does not know keeps the default.
template <class Enum>
Enum enumFrom(const QSettings& file, const char* key, Enum fallback, int last) {
    bool is_number = false;
    const int value = file.value(QLatin1String(key), static_cast<int>(fallback)).toInt(&is_number);
    return is_number && value >= 0 && value <= last ? static_cast<Enum>(value) : fallback;
}

/// A number within bounds, else the default.
inline double numberFrom(const QSettings& file, const char* key, double fallback, double least, double most) {
    bool is_number = false;
    const double value = file.value(QLatin1String(key), fallback).toDouble(&is_number);
    return is_number && value >= least && value <= most ? value : fallback;
}

}  // namespace pmts::app
