#include "pmts/app/desk/file_saving.hpp"

#include "pmts/app/desk/whole_file.hpp"

#include <QDir>
#include <QFileInfo>
#include <QPromise>
#include <QThreadPool>

#include <cmath>

namespace pmts::app {

namespace {

constexpr int kProgressSteps = 100;

}  // namespace

FileSaving::FileSaving(Threading threading, QObject* parent) : QObject(parent), threading_(threading) {
    connect(&watcher_, &QFutureWatcherBase::finished, this, &FileSaving::finish);
    connect(&watcher_, &QFutureWatcherBase::progressValueChanged, this,
            [this](int value) { show(static_cast<double>(value) / kProgressSteps); });
}

FileSaving::~FileSaving() {
    watcher_.disconnect(this);
    watcher_.cancel();
    watcher_.waitForFinished();
}

core::Result<void> FileSaving::save(const QString& path, Make make) {
    if (isBusy()) {
        return core::fail(core::ErrorKind::kRefused, tr("“%1” is still being written.").arg(QFileInfo(path_).fileName()),
                          tr("Wait until it is done, or cancel it."));
    }
    path_ = path;
    outcome_ = std::make_shared<std::optional<core::Result<void>>>();
    const auto promise = std::make_shared<QPromise<void>>();
    promise->setProgressRange(0, kProgressSteps);
    watcher_.setFuture(promise->future());
    promise->start();
    show(0.0);
    const auto job = [promise, path, outcome = outcome_, make = std::move(make)] {
        const QByteArray bytes = make([&promise](double share) {
            promise->setProgressValue(static_cast<int>(std::lround(share * kProgressSteps)));
            return !promise->isCanceled();
        });
        if (!promise->isCanceled()) {
            *outcome = writeWhole(path, bytes);
        }
        promise->finish();
    };
    if (threading_ == Threading::kOwnThread) {
        QThreadPool::globalInstance()->start(job);
    } else {
        job();
    }
    return {};
}

void FileSaving::cancel() { watcher_.cancel(); }

void FileSaving::show(std::optional<double> share) {
    Q_EMIT transferChanged({.busy = isBusy(), .text = tr("Writing %1").arg(QFileInfo(path_).fileName()), .fraction = share});
}

void FileSaving::finish() {
    const QString path = QDir::toNativeSeparators(std::exchange(path_, {}));
    Q_EMIT transferChanged({});
    if (!*outcome_) {
        Q_EMIT ended(tr("Cancelled: “%1” was not written.").arg(path));
        return;
    }
    const core::Result<void>& written = **outcome_;
    Q_EMIT ended(written ? tr("“%1” is written.").arg(path) : written.error().sentence());
}

}  // namespace pmts::app
