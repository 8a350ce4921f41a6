#include "method_tables_text.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pmts::targeting {
namespace {

using core::Angle;

constexpr int kHalfBar = 16;

QString sentence(const char* text) { return QCoreApplication::translate("MethodReport", text); }

/// Angles in the report's unit: numbers in columns, texts with the sign in sentences.
class AngleWriter {
public:
    explicit AngleWriter(core::AngleUnit unit) : unit_(unit) {}
    [[nodiscard]] QString number(Angle angle) const { return core::angleNumber(angle, unit_, core::usualDecimals(unit_)); }
    [[nodiscard]] QString text(Angle angle) const { return core::angleText(angle, unit_, core::usualDecimals(unit_)); }
    [[nodiscard]] QString unit() const {
        switch (unit_) {
            case core::AngleUnit::kGon: return sentence("gon");
            case core::AngleUnit::kDms: return sentence("d m s");
            case core::AngleUnit::kDegree: return sentence("deg");
            case core::AngleUnit::kMil: return sentence("mil");
        }
        return {};
    }

private:
    core::AngleUnit unit_;
};

QString line(const QStringList& cells) {
    QString text;
    for (const QString& cell : cells) {
        text += cell.rightJustified(cell == cells.front() ? 8 : 11);
    }
    return text + u'\n';
}

/// An error as a bar from the middle, the table's largest at full length.
QString bar(Angle error, Angle largest) {
    const int length = largest.gon() > 0 ? static_cast<int>(std::lround(kHalfBar * (error / largest))) : 0;
    const QString left = QString(std::max(0, -length), u'#').rightJustified(kHalfBar);
    const QString right = QString(std::max(0, length), u'#').leftJustified(kHalfBar);
    return left + u'|' + right;
}

QString plot(const std::vector<ListedTarget>& targets, const MethodTable& table, const AngleWriter& write) {
    const Angle largest = std::max(table.largest_ha, table.largest_va);
    const int width = 2 * kHalfBar + 1;
    QString text = QStringLiteral("    %1  %2  %3\n")
                       .arg(sentence("plot").rightJustified(4), sentence("error of HA").leftJustified(width),
                            sentence("error of VA; full bar %1").arg(write.text(largest)));
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (table.rows[i].computed) {
            const MethodRow& row = table.rows[i];
            text += targets[i].name.rightJustified(8) + "  " + bar(row.error_ha, largest) + "  " +
                    bar(row.error_va, largest) + u'\n';
        }
    }
    return text;
}

QString rowText(const ListedTarget& target, const MethodRow& row, const AngleWriter& write) {
    const QStringList known{target.name, QString::number(target.observed.slope_distance_m, 'f', 4),
                            write.number(target.observed.pointing.ha), write.number(target.observed.pointing.va)};
    if (!row.computed) {
        return line(known).chopped(1) + "  " + row.computed.error().happened + u'\n';
    }
    return line(known + QStringList{write.number(core::normalized(row.computed->ha)), write.number(row.computed->va),
                                    write.number(row.error_ha), write.number(row.error_va)});
}

QString tableText(const std::vector<ListedTarget>& targets, const MethodTable& table, const AngleWriter& write) {
    QString text =
        u'\n' + table.title + u'\n' + QString(table.title.size(), u'=') + u'\n' + table.setting + u'\n' +
        table.known_error + "\n\n" +
        line({sentence("No"), sentence("SD m"), sentence("HA %1").arg(write.unit()), sentence("VA %1").arg(write.unit()), sentence("HA comp."),
              sentence("VA comp."), sentence("error HA"), sentence("error VA")});
    for (std::size_t i = 0; i < targets.size(); ++i) {
        text += rowText(targets[i], table.rows[i], write);
    }
    if (table.computed > 0) {
        text += line({sentence("rms"), {}, {}, {}, {}, {}, write.number(table.rms_ha), write.number(table.rms_va)}) +
                line({sentence("maximum"), {}, {}, {}, {}, {}, write.number(table.largest_ha), write.number(table.largest_va)});
    }
    if (table.off_printed) {
        text += sentence("largest difference from the printed columns: %1").arg(write.text(*table.off_printed)) +
                u'\n';
    }
    return table.computed > 0 ? text + u'\n' + plot(targets, table, write) : text;
}

QString head(const std::vector<ListedTarget>& targets, const MethodReportOptions& options, const AngleWriter& write) {
    QString text = sentence("Method report: %1 targets, photo %2 x %3 px taken at HA %4, VA %5\n")
                       .arg(targets.size())
                       .arg(options.width_px)
                       .arg(options.height_px)
                       .arg(write.text(options.photo.ha), write.text(options.photo.va)) +
                   sentence("errors are computed less observed, in %1\n").arg(write.unit());
    if (options.fit) {
        text += u'\n' + sentence("Fitted rig: rms %1 px, largest %2 px\n")
                            .arg(options.fit->rms_px, 0, 'f', 2)
                            .arg(options.fit->largest_px, 0, 'f', 2);
        for (const QString& parameter : options.fit->parameters) {
            text += "    " + parameter + u'\n';
        }
    }
    return text;
}

QString summary(const std::vector<MethodTable>& tables, const AngleWriter& write) {
    QString text = u'\n' + sentence("Summary") + u'\n' +
                   line({{}, sentence("rms HA"), sentence("rms VA"), sentence("max HA"), sentence("max VA")});
    for (const MethodTable& table : tables) {
        if (table.computed > 0) {
            text +=
                line({{}, write.number(table.rms_ha), write.number(table.rms_va), write.number(table.largest_ha), write.number(table.largest_va)})
                    .chopped(1) +
                "  " + table.title + u'\n';
        }
    }
    return text;
}

}  // namespace

QString textOfTables(const std::vector<ListedTarget>& targets, const MethodReportOptions& options,
                     const std::vector<MethodTable>& tables) {
    const AngleWriter write(options.angle_unit);
    QString text = head(targets, options, write);
    for (const MethodTable& table : tables) {
        text += tableText(targets, table, write);
    }
    return text + summary(tables, write);
}

}  // namespace pmts::targeting
