#pragma once

#include <QString>
#include <QtGlobal>

namespace pmts::survey {

/// A point of the design, to be found or staked out: nobody has measured it. Ground system, metres.
struct PlannedPoint {
    qint64 row_id = 0;  ///< of the job file; 0: not stored yet
    QString id;
    QString code;
    QString remark;
    double e_m = 0.0, n_m = 0.0, h_m = 0.0;
};

}  // namespace pmts::survey
