#pragma once

#include "pmts/app/line/instrument_air.hpp"
#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/desk/log_model.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/blackbox/record.hpp"
#include "pmts/camera/frame.hpp"

#include <QCborMap>

namespace pmts::app {

// What the program knows, as maps of black box records and back (docs/black-box.md). What is missing or of another type
// becomes a default: a file of a later version is still shown.

[[nodiscard]] QCborMap mapOf(const scheduler::TransactionRecord& record);
[[nodiscard]] scheduler::TransactionRecord transactionFrom(const QCborMap& map);

[[nodiscard]] QCborMap mapOf(const instrument::ControlStatus& status);
[[nodiscard]] instrument::ControlStatus controlFrom(const QCborMap& map);

[[nodiscard]] QCborMap mapOf(const LogLine& line);
[[nodiscard]] LogLine logLineFrom(const QCborMap& map);

[[nodiscard]] QCborMap mapOf(const Message& message);
[[nodiscard]] Message messageFrom(const QCborMap& map);

[[nodiscard]] QCborMap mapOf(const geometry::Pointing& pointing);
[[nodiscard]] std::optional<geometry::Pointing> pointingFrom(const QCborMap& map);

/// The connection and, where known, who answers.
[[nodiscard]] QCborMap mapOf(ConnectionState state, const QString& sentence, const std::optional<instrument::Identity>& identity);
[[nodiscard]] ConnectionState connectionFrom(const QCborMap& map);
[[nodiscard]] std::optional<instrument::Identity> identityFrom(const QCborMap& map);

/// The air the instrument uses, and the temperature of Lab > Profiles: that one counts as `temperature_c` where there is one.
[[nodiscard]] QCborMap mapOf(const InstrumentAir& air, const std::optional<double>& typed_degc);
[[nodiscard]] InstrumentAir airFrom(const QCborMap& map);
[[nodiscard]] std::optional<double> temperatureFrom(const QCborMap& map);  ///< whatever its source

/// A picture, at most `width_px` wide, as JPEG. Takes milliseconds: not on the GUI thread.
[[nodiscard]] QCborMap pictureMap(const camera::Frame& frame, int width_px);
/// Null where the picture cannot be read.
[[nodiscard]] camera::FramePtr pictureFrom(const QCborMap& map);

}  // namespace pmts::app
