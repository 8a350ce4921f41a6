// Scene files: docs/scene-format.md.
#include "pmts/simulator/scene.hpp"
#include "scene_texture.hpp"

#include <Eigen/Geometry>
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <map>
#include <stdexcept>

static void nameScenes() { Q_INIT_RESOURCE(scenes); }  // outside every namespace, as the macro wants

namespace pmts::simulator {
namespace {

using core::ErrorKind;

constexpr double kLargestPanel_px = 8192.0;

QString tr(const char* text) { return QCoreApplication::translate("SceneFile", text); }

/// Reads one file; any trouble is thrown as core::Error and caught in fromFile(): the reader itself reads top
/// to bottom.
class SceneReader {
public:
    explicit SceneReader(const QString& path) : path_(path) {}

    Scene read() {
        const QJsonObject root = document();
        if (root.value(QStringLiteral("format")).toString() != QStringLiteral("pmts-scene")) {
            refuse(QStringLiteral("format"), tr("\"pmts-scene\" was expected"));
        }
        eachObject(root, QStringLiteral("panels"),
                   [this](const QJsonObject& object, const QString& at) { readPanel(object, at); });
        eachObject(root, QStringLiteral("marks"),
                   [this](const QJsonObject& object, const QString& at) { readMark(object, at); });
        if (panels_.empty()) {
            refuse(QStringLiteral("panels"), tr("at least one panel was expected"));
        }
        const auto seed = static_cast<unsigned>(number(root, QStringLiteral("sky_seed"), {}, 1.0));
        try {
            return Scene(std::move(panels_), std::move(marks_), seed);
        } catch (const std::length_error&) {
            refuse(QStringLiteral("panels"), tr("all textures together are too large; use a larger texel_m"));
        }
    }

private:
    [[noreturn]] void refuse(const QString& at, const QString& why,
                             ErrorKind kind = ErrorKind::kBadInput) const {
        throw core::Error{
            kind,
            tr("The scene file %1 cannot be used: at %2, %3.").arg(QFileInfo(path_).fileName(), at, why),
            tr("Correct the file and load it again."), std::nullopt, path_};
    }

    QJsonObject document() const {
        QFile file(path_);
        if (!file.open(QIODevice::ReadOnly)) {
            throw core::Error{ErrorKind::kFile, tr("The scene file %1 cannot be opened.").arg(path_),
                              tr("Check its name and that you may read it."), std::nullopt,
                              file.errorString()};
        }
        const QByteArray text = file.readAll();
        QJsonParseError problem;
        const QJsonDocument parsed = QJsonDocument::fromJson(text, &problem);
        if (!parsed.isObject()) {
            const auto line =
                std::count(text.begin(), text.begin() + std::min<qsizetype>(problem.offset, text.size()),
                           '\n') +
                1;
            refuse(tr("line %1").arg(line), problem.error == QJsonParseError::NoError
                                                ? tr("an object was expected")
                                                : problem.errorString());
        }
        return parsed.object();
    }

    template <class Use>
    void eachObject(const QJsonObject& root, const QString& key, Use use) {
        const QJsonValue value = root.value(key);
        if (!value.isUndefined() && !value.isArray()) {
            refuse(key, tr("a list was expected"));
        }
        const QJsonArray list = value.toArray();
        for (int i = 0; i < list.size(); ++i) {
            const QString at = QStringLiteral("%1[%2]").arg(key).arg(i);
            if (!list[i].isObject()) {
                refuse(at, tr("an object was expected"));
            }
            use(list[i].toObject(), at);
        }
    }

    [[nodiscard]] double number(const QJsonObject& object, const QString& key, const QString& at,
                                std::optional<double> otherwise = {}) const {
        const QJsonValue value = object.value(key);
        if (value.isUndefined() && otherwise) {
            return *otherwise;
        }
        if (!value.isDouble()) {
            refuse(at + key, tr("a number was expected"));
        }
        return value.toDouble();
    }

    [[nodiscard]] Eigen::Vector3d vector(const QJsonObject& object, const QString& key,
                                         const QString& at) const {
        const QJsonArray list = object.value(key).toArray();
        const bool numbers =
            std::all_of(list.begin(), list.end(), [](const QJsonValue& value) { return value.isDouble(); });
        if (list.size() != 3 || !numbers) {
            refuse(at + key, tr("three numbers were expected"));
        }
        return {list[0].toDouble(), list[1].toDouble(), list[2].toDouble()};
    }

    [[nodiscard]] QString name(const QJsonObject& object, const QString& at) const {
        const QString text = object.value(QStringLiteral("name")).toString();
        if (text.isEmpty()) {
            refuse(at + QStringLiteral("name"), tr("a name was expected"));
        }
        return text;
    }

    void readPanel(const QJsonObject& object, const QString& where) {
        const QString at = where + u'.';
        Panel panel;
        panel.name = name(object, at);
        panel.origin_m = vector(object, QStringLiteral("origin_m"), at);
        panel.right_m = vector(object, QStringLiteral("right_m"), at);
        panel.up_m = vector(object, QStringLiteral("up_m"), at);
        panel.absorbing = object.value(QStringLiteral("absorbing")).toBool(false);
        const double area = panel.right_m.cross(panel.up_m).norm();
        if (area < 1e-6 || std::abs(panel.right_m.dot(panel.up_m)) > 1e-3 * area) {
            refuse(where, tr("right_m and up_m were expected to be two sides of a rectangle"));
        }
        if (!object.value(QStringLiteral("texture")).isObject()) {
            refuse(at + QStringLiteral("texture"), tr("an object was expected"));
        }
        panel.texture = texture(object.value(QStringLiteral("texture")).toObject(), panel,
                                at + QStringLiteral("texture."));
        panels_.push_back(std::move(panel));
    }

    cv::Mat texture(const QJsonObject& object, const Panel& panel, const QString& at) {
        if (object.contains(QStringLiteral("image"))) {
            return image(object.value(QStringLiteral("image")).toString(), at + QStringLiteral("image"));
        }
        const double texel_m = number(object, QStringLiteral("texel_m"), at, 0.02);
        const double width_m = panel.right_m.norm();
        const double height_m = panel.up_m.norm();
        if (texel_m <= 0.0 || std::max(width_m, height_m) / texel_m > kLargestPanel_px) {
            refuse(at + QStringLiteral("texel_m"),
                   tr("a size that makes at most %1 texels a side was expected").arg(kLargestPanel_px));
        }
        cv::RNG rng(static_cast<std::uint64_t>(number(object, QStringLiteral("seed"), at, 1.0)) + 1ULL);
        return procedural(object, width_m, height_m, texel_m, rng, at);
    }

    [[nodiscard]] cv::Mat image(const QString& file, const QString& at) {
        const QString path = QFileInfo(path_).dir().absoluteFilePath(file);
        cv::Mat& known = images_[path];
        if (known.empty()) {
            known = cv::imread(path.toStdString(), cv::IMREAD_COLOR);
        }
        if (known.empty()) {
            refuse(at, tr("the image %1 cannot be read").arg(path), ErrorKind::kFile);
        }
        return known;
    }

    [[nodiscard]] cv::Mat procedural(const QJsonObject& object, double width_m, double height_m,
                                     double texel_m, cv::RNG& rng, const QString& at) const {
        static const std::map<QString, Wall> kWalls{{QStringLiteral("plaster"), Wall::kPlaster},
                                                    {QStringLiteral("brick"), Wall::kBrick},
                                                    {QStringLiteral("stone"), Wall::kStone},
                                                    {QStringLiteral("timber"), Wall::kTimber}};
        const QString kind = object.value(QStringLiteral("kind")).toString();
        if (const auto wall = kWalls.find(kind); wall != kWalls.end()) {
            return drawWall(wall->second, colour(object, QStringLiteral("colour"), at, {150, 170, 185}),
                            width_m, height_m, texel_m, rng)
                .image();
        }
        if (kind == QStringLiteral("facade")) {
            const auto wall =
                kWalls.find(object.value(QStringLiteral("wall")).toString(QStringLiteral("plaster")));
            if (wall == kWalls.end()) {
                refuse(at + QStringLiteral("wall"), tr("plaster, brick, stone or timber was expected"));
            }
            return drawFacade(facade(object, wall->second, at), width_m, height_m, texel_m, rng);
        }
        if (kind == QStringLiteral("paving")) {
            return drawPaving(width_m, height_m, texel_m, rng);
        }
        if (kind == QStringLiteral("roof")) {
            return drawRoof(colour(object, QStringLiteral("colour"), at, {62, 78, 142}), width_m, height_m,
                            texel_m, rng);
        }
        if (kind == QStringLiteral("hedge")) {
            return drawHedge(width_m, height_m, texel_m, rng);
        }
        if (kind == QStringLiteral("posters")) {
            return drawPosters(width_m, height_m, texel_m, 1.0, rng);
        }
        if (kind == QStringLiteral("plumb")) {
            return drawPlumbLine(width_m, height_m, texel_m);
        }
        if (kind == QStringLiteral("chessboard")) {
            const auto count = [&](const QString& key, int usual) { return std::clamp(static_cast<int>(number(object, key, at, usual)), 3, 60); };
            return drawChessboard(count(QStringLiteral("columns"), 9), count(QStringLiteral("rows"), 6), width_m, height_m, texel_m);
        }
        if (kind == QStringLiteral("black")) {
            return drawBlackBoard(width_m, height_m, texel_m, rng);
        }
        refuse(
            at + QStringLiteral("kind"),
            tr("plaster, brick, stone, timber, facade, paving, roof, hedge, posters, plumb, chessboard or black was expected"));
    }

    [[nodiscard]] Facade facade(const QJsonObject& object, Wall wall, const QString& at) const {
        Facade front;
        front.wall = wall;
        front.colour = colour(object, QStringLiteral("colour"), at, front.colour);
        front.trim = colour(object, QStringLiteral("trim"), at, front.trim);
        front.shutter = colour(object, QStringLiteral("shutter"), at, front.shutter);
        front.storeys =
            std::clamp(static_cast<int>(number(object, QStringLiteral("storeys"), at, front.storeys)), 1, 20);
        front.bays =
            std::clamp(static_cast<int>(number(object, QStringLiteral("bays"), at, front.bays)), 1, 40);
        front.shutters = object.value(QStringLiteral("shutters")).toBool(false);
        front.arched = object.value(QStringLiteral("arched")).toBool(false);
        front.sign = object.value(QStringLiteral("sign")).toString().toStdString();
        front.number = object.value(QStringLiteral("number")).toString().toStdString();
        front.light = std::clamp(number(object, QStringLiteral("light"), at, 1.0), 0.1, 1.5);
        return front;
    }

    /// In the file: red, green, blue.
    [[nodiscard]] cv::Scalar colour(const QJsonObject& object, const QString& key, const QString& at,
                                    const cv::Scalar& otherwise) const {
        if (!object.contains(key)) {
            return otherwise;
        }
        const Eigen::Vector3d rgb = vector(object, key, at);
        if (rgb.minCoeff() < 0.0 || rgb.maxCoeff() > 255.0) {
            refuse(at + key, tr("red, green and blue from 0 to 255 were expected"));
        }
        return {rgb.z(), rgb.y(), rgb.x()};
    }

    void readMark(const QJsonObject& object, const QString& where) {
        const QString at = where + u'.';
        const QString mark_name = name(object, at);
        const Eigen::Vector3d centre = vector(object, QStringLiteral("position_m"), at);
        const QString kind = object.value(QStringLiteral("kind")).toString(QStringLiteral("quadrants"));
        const double size_m = number(object, QStringLiteral("size_m"), at, 0.2);
        if (size_m <= 0.0 || size_m > 10.0) {
            refuse(at + QStringLiteral("size_m"), tr("a size between 0 and 10 m was expected"));
        }
        if (kind != QStringLiteral("quadrants") && kind != QStringLiteral("prism") &&
            kind != QStringLiteral("none")) {
            refuse(at + QStringLiteral("kind"), tr("quadrants, prism or none was expected"));
        }
        marks_.push_back({mark_name, centre});
        if (kind != QStringLiteral("none")) {
            panels_.push_back(board(mark_name, centre, facing(object, centre, at), size_m,
                                    kind == QStringLiteral("prism")));
        }
    }

    /// Horizontal direction a mark looks into: to the instrument when the file does not say.
    [[nodiscard]] Eigen::Vector3d facing(const QJsonObject& object, const Eigen::Vector3d& centre,
                                         const QString& at) const {
        Eigen::Vector3d normal = object.contains(QStringLiteral("facing_m"))
                                     ? vector(object, QStringLiteral("facing_m"), at)
                                     : Eigen::Vector3d(-centre);
        normal.z() = 0.0;
        if (normal.norm() < 1e-6) {
            refuse(at + QStringLiteral("facing_m"), tr("a horizontal direction was expected"));
        }
        return normal.normalized();
    }

    static Panel board(const QString& name, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal,
                       double size_m, bool prism) {
        const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(normal) * size_m;
        const Eigen::Vector3d up(0, 0, size_m);
        return {.name = name,
                .origin_m = centre - right / 2 - up / 2,
                .right_m = right,
                .up_m = up,
                .texture = prism ? drawPrism(160) : drawQuadrants(200)};
    }

    QString path_;
    std::vector<Panel> panels_;
    std::vector<Mark> marks_;
    std::map<QString, cv::Mat> images_;
};

}  // namespace

core::Result<Scene> Scene::named(const QString& name_or_path, unsigned seed) {
    if (name_or_path.isEmpty() || name_or_path == builtInNames()[0]) {
        return townSquare(seed);
    }
    nameScenes();
    return fromFile(name_or_path == builtInNames()[1] ? QStringLiteral(":/pmts/scenes/laboratory.json") : name_or_path);
}

QStringList Scene::builtInNames() { return {QStringLiteral("town-square"), QStringLiteral("laboratory")}; }

core::Result<Scene> Scene::fromFile(const QString& path) {
    try {
        return SceneReader(path).read();
    } catch (const core::Error& error) {
        return tl::unexpected(error);
    }
}

}  // namespace pmts::simulator
