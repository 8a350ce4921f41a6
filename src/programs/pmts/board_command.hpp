#pragma once

#include "pmts/core/result.hpp"

#include <QStringList>

namespace pmts {

/// `--calibrate-board DIR --pattern 9x6 [--charuco DICT] [--square 25mm] [--marker 18mm] [--k3] [--output FILE]`: the lens from the
/// pictures of a board in a folder, without a window. Fails with kBadInput for arguments that are not understood and with
/// the calibration's own errors.
[[nodiscard]] core::Result<QString> boardCalibrationFor(const QStringList& arguments);

}  // namespace pmts
