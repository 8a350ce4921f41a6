#include "pmts/app/desk/log_model.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <atomic>

namespace pmts::app {

namespace {

constexpr qint64 kLargestFile = 5 * 1024 * 1024;
constexpr QIODevice::OpenMode kHow = QIODevice::WriteOnly | QIODevice::Append | QIODevice::Text;

// Qt's handler is a plain function: it finds the model here.
std::atomic<LogModel*> installed_model{nullptr};
QtMessageHandler previous_handler = nullptr;

void handleMessage(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if (LogModel* model = installed_model.load()) {
        model->append({.utc = model->utc_now(), .level = type, .category = QString::fromUtf8(context.category),
                       .text = text});
    }
    if (previous_handler) {
        previous_handler(type, context, text);
    }
}

QString levelText(QtMsgType level) {
    switch (level) {
        case QtDebugMsg: return QStringLiteral("debug");
        case QtInfoMsg: return QStringLiteral("info");
        case QtWarningMsg: return QStringLiteral("warning");
        case QtCriticalMsg: return QStringLiteral("error");
        case QtFatalMsg: return QStringLiteral("fatal");
    }
    return {};
}

void putOldFileAside(const QString& path) {
    if (QFileInfo(path).size() > kLargestFile) {
        const QString aside = path + QStringLiteral(".1");
        QFile::remove(aside);
        QFile::rename(path, aside);
    }
}

}  // namespace

LogModel::LogModel(const QString& file_path, QObject* parent) : QAbstractTableModel(parent), file_(file_path) {
    if (file_path.isEmpty()) {
        return;
    }
    QDir().mkpath(QFileInfo(file_path).absolutePath());
    putOldFileAside(file_path);
    file_.open(kHow);
}

LogModel::~LogModel() {
    if (installed_) {
        installed_model.store(nullptr);
        qInstallMessageHandler(previous_handler);
    }
}

void LogModel::install() {
    installed_model.store(this);
    installed_ = true;
    previous_handler = qInstallMessageHandler(&handleMessage);
}

void LogModel::append(LogLine line) {
    if (on_line) {
        on_line(line);
    }
    const QMutexLocker lock(&mutex_);
    writeLine(line);
    pending_.push_back(std::move(line));
    if (!wake_queued_) {
        wake_queued_ = true;
        QMetaObject::invokeMethod(this, &LogModel::takePending, Qt::QueuedConnection);
    }
}

void LogModel::clear() {
    const QMutexLocker lock(&mutex_);
    beginResetModel();
    pending_.clear();
    lines_.clear();
    endResetModel();
}

void LogModel::appendWire(const QString& text) {
    append({.utc = utc_now(), .level = QtDebugMsg, .category = QStringLiteral("wire"), .text = text});
}

void LogModel::writeLine(const LogLine& line) {
    if (!file_.isOpen()) {
        return;
    }
    file_.write(QStringLiteral("%1 %2 %3 %4\n")
                    .arg(line.utc.toString(Qt::ISODateWithMs), levelText(line.level), line.category, line.text)
                    .toUtf8());
    file_.flush();  // a crash right after keeps the line
    if (file_.size() > kLargestFile) {
        file_.close();
        putOldFileAside(file_.fileName());
        file_.open(kHow);
    }
}

void LogModel::takePending() {
    std::vector<LogLine> taken;
    {
        const QMutexLocker lock(&mutex_);
        taken.swap(pending_);
        wake_queued_ = false;
    }
    if (taken.empty()) {
        return;  // cleared meanwhile
    }
    const int surplus = static_cast<int>(lines_.size() + taken.size()) - kCapacity;
    if (const int gone = std::min<int>(surplus, static_cast<int>(lines_.size())); gone > 0) {
        beginRemoveRows({}, 0, gone - 1);
        lines_.erase(lines_.begin(), lines_.begin() + gone);
        endRemoveRows();
    }
    const std::size_t skipped = taken.size() > kCapacity ? taken.size() - kCapacity : 0;
    const int first = static_cast<int>(lines_.size());
    beginInsertRows({}, first, first + static_cast<int>(taken.size() - skipped) - 1);
    lines_.insert(lines_.end(), taken.begin() + static_cast<std::ptrdiff_t>(skipped), taken.end());
    endInsertRows();
}

int LogModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(lines_.size()); }

int LogModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumnCount; }

QVariant LogModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const LogLine& line = lines_[static_cast<std::size_t>(index.row())];
    if (role == kLevelRole) {
        return static_cast<int>(line.level);
    }
    if (role == kCategoryRole) {
        return line.category;
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (index.column()) {
        case kTime: return line.utc.toLocalTime().toString(QStringLiteral("HH:mm:ss.zzz"));
        case kLevel: return levelText(line.level);
        case kCategory: return line.category;
        case kText: return line.text;
        default: return {};
    }
}

QVariant LogModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
        case kTime: return tr("Time");
        case kLevel: return tr("Level");
        case kCategory: return tr("Source");
        case kText: return tr("Message");
        default: return {};
    }
}

}  // namespace pmts::app
