#pragma once

#include "pmts/app/line/memory_presenter.hpp"
#include "pmts/app/desk/threading.hpp"
#include "pmts/core/result.hpp"

#include <QByteArray>
#include <QFutureWatcher>
#include <QObject>

#include <functional>
#include <memory>
#include <optional>

namespace pmts::app {

/// Makes the bytes of a file and writes them, in the pool, one file at a time. A cancelled one is not written.
class FileSaving : public QObject {
    Q_OBJECT
public:
    using Progress = std::function<bool(double share)>;  ///< false: cancelled, the rest is in vain
    /// Runs in the pool: takes values only.
    using Make = std::function<QByteArray(const Progress&)>;

    explicit FileSaving(Threading threading = Threading::kOwnThread, QObject* parent = nullptr);
    ~FileSaving() override;  ///< a file under way is cancelled and waited for

    [[nodiscard]] bool isBusy() const { return !path_.isEmpty(); }
    /// kRefused while another file is being written.
    [[nodiscard]] core::Result<void> save(const QString& path, Make make);
    void cancel();

Q_SIGNALS:
    void transferChanged(const pmts::app::TransferView& transfer);
    void ended(const QString& sentence);  ///< written, cancelled, or why not

private:
    void finish();
    void show(std::optional<double> share);

    Threading threading_;
    QString path_;  ///< of the file that is being written
    /// Not the future's result: what was written while somebody pressed Cancel is written.
    std::shared_ptr<std::optional<core::Result<void>>> outcome_;
    QFutureWatcher<void> watcher_;
};

}  // namespace pmts::app
