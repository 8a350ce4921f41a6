#pragma once

#include "pmts/job/evidence.hpp"

#include <QImage>

namespace pmts::app {

/// Evidence on its way to the job: the thumbnails are encoded on the job thread, into evidence.before and
/// .after. A null image stays absent. Spot and reticle are pixels of these images.
struct EvidenceShots {
    job::Evidence evidence;
    QImage before;
    QImage after;
};

}  // namespace pmts::app
