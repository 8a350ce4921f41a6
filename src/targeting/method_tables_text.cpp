#include "method_tables_text.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pmts::targeting {
namespace {

using core::Angle;

constexpr int kHalfBar = 16;

QString sentence(const char* text) { return QCoreApplication::translate("MethodReport", text); }

QString gon(Angle angle, int decimals = 4) { return QString::number(angle.gon(), 'f', decimals); }

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

QString plot(const std::vector<ListedTarget>& targets, const MethodTable& table) {
    const Angle largest = std::max(table.largest_ha, table.largest_va);
    const int width = 2 * kHalfBar + 1;
    QString text = QStringLiteral("    %1  %2  %3\n")
                       .arg(sentence("plot").rightJustified(4), sentence("error of HA").leftJustified(width),
                            sentence("error of VA; full bar %1 gon").arg(gon(largest)));
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (table.rows[i].computed) {
            const MethodRow& row = table.rows[i];
            text += targets[i].name.rightJustified(8) + "  " + bar(row.error_ha, largest) + "  " +
                    bar(row.error_va, largest) + u'\n';
        }
    }
    return text;
}

QString rowText(const ListedTarget& target, const MethodRow& row) {
    const QStringList known{target.name, QString::number(target.observed.slope_distance_m, 'f', 4),
                            gon(target.observed.pointing.ha), gon(target.observed.pointing.va)};
    if (!row.computed) {
        return line(known).chopped(1) + "  " + row.computed.error().happened + u'\n';
    }
    return line(known + QStringList{gon(core::normalized(row.computed->ha)), gon(row.computed->va),
                                    gon(row.error_ha), gon(row.error_va)});
}

QString tableText(const std::vector<ListedTarget>& targets, const MethodTable& table) {
    QString text =
        u'\n' + table.title + u'\n' + QString(table.title.size(), u'=') + u'\n' + table.setting + u'\n' +
        table.known_error + "\n\n" +
        line({sentence("No"), sentence("SD m"), sentence("HA gon"), sentence("VA gon"), sentence("HA comp."),
              sentence("VA comp."), sentence("error HA"), sentence("error VA")});
    for (std::size_t i = 0; i < targets.size(); ++i) {
        text += rowText(targets[i], table.rows[i]);
    }
    if (table.computed > 0) {
        text += line({sentence("rms"), {}, {}, {}, {}, {}, gon(table.rms_ha), gon(table.rms_va)}) +
                line({sentence("maximum"), {}, {}, {}, {}, {}, gon(table.largest_ha), gon(table.largest_va)});
    }
    if (table.off_printed) {
        text += sentence("largest difference from the printed columns: %1 gon").arg(gon(*table.off_printed)) +
                u'\n';
    }
    return table.computed > 0 ? text + u'\n' + plot(targets, table) : text;
}

QString head(const std::vector<ListedTarget>& targets, const MethodReportOptions& options) {
    QString text = sentence("Method report: %1 targets, photo %2 x %3 px taken at HA %4, VA %5 gon\n")
                       .arg(targets.size())
                       .arg(options.width_px)
                       .arg(options.height_px)
                       .arg(gon(options.photo.ha), gon(options.photo.va)) +
                   sentence("errors are computed less observed, in gon\n");
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

QString summary(const std::vector<MethodTable>& tables) {
    QString text = u'\n' + sentence("Summary") + u'\n' +
                   line({{}, sentence("rms HA"), sentence("rms VA"), sentence("max HA"), sentence("max VA")});
    for (const MethodTable& table : tables) {
        if (table.computed > 0) {
            text +=
                line({{}, gon(table.rms_ha), gon(table.rms_va), gon(table.largest_ha), gon(table.largest_va)})
                    .chopped(1) +
                "  " + table.title + u'\n';
        }
    }
    return text;
}

}  // namespace

QString textOfTables(const std::vector<ListedTarget>& targets, const MethodReportOptions& options,
                     const std::vector<MethodTable>& tables) {
    QString text = head(targets, options);
    for (const MethodTable& table : tables) {
        text += tableText(targets, table);
    }
    return text + summary(tables);
}

}  // namespace pmts::targeting
