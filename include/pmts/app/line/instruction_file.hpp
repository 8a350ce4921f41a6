#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/protocol/instruction_table.hpp"

#include <QFileSystemWatcher>
#include <QObject>

#include <optional>

namespace pmts::app {

/// The instruction table on disk: the user's copy in the data folder, or the shipped one while there is none. Another
/// program may change it at any time; what it says then is taken over, a broken table leaves the last good one of this run
/// in use.
class InstructionFile : public QObject {
    Q_OBJECT
public:
    /// The clock outlives it. An empty path: the shipped table only.
    InstructionFile(QString path, core::Clock& clock, QObject* parent = nullptr);

    [[nodiscard]] const QString& path() const { return path_; }
    [[nodiscard]] const QString& text() const { return text_; }
    [[nodiscard]] bool isShipped() const { return is_shipped_; }
    /// The last table without a problem: what may be run.
    [[nodiscard]] const protocol::InstructionTable& table() const { return good_; }
    /// Of the text as it is now.
    [[nodiscard]] const std::vector<protocol::TableProblem>& problems() const { return problems_; }
    /// Why the file cannot be read, while it cannot: known from the constructor on, before anybody hears a signal.
    [[nodiscard]] const std::optional<core::Error>& trouble() const { return trouble_; }
    static constexpr qint64 kLargest = 1 << 20;  ///< bytes
    /// Refused while what stands there cannot be read.
    [[nodiscard]] core::Result<void> save(const QString& text);
    [[nodiscard]] static QString shippedText();

Q_SIGNALS:
    void changed();  ///< the text is another one now: saved here, or by another program
    void problemReported(const pmts::core::Error& error);

private:
    void watch();
    void readSoon();
    void read();
    void take(const QString& text, bool is_shipped);

    QString path_;
    core::Clock& clock_;
    QFileSystemWatcher watcher_;
    core::Timer settle_;
    QString text_;
    bool is_shipped_ = true;
    protocol::InstructionTable good_;
    std::vector<protocol::TableProblem> problems_;
    std::optional<core::Error> trouble_;
};

}  // namespace pmts::app
