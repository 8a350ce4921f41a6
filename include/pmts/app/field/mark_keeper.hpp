#pragma once

#include "pmts/app/field/image_marks.hpp"
#include "pmts/app/desk/job_desk.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/desk/message_centre.hpp"

#include <QHash>
#include <QObject>

namespace pmts::app {

/// Keeps the marks that belong to a photo in the job, and brings them back when it is opened. Marks drawn before the
/// first still of a job are kept in memory only.
class MarkKeeper : public QObject {
    Q_OBJECT
public:
    MarkKeeper(ImageMarks& marks, JobDesk& job, const LivePresenter& live, MessageCentre& messages,
               QObject* parent = nullptr);

private:
    void readJob(const JobContents& contents);
    void takeLoaded(Ticket ticket, qint64 photo_row, const std::vector<job::ImageMark>& stored);
    void takeAdded(Ticket ticket, const job::ImageMark& stored);
    void store(const ImageMark& mark);
    void storeAgain(const ImageMark& mark);
    void drop(qint64 id);

    ImageMarks& marks_;
    JobDesk& job_;
    const LivePresenter& live_;
    MessageCentre& messages_;
    QHash<qint64, job::Photo> photos_;        ///< of the job as it was opened
    QHash<qint64, job::ImageMark> stored_;    ///< by the mark's id
    QHash<Ticket, qint64> being_added_;       ///< mark's id
    QHash<Ticket, qint64> being_loaded_;      ///< photo's row
    QSet<Ticket> being_changed_;
    bool reading_ = false;
};

}  // namespace pmts::app
