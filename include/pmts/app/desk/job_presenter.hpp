#pragma once

#include "pmts/app/desk/job_desk.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/settings/preferences.hpp"

#include <QObject>

namespace pmts::app {

/// New, open, close and export of jobs.
class JobPresenter : public QObject {
    Q_OBJECT
public:
    JobPresenter(JobDesk& job, Preferences& preferences, MessageCentre& messages, QObject* parent = nullptr);

    [[nodiscard]] bool isOpen() const { return job_.isOpen(); }
    [[nodiscard]] QString name() const { return job_.name(); }
    [[nodiscard]] QString path() const { return job_.path(); }
    [[nodiscard]] QStringList recentJobs() const;
    [[nodiscard]] static QString exportFilter();  ///< for a file dialog: CSV, GeoJSON, DXF

public Q_SLOTS:
    void createJob(const QString& path);
    void openJob(const QString& path);
    void closeJob();
    void exportTo(const QString& path);  ///< format by the file's ending

Q_SIGNALS:
    void jobChanged();  ///< opened or closed: take name()
    void exported(const QString& path);

private:
    void onOpened(const JobContents& contents);

    JobDesk& job_;
    Preferences& preferences_;
    MessageCentre& messages_;
    Ticket export_ticket_ = 0;
};

}  // namespace pmts::app
