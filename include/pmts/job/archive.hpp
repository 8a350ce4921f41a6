#pragma once

#include <QByteArray>
#include <QString>

#include <functional>
#include <optional>

namespace pmts::job {

/// A file inside a zip archive; absent when there is none of that name. `wanted` is asked once a megabyte, false ends the
/// reading early.
[[nodiscard]] std::optional<QByteArray> archivedFile(const QString& archive, const QString& name,
                                                     const std::function<bool()>& wanted = {});

}  // namespace pmts::job
