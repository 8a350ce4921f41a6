#include "pmts/app/field/method_report_presenter.hpp"

#include "pmts/app/field/method_fit.hpp"
#include "pmts/app/desk/whole_file.hpp"
#include "report_form.hpp"

#include <QFile>
#include <QFileInfo>
#include <QPromise>
#include <QThreadPool>

static void nameExamples() { Q_INIT_RESOURCE(examples); }  // outside every namespace, as the macro wants

namespace pmts::app {

namespace {

const QString kThesisExample = QStringLiteral(":/pmts/examples/thesis-targets.csv");

}  // namespace

MethodReportPresenter::MethodReportPresenter(LivePresenter& live, JobDesk& job, const PointsModel& points,
                                             const StationPresenter& station, const RangeKeeper& range,
                                             const Preferences& preferences, Threading threading, QObject* parent)
    : QObject(parent), live_(live), range_(range), preferences_(preferences), threading_(threading), targets_(preferences),
      collector_(targets_, live, job, points, station, preferences) {
    connect(&targets_, &TargetListModel::targetsChanged, this, [this] {
        forget();
        if (targets_.isEmpty()) {
            useStill();  // what is collected next is of the chosen still
        }
    });
    connect(&collector_, &TargetCollector::stillChosen, this, &MethodReportPresenter::useStill);
    connect(&collector_, &TargetCollector::said, this, &MethodReportPresenter::said);
    connect(&collector_, &TargetCollector::problemReported, this, &MethodReportPresenter::problemReported);
    connect(&preferences_, &Preferences::unitsChanged, this, [this] {
        Q_EMIT formChanged();
        if (shown_) {
            show(*shown_);
        }
    });
    connect(&watcher_, &QFutureWatcherBase::progressValueChanged, this,
            [this](int done) { Q_EMIT progressChanged(done, watcher_.progressMaximum()); });
    connect(&watcher_, &QFutureWatcherBase::finished, this, &MethodReportPresenter::finishFit);
}

MethodReportPresenter::~MethodReportPresenter() {
    watcher_.disconnect(this);
    watcher_.cancel();
    watcher_.waitForFinished();
}

MethodReportForm MethodReportPresenter::form() const { return reportFormOf(options_, rig_, preferences_.units()); }

void MethodReportPresenter::openThesisExample() {
    nameExamples();
    const auto targets = targeting::readTargetFile(kThesisExample);
    if (!targets) {
        Q_EMIT problemReported(targets.error());
        return;
    }
    options_ = {};
    rig_ = RigOfReport::kFitted;
    targets_.setTargets(*targets, tr("the thesis's tables 6.1 to 6.4"));
    Q_EMIT formChanged();
    Q_EMIT said(tr("The thesis's 11 targets and its camera are loaded. Run computes all methods."));
}

void MethodReportPresenter::openTable(const QString& path) {
    auto targets = targeting::readTargetFile(path);
    if (!targets) {
        Q_EMIT problemReported(targets.error());
        return;
    }
    QFile file(path);
    const bool has_options = file.open(QIODevice::ReadOnly | QIODevice::Text) &&
                             takeArguments(QString::fromUtf8(file.readAll()), options_);
    targets_.setTargets(*std::move(targets), QFileInfo(path).fileName());
    Q_EMIT formChanged();
    Q_EMIT said(has_options ? tr("The targets and the camera of their photo are loaded.")
                            : tr("The targets are loaded. Check the camera and the pointing of their photo."));
}

void MethodReportPresenter::saveTable(const QString& path) {
    if (targets_.isEmpty()) {
        Q_EMIT said(tr("There is no target to save."));
        return;
    }
    write(path, targeting::targetListText(targets_.targets(), optionsComment()));
}

QString MethodReportPresenter::optionsComment() const {
    return tr("Targets of %1; sd m; angles gon; u, v px. To print the report without a window:").arg(targets_.source()) +
           QStringLiteral("\npmts --method-report FILE.csv ") + argumentsOf(options_);
}

void MethodReportPresenter::useStill() {
    const CollectibleStill* const still = collector_.still();
    if (still == nullptr || (!targets_.isEmpty() && targets_.source() != still->name)) {
        return;  // the list on the desk is of another photo
    }
    const RigProfile profile = preferences_.settings().chosenRig();
    const targeting::PixelToPointing model(still->rig);
    // The thesis counts from the cross-hair: the pixel of the telescope's axis, here at the assumed range.
    const auto reticle = model.reticlePixel(still->pointing, range_.assumed());
    options_ = {};
    options_.width_px = still->rig.width_px;
    options_.height_px = still->rig.height_px;
    options_.photo = still->pointing;
    options_.camera.centre_px = reticle ? *reticle : still->rig.lens.principalPoint();
    options_.camera.f_px = still->rig.lens.focalLengthPx();
    options_.nominal_mount = still->rig.mount.kind;
    options_.offset_right_m = still->rig.mount.offset_m.x();
    options_.camera.forward_m = still->rig.mount.offset_m.y();
    options_.camera.up_m = still->rig.mount.offset_m.z();
    options_.pixel_angle_given = profile.average_pixel_angle.has_value();
    options_.camera.pixel_angle = profile.average_pixel_angle.value_or(targeting::AveragePixelAngle{});
    rig_ = RigOfReport::kInUse;
    Q_EMIT formChanged();
}

bool MethodReportPresenter::readField(ReportField field, const QString& text, targeting::MethodReportOptions& options) {
    if (text == reportFormOf(options, rig_, preferences_.units()).fields.at(field)) {
        return true;  // untouched: what it shows is rounded
    }
    const auto read = readReportField(field, text, preferences_.units(), options);
    if (!read) {
        Q_EMIT fieldRejected(field, read.error());
    }
    return read.has_value();
}

bool MethodReportPresenter::keepForm(const MethodReportForm& form) {
    targeting::MethodReportOptions next = options_;
    bool all = true;
    for (const auto& [field, text] : form.fields) {
        all = readField(field, text, next) && all;
    }
    const QString across = form.fields.at(ReportField::kPixelAcross).trimmed();
    const QString down = form.fields.at(ReportField::kPixelDown).trimmed();
    next.pixel_angle_given = !across.isEmpty() && !down.isEmpty();
    if (across.isEmpty() != down.isEmpty()) {
        const core::Error half{.kind = core::ErrorKind::kBadInput,
                               .happened = tr("Only one of the two pixel angles is given."),
                               .remedy = tr("Enter both, or none: then they are measured between the outermost targets."),
                               .info_code = std::nullopt, .detail = {}};
        Q_EMIT fieldRejected(across.isEmpty() ? ReportField::kPixelAcross : ReportField::kPixelDown, half);
        all = false;
    }
    next.nominal_mount = form.on_handle ? camera::MountKind::kHandle : camera::MountKind::kTelescope;
    options_ = next;
    rig_ = form.rig;
    return all;
}

void MethodReportPresenter::run(const MethodReportForm& form) {
    if (isRunning() || !keepForm(form)) {
        return;
    }
    if (targets_.isEmpty()) {
        Q_EMIT said(tr("There is no target yet. Open a table, or collect targets in a still."));
        return;
    }
    if (rig_ == RigOfReport::kFitted) {
        return startFit();
    }
    targeting::MethodReportOptions options = options_;
    if (rig_ == RigOfReport::kInUse) {
        const CollectibleStill* const still = collector_.still();
        const bool of_still = still != nullptr && still->name == targets_.source();
        options.rig = of_still ? still->rig : preferences_.settings().chosenRig().rig;
    }
    show(options);
    Q_EMIT said(tr("The report is ready."));
}

void MethodReportPresenter::startFit() {
    const auto promise = std::make_shared<QPromise<Fit>>();
    fit_options_ = options_;
    watcher_.setFuture(promise->future());
    promise->start();
    const auto work = [promise, targets = targets_.targets(), options = options_] {
        promise->addResult(fitToTargets(targets, options, [&promise](int done, int all) {
            promise->setProgressRange(0, all);
            promise->setProgressValue(done);
            return !promise->isCanceled();
        }));
        promise->finish();
    };
    Q_EMIT runningChanged(true);
    if (threading_ == Threading::kOwnThread) {
        QThreadPool::globalInstance()->start(work);
    } else {
        work();
    }
}

void MethodReportPresenter::cancel() { watcher_.cancel(); }

void MethodReportPresenter::finishFit() {
    Q_EMIT runningChanged(false);
    if (watcher_.isCanceled() || watcher_.future().resultCount() == 0) {
        Q_EMIT said(tr("The fit was cancelled."));
        return;
    }
    const Fit fit = watcher_.result();
    if (!fit) {
        Q_EMIT problemReported(fit.error());
        return;
    }
    fit_options_.fit = *fit;
    show(fit_options_);
    Q_EMIT said(tr("The report is ready."));
}

void MethodReportPresenter::show(const targeting::MethodReportOptions& options) {
    shown_ = options;
    view_ = methodReportView(targets_.targets(), options, preferences_.units());
    Q_EMIT viewChanged();
}

void MethodReportPresenter::forget() {
    watcher_.cancel();  // of the list as it was
    if (view_) {
        view_.reset();
        shown_.reset();
        Q_EMIT viewChanged();
    }
}

void MethodReportPresenter::saveText(const QString& path) {
    if (shown_) {
        targeting::MethodReportOptions options = *shown_;
        options.angle_unit = preferences_.units().angle_unit;
        write(path, targeting::methodReport(targets_.targets(), options));
    }
}

void MethodReportPresenter::saveCsv(const QString& path) {
    if (view_) {
        write(path, csvOf(*view_));
    }
}

void MethodReportPresenter::write(const QString& path, const QString& text) {
    if (const auto written = writeWhole(path, text.toUtf8()); !written) {
        Q_EMIT problemReported(written.error());
        return;
    }
    Q_EMIT said(tr("Saved as %1.").arg(path));
}

}  // namespace pmts::app
