#pragma once

#include "pmts/protocol/line_decoding.hpp"

#include <QStringList>

#include <optional>

namespace pmts::line {

enum class Command { kDecode, kPins, kCorrelate, kSearch, kTable };

struct Request {
    Command command = Command::kDecode;
    QString path;
    QString panel;                                  ///< for kCorrelate: what the panel showed
    QString wanted;                                 ///< for kSearch: text or bytes
    QString routine;                                ///< for kTable: its name
    std::optional<protocol::CaptureFormat> format;  ///< absent: guessed
    std::optional<double> samples_per_s;
    std::optional<int> line;             ///< absent: the busiest
    std::optional<double> baud;          ///< absent: found
    std::optional<protocol::Framing> form;  ///< data bits, parity, order, polarity; absent: found
    bool hex = false;
    bool times = false;  ///< when each line was said
    std::optional<QString> text;  ///< help or version: print it and end
};

/// `decode|pins|correlate|search|table FILE [options]`. kBadInput names the argument.
[[nodiscard]] core::Result<Request> readCommandLine(const QStringList& arguments);

}  // namespace pmts::line
