#include "lens_numbers.hpp"

#include <QCoreApplication>
#include <QStringList>
#include <opencv2/core.hpp>

namespace pmts::camera {
namespace {

using core::ErrorKind;

QString text(const char* sentence) { return QCoreApplication::translate("LensFile", sentence); }

/// Of the names that programs give an entry, the first that is there.
cv::FileNode entry(const cv::FileStorage& file, std::initializer_list<const char*> names) {
    for (const char* name : names) {
        if (const cv::FileNode node = file[name]; !node.empty()) {
            return node;
        }
    }
    return {};
}

/// A matrix as OpenCV writes it, ROS's map with `data`, or a plain list; row by row.
std::vector<double> values(const cv::FileNode& node) {
    std::vector<double> numbers;
    const cv::FileNode data = node.isMap() ? node["data"] : node;
    if (data.isSeq()) {
        for (const cv::FileNode& item : data) {
            if (item.isSeq()) {
                for (const cv::FileNode& inner : item) {
                    numbers.push_back(inner.real());
                }
            } else {
                numbers.push_back(item.real());
            }
        }
    }
    return numbers;
}

core::Result<LensNumbers> numbersFrom(const cv::FileStorage& file) {
    const std::vector<double> k = values(entry(file, {"camera_matrix", "Camera_Matrix", "cameraMatrix", "K"}));
    if (k.size() != 9) {
        return core::fail(ErrorKind::kBadInput, text("The file has no camera_matrix of 3 x 3 numbers."),
                          text("Choose a calibration that OpenCV or ROS wrote."));
    }
    LensNumbers n{.fx = k[0], .fy = k[4], .cx = k[2], .cy = k[5], .distortion = {}};
    n.distortion = values(entry(file, {"distortion_coefficients", "Distortion_Coefficients", "distCoeffs", "dist_coeffs", "D"}));
    const std::string model = entry(file, {"distortion_model"}).string();
    const cv::FileNode flag = entry(file, {"fisheye_model", "fisheye"});
    n.fisheye = model == "fisheye" || model == "equidistant" || (flag.isInt() && static_cast<int>(flag) != 0);
    n.width_px = static_cast<int>(entry(file, {"image_width", "image_Width", "width"}).real());
    n.height_px = static_cast<int>(entry(file, {"image_height", "image_Height", "height"}).real());
    if (n.distortion.size() == 1 || n.distortion.size() == 2 || n.distortion.size() == 3) {
        return core::fail(ErrorKind::kBadInput, text("The file has %1 distortion coefficients.").arg(n.distortion.size()),
                          text("Known are 0, 4, 5 and 8 of them."));
    }
    return n;
}

QByteArray matrix(const char* name, int rows, int columns, const std::vector<double>& numbers) {
    QStringList parts;
    for (const double number : numbers) {
        QString part = QString::fromLatin1(exactNumber(number));
        // Without a point OpenCV reads a whole number.
        parts.append(part.contains(QLatin1Char('.')) || part.contains(QLatin1Char('e')) ? part : part + QStringLiteral("."));
    }
    return QStringLiteral("%1: !!opencv-matrix\n   rows: %2\n   cols: %3\n   dt: d\n   data: [ %4 ]\n")
        .arg(QLatin1String(name)).arg(rows).arg(columns).arg(parts.join(QStringLiteral(",\n       "))).toUtf8();
}

}  // namespace

core::Result<LensFile> lensFromOpenCvYaml(const QByteArray& yaml) {
    const QByteArray headed = yaml.trimmed().startsWith("%YAML") ? yaml.trimmed() : "%YAML:1.0\n---\n" + yaml;
    try {
        const cv::FileStorage file(headed.toStdString(), cv::FileStorage::READ | cv::FileStorage::MEMORY | cv::FileStorage::FORMAT_YAML);
        const auto numbers = numbersFrom(file);
        PMTS_TRY(numbers);
        return lensFromNumbers(*numbers);
    } catch (const cv::Exception& trouble) {
        return core::fail(ErrorKind::kBadInput, text("This is no YAML that OpenCV can read."),
                          text("Choose a calibration that OpenCV or ROS wrote."), QString::fromStdString(trouble.err));
    }
}

core::Result<QByteArray> lensToOpenCvYaml(const Lens& lens, int width_px, int height_px) {
    const auto n = numbersOfLens(lens, width_px, height_px);
    PMTS_TRY(n);
    QByteArray yaml = "%YAML:1.0\n---\n";
    yaml += QStringLiteral("image_width: %1\nimage_height: %2\n").arg(width_px).arg(height_px).toUtf8();
    yaml += matrix("camera_matrix", 3, 3, {n->fx, 0, n->cx, 0, n->fy, n->cy, 0, 0, 1});
    yaml += n->fisheye ? "distortion_model: fisheye\nfisheye_model: 1\n"
                       : n->distortion.size() > 5 ? "distortion_model: rational_polynomial\n" : "distortion_model: plumb_bob\n";
    yaml += matrix("distortion_coefficients", n->fisheye ? 4 : 1, n->fisheye ? 1 : static_cast<int>(n->distortion.size()), n->distortion);
    return yaml;
}

}  // namespace pmts::camera
