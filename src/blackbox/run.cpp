#include "pmts/blackbox/run.hpp"

#include <QFileInfo>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

namespace pmts::blackbox {
namespace {

constexpr qint64 kRoomForSession = 64 * 1024;

struct Head {
    QString path;
    QString run;
    core::Duration at{0};
    qint64 size = 0;
};

/// Of the first record only: the others may be hundreds of megabytes.
std::optional<Head> headOf(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return std::nullopt;
    }
    const QByteArray bytes = file.read(kRoomForSession);
    std::string_view rest(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    rest.remove_prefix(rest.starts_with(kFileHead) ? kFileHead.size() : 0);
    const auto head = headAt(rest);
    if (!head || head->kind != Kind::kSession || !isWhole(rest, *head)) {
        return std::nullopt;
    }
    const QCborMap map = mapOf(QByteArray(rest.data() + kHeadSize, static_cast<qsizetype>(head->body_size)));
    const bool is_excerpt = map.value(QStringLiteral("excerpt")).toBool();
    return Head{.path = path, .run = is_excerpt ? QString() : map.value(QStringLiteral("run")).toString(), .at = head->at, .size = file.size()};
}

}  // namespace

bool holdsOn(Kind kind) {
    return kind == Kind::kSession || kind == Kind::kConnection || kind == Kind::kControl || kind == Kind::kAir;
}

QStringList filesOfRun(const QString& path) {
    const auto wanted = headOf(path);
    if (!wanted || wanted->run.isEmpty()) {
        return {path};
    }
    std::vector<Head> of_run{*wanted};
    for (const QString& other : recordingsIn(QFileInfo(path).absolutePath())) {
        const auto head = headOf(other);
        const bool is_copy = head && head->at == wanted->at && head->size == wanted->size;  // or the file itself
        if (head && head->run == wanted->run && !is_copy) {
            of_run.push_back(*head);
        }
    }
    std::sort(of_run.begin(), of_run.end(), [](const Head& a, const Head& b) { return std::tie(a.at, a.path) < std::tie(b.at, b.path); });
    QStringList paths;
    for (const Head& head : of_run) {
        paths.append(head.path);
    }
    return paths;
}

core::Result<std::shared_ptr<const Run>> Run::open(const QString& path) {
    std::vector<std::shared_ptr<const Recording>> files;
    std::size_t chosen = 0;
    for (const QString& file : filesOfRun(path)) {
        auto opened = Recording::open(file);
        if (!opened && file == path) {
            return tl::unexpected(opened.error());
        }
        if (opened) {
            chosen = file == path ? files.size() : chosen;
            files.push_back(*opened);
        }
    }
    return std::make_shared<const Run>(std::move(files), chosen);
}

Run::Run(std::vector<std::shared_ptr<const Recording>> files, std::size_t chosen) : files_(std::move(files)), chosen_(chosen) {
    std::map<Kind, QByteArray> standing;
    for (std::size_t file = 0; file < files_.size(); ++file) {
        for (const Entry& entry : files_[file]->entries()) {
            if (holdsOn(entry.kind) && entry.kind != Kind::kSession) {
                QByteArray body = files_[file]->bodyBytes(entry);
                if (standing[entry.kind] == body) {
                    continue;
                }
                standing[entry.kind] = std::move(body);
            }
            Place place{.file = file, .entry = entry};
            place.is_distance = entry.kind == Kind::kReading && files_[file]->bodyBytes(entry).contains("sd_m");
            place.is_toast = entry.kind == Kind::kMessage && !files_[file]->body(entry).contains(QStringLiteral("bars"));
            places_.push_back(place);
        }
    }
}

int Run::damages() const {
    std::size_t sum = 0;
    for (const auto& file : files_) {
        sum += file->damages().size();
    }
    return static_cast<int>(sum);
}

}  // namespace pmts::blackbox
