#pragma once

#include "pmts/core/result.hpp"

#include <QString>
#include <QStringList>

namespace pmts {

/// `pmts --method-report FILE.csv [--image WxH] [--centre X,Y] [--pointing HA,VA] [--f PX] [--offset X,Y,Z] [--fit]`:
/// tables 6.1-6.4 of the thesis for a list of targets, without a window. kBadInput names the argument.
[[nodiscard]] core::Result<QString> methodReportFor(const QStringList& arguments);

}  // namespace pmts
