#pragma once

#include "pmts/app/line/black_box_presenter.hpp"
#include "pmts/app/desk/job_desk.hpp"
#include "pmts/blackbox/excerpt.hpp"
#include "pmts/blackbox/zip_file.hpp"

#include <QObject>

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

namespace pmts::app {

/// Names and places that must not leave this computer.
struct PersonalNames {
    QString home;
    QString user;
    QString host;
    QString job_folder;
    QString data_folder;

    [[nodiscard]] static PersonalNames ofThisComputer();
    [[nodiscard]] blackbox::Scrubber scrubber() const;
};

struct BugReportOrder {
    int minutes = 10;
    bool pictures = true;
    QString words;  ///< what the user says about it
};

/// A report ready to be looked at and written.
struct BugReport {
    std::vector<blackbox::ZipEntry> files;
    QStringList inside;  ///< a line for each thing that is in it
    QString overview;    ///< report.txt, as it is written
};

/// The bug report: the last minutes of the black box, versions and settings in one zip archive, without names of people,
/// computers and folders. It is put together in the pool, shown, and only then written.
class BugReportPresenter : public QObject {
    Q_OBJECT
public:
    BugReportPresenter(BlackBoxPresenter& black_box, const Preferences& preferences, const JobDesk& job, QString log_path,
                       const core::Clock& clock, QObject* parent = nullptr);
    ~BugReportPresenter() override;

    /// Puts it together; prepared() or failed() follows. The newest order counts.
    void prepare(const BugReportOrder& order);
    [[nodiscard]] bool isBusy() const { return wanted_ != done_ || isWriting(); }
    [[nodiscard]] bool isWriting() const { return writing_ != nullptr; }
    [[nodiscard]] const std::optional<BugReport>& report() const { return report_; }
    [[nodiscard]] static QString usualName(const QDateTime& utc);
    [[nodiscard]] QDateTime utcNow() const { return clock_.utcNow(); }
    /// What was shown, all of it or nothing, written in the pool; written() or failed() follows, nothing after cancel().
    void write(const QString& path);
    void cancel();  ///< what is being put together or written
    void forget();  ///< other words, other minutes: what was shown no longer counts

    PersonalNames names = PersonalNames::ofThisComputer();  ///< besides the job's folder

Q_SIGNALS:
    void prepared();
    void failed(const pmts::core::Error& error);
    void busyChanged(bool busy);
    void writingProgressed(double done);  ///< 0 to 1
    void written(const QString& path);

private:
    using Stop = std::shared_ptr<std::atomic<bool>>;
    void take(int number, const core::Result<BugReport>& outcome);
    void endWriting(const Stop& stop, const QString& path, const core::Result<void>& outcome);

    BlackBoxPresenter& black_box_;
    const Preferences& preferences_;
    const JobDesk& job_;
    const QString log_path_;
    const core::Clock& clock_;
    int wanted_ = 0;
    int done_ = 0;
    std::optional<BugReport> report_;
    Stop writing_;  ///< set: give it up
};

}  // namespace pmts::app
