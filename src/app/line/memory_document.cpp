#include "pmts/app/line/memory_document.hpp"

#include "pmts/protocol/labels.hpp"
#include "pmts/protocol/memory_records.hpp"

#include <QCoreApplication>

#include <algorithm>

namespace pmts::app {
namespace {

QString tr(const char* sentence) { return QCoreApplication::translate("MemoryDocument", sentence); }

QString latin1(const std::string& bytes) {
    return QString::fromLatin1(bytes.data(), static_cast<qsizetype>(bytes.size()));
}

QString reasonOf(protocol::BadLineKind kind) {
    switch (kind) {
        case protocol::BadLineKind::kNoEquals:
            return tr("no = in it: the instrument would answer 34");
        case protocol::BadLineKind::kNoLabel:
            return tr("no label number: the instrument would answer 35");
        case protocol::BadLineKind::kNoData:
            return tr("no value: the instrument would answer 35");
    }
    return {};
}

MemoryRow rowOf(const protocol::MemoryLine& line) {
    const auto* const known = protocol::findLabel(line.label);
    return {.number = line.number,
            .label = QString::number(line.label),
            .meaning = known == nullptr
                           ? QString()
                           : QString::fromLatin1(known->meaning.data(), static_cast<qsizetype>(known->meaning.size())),
            .data = latin1(line.data),
            .fate = LineFate::kRead,
            .remark = {}};
}

QString detailsOf(const std::vector<protocol::PointCheck>& checks) {
    const auto two_faces = std::ranges::count(checks, true, &protocol::PointCheck::two_faces);
    const QString given = tr("HA, VA, SD, IH and SH give the coordinates of the file.");
    return two_faces == 0 ? given : given + u' ' + tr("%1 of them in two faces.").arg(two_faces);
}

/// Later ones come in the place of earlier ones.
void put(std::vector<survey::PlannedPoint>& points, const survey::PlannedPoint& point) {
    const auto same = std::ranges::find(points, point.id, &survey::PlannedPoint::id);
    if (same == points.end()) {
        points.push_back(point);
    } else {
        *same = point;
    }
}

void putPlace(std::vector<survey::PlannedPoint>& points, const std::string& name, const std::string& code,
              const protocol::FileCoordinates& place) {
    if (place.e_m && place.n_m && place.h_m && !name.empty()) {
        survey::PlannedPoint point;
        point.id = latin1(name).trimmed();
        point.code = latin1(code).trimmed();
        point.e_m = *place.e_m;
        point.n_m = *place.n_m;
        point.h_m = *place.h_m;
        put(points, point);
    }
}

}  // namespace

MemoryDocument::MemoryDocument(QString name, const std::string& bytes)
    : name_(std::move(name)), file_(protocol::parseMemoryFile(bytes)), units_(protocol::unitsIn(file_)) {
    makeRows();
}

void MemoryDocument::makeRows() {
    rows_.clear();
    std::ranges::transform(file_.lines, std::back_inserter(rows_), rowOf);
    for (const auto& bad : file_.bad) {
        rows_.push_back({.number = bad.number,
                         .label = {},
                         .meaning = {},
                         .data = latin1(bad.text),
                         .fate = LineFate::kBad,
                         .remark = reasonOf(bad.kind)});
    }
    std::ranges::stable_sort(rows_, {}, &MemoryRow::number);
}

std::vector<std::string> MemoryDocument::lines() const {
    std::vector<std::string> lines;
    std::ranges::transform(file_.lines, std::back_inserter(lines),
                           [](const protocol::MemoryLine& line) { return std::to_string(line.label) + '=' + line.data; });
    return lines;
}

std::string MemoryDocument::text() const { return protocol::memoryFileText(file_.lines); }

bool MemoryDocument::hasUnitsOfItsOwn() const { return protocol::unitsIn(file_).has_value(); }

StatusItem MemoryDocument::verdict() const {
    if (isEmpty()) {
        return {};
    }
    if (!units_) {
        return {DeviceState::kWarning, tr("The file does not say its units (label 23)."),
                tr("Choose them: gon and degrees look alike.")};
    }
    const auto records = protocol::recordsOf(file_, *units_);
    if (!records.bad.empty()) {
        const auto& bad = records.bad.front();
        return {DeviceState::kWarning,
                tr("Line %1: “%2” is no value for label %3.").arg(bad.line).arg(latin1(bad.data)).arg(bad.label),
                tr("Lines with no value: %1.").arg(records.bad.size())};
    }
    const auto checks = protocol::checkPoints(records);
    if (checks.empty()) {
        return {DeviceState::kIdle, tr("No point can be computed again."),
                tr("That takes a station with coordinates and height, and points with HA, VA, SD, SH and coordinates.")};
    }
    const auto off = std::ranges::count(checks, false, &protocol::PointCheck::within);
    const auto worst = *std::ranges::max_element(checks, {}, &protocol::PointCheck::worst_m);
    const QString worst_name = latin1(records.points[worst.point].name);
    const QString worst_mm = QString::number(worst.worst_m * 1000, 'f', 1);
    if (off == 0) {
        return {DeviceState::kGood,
                tr("%1 points computed again, all within 1 mm (worst %2 mm, point %3).")
                    .arg(checks.size())
                    .arg(worst_mm, worst_name),
                detailsOf(checks)};
    }
    return {DeviceState::kWarning,
            tr("%1 of %2 points are off by more than 1 mm (worst %3 mm, point %4).")
                .arg(off)
                .arg(checks.size())
                .arg(worst_mm, worst_name),
            tr("Check units, instrument height and target heights of the file.")};
}

std::vector<survey::PlannedPoint> MemoryDocument::points() const {
    std::vector<survey::PlannedPoint> points;
    const auto records = protocol::recordsOf(file_, units_.value_or(protocol::WireUnits{}));
    for (const auto& station : records.stations) {
        putPlace(points, station.name, {}, station.coordinates);
    }
    for (const auto& point : records.points) {
        putPlace(points, point.name, point.code, point.coordinates);
    }
    return points;
}

void MemoryDocument::markSent(int lines) {
    int at = 0;
    for (MemoryRow& row : rows_) {
        if (row.fate != LineFate::kBad) {
            row.fate = at++ < lines ? LineFate::kSent : LineFate::kLost;
            row.remark = row.fate == LineFate::kLost ? tr("not sent") : QString();
        }
    }
}

void MemoryDocument::compareWith(const std::vector<std::string>& kept) {
    std::size_t at = 0;
    for (MemoryRow& row : rows_) {
        if (row.fate == LineFate::kBad) {
            continue;
        }
        const QString sent = row.label + u'=' + row.data;
        row.fate = at >= kept.size() ? LineFate::kLost : latin1(kept[at]) == sent ? LineFate::kKept : LineFate::kChanged;
        row.remark = row.fate == LineFate::kChanged ? tr("the instrument holds %1").arg(latin1(kept[at])) : QString();
        ++at;
    }
}

}  // namespace pmts::app
