#include "lens_numbers.hpp"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <array>

namespace pmts::camera {
namespace {

using core::ErrorKind;

constexpr double kCornerToCentre_px = 0.5;  ///< COLMAP counts from the corner of the first pixel

QString text(const char* sentence) { return QCoreApplication::translate("LensFile", sentence); }

/// The place of each number in COLMAP's list of a model; -1: not in it.
struct Model {
    const char* name;
    int count;
    int fy;                                   ///< index; fx is always the first
    std::array<int, 8> distortion;            ///< indices of k1 k2 p1 p2 k3 k4 k5 k6, or of the fisheye's k1 to k4
    bool fisheye;
};

constexpr std::array<Model, 7> kModels{{
    {"SIMPLE_PINHOLE", 3, 0, {-1, -1, -1, -1, -1, -1, -1, -1}, false},
    {"PINHOLE", 4, 1, {-1, -1, -1, -1, -1, -1, -1, -1}, false},
    {"SIMPLE_RADIAL", 4, 0, {3, -1, -1, -1, -1, -1, -1, -1}, false},
    {"RADIAL", 5, 0, {3, 4, -1, -1, -1, -1, -1, -1}, false},
    {"OPENCV", 8, 1, {4, 5, 6, 7, -1, -1, -1, -1}, false},
    {"FULL_OPENCV", 12, 1, {4, 5, 6, 7, 8, 9, 10, 11}, false},
    {"OPENCV_FISHEYE", 8, 1, {4, 5, 6, 7, -1, -1, -1, -1}, true},
}};

core::Result<LensNumbers> numbersFrom(const QStringList& words) {
    const auto model = std::find_if(kModels.begin(), kModels.end(),
                                    [&](const Model& known) { return words.value(1) == QLatin1String(known.name); });
    if (model == kModels.end()) {
        return core::fail(ErrorKind::kBadInput, text("COLMAP's camera model “%1” is not known here.").arg(words.value(1)),
                          text("Known: SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL, OPENCV, FULL_OPENCV, OPENCV_FISHEYE."));
    }
    std::vector<double> numbers;
    bool all_read = true;
    for (qsizetype i = 2; i < words.size(); ++i) {
        bool is_number = false;
        numbers.push_back(words[i].toDouble(&is_number));
        all_read = all_read && is_number;
    }
    if (!all_read || static_cast<int>(numbers.size()) != model->count + 2 || !(numbers[0] >= 1 && numbers[1] >= 1)) {
        return core::fail(ErrorKind::kBadInput, text("The camera's line does not hold a size and %1 numbers.").arg(model->count),
                          text("A line is: CAMERA_ID MODEL WIDTH HEIGHT PARAMETERS."));
    }
    const double* const p = numbers.data() + 2;
    const int centre = model->fy + 1;
    LensNumbers n{.fx = p[0], .fy = p[model->fy], .cx = p[centre] - kCornerToCentre_px, .cy = p[centre + 1] - kCornerToCentre_px,
                  .distortion = {}, .fisheye = model->fisheye, .width_px = static_cast<int>(numbers[0]),
                  .height_px = static_cast<int>(numbers[1])};
    for (const int index : model->distortion) {
        n.distortion.push_back(index < 0 ? 0.0 : p[index]);
    }
    return n;
}

}  // namespace

core::Result<LensFile> lensFromColmap(const QByteArray& content) {
    static const QRegularExpression blanks(QStringLiteral("\\s+"));
    for (const QString& line : QString::fromUtf8(content).split(QLatin1Char('\n'))) {
        const QString trimmed = line.trimmed();
        if (!trimmed.isEmpty() && !trimmed.startsWith(QLatin1Char('#'))) {
            const auto numbers = numbersFrom(trimmed.split(blanks));
            PMTS_TRY(numbers);
            return lensFromNumbers(*numbers);
        }
    }
    return core::fail(ErrorKind::kBadInput, text("The file holds no camera."), text("Choose COLMAP's cameras.txt or OpenCV's YAML."));
}

core::Result<QByteArray> lensToColmap(const Lens& lens, int width_px, int height_px) {
    const auto n = numbersOfLens(lens, width_px, height_px);
    PMTS_TRY(n);
    const auto k = [&n](std::size_t i) { return i < n->distortion.size() ? n->distortion[i] : 0.0; };
    const bool full = !n->fisheye && (k(4) != 0 || k(5) != 0 || k(6) != 0 || k(7) != 0);
    std::vector<double> numbers{n->fx, n->fy, n->cx + kCornerToCentre_px, n->cy + kCornerToCentre_px};
    for (std::size_t i = 0; i < (full ? 8U : 4U); ++i) {
        numbers.push_back(k(i));
    }
    QByteArray line = QStringLiteral("1 %1 %2 %3")
                          .arg(QLatin1String(n->fisheye ? "OPENCV_FISHEYE" : full ? "FULL_OPENCV" : "OPENCV"))
                          .arg(width_px)
                          .arg(height_px)
                          .toUtf8();
    for (const double number : numbers) {
        line += ' ' + exactNumber(number);
    }
    return "# Camera list with one line of data per camera:\n#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n" + line + '\n';
}

}  // namespace pmts::camera
