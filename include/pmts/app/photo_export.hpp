#pragma once

#include "pmts/app/job_desk.hpp"
#include "pmts/app/message_centre.hpp"
#include "pmts/job/photo_file.hpp"

#include <QObject>

namespace pmts::app {

/// A stored photo with everything its rig JSON knows of the moment it was taken.
[[nodiscard]] job::PhotoFile photoFileOf(const job::Photo& photo);

/// File > Export photos: every photo of the job into a folder, each with EXIF, XMP and a sidecar file.
class PhotoExport : public QObject {
    Q_OBJECT
public:
    PhotoExport(JobDesk& job, MessageCentre& messages, QObject* parent = nullptr);

public Q_SLOTS:
    void exportTo(const QString& folder);

private:
    JobDesk& job_;
    MessageCentre& messages_;
    Ticket ticket_ = 0;
};

}  // namespace pmts::app
