#pragma once

#include "pmts/app/field/method_page.hpp"
#include "pmts/app/field/target_collector.hpp"
#include "pmts/app/field/target_list_model.hpp"

#include <QFutureWatcher>
#include <QObject>

#include <map>
#include <optional>

namespace pmts::app {

/// What the rigorous method and the distortion table are taken from.
enum class RigOfReport {
    kNominal,  ///< the camera of the fields, without distortion
    kInUse,    ///< the chosen rig profile
    kFitted,   ///< 8 parameters fitted to the targets; with left-one-out
};

enum class ReportField { kWidth, kHeight, kCentreX, kCentreY, kPhotoHa, kPhotoVa, kF, kRight, kForward, kUp, kPixelAcross,
                         kPixelDown };

/// The options of a report as texts; quantities carry their unit. The pixel angles may be empty.
struct MethodReportForm {
    std::map<ReportField, QString> fields;
    bool on_handle = true;
    RigOfReport rig = RigOfReport::kFitted;
};

/// The thesis's methods over a list of targets: options, run, report.
class MethodReportPresenter : public QObject {
    Q_OBJECT
public:
    MethodReportPresenter(LivePresenter& live, JobDesk& job, const PointsModel& points, const StationPresenter& station,
                          const RangeKeeper& range, const Preferences& preferences,
                          Threading threading = Threading::kOwnThread, QObject* parent = nullptr);
    ~MethodReportPresenter() override;  ///< a running fit is cancelled and waited for

    [[nodiscard]] TargetListModel& targets() { return targets_; }
    [[nodiscard]] TargetCollector& collector() { return collector_; }
    [[nodiscard]] MethodReportForm form() const;
    [[nodiscard]] const std::optional<MethodReportView>& view() const { return view_; }
    [[nodiscard]] bool isRunning() const { return watcher_.isRunning(); }

public Q_SLOTS:
    void openThesisExample();  ///< the table of the thesis, with its options
    void openTable(const QString& path);
    void saveTable(const QString& path);
    /// Keeps what can be read; fieldRejected() says what cannot. True when all could be read.
    bool keepForm(const pmts::app::MethodReportForm& form);
    /// The fit of kFitted runs in the pool: progressChanged(), then viewChanged() or problemReported().
    void run(const pmts::app::MethodReportForm& form);
    void cancel();
    void saveText(const QString& path);
    void saveCsv(const QString& path);

Q_SIGNALS:
    void formChanged();
    void fieldRejected(pmts::app::ReportField field, const pmts::core::Error& error);
    void runningChanged(bool running);
    void progressChanged(int done, int all);
    void viewChanged();  ///< take view(): absent when the list or the options are not those of the report any more
    void said(const QString& sentence);
    void problemReported(const pmts::core::Error& error);

private:
    using Fit = core::Result<targeting::FittedRig>;

    bool readField(ReportField field, const QString& text, targeting::MethodReportOptions& options);
    void useStill();
    void startFit();
    void finishFit();
    void show(const targeting::MethodReportOptions& options);
    void forget();
    void write(const QString& path, const QString& text);
    [[nodiscard]] QString optionsComment() const;

    LivePresenter& live_;
    const RangeKeeper& range_;
    const Preferences& preferences_;
    Threading threading_;
    TargetListModel targets_;
    TargetCollector collector_;
    targeting::MethodReportOptions options_;
    RigOfReport rig_ = RigOfReport::kFitted;
    std::optional<targeting::MethodReportOptions> shown_;  ///< what the view was made with
    std::optional<MethodReportView> view_;
    targeting::MethodReportOptions fit_options_;  ///< of the running fit
    QFutureWatcher<Fit> watcher_;
};

}  // namespace pmts::app
