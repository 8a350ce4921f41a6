#include "event_loop.hpp"
#include "figures.hpp"
#include "pmts/app/recording_presenter.hpp"
#include "pmts/app/targeting_presenter.hpp"
#include "support/figure.hpp"
#include "wire_peer.hpp"

namespace pmts::bench {

namespace {

using namespace std::chrono_literals;

constexpr int kSamples = 100;

double milliseconds(core::Duration span) { return std::chrono::duration<double, std::milli>(span).count(); }

/// A grey picture, drawn at once: the video runs, the drawing costs nothing.
camera::Frame greyFrame(core::Duration captured_at) {
    camera::Frame frame;
    frame.image = cv::Mat(720, 1280, CV_8UC3, cv::Scalar::all(128));
    frame.captured_at = captured_at;
    return frame;
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
        live.setSource(video::makeSimulatedSource(greyFrame, gate));
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

/// A double-click in the live view until the first byte of the first target is at the instrument.
double clickToWireMs(Desk& desk, WirePeer& peer, int sample) {
    peer.watchFor("WG,2");
    const core::Duration clicked = desk.clock.now();
    desk.targeting.moveToLivePixel({sample % 2 == 0 ? 700.0 : 580.0, 360.0});
    runUntil([&] { return peer.arrival().has_value() && !desk.targeting.isMoving(); });
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
    std::vector<double> stops_ms;
    for (int sample = 0; sample < kSamples; ++sample) {
        clicks_ms.push_back(clickToWireMs(desk, peer, sample));
    }
    for (int sample = 0; sample < kSamples; ++sample) {
        stops_ms.push_back(stopToWireMs(desk, peer, sample));
    }
    figure("app.click_to_wire_median", median(clicks_ms), "ms", Wanted::kAtMost, 5.0);
    figure("app.stop_to_wire_p99", quantile(stops_ms, 0.99), "ms", Wanted::kAtMost, 50.0);
}

}  // namespace pmts::bench
