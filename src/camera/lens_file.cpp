#include "pmts/camera/lens_file.hpp"

#include "lens_numbers.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QSaveFile>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pmts::camera {
namespace {

using core::ErrorKind;

QString text(const char* sentence) { return QCoreApplication::translate("LensFile", sentence); }

constexpr std::size_t kRationalCount = 8;
constexpr qint64 kLargestFile = 1 << 20;

Lens lensOf(const LensNumbers& n, double f_px) {
    const auto k = [&n](std::size_t i) { return i < n.distortion.size() ? n.distortion[i] : 0.0; };
    if (n.fisheye) {
        return Lens(FisheyeLens{.f_px = f_px, .cx_px = n.cx, .cy_px = n.cy, .k1 = k(0), .k2 = k(1), .k3 = k(2), .k4 = k(3)});
    }
    if (k(5) != 0 || k(6) != 0 || k(7) != 0) {
        return Lens(RationalLens{.f_px = f_px, .cx_px = n.cx, .cy_px = n.cy, .k1 = k(0), .k2 = k(1), .k3 = k(4),
                                 .k4 = k(5), .k5 = k(6), .k6 = k(7), .p1 = k(2), .p2 = k(3)});
    }
    return Lens(BrownLens{.f_px = f_px, .cx_px = n.cx, .cy_px = n.cy, .k1 = k(0), .k2 = k(1), .k3 = k(4), .p1 = k(2), .p2 = k(3)});
}

core::Result<void> distortionIsOurs(const LensNumbers& n) {
    const std::size_t most = n.fisheye ? 4 : kRationalCount;
    const bool rest_is_zero = n.distortion.size() <= most ||
                              std::all_of(n.distortion.begin() + static_cast<std::ptrdiff_t>(most), n.distortion.end(),
                                          [](double value) { return value == 0; });
    if (!rest_is_zero) {
        return core::fail(ErrorKind::kBadInput, text("The lens has thin prism or tilt terms; PMTS has none."),
                          text("Calibrate again with at most 8 distortion coefficients."));
    }
    return {};
}

struct Numbered {
    LensNumbers numbers;
    void operator()(const BrownLens& l) { take(l, {l.k1, l.k2, l.p1, l.p2, l.k3}); }
    void operator()(const RationalLens& l) { take(l, {l.k1, l.k2, l.p1, l.p2, l.k3, l.k4, l.k5, l.k6}); }
    void operator()(const FisheyeLens& l) {
        take(l, {l.k1, l.k2, l.k3, l.k4});
        numbers.fisheye = true;
    }
    void operator()(const RadialTableLens&) { numbers.fx = 0; }

    template <class FocalLens>
    void take(const FocalLens& lens, std::vector<double> distortion) {
        numbers.fx = numbers.fy = lens.f_px;
        numbers.cx = lens.cx_px;
        numbers.cy = lens.cy_px;
        numbers.distortion = std::move(distortion);
    }
};

}  // namespace

QByteArray exactNumber(double value) { return QByteArray::number(value, 'g', 17); }

core::Result<LensFile> lensFromNumbers(const LensNumbers& n) {
    constexpr double kMostApart = 0.01;
    PMTS_TRY(distortionIsOurs(n));
    const double f_px = (n.fx + n.fy) / 2;
    const bool makes_a_camera = std::isfinite(f_px) && n.fx > 0 && n.fy > 0;
    if (!makes_a_camera) {
        return core::fail(ErrorKind::kBadInput, text("The file has no usable focal length."), text("Check the camera matrix."));
    }
    const double apart = std::abs(n.fx - n.fy) / f_px;
    if (apart > kMostApart) {
        return core::fail(ErrorKind::kBadInput, text("Its pixels are not square: fx and fy differ by %1 %.").arg(100 * apart, 0, 'f', 1),
                          text("Calibrate again with a fixed aspect ratio."));
    }
    LensFile file{.lens = {}, .width_px = n.width_px, .height_px = n.height_px, .note = {}};
    try {
        file.lens = lensOf(n, f_px);
    } catch (const std::logic_error&) {
        return core::fail(ErrorKind::kBadInput, text("The numbers in the file make no lens."), text("Check that each is a number."));
    }
    const double off_px = apart / 2 * std::max(n.width_px, n.height_px) / 2;
    if (apart > 1e-9) {
        file.note = text("fx and fy differ; their mean is used, up to %1 px off at the edge.").arg(off_px, 0, 'f', 2);
    }
    return file;
}

core::Result<LensNumbers> numbersOfLens(const Lens& lens, int width_px, int height_px) {
    Numbered visit;
    std::visit(visit, lens.model());
    if (!(visit.numbers.fx > 0) || lens.residuals()) {
        return core::fail(ErrorKind::kBadInput, text("A lens with a table has no place in this format."),
                          text("Export the profile instead; other PMTS read it."));
    }
    visit.numbers.width_px = width_px;
    visit.numbers.height_px = height_px;
    return visit.numbers;
}

core::Result<LensFile> lensFromFile(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return core::fail(ErrorKind::kFile, text("The lens file cannot be read."), text("Check that the file is there."),
                          path + QStringLiteral(": ") + file.errorString());
    }
    const QByteArray content = file.read(kLargestFile);
    return content.contains("camera_matrix") || content.contains("%YAML") || content.contains("K:") ? lensFromOpenCvYaml(content)
                                                                                                    : lensFromColmap(content);
}

core::Result<void> lensToFile(const Lens& lens, int width_px, int height_px, const QString& path) {
    const bool colmap = path.endsWith(QLatin1String(".txt"), Qt::CaseInsensitive);
    const auto content = colmap ? lensToColmap(lens, width_px, height_px) : lensToOpenCvYaml(lens, width_px, height_px);
    PMTS_TRY(content);
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(*content) < 0 || !file.commit()) {
        return core::fail(ErrorKind::kFile, text("The lens file cannot be written."), text("Choose another folder."),
                          path + QStringLiteral(": ") + file.errorString());
    }
    return {};
}

}  // namespace pmts::camera
