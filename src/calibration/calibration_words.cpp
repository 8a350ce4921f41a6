#include "pmts/calibration/self_calibration.hpp"

#include <QCoreApplication>

#include <array>
#include <numbers>

namespace pmts::calibration {
namespace {

QString text(const char* sentence) { return QCoreApplication::translate("Calibration", sentence); }

QString howGood(const SelfCalibration& calibration) {
    const double mgon =
        calibration.held_out_px / calibration.rig.lens.focalLengthPx() * 2e5 / std::numbers::pi;
    const QString size = text("%1 px, %2 mgon").arg(calibration.held_out_px, 0, 'f', 3).arg(mgon, 0, 'f', 1);
    if (calibration.held_out_px <= 0.1) {
        return text("Very good: a new spot will be met within %1.").arg(size);
    }
    if (calibration.held_out_px <= 0.4) {
        return text(
                   "Usable: a new spot will be met within %1. A sharper spot or a calmer day makes it "
                   "better.")
            .arg(size);
    }
    return text(
               "Poor: a new spot is missed by %1. Choose another spot, check that the camera sits tight, and "
               "sweep again.")
        .arg(size);
}

QString tableWords(const SelfCalibration& calibration) {
    return text(
               "The lens bends otherwise than its model: a table of residuals takes %1 px down to %2 px in "
               "pictures it "
               "never saw.")
        .arg(calibration.held_out_without_table_px, 0, 'f', 3)
        .arg(calibration.held_out_px, 0, 'f', 3);
}

}  // namespace

QString parameterWords(RigParameter parameter) {
    static constexpr std::array kWords{
        QT_TRANSLATE_NOOP("Calibration", "focal length"),
        QT_TRANSLATE_NOOP("Calibration", "centre column"),
        QT_TRANSLATE_NOOP("Calibration", "centre row"),
        QT_TRANSLATE_NOOP("Calibration", "distortion k1"),
        QT_TRANSLATE_NOOP("Calibration", "distortion k2"),
        QT_TRANSLATE_NOOP("Calibration", "distortion k3"),
        QT_TRANSLATE_NOOP("Calibration", "distortion p1"),
        QT_TRANSLATE_NOOP("Calibration", "distortion p2"),
        QT_TRANSLATE_NOOP("Calibration", "yaw"),
        QT_TRANSLATE_NOOP("Calibration", "pitch"),
        QT_TRANSLATE_NOOP("Calibration", "twist"),
        QT_TRANSLATE_NOOP("Calibration", "offset to the right"),
        QT_TRANSLATE_NOOP("Calibration", "offset forward"),
        QT_TRANSLATE_NOOP("Calibration", "offset upward"),
    };
    return text(kWords.at(static_cast<std::size_t>(parameter)));
}

QStringList verdict(const SelfCalibration& calibration) {
    QStringList sentences{howGood(calibration)};
    if (calibration.hasTable()) {
        sentences.append(tableWords(calibration));
    }
    for (const HeldParameter& held : calibration.held) {
        if (!sentences.contains(held.sentence)) {  // one reason may hold several
            sentences.append(held.sentence);
        }
    }
    if (!calibration.outliers.empty()) {
        QStringList numbers;
        for (const std::size_t index : calibration.outliers) {
            numbers.append(QString::number(index + 1));
        }
        sentences.append(text("%1 of %2 pictures contradict the others and were left out: %3.")
                             .arg(calibration.outliers.size())
                             .arg(calibration.residuals_px.size())
                             .arg(numbers.join(QStringLiteral(", "))));
    }
    return sentences;
}

}  // namespace pmts::calibration
