#include "pmts/job/planned_import.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QStringConverter>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace pmts::job {
namespace {

using core::ErrorKind;
using Planned = std::vector<survey::PlannedPoint>;

constexpr qint64 kMostBytes = 64LL * 1024 * 1024;

QString tr(const char* sentence) { return QCoreApplication::translate("pmts::job", sentence); }

tl::unexpected<core::Error> unreadable(int line, const QString& what, const QString& remedy = {}) {
    return core::fail(ErrorKind::kBadInput, tr("Line %1 of the planned points: %2.").arg(line).arg(what),
                      remedy.isEmpty()
                          ? tr("Correct the line and import the file again; nothing was taken from it.")
                          : remedy);
}

/// One record of the file and the line it starts on; quoted fields may hold separators and line ends.
struct Record {
    int line = 0;
    QStringList fields;
};

QString decoded(const QByteArray& bytes) {
    QStringDecoder utf8(QStringDecoder::Utf8);
    QString text = utf8(bytes);
    return utf8.hasError() ? QString::fromLatin1(bytes) : text;
}

/// The one of tab, semicolon, comma that the first line with contents has.
QChar separatorOf(const QString& text) {
    for (const QString& line : text.split(u'\n')) {
        if (line.trimmed().isEmpty() || line.startsWith(u'#')) {
            continue;
        }
        for (const QChar separator : {QChar(u'\t'), QChar(u';')}) {
            if (line.contains(separator)) {
                return separator;
            }
        }
        break;
    }
    return u',';
}

class RecordReader {
public:
    explicit RecordReader(const QString& text) : text_(text), separator_(separatorOf(text)) {}

    [[nodiscard]] QChar separator() const { return separator_; }

    /// The next record that is neither empty nor a remark; absent at the end.
    std::optional<Record> next() {
        while (at_ < text_.size()) {
            Record record = read();
            const bool empty = record.fields.join(QString()).trimmed().isEmpty();
            if (!empty && !record.fields.front().startsWith(u'#')) {
                return record;
            }
        }
        return std::nullopt;
    }

private:
    Record read() {
        Record record{.line = line_, .fields = {}};
        QString field;
        bool quoted = false;
        for (; at_ < text_.size(); ++at_) {
            const QChar c = text_[at_];
            line_ += c == u'\n' ? 1 : 0;
            if (quoted && c == u'"' && at_ + 1 < text_.size() && text_[at_ + 1] == u'"') {
                field += c;
                ++at_;
            } else if (c == u'"' && (quoted || field.trimmed().isEmpty())) {
                quoted = !quoted;
            } else if (quoted || (c != separator_ && c != u'\n')) {
                field += c;
            } else {
                record.fields += field.trimmed();
                field.clear();
                if (c == u'\n') {
                    ++at_;
                    return record;
                }
            }
        }
        record.fields += field.trimmed();
        return record;
    }

    QString text_;
    QChar separator_;
    qsizetype at_ = 0;
    int line_ = 1;
};

enum Column { kId, kE, kN, kH, kCode, kRemark, kAbsurd, kColumns };

/// Where each column stands in a record; -1: the file has none.
using Places = std::array<qsizetype, kColumns>;

constexpr Places kUsualPlaces{0, 1, 2, 3, 4, 5, -1};

/// Names a column may have. x and y are not among them: which of the two is east differs from country to
/// country.
std::optional<Column> columnNamed(const QString& name) {
    static const std::array<QStringList, kColumns> names{
        QStringList{"id", "point", "point_id", "name", "number", "no", "nr"},
        QStringList{"e", "e_m", "east", "east_m", "easting", "easting_m"},
        QStringList{"n", "n_m", "north", "north_m", "northing", "northing_m"},
        QStringList{"h", "h_m", "height", "height_m", "elevation", "elevation_m", "z", "z_m"},
        QStringList{"code"},
        QStringList{"remark", "remarks", "comment", "note", "description"},
        QStringList{"absurd_reason"}};
    const QString plain =
        name.toLower().replace(u' ', u'_').replace(QStringLiteral("_(m)"), QStringLiteral("_m"));
    const auto found = std::find_if(names.begin(), names.end(),
                                    [&](const QStringList& known) { return known.contains(plain); });
    return found == names.end() ? std::nullopt : std::optional(static_cast<Column>(found - names.begin()));
}

std::optional<double> numberIn(QString text, QChar separator) {
    if (separator != u',') {
        text.replace(u',', u'.');
    }
    bool is_number = false;
    const double value = text.toDouble(&is_number);
    return is_number && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// A first line of names has no number in it.
bool isHeader(const Record& record, QChar separator) {
    return std::ranges::none_of(record.fields,
                                [&](const QString& f) { return numberIn(f, separator).has_value(); }) &&
           std::ranges::any_of(record.fields, [](const QString& f) { return columnNamed(f).has_value(); });
}

core::Result<Places> placesFromHeader(const Record& header) {
    Places places;
    places.fill(-1);
    for (qsizetype i = 0; i < header.fields.size(); ++i) {
        if (const auto column = columnNamed(header.fields[i]); column && places[*column] < 0) {
            places[*column] = i;
        }
    }
    for (const auto& [column, name] : {std::pair(kId, "id"), {kE, "e"}, {kN, "n"}, {kH, "h"}}) {
        if (places[column] < 0) {
            return unreadable(
                header.line, tr("no column is called “%1”").arg(QLatin1String(name)),
                tr("Name the columns id, e, n, h (metres), code, remark; x and y are not understood."));
        }
    }
    return places;
}

core::Result<survey::PlannedPoint> pointOf(const Record& record, const Places& places, QChar separator) {
    const auto field = [&](Column column) {
        return places[column] < 0 ? QString() : record.fields.value(places[column]);
    };
    survey::PlannedPoint point{.id = field(kId), .code = field(kCode), .remark = field(kRemark)};
    if (point.id.isEmpty()) {
        return unreadable(record.line, tr("the point has no ID"));
    }
    const std::pair<Column, double*> numbers[] = {{kE, &point.e_m}, {kN, &point.n_m}, {kH, &point.h_m}};
    for (const auto& [column, value] : numbers) {
        const QString text = field(column);
        const auto number = numberIn(text, separator);
        if (!number) {
            const QString name(QStringLiteral("ENH")[column - kE]);
            return unreadable(record.line, text.isEmpty() ? tr("%1 is missing").arg(name)
                                                          : tr("“%1” is no number for %2").arg(text, name));
        }
        *value = *number;
    }
    return point;
}

/// A row of PMTS's own export that never had a place: its shot was absurd, or a direction only.
bool isWithoutPlace(const Record& record, const Places& places) {
    const auto is_empty = [&](Column column) { return record.fields.value(places[column]).isEmpty(); };
    return places[kAbsurd] >= 0 && is_empty(kE) && is_empty(kN) && is_empty(kH);
}

}  // namespace

core::Result<std::vector<survey::PlannedPoint>> plannedFromText(const QByteArray& bytes) {
    RecordReader reader(
        decoded(bytes).replace(QStringLiteral("\r\n"), QStringLiteral("\n")).replace(u'\r', u'\n'));
    Places places = kUsualPlaces;
    Planned points;
    std::optional<Record> record = reader.next();
    if (record && isHeader(*record, reader.separator())) {
        const auto named = placesFromHeader(*record);
        PMTS_TRY(named);
        places = *named;
        record = reader.next();
    }
    for (; record; record = reader.next()) {
        if (isWithoutPlace(*record, places)) {
            continue;
        }
        auto point = pointOf(*record, places, reader.separator());
        PMTS_TRY(point);
        points.push_back(*std::move(point));
    }
    if (points.empty()) {
        return core::fail(ErrorKind::kBadInput, tr("There is no planned point in the file."),
                          tr("Write one point a line: ID, E, N, H, code, remark."));
    }
    return points;
}

core::Result<std::vector<survey::PlannedPoint>> plannedFromFile(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return core::fail(ErrorKind::kFile, tr("%1 cannot be read.").arg(QDir::toNativeSeparators(path)),
                          tr("Choose a text file with planned points."), file.errorString());
    }
    if (file.size() > kMostBytes) {
        return core::fail(ErrorKind::kLimit,
                          tr("%1 is too large for a list of points.").arg(QDir::toNativeSeparators(path)),
                          tr("Choose a text file of at most 64 MB."));
    }
    return plannedFromText(file.readAll());
}

}  // namespace pmts::job
