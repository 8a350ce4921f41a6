#pragma once

#include <QAbstractTableModel>
#include <QDateTime>
#include <QFile>
#include <QMutex>
#include <QString>

#include <deque>
#include <functional>
#include <vector>

namespace pmts::app {

struct LogLine {
    QDateTime utc;
    QtMsgType level = QtInfoMsg;
    QString category;  ///< `pmts.instrument`, `wire`
    QString text;
};

/// The log window's table: the newest lines of a ring, oldest first, and the same lines in a file that is flushed line by line.
/// append() may be called from any thread; the model lives on the GUI thread.
class LogModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kTime, kLevel, kCategory, kText, kColumnCount };
    enum Role { kLevelRole = Qt::UserRole, kCategoryRole };
    static constexpr int kCapacity = 5000;

    /// `file_path` empty: no file. A file over 5 MB is put aside as `.1` first.
    explicit LogModel(const QString& file_path, QObject* parent = nullptr);
    ~LogModel() override;

    /// Takes over Qt's message handler until destroyed; messages still reach the previous handler.
    void install();
    void append(LogLine line);
    /// One transaction of the wire: what was sent, what came back, how long it took.
    void appendWire(const QString& text);
    [[nodiscard]] QString filePath() const { return file_.fileName(); }
    void clear();
    /// Each line as it is appended, on the thread that appends it; set before install().
    std::function<void(const LogLine& line)> on_line;
    /// The program's clock; asked on the thread that appends, set before install().
    std::function<QDateTime()> utc_now = &QDateTime::currentDateTimeUtc;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void takePending();
    void writeLine(const LogLine& line);

    QMutex mutex_;                  ///< guards file_ and pending_
    QFile file_;
    std::vector<LogLine> pending_;
    bool wake_queued_ = false;
    std::deque<LogLine> lines_;
    bool installed_ = false;
};

}  // namespace pmts::app
