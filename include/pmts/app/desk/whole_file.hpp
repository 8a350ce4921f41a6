#pragma once

#include "pmts/core/result.hpp"

#include <QByteArray>

#include <functional>

class QIODevice;

namespace pmts::app {

/// kFile: this file cannot be written, why not, and what to do.
[[nodiscard]] tl::unexpected<core::Error> cannotWrite(const QString& path, const QString& why);

/// All of the bytes or nothing: a file of before stays as it was when they cannot be written.
[[nodiscard]] core::Result<void> writeWhole(const QString& path, const QByteArray& bytes);
/// The same piece by piece; `write` says false to give it up, or when the file took less than it was given.
[[nodiscard]] core::Result<void> writeWhole(const QString& path, const std::function<bool(QIODevice& file)>& write);

/// kFile: it cannot be read, or it is larger than that.
[[nodiscard]] core::Result<QByteArray> readWhole(const QString& path, qint64 most_bytes);

/// Of a job file, an area file or a backup of labels: far above any instrument's memory.
inline constexpr qint64 kLargestMemoryFile = qint64{4} << 20;

}  // namespace pmts::app
