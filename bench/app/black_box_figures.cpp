#include "event_loop.hpp"
#include "figures.hpp"
#include "pmts/app/line/black_box_presenter.hpp"
#include "still_frames.hpp"
#include "support/figure.hpp"
#include "support/thread_times.hpp"
#include "wire_peer.hpp"

#include "pmts/transport/serial_link.hpp"

#include <QTemporaryDir>

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace pmts::bench {

namespace {

constexpr auto kSpan = std::chrono::seconds(20);
constexpr int kTurns = 3;

/// Full HD, as much detail as a street has: a flat picture would compress for nothing.
cv::Mat street() {
    cv::Mat small(270, 480, CV_8UC3), large;
    cv::RNG(5).fill(small, cv::RNG::UNIFORM, 0, 255);
    cv::resize(small, large, {1920, 1080}, 0, 0, cv::INTER_CUBIC);
    return large;
}

/// Instrument and camera with everything recorded that the program records of them.
struct RecordedDesk {
    explicit RecordedDesk(const QString& port_path) {
        app::SerialChoice choice;
        choice.path = port_path;
        instrument.connectSerial(choice);
        runUntil([this] { return instrument.connectionState() == app::ConnectionState::kConnected; });
        live.setSource(video::makeSimulatedSource(stillFrames(street()), gate));
        black_box.watch(instrument);
        black_box.watch(live, gate);
        runUntil([this] { return live.scene().frame != nullptr; });
        black_box.start();
    }
    app::InstrumentWiring wiring() {
        app::InstrumentWiring wires;
        wires.make_link = [this](const app::SerialChoice& choice) {
            transport::SerialSettings settings;
            settings.port_name = choice.path;
            return black_box.tapped(std::make_unique<transport::SerialLink>(settings));
        };
        return wires;
    }

    QTemporaryDir folder;
    core::SystemClock clock;
    core::VideoGate gate;
    QUndoStack undo;
    app::Preferences preferences{QString()};
    app::MessageCentre messages;
    app::BlackBoxPresenter black_box{folder.path(), preferences, messages, clock};
    app::RangeKeeper range{25.0};
    app::InstrumentDesk instrument{gate, wiring()};
    app::JobDesk job;
    app::PointsModel points{job, preferences, messages, undo};
    app::StationPresenter station{job, points, instrument, preferences, messages, undo};
    app::LivePresenter live{instrument, points, station, range, job, preferences, messages, gate, clock};
};

struct Cost {
    double box = 0.0;   ///< of the recording thread, part of one core
    double rest = 0.0;  ///< of all others
};

Cost costOf(RecordedDesk& desk, bool on) {
    desk.black_box.setSettings({.on = on, .kept_mb = 300, .frames_per_s = 1.0});
    const core::Duration began = desk.clock.now();
    const double box = cpuSecondsOf("black box");
    const double rest = cpuSecondsWithout({"black box"});
    QEventLoop loop;
    QTimer::singleShot(kSpan, &loop, &QEventLoop::quit);
    loop.exec();
    const double passed_s = std::chrono::duration<double>(desk.clock.now() - began).count();
    return {(cpuSecondsOf("black box") - box) / passed_s, (cpuSecondsWithout({"black box"}) - rest) / passed_s};
}

}  // namespace

void measureBlackBox() {
    WirePeer peer;
    RecordedDesk desk(peer.portPath());
    (void)costOf(desk, false);  // everything is warm
    std::vector<double> box, added;
    for (int turn = 0; turn < kTurns; ++turn) {
        const Cost off = costOf(desk, false);
        const Cost on = costOf(desk, true);
        box.push_back(on.box * 100.0);
        added.push_back(std::max(0.0, on.rest - off.rest) * 100.0);
    }
    figure("app.black_box_thread", median(box), "% of a core", Wanted::kAtMost, 2.0);
    figure("app.black_box_all", median(box) + median(added), "% of a core", Wanted::kAtMost, 2.0);
}

}  // namespace pmts::bench
