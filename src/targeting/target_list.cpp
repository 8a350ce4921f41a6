#include "pmts/targeting/target_list.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QHash>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace pmts::targeting {
namespace {

using core::Angle;
using core::ErrorKind;

QString sentence(const char* text) { return QCoreApplication::translate("Targeting", text); }

tl::unexpected<core::Error> badLine(int line, const QString& what, const QString& remedy) {
    return core::fail(ErrorKind::kBadInput, sentence("Line %1: %2").arg(line).arg(what), remedy);
}

QChar separatorOf(const QString& header) {
    for (const QChar candidate : {u'\t', u';'}) {
        if (header.contains(candidate)) {
            return candidate;
        }
    }
    return u',';
}

/// Names of the columns and where they are.
class Columns {
public:
    Columns() = default;
    explicit Columns(const QString& header) : separator_(separatorOf(header)) {
        const QStringList names = header.split(separator_);
        for (qsizetype i = 0; i < names.size(); ++i) {
            places_.insert(names[i].trimmed().toLower(), i);
        }
    }
    [[nodiscard]] bool has(const QString& name) const { return places_.contains(name); }
    [[nodiscard]] QStringList cellsOf(const QString& line) const { return line.split(separator_); }
    [[nodiscard]] QString cell(const QStringList& cells, const QString& name) const {
        const qsizetype place = places_.value(name, cells.size());
        return place < cells.size() ? cells[place].trimmed() : QString();
    }
    [[nodiscard]] bool isKnown() const { return !places_.isEmpty(); }
    /// A comma is a decimal sign where it does not separate.
    [[nodiscard]] bool hasDecimalCommas() const { return separator_ != u','; }

private:
    QChar separator_ = u',';
    QHash<QString, qsizetype> places_;
};

const QStringList& neededColumns() {
    static const QStringList names{"sd", "sha", "sva", "u", "v"};
    return names;
}

core::Result<Columns> readHeader(int number, const QString& line) {
    const Columns columns(line);
    for (const QString& name : neededColumns()) {
        if (!columns.has(name)) {
            return badLine(number, sentence("the column “%1” is missing.").arg(name),
                           sentence("The first line names the columns: no,sd,sha,sva,u,v."));
        }
    }
    return columns;
}

/// One line of the table; remembers the first thing that is wrong with it.
class Row {
public:
    Row(int number, const Columns& columns, const QString& line)
        : number_(number), columns_(columns), cells_(columns.cellsOf(line)) {}

    double number(const QString& name) {
        QString text = columns_.cell(cells_, name);
        if (columns_.hasDecimalCommas()) {
            text.replace(u',', u'.');
        }
        bool ok = false;
        const double value = text.toDouble(&ok);
        if ((!ok || !std::isfinite(value)) && !error_) {
            error_ = text.isEmpty()
                         ? badLine(number_, sentence("the column “%1” is empty.").arg(name),
                                   sentence("Enter a number."))
                               .value()
                         : badLine(number_, sentence("“%1” in the column “%2” is no number.").arg(text, name),
                                   sentence("Enter a number."))
                               .value();
        }
        return value;
    }
    geometry::Pointing pointing(const QString& prefix) {
        return {Angle::fromGon(number(prefix + "sha")), Angle::fromGon(number(prefix + "sva"))};
    }
    std::optional<geometry::Pointing> printed(const QString& prefix) {
        const bool there = !columns_.cell(cells_, prefix + "sha").isEmpty() &&
                           !columns_.cell(cells_, prefix + "sva").isEmpty();
        return there ? std::optional(pointing(prefix)) : std::nullopt;
    }
    [[nodiscard]] QString name() const {
        const QString no = columns_.cell(cells_, "no");
        return no.isEmpty() ? columns_.cell(cells_, "name") : no;
    }
    core::Result<ListedTarget> target() {
        ListedTarget target{.name = name(),
                            .observed = {pointing({}), number("sd")},
                            .px = {number("u"), number("v")},
                            .printed_apa = printed("apa_"),
                            .printed_tpa = printed("tpa_"),
                            .printed_oatpa = printed("oatpa_")};
        if (!error_ && !(target.observed.slope_distance_m > 0)) {
            return badLine(number_, sentence("the slope distance is not above zero."),
                           sentence("Enter metres."));
        }
        if (error_) {
            return tl::unexpected(*error_);
        }
        return target;
    }

private:
    int number_;
    const Columns& columns_;
    QStringList cells_;
    std::optional<core::Error> error_;
};

QString printedCells(const std::optional<geometry::Pointing>& printed) {
    return printed ? QStringLiteral(",%1,%2").arg(printed->ha.gon(), 0, 'f', 5).arg(printed->va.gon(), 0, 'f', 5)
                   : QStringLiteral(",,");
}

}  // namespace

core::Result<std::vector<ListedTarget>> readTargetList(const QString& text) {
    std::vector<ListedTarget> targets;
    Columns columns;
    int number = 0;
    for (QString line : text.split(u'\n')) {
        ++number;
        line = line.trimmed();
        if (line.startsWith(QChar::ByteOrderMark)) {
            line.remove(0, 1);
        }
        if (line.isEmpty() || line.startsWith(u'#')) {
            continue;
        }
        if (!columns.isKnown()) {
            const auto header = readHeader(number, line);
            PMTS_TRY(header);
            columns = *header;
            continue;
        }
        auto target = Row(number, columns, line).target();
        PMTS_TRY(target);
        if (target->name.isEmpty()) {
            target->name = QString::number(targets.size() + 1);
        }
        targets.push_back(*target);
    }
    if (targets.empty()) {
        return core::fail(ErrorKind::kBadInput, sentence("There is no target in the table."),
                          sentence("Write one target a line below the names of the columns."));
    }
    return targets;
}

QString targetListText(const std::vector<ListedTarget>& targets, const QString& comment) {
    QString text;
    for (const QString& line : comment.split(u'\n', Qt::SkipEmptyParts)) {
        text += QStringLiteral("# ") + line + u'\n';
    }
    text += QStringLiteral("no,sd,sha,sva,u,v");
    const auto has = [&targets](auto printed) {
        return std::ranges::any_of(targets, [printed](const ListedTarget& target) { return (target.*printed).has_value(); });
    };
    std::vector<std::optional<geometry::Pointing> ListedTarget::*> printed;
    for (const auto& [column, name] : {std::pair(&ListedTarget::printed_apa, "apa"), std::pair(&ListedTarget::printed_tpa, "tpa"),
                                       std::pair(&ListedTarget::printed_oatpa, "oatpa")}) {
        if (has(column)) {
            printed.push_back(column);
            text += QStringLiteral(",%1_sha,%1_sva").arg(QLatin1String(name));
        }
    }
    text += u'\n';
    for (const ListedTarget& target : targets) {
        QString name = target.name;
        text += QStringLiteral("%1,%2,%3,%4,%5,%6")
                    .arg(name.replace(u',', u' '))
                    .arg(target.observed.slope_distance_m, 0, 'f', 4)
                    .arg(target.observed.pointing.ha.gon(), 0, 'f', 5)
                    .arg(target.observed.pointing.va.gon(), 0, 'f', 5)
                    .arg(target.px.x(), 0, 'f', 2)
                    .arg(target.px.y(), 0, 'f', 2);
        for (const auto column : printed) {
            text += printedCells(target.*column);
        }
        text += u'\n';
    }
    return text;
}

core::Result<std::vector<ListedTarget>> readTargetFile(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly | QIODevice::Text)) {
        return core::fail(ErrorKind::kFile, sentence("The table of targets “%1” cannot be read.").arg(path),
                          sentence("Check its name and place."), file.errorString());
    }
    return readTargetList(QString::fromUtf8(file.readAll()));
}

}  // namespace pmts::targeting
