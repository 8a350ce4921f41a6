#include "pmts/protocol/info_code.hpp"

#include "info_code_table.hpp"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>

namespace pmts::protocol {
namespace {

constexpr int kLineError = 21;
constexpr int kServoCannotStart = 164;
constexpr int kTooManyCommands = 207;

struct Named {
    int number;
    const char* name;
};

constexpr std::array kDevices{
    Named{0, QT_TRANSLATE_NOOP("InfoCode", "recorder")},
    Named{1, QT_TRANSLATE_NOOP("InfoCode", "serial port")},
    Named{2, QT_TRANSLATE_NOOP("InfoCode", "internal memory")},
    Named{3, QT_TRANSLATE_NOOP("InfoCode", "external memory")},
    Named{4, QT_TRANSLATE_NOOP("InfoCode", "second serial port")},
    Named{5, QT_TRANSLATE_NOOP("InfoCode", "card")},
    Named{6, QT_TRANSLATE_NOOP("InfoCode", "radio")},
    Named{7, QT_TRANSLATE_NOOP("InfoCode", "distance meter")},
    Named{8, QT_TRANSLATE_NOOP("InfoCode", "main board")},
    Named{12, QT_TRANSLATE_NOOP("InfoCode", "servo")},
    Named{13, QT_TRANSLATE_NOOP("InfoCode", "tracker")},
    Named{15, QT_TRANSLATE_NOOP("InfoCode", "angle unit")},
};

constexpr std::array kLineErrorBits{
    Named{1, QT_TRANSLATE_NOOP("InfoCode", "overrun")},
    Named{2, QT_TRANSLATE_NOOP("InfoCode", "parity")},
    Named{4, QT_TRANSLATE_NOOP("InfoCode", "framing")},
    Named{8, QT_TRANSLATE_NOOP("InfoCode", "break received")},
};

QString tr(const char* text) {
    return *text == '\0' ? QString() : QCoreApplication::translate("InfoCode", text);
}

QString lineErrors(int bit_sum) {
    QStringList names;
    for (const auto& bit : kLineErrorBits) {
        if ((bit_sum & bit.number) != 0) {
            names << tr(bit.name);
        }
    }
    return names.join(QStringLiteral(", "));
}

QString deviceName(int number) {
    const auto found = std::ranges::find(kDevices, number, &Named::number);
    return found == kDevices.end() ? tr(QT_TRANSLATE_NOOP("InfoCode", "unit %1")).arg(number)
                                   : tr(found->name);
}

QString statusText(const Status& status) {
    return status.suffix ? QStringLiteral("%1.%2").arg(status.code).arg(*status.suffix)
                         : QString::number(status.code);
}

}  // namespace

InfoCode infoCode(int code) {
    const auto table = infoTable();
    const auto row =
        std::ranges::find_if(table, [code](const InfoRow& r) { return code >= r.first && code <= r.last; });
    if (row == table.end()) {
        return {
            .code = code,
            .info_class = InfoClass::kUnknown,
            .happened =
                tr(QT_TRANSLATE_NOOP("InfoCode", "The instrument reports info %1, which is not in its list."))
                    .arg(code),
            .remedy =
                tr(QT_TRANSLATE_NOOP("InfoCode", "Look it up in the instrument's manual and keep the log."))};
    }
    return {.code = code,
            .info_class = row->info_class,
            .happened = tr(row->happened),
            .remedy = tr(row->remedy)};
}

bool isWarning(int code) {
    constexpr std::array kWarnings{8, 9, 25, 26};
    return std::ranges::find(kWarnings, code) != kWarnings.end();
}

QString suffixMeaning(const Status& status) {
    if (!status.suffix) {
        return {};
    }
    switch (status.code) {
        case kLineError:
            return lineErrors(*status.suffix);
        case kServoCannotStart:
            return tr(QT_TRANSLATE_NOOP("InfoCode", "knob %1")).arg(*status.suffix);
        case kTooManyCommands:
            return *status.suffix == 1 ? tr(QT_TRANSLATE_NOOP("InfoCode", "second queue"))
                                       : deviceName(*status.suffix);
        default:
            return deviceName(*status.suffix);
    }
}

core::Error errorFromStatus(const Status& status) {
    const InfoCode info = infoCode(status.code);
    const bool soft = info.info_class == InfoClass::kMotionSoft;
    const QString device = suffixMeaning(status);
    return {.kind = soft ? core::ErrorKind::kNotReached : core::ErrorKind::kDevice,
            .happened = info.happened,
            .remedy = info.remedy,
            .info_code = status.code,
            .detail = QStringLiteral("info %1").arg(statusText(status)) +
                      (device.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(device))};
}

}  // namespace pmts::protocol
