#pragma once

#include "pmts/app/desk/job_desk.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/job/photo_file.hpp"

#include <QObject>

namespace pmts::app {

/// A stored photo with everything its rig JSON knows of the moment it was taken.
[[nodiscard]] job::PhotoFile photoFileOf(const job::Photo& photo);

/// File > Export photos: every photo of the job into a folder, each with EXIF, XMP and a sidecar file. One after the
/// other: records go in between, and Cancel ends it behind the one being written.
class PhotoExport : public QObject {
    Q_OBJECT
public:
    PhotoExport(JobDesk& job, MessageCentre& messages, QObject* parent = nullptr);

    [[nodiscard]] bool isRunning() const { return ticket_ != 0; }
    [[nodiscard]] std::size_t done() const { return done_; }
    [[nodiscard]] std::size_t count() const { return photos_.size(); }

public Q_SLOTS:
    void exportTo(const QString& folder);
    void cancel();  ///< what is written stays; the photo under way still is, whole

Q_SIGNALS:
    void progressed();  ///< of done(), count() or isRunning()

private:
    void next();
    void finish();
    void fail(core::Error error);

    JobDesk& job_;
    MessageCentre& messages_;
    Ticket ticket_ = 0;  ///< of the request under way
    bool is_cancelled_ = false;
    QString folder_;
    std::vector<job::Photo> photos_;
    std::size_t done_ = 0;
};

}  // namespace pmts::app
