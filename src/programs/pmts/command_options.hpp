#pragma once

#include "pmts/core/result.hpp"

#include <QCommandLineParser>

#include <initializer_list>

namespace pmts {

/// An option of a command that runs without a window; it takes a value.
struct ValueOption {
    const char* name;
    const char* value;  ///< `LENGTH`: what the help calls it
    const char* usual;  ///< where it is not given
};

/// Reads the words of such a command. kBadInput when one is unknown or too many.
[[nodiscard]] core::Result<void> readOptions(QCommandLineParser& parser, const QStringList& arguments,
                                             std::initializer_list<ValueOption> options, const QString& flag);

/// The value of this option cannot be read; `example` can.
[[nodiscard]] tl::unexpected<core::Error> unreadable(const QString& option, const QString& example);

}  // namespace pmts
