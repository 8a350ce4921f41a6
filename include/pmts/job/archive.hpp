#pragma once

#include <QByteArray>
#include <QString>

#include <functional>
#include <optional>

namespace pmts::job {

/// A file inside a zip archive, or its first `most_bytes`: a megabyte may unpack to a thousand. Absent when there is none of
/// that name. `wanted` is asked once a megabyte, false ends the reading early.
[[nodiscard]] std::optional<QByteArray> archivedFile(const QString& archive, const QString& name, qint64 most_bytes,
                                                     const std::function<bool()>& wanted = {});

}  // namespace pmts::job
