#include "event_loop.hpp"
#include "figures.hpp"
#include "pmts/app/field/recording_presenter.hpp"
#include "pmts/app/field/targeting_presenter.hpp"
#include "still_frames.hpp"
#include "support/figure.hpp"
#include "wire_peer.hpp"

#include <opencv2/imgproc.hpp>

#include <random>

namespace pmts::bench {

namespace {

using namespace std::chrono_literals;

constexpr int kSamples = 100;

double milliseconds(core::Duration span) { return std::chrono::duration<double, std::milli>(span).count(); }

/// Detail of several sizes, like stone: every spot can be told from every other.
cv::Mat texture() {
    cv::Mat sum(720, 1280, CV_8UC3, cv::Scalar::all(110));
    cv::RNG random(5);
    for (const int step : {4, 16, 64}) {
        cv::Mat noise(720 / step + 1, 1280 / step + 1, CV_8UC3), grown;
        random.fill(noise, cv::RNG::UNIFORM, 0, 45);
        cv::resize(noise, grown, sum.size(), 0, 0, cv::INTER_CUBIC);
        sum += grown;
    }
    return sum;
}

/// The presenters behind a click, on the GUI thread, connected to an instrument at the other end of a pty.
struct Desk {
    explicit Desk(const QString& port_path) {
        app::SerialChoice choice;
        choice.path = port_path;
        instrument.connectSerial(choice);
        runUntil([this] {
            return instrument.connectionState() == app::ConnectionState::kConnected && instrument.track().newest() &&
                   !instrument.isBusy();
        });
        live.setSource(video::makeSimulatedSource(stillFrames(texture()), gate));
        runUntil([this] { return live.scene().pointing.has_value(); });
    }

    core::SystemClock clock;
    core::VideoGate gate;
    QUndoStack undo;
    app::Preferences preferences{QString()};
    app::MessageCentre messages;
    app::RangeKeeper range{25.0};
    app::InstrumentDesk instrument{gate};
    app::JobDesk job;
    app::PointsModel points{job, preferences, messages, undo};
    app::StationPresenter station{job, points, instrument, preferences, messages, undo};
    app::LivePresenter live{instrument, points, station, range, job, preferences, messages, gate, clock};
    app::TargetingPresenter targeting{instrument, live, points, station, range, preferences, messages};
};

/// The second click of a double-click in the live view until the first byte of the target is at the instrument.
double clickToWireMs(Desk& desk, WirePeer& peer, int sample, bool with_picture) {
    desk.targeting.setRecentring(with_picture);
    const QPointF px(sample % 2 == 0 ? 700.0 : 580.0, 360.0);
    desk.targeting.aimAtLivePixel(px);
    // The hand takes its time between the clicks, and keeps none with the polls on the line.
    static std::mt19937 hand(3);
    const auto pause = std::chrono::milliseconds(std::uniform_int_distribution<int>(120, 420)(hand));
    runUntil([&, first = desk.clock.now()] { return desk.clock.now() - first >= pause; });
    peer.watchFor("WG,2");
    const core::Duration clicked = desk.clock.now();
    desk.targeting.moveToLivePixel(px);
    runUntil([&] { return peer.arrival().has_value(); });
    if (with_picture) {
        desk.targeting.stop();  // this picture does not turn with the instrument
    }
    runUntil([&] { return !desk.targeting.isMoving(); });
    // The line is quiet again once a poll has been answered.
    runUntil([&, ended = desk.clock.now()] { return desk.instrument.track().newest()->at > ended; });
    return milliseconds(*peer.arrival() - clicked);
}

/// Esc in the middle of a long turn until the stop is at the instrument.
double stopToWireMs(Desk& desk, WirePeer& peer, int sample) {
    desk.targeting.aimAtText(sample % 2 == 0 ? QStringLiteral("150 gon") : QStringLiteral("20 gon"), QStringLiteral("95 gon"));
    desk.targeting.move();
    runUntil([&] { return desk.targeting.target()->state == app::MoveState::kTurning; });
    peer.watchFor("PG,3");
    const core::Duration pressed = desk.clock.now();
    desk.targeting.stop();
    runUntil([&] { return peer.arrival().has_value() && !desk.targeting.isMoving(); });
    return milliseconds(*peer.arrival() - pressed);
}

}  // namespace

void measureWire() {
    WirePeer peer;
    Desk desk(peer.portPath());
    std::vector<double> clicks_ms;
    std::vector<double> recentred_ms;
    std::vector<double> stops_ms;
    for (int sample = 0; sample < kSamples; ++sample) {
        clicks_ms.push_back(clickToWireMs(desk, peer, sample, false));
        recentred_ms.push_back(clickToWireMs(desk, peer, sample, true));
    }
    for (int sample = 0; sample < kSamples; ++sample) {
        stops_ms.push_back(stopToWireMs(desk, peer, sample));
    }
    figure("app.click_to_wire_median", median(clicks_ms), "ms", Wanted::kAtMost, 5.0);
    figure("app.recentred_click_to_wire_median", median(recentred_ms), "ms", Wanted::kAtMost, 5.0);
    figure("app.stop_to_wire_p99", quantile(stops_ms, 0.99), "ms", Wanted::kAtMost, 50.0);
}

}  // namespace pmts::bench
