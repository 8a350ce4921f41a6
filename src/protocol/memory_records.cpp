#include "pmts/protocol/memory_records.hpp"

#include "pmts/protocol/labels.hpp"

#include <algorithm>
#include <cmath>

namespace pmts::protocol {
namespace {

constexpr int kStationName = 2, kInstrumentHeight = 3, kHorizontalDistance = 11, kHaTwo = 17, kVaTwo = 18, kHaOne = 24,
              kVaOne = 25, kReferenceObject = 62;
/// Rounding of the comparison itself, far below the last digit of a file.
constexpr double kRounding_m = 1e-9;

bool beginsBlock(int label) { return label == kStationName || label == kPointNumber || label == kReferenceObject; }

/// In a dump the items of one quoted line are one block, its number may stand behind its code.
std::vector<MemoryLine> inBlockOrder(const MemoryFile& file) {
    auto lines = file.lines;
    if (file.is_geodat_dump) {
        std::ranges::stable_sort(lines, {},
                                 [](const MemoryLine& line) { return std::pair(line.number, !beginsBlock(line.label)); });
    }
    return lines;
}

std::string_view number(const std::string& data) {
    const std::string_view text = data;
    const auto begin = std::min(text.find_first_not_of(' '), text.size());
    return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// Builds the records line by line.
class Reader {
public:
    explicit Reader(const WireUnits& units) : units_(units) {}

    void take(const MemoryLine& line) {
        if (line.label == kStationName) {
            records_.stations.push_back(
                {.line = line.number, .name = line.data, .coordinates = {}, .instrument_height_m = {}});
            point_ = nullptr;
        } else if (beginsBlock(line.label)) {
            beginPoint(line);
        } else {
            takeValue(line);
        }
    }
    [[nodiscard]] MemoryRecords take() && { return std::move(records_); }

private:
    void beginPoint(const MemoryLine& line) {
        FilePoint& point = records_.points.emplace_back();
        point.line = line.number;
        point.name = line.data;
        point.is_backsight = line.label == kReferenceObject;
        if (!records_.stations.empty()) {
            point.station = records_.stations.size() - 1;
        }
        point_ = &point;
    }

    void takeValue(const MemoryLine& line) {
        if (line.label == kInstrumentHeight) {
            if (!records_.stations.empty()) {
                length(line, records_.stations.back().instrument_height_m);
            }
        } else if (FileCoordinates* const place = coordinates(); place != nullptr && isCoordinate(line.label)) {
            length(line, line.label == kNorthing ? place->n_m : line.label == kEasting ? place->e_m : place->h_m);
        } else if (point_ != nullptr) {
            takePointValue(line);
        }
    }

    static bool isCoordinate(int label) { return label == kNorthing || label == kEasting || label == kElevation; }

    FileCoordinates* coordinates() {
        if (point_ != nullptr) {
            return &point_->coordinates;
        }
        return records_.stations.empty() ? nullptr : &records_.stations.back().coordinates;
    }

    void takePointValue(const MemoryLine& line) {
        switch (line.label) {
            case kPointCode:
                point_->code = line.data;
                break;
            case kTargetHeight:
                length(line, point_->target_height_m);
                break;
            case kHa:
                angle(line, point_->ha);
                break;
            case kVa:
                angle(line, point_->va);
                break;
            case kHaOne:
                angle(line, point_->ha_one);
                break;
            case kVaOne:
                angle(line, point_->va_one);
                break;
            case kHaTwo:
                angle(line, point_->ha_two);
                break;
            case kVaTwo:
                angle(line, point_->va_two);
                break;
            case kSd:
                length(line, point_->slope_distance_m);
                break;
            case kHorizontalDistance:
                length(line, point_->horizontal_distance_m);
                break;
            default:
                break;
        }
    }

    void length(const MemoryLine& line, std::optional<double>& place) {
        put(line, metresFromWire(number(line.data), units_.length), place);
    }
    void angle(const MemoryLine& line, std::optional<core::Angle>& place) {
        put(line, angleFromWire(number(line.data), units_.angle), place);
    }

    template <class Value>
    void put(const MemoryLine& line, const core::Result<Value>& value, std::optional<Value>& place) {
        if (value) {
            place = *value;
        } else {
            records_.bad.push_back({line.number, line.label, line.data});
        }
    }

    WireUnits units_;
    MemoryRecords records_;
    FilePoint* point_ = nullptr;
};

std::optional<double> slopeDistance(const FilePoint& point, core::Angle va) {
    if (point.slope_distance_m || !point.horizontal_distance_m) {
        return point.slope_distance_m;
    }
    return *point.horizontal_distance_m / std::abs(core::sin(va));
}

bool isWhole(const FileCoordinates& c) { return c.n_m && c.e_m && c.h_m; }

/// Along one direction; of a point and a station that have all the rest.
std::optional<PointCheck> checkedAlong(const std::optional<FileDirection>& direction, const FilePoint& point,
                                       const FileStation& station) {
    const auto sd_m = direction ? slopeDistance(point, direction->va) : std::nullopt;
    if (!sd_m) {
        return std::nullopt;
    }
    const double across_m = *sd_m * core::sin(direction->va);
    PointCheck check;
    check.dn_m = *station.coordinates.n_m + across_m * core::cos(direction->ha) - *point.coordinates.n_m;
    check.de_m = *station.coordinates.e_m + across_m * core::sin(direction->ha) - *point.coordinates.e_m;
    check.dh_m = *station.coordinates.h_m + *station.instrument_height_m + *sd_m * core::cos(direction->va) -
                 *point.target_height_m - *point.coordinates.h_m;
    check.worst_m = std::max({std::abs(check.dn_m), std::abs(check.de_m), std::abs(check.dh_m)});
    check.within = check.worst_m <= kCheckLimit_m + kRounding_m;
    return check;
}

std::optional<PointCheck> checked(const MemoryRecords& records, std::size_t index) {
    const FilePoint& point = records.points[index];
    if (point.is_backsight || !point.station || !point.target_height_m || !isWhole(point.coordinates)) {
        return std::nullopt;
    }
    const FileStation& station = records.stations[*point.station];
    if (!isWhole(station.coordinates) || !station.instrument_height_m) {
        return std::nullopt;
    }
    const auto by_mean = checkedAlong(meanOfFaces(point), point, station);
    const auto by_face_one = checkedAlong(faceOneOf(point), point, station);
    if (!by_mean && !by_face_one) {
        return std::nullopt;
    }
    PointCheck nearest = by_face_one && (!by_mean || by_face_one->worst_m < by_mean->worst_m) ? *by_face_one : *by_mean;
    nearest.point = index;
    nearest.two_faces = by_mean.has_value();
    return nearest;
}

std::optional<FileDirection> direction(const std::optional<core::Angle>& ha, const std::optional<core::Angle>& va) {
    return ha && va ? std::optional(FileDirection{.ha = *ha, .va = *va}) : std::nullopt;
}

}  // namespace

std::optional<FileDirection> faceOneOf(const FilePoint& point) {
    const auto one = direction(point.ha_one, point.va_one);
    return one ? one : direction(point.ha, point.va);
}

std::optional<FileDirection> meanOfFaces(const FilePoint& point) {
    if (direction(point.ha_one, point.va_one) && direction(point.ha, point.va)) {
        return direction(point.ha, point.va);
    }
    const auto one = faceOneOf(point);
    const auto two = direction(point.ha_two, point.va_two);
    if (!one || !two) {
        return std::nullopt;
    }
    const core::Angle half_turn = core::Angle::fromGon(200.0);
    return FileDirection{.ha = one->ha + core::normalizedSigned(two->ha - half_turn - one->ha) / 2.0,
                         .va = (one->va + half_turn * 2.0 - two->va) / 2.0};
}

std::optional<WireUnits> unitsIn(const MemoryFile& file) {
    const auto line = std::ranges::find(file.lines, kUnits, &MemoryLine::label);
    if (line == file.lines.end()) {
        return std::nullopt;
    }
    const auto units = parseUnitStatus(number(line->data));
    return units ? std::optional(*units) : std::nullopt;
}

MemoryRecords recordsOf(const MemoryFile& file, const WireUnits& units) {
    Reader reader(units);
    for (const MemoryLine& line : inBlockOrder(file)) {
        reader.take(line);
    }
    return std::move(reader).take();
}

std::vector<PointCheck> checkPoints(const MemoryRecords& records) {
    std::vector<PointCheck> checks;
    for (std::size_t i = 0; i < records.points.size(); ++i) {
        if (const auto check = checked(records, i)) {
            checks.push_back(*check);
        }
    }
    return checks;
}

}  // namespace pmts::protocol
