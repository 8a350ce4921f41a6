#include "black_box_records.hpp"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <QCborValue>

#include <algorithm>

namespace pmts::app {

namespace {

constexpr int kJpegQuality = 70;

QString key(const char* name) { return QLatin1String(name); }

QByteArray bytesOf(const std::string& text) { return {text.data(), static_cast<qsizetype>(text.size())}; }

QString textIn(const QCborMap& map, const char* name) { return map.value(key(name)).toString(); }

core::Duration timeIn(const QCborMap& map, const char* name) { return core::Duration(map.value(key(name)).toInteger()); }

qint64 ns(core::Duration time) { return time.count(); }

template <class Enum>
Enum enumIn(const QCborMap& map, const char* name, Enum highest, Enum usual = Enum{}) {
    const qint64 number = map.value(key(name)).toInteger(static_cast<qint64>(usual));
    return number >= 0 && number <= static_cast<qint64>(highest) ? static_cast<Enum>(number) : usual;
}

}  // namespace

QCborMap mapOf(const scheduler::TransactionRecord& record) {
    return {{key("sent"), bytesOf(record.sent)},
            {key("received"), bytesOf(record.received)},
            {key("queued"), ns(record.queued_at)},
            {key("sent_at"), ns(record.sent_at)},
            {key("finished"), ns(record.finished_at)},
            {key("video_paused"), record.video_paused},
            {key("may_stay_silent"), record.may_stay_silent},
            {key("priority"), static_cast<int>(record.priority)},
            {key("outcome"), static_cast<int>(record.outcome)},
            {key("master"), static_cast<int>(record.master)}};
}

scheduler::TransactionRecord transactionFrom(const QCborMap& map) {
    scheduler::TransactionRecord record;
    record.sent = map.value(key("sent")).toByteArray().toStdString();
    record.received = map.value(key("received")).toByteArray().toStdString();
    record.queued_at = timeIn(map, "queued");
    record.sent_at = timeIn(map, "sent_at");
    record.finished_at = timeIn(map, "finished");
    record.video_paused = map.value(key("video_paused")).toBool();
    record.may_stay_silent = map.value(key("may_stay_silent")).toBool();
    record.priority = enumIn(map, "priority", scheduler::Priority::kPoll);
    record.outcome = enumIn(map, "outcome", scheduler::Outcome::kSwallowed);
    record.master = enumIn(map, "master", scheduler::Master::kPanel);
    record.timed_out = record.outcome == scheduler::Outcome::kTimedOut;
    return record;
}

QCborMap mapOf(const instrument::ControlStatus& status) {
    return {{key("mode"), static_cast<int>(status.mode)},
            {key("wanted"), static_cast<int>(status.wanted)},
            {key("owner"), static_cast<int>(status.owner)},
            {key("since"), ns(status.owner_since)},
            {key("panel"), static_cast<int>(status.panel)}};
}

instrument::ControlStatus controlFrom(const QCborMap& map) {
    instrument::ControlStatus status;
    status.mode = enumIn(map, "mode", scheduler::ControlMode::kPanel);
    status.wanted = enumIn(map, "wanted", scheduler::ControlMode::kPanel);
    status.owner = enumIn(map, "owner", scheduler::LineOwner::kPanel);
    status.owner_since = timeIn(map, "since");
    status.panel = enumIn(map, "panel", instrument::PanelPortState::kMissing);
    return status;
}

QCborMap mapOf(const LogLine& line) {
    return {{key("utc"), line.utc.toUTC().toString(Qt::ISODateWithMs)},
            {key("level"), static_cast<int>(line.level)},
            {key("category"), line.category},
            {key("text"), line.text}};
}

LogLine logLineFrom(const QCborMap& map) {
    return {.utc = QDateTime::fromString(textIn(map, "utc"), Qt::ISODateWithMs),
            .level = enumIn(map, "level", QtInfoMsg, QtInfoMsg),
            .category = textIn(map, "category"),
            .text = textIn(map, "text")};
}

QCborMap mapOf(const Message& message) {
    return {{key("kind"), static_cast<int>(message.kind)}, {key("happened"), message.happened},
            {key("remedy"), message.remedy},               {key("details"), message.details},
            {key("topic"), message.topic},                 {key("count"), message.count}};
}

/// Without its button: there is nothing to be done about what is over.
Message messageFrom(const QCborMap& map) {
    Message message;
    message.kind = enumIn(map, "kind", MessageKind::kProblem);
    message.happened = textIn(map, "happened");
    message.remedy = textIn(map, "remedy");
    message.details = textIn(map, "details");
    message.topic = textIn(map, "topic");
    message.count = static_cast<int>(map.value(key("count")).toInteger(1));
    return message;
}

QCborMap mapOf(const geometry::Pointing& pointing) {
    return {{key("ha_gon"), pointing.ha.gon()}, {key("va_gon"), pointing.va.gon()}};
}

std::optional<geometry::Pointing> pointingFrom(const QCborMap& map) {
    const QCborValue ha = map.value(key("ha_gon"));
    const QCborValue va = map.value(key("va_gon"));
    if (!ha.isDouble() || !va.isDouble()) {
        return std::nullopt;
    }
    return geometry::Pointing{.ha = core::Angle::fromGon(ha.toDouble()), .va = core::Angle::fromGon(va.toDouble())};
}

QCborMap mapOf(ConnectionState state, const QString& sentence, const std::optional<instrument::Identity>& identity) {
    QCborMap map{{key("state"), static_cast<int>(state)}, {key("sentence"), sentence}};
    if (identity) {
        map[key("model")] = identity->model;
        map[key("serial_number")] = identity->serial_number;
        map[key("units")] = QString::fromStdString(protocol::unitStatusText(identity->units));
    }
    return map;
}

ConnectionState connectionFrom(const QCborMap& map) { return enumIn(map, "state", ConnectionState::kReconnecting); }

std::optional<instrument::Identity> identityFrom(const QCborMap& map) {
    if (!map.contains(key("model"))) {
        return std::nullopt;
    }
    instrument::Identity identity;
    identity.model = textIn(map, "model");
    identity.serial_number = textIn(map, "serial_number");
    const auto units = protocol::parseUnitStatus(textIn(map, "units").toStdString());
    identity.units_known = units.has_value();
    identity.units = units.value_or(protocol::WireUnits());
    return identity;
}

namespace {

struct AirKey {
    const char* name;
    std::optional<double> InstrumentAir::*value;
};
constexpr AirKey kAirKeys[] = {{"label_56_c", &InstrumentAir::temperature_degc},
                               {"label_74_mbar", &InstrumentAir::pressure_mbar},
                               {"label_65_percent", &InstrumentAir::humidity_percent},
                               {"label_30_ppm", &InstrumentAir::ppm}};

std::optional<double> numberIn(const QCborMap& map, const char* name) {
    const QCborValue value = map.value(key(name));
    return value.isDouble() || value.isInteger() ? std::optional(value.toDouble()) : std::nullopt;
}

}  // namespace

QCborMap mapOf(const InstrumentAir& air, const std::optional<double>& typed_degc) {
    QCborMap map;
    if (const auto temperature_c = typed_degc ? typed_degc : air.temperature_degc) {
        map[key("temperature_c")] = *temperature_c;
        map[key("source")] = typed_degc ? key("lab") : key("instrument");
    }
    for (const AirKey& part : kAirKeys) {
        if (const auto& value = air.*part.value) {
            map[key(part.name)] = *value;
        }
    }
    return map;
}

InstrumentAir airFrom(const QCborMap& map) {
    InstrumentAir air;
    for (const AirKey& part : kAirKeys) {
        air.*part.value = numberIn(map, part.name);
    }
    return air;
}

std::optional<double> temperatureFrom(const QCborMap& map) { return numberIn(map, "temperature_c"); }

QCborMap pictureMap(const camera::Frame& frame, int width_px) {
    cv::Mat small = frame.image;
    if (frame.image.cols > width_px) {
        // Every n-th row and column first: averaging all of a full HD picture costs more than the JPEG itself.
        const int step = std::max(1, frame.image.cols / (2 * width_px));
        const int height_px = frame.image.rows * width_px / frame.image.cols;
        cv::resize(frame.image, small, {frame.image.cols / step, frame.image.rows / step}, 0, 0, cv::INTER_NEAREST);
        cv::resize(small, small, {width_px, height_px}, 0, 0, cv::INTER_AREA);
    }
    std::vector<uchar> jpeg;
    cv::imencode(".jpg", small, jpeg, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
    QCborMap map{{key("width"), frame.image.cols},
                 {key("height"), frame.image.rows},
                 {key("sequence"), static_cast<qint64>(frame.sequence)},
                 {key("jpeg"), QByteArray(reinterpret_cast<const char*>(jpeg.data()), static_cast<qsizetype>(jpeg.size()))}};
    if (frame.pointing) {
        map[key("ha_gon")] = frame.pointing->ha.gon();
        map[key("va_gon")] = frame.pointing->va.gon();
    }
    return map;
}

camera::FramePtr pictureFrom(const QCborMap& map) {
    const QByteArray jpeg = map.value(key("jpeg")).toByteArray();
    if (jpeg.isEmpty()) {
        return nullptr;
    }
    auto frame = std::make_shared<camera::Frame>();
    const cv::Mat encoded(1, static_cast<int>(jpeg.size()), CV_8UC1, const_cast<char*>(jpeg.constData()));  // read only
    frame->image = cv::imdecode(encoded, cv::IMREAD_COLOR);
    if (frame->image.empty()) {
        return nullptr;
    }
    frame->sequence = static_cast<std::uint64_t>(map.value(key("sequence")).toInteger());
    frame->pointing = pointingFrom(map);
    return frame;
}

}  // namespace pmts::app
