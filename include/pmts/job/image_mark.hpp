#pragma once

#include <QString>
#include <QtGlobal>

namespace pmts::job {

/// A mark somebody drew into a photo (features P2). Pixel of the photo: centre of its first pixel is (0, 0).
struct ImageMark {
    qint64 row_id = 0;  ///< of the job file; 0: not stored yet
    qint64 photo_row = 0;
    double x_px = 0.0;
    double y_px = 0.0;
    QString label;
};

}  // namespace pmts::job
