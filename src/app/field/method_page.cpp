#include "pmts/app/field/method_page.hpp"

#include <QCoreApplication>

namespace pmts::app {

namespace {

using targeting::ListedTarget;
using targeting::Method;
using targeting::MethodRow;
using targeting::MethodTable;

QString say(const char* text) { return QCoreApplication::translate("MethodReport", text); }

QString shortName(const MethodTable& table) {
    switch (table.method) {
        case Method::kApa: return say("APA");
        case Method::kTpa: return say("TPA");
        case Method::kOatpa: return say("OATPA");
        case Method::kRectifiedOatpa: return say("Rectified OATPA");
        case Method::kRigorous: return table.left_one_out ? say("Left one out") : say("Rigorous");
    }
    return {};
}

double plotted(core::Angle angle, core::AngleUnit unit) {
    switch (unit) {
        case core::AngleUnit::kGon: return angle.gon();
        case core::AngleUnit::kMil: return angle.mil();
        case core::AngleUnit::kDms:
        case core::AngleUnit::kDegree: return angle.deg();
    }
    return angle.gon();
}

QString plotUnit(core::AngleUnit unit) {
    return unit == core::AngleUnit::kGon ? say("gon") : unit == core::AngleUnit::kMil ? say("mil") : QStringLiteral("°");
}

QStringList rowTexts(const ListedTarget& target, const MethodRow& row, bool has_printed, const UnitFormat& units) {
    QStringList cells{target.name, units.lengthNumber(target.observed.slope_distance_m),
                      units.directionNumber(target.observed.pointing.ha),
                      units.angleNumber(target.observed.pointing.va)};
    if (!row.computed) {
        cells += {row.computed.error().happened, {}, {}, {}};
    } else {
        cells += {units.directionNumber(row.computed->ha), units.angleNumber(row.computed->va),
                  units.angleNumber(row.error_ha), units.angleNumber(row.error_va)};
    }
    if (has_printed) {
        const auto off = [&units](const auto& angle) { return angle ? units.angleNumber(*angle) : QString(); };
        cells += {off(row.off_printed_ha), off(row.off_printed_va)};
    }
    return cells;
}

QStringList padded(QStringList cells, qsizetype columns) {
    while (cells.size() < columns) {
        cells.append(QString());
    }
    return cells;
}

TextTable textsOf(const std::vector<ListedTarget>& targets, const MethodTable& table, const UnitFormat& units) {
    const QString unit = units.angleUnitSign();
    TextTable texts;
    texts.header = {say("Target"), say("SD %1").arg(units.lengthUnitSign()), say("HA %1").arg(unit), say("VA %1").arg(unit),
                    say("HA computed"), say("VA computed"), say("Error HA"), say("Error VA")};
    const bool has_printed = table.off_printed.has_value();
    if (has_printed) {
        texts.header += {say("HA less printed"), say("VA less printed")};
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        texts.rows.push_back(rowTexts(targets[i], table.rows[i], has_printed, units));
    }
    texts.plain_rows = static_cast<int>(texts.rows.size());
    if (table.computed > 0) {
        const auto sum_up = [&](const QString& name, core::Angle ha, core::Angle va) {
            texts.rows.push_back(padded({name, {}, {}, {}, {}, {}, units.angleNumber(ha), units.angleNumber(va)},
                                        texts.header.size()));
        };
        sum_up(say("rms"), table.rms_ha, table.rms_va);
        sum_up(say("maximum"), table.largest_ha, table.largest_va);
    }
    return texts;
}

MethodPage pageOf(const std::vector<ListedTarget>& targets, const MethodTable& table, const UnitFormat& units) {
    MethodPage page{.name = shortName(table), .title = table.title, .setting = table.setting,
                    .known_error = table.known_error, .off_printed = {}, .table = textsOf(targets, table, units), .errors = {}};
    if (table.off_printed) {
        page.off_printed = say("largest difference from the printed columns: %1").arg(units.angle(*table.off_printed));
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (const MethodRow& row = table.rows[i]; row.computed) {
            page.errors.push_back({.name = targets[i].name,
                                   .ha = plotted(row.error_ha, units.angle_unit),
                                   .va = plotted(row.error_va, units.angle_unit),
                                   .px = {targets[i].px.x(), targets[i].px.y()}});
        }
    }
    return page;
}

/// `known error: up to …` under a header that says so already.
QString withoutLabel(const QString& known_error) {
    const QString text = known_error.section(QStringLiteral(": "), 1);
    return text.isEmpty() ? known_error : text;
}

TextTable summaryOf(const std::vector<MethodTable>& tables, const UnitFormat& units) {
    const QString unit = units.angleUnitSign();
    TextTable summary;
    summary.header = {say("Method"), say("rms HA %1").arg(unit), say("rms VA %1").arg(unit), say("max HA %1").arg(unit),
                      say("max VA %1").arg(unit), say("From printed"), say("Known error")};
    for (const MethodTable& table : tables) {
        QStringList row{shortName(table)};
        if (table.computed > 0) {
            row += {units.angleNumber(table.rms_ha), units.angleNumber(table.rms_va), units.angleNumber(table.largest_ha),
                    units.angleNumber(table.largest_va)};
        } else {
            row += {table.rows.empty() ? QString() : table.rows.front().computed.error().happened, {}, {}, {}};
        }
        row += {table.off_printed ? units.angleNumber(*table.off_printed) : QString(), withoutLabel(table.known_error)};
        summary.rows.push_back(row);
    }
    summary.plain_rows = static_cast<int>(summary.rows.size());
    return summary;
}

QString csvCell(QString text) {
    const bool quoted = text.contains(u',') || text.contains(u'"');
    return quoted ? u'"' + text.replace(u'"', QStringLiteral("\"\"")) + u'"' : text;
}

QString csvLine(const QStringList& cells) {
    QStringList written;
    for (const QString& cell : cells) {
        written.append(csvCell(cell));
    }
    return written.join(u',') + u'\n';
}

}  // namespace

MethodReportView methodReportView(const std::vector<ListedTarget>& targets,
                                  const targeting::MethodReportOptions& options, const UnitFormat& units) {
    targeting::MethodReportOptions in_units = options;
    in_units.angle_unit = units.angle_unit;
    const std::vector<MethodTable> tables = targeting::runMethods(targets, in_units);
    MethodReportView view{.head = QCoreApplication::translate("MethodReport", "%n target(s), photo %1 x %2 px taken at HA %3, VA %4",
                                                              nullptr, static_cast<int>(targets.size()))
                                      .arg(options.width_px)
                                      .arg(options.height_px)
                                      .arg(units.direction(options.photo.ha), units.angle(options.photo.va)),
                          .fit = {}, .summary = summaryOf(tables, units), .pages = {},
                          .image_px = {options.width_px, options.height_px}, .plot_unit = plotUnit(units.angle_unit)};
    if (options.fit) {
        view.fit = QStringList{say("Fitted rig: rms %1 px, largest %2 px")
                                   .arg(options.fit->rms_px, 0, 'f', 2)
                                   .arg(options.fit->largest_px, 0, 'f', 2)} +
                   QStringList(options.fit->parameters).replaceInStrings(QStringLiteral("+-"), QStringLiteral("±"));
    }
    for (const MethodTable& table : tables) {
        view.pages.push_back(pageOf(targets, table, units));
    }
    return view;
}

QString csvOf(const MethodReportView& view) {
    QStringList header;
    for (const MethodPage& page : view.pages) {  // the printed columns come last, where there are
        header = page.table.header.size() > header.size() ? page.table.header : header;
    }
    const qsizetype columns = header.size();
    QString text = csvLine(QStringList{say("Method")} + header);
    for (const MethodPage& page : view.pages) {
        for (int row = 0; row < page.table.plain_rows; ++row) {
            text += csvLine(padded(QStringList{page.name} + page.table.rows[static_cast<std::size_t>(row)], columns + 1));
        }
    }
    return text;
}

}  // namespace pmts::app
