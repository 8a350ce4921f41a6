#pragma once

#include "pmts/core/result.hpp"

#include <QByteArray>

namespace pmts::app {

/// kFile: this file cannot be written, why not, and what to do.
[[nodiscard]] tl::unexpected<core::Error> cannotWrite(const QString& path, const QString& why);

/// All of the bytes or nothing: a file of before stays as it was when they cannot be written.
[[nodiscard]] core::Result<void> writeWhole(const QString& path, const QByteArray& bytes);

}  // namespace pmts::app
