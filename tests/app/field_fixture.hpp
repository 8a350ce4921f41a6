#pragma once

#include "pmts/app/desk/connection_presenter.hpp"
#include "pmts/app/field/planned_points_model.hpp"
#include "pmts/app/field/recording_presenter.hpp"
#include "pmts/app/desk/status_presenter.hpp"
#include "pmts/app/field/targeting_presenter.hpp"
#include "pmts/core/virtual_clock.hpp"
#include "pmts/geometry/polar.hpp"
#include "pmts/simulator/station.hpp"
#include "pmts/transport/memory_link.hpp"
#include "support/matchers.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include <list>

namespace pmts::app {

using namespace std::chrono_literals;
using core::Angle;

/// A camera that shows what a test puts before it.
class HandSource : public video::VideoSource {
public:
    explicit HandSource(video::SourceKind kind = video::SourceKind::kSimulated) : kind_(kind) {}

    void start(const video::VideoFormat&) override { setState(video::SourceState::kRunning); }
    void stop() override { setState(video::SourceState::kStopped); }
    [[nodiscard]] video::SourceAddress address() const override {
        return {.kind = kind_, .location = {}, .name = QStringLiteral("Hand camera")};
    }
    [[nodiscard]] video::SourceState state() const override { return state_; }
    [[nodiscard]] video::SourceStatistics statistics() const override { return {}; }
    [[nodiscard]] camera::FramePtr newestFrame() const override { return frame_; }

    std::function<cv::Mat(core::Duration at)> picture;  ///< empty: plain grey

    void setState(video::SourceState state) {
        state_ = state;
        Q_EMIT stateChanged(state);
    }
    void show(core::Duration captured_at) {
        show(captured_at, picture ? picture(captured_at) : cv::Mat(72, 128, CV_8UC3, cv::Scalar::all(90)));
    }
    void show(core::Duration captured_at, const cv::Mat& image) {
        auto frame = std::make_shared<camera::Frame>();
        frame->image = image;
        frame->captured_at = captured_at;
        frame->sequence = ++sequence_;
        frame_ = frame;
        Q_EMIT frameReady();
    }

private:
    video::SourceKind kind_;
    video::SourceState state_ = video::SourceState::kStopped;
    camera::FramePtr frame_;
    std::uint64_t sequence_ = 0;
};

/// The whole desk without a screen, against the simulated instrument on a line in memory, in virtual time.
/// A wall stands 15 m to the north; a black panel that gives no echo hangs before it at HA 35 gon.
class FieldTest : public testing::Test {
protected:
    explicit FieldTest(const simulator::StationSettings& settings = {}) : station(settings, scene, true_pointing, clock) {
        live.setSource(std::unique_ptr<video::VideoSource>(camera));
        targeting.setRecentring(false);  // the hand camera shows nothing that could be found again
    }
    /// Routines that are suspended end before the clock goes.
    void TearDown() override {
        instrument.disconnectInstrument();
        pass(10s);
    }

    static simulator::Panel wall(const char* name, double west_m, double east_m, double north_m, bool absorbing = false) {
        return {QString::fromLatin1(name), {west_m, north_m, -4}, {east_m - west_m, 0, 0}, {0, 0, 10},
                cv::Mat(8, 8, CV_8UC3, cv::Scalar::all(128)), absorbing};
    }

    /// Runs the event loop and the virtual clock until it is so; false when it is not after `limit`. Where no timer is
    /// left, a chain of calls between desks still goes on, a few of them each time the loop is run.
    bool until(const std::function<bool()>& so, core::Duration limit = 60s) {
        constexpr int kLongestChain = 100;
        const core::Duration latest = clock.now() + limit;
        int without_timer = 0;
        core::deliverQueuedEvents();
        while (!so()) {
            without_timer = clock.advanceToNextTimer(latest) ? 0 : without_timer + 1;
            if (without_timer > kLongestChain) {
                return false;
            }
            core::deliverQueuedEvents();
        }
        return true;
    }

    void pass(core::Duration span) { clock.advance(span); }

    void connectInstrument() {
        SerialChoice choice;
        choice.path = QStringLiteral("memory");
        instrument.connectSerial(choice);
        ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kConnected; }));
        ASSERT_TRUE(until([this] { return instrument.track().newest().has_value() && !instrument.isBusy(); }));
    }
    void openJob() {
        job_desk.create(jobPath());
        ASSERT_TRUE(until([this] { return job_desk.isOpen(); }));
    }
    /// The job file goes from under the program: it refuses every write until it is back.
    void moveJobAway() { ASSERT_TRUE(QFile::rename(jobPath(), jobPath() + QStringLiteral(".away"))); }
    void bringJobBack() { ASSERT_TRUE(QFile::rename(jobPath() + QStringLiteral(".away"), jobPath())); }
    [[nodiscard]] QString jobPath() const { return folder.filePath(QStringLiteral("wall.gpkg")); }
    /// Cable pulled; make_link fails until plugIn().
    void unplug() {
        plugged = false;
        if (instrument_end) {
            instrument_end->unplug();
        }
    }
    void plugIn() { plugged = true; }

    /// Shows pictures until the circles have been read on both sides of one.
    void showFrames(int count = 3) {
        for (int i = 0; i < count; ++i) {
            camera->show(clock.now());
            pass(150ms);
        }
    }
    /// Pixel at which the camera sees a place, at the frame shown now.
    [[nodiscard]] QPointF pixelOf(const Eigen::Vector3d& p_station) const {
        const auto px = live.model().pixelForPoint(p_station, live.scene().pointing.value());
        return {px->x(), px->y()};
    }
    bool turnTo(double ha_gon, double va_gon) {
        targeting.aimAtText(QStringLiteral("%1 gon").arg(ha_gon), QStringLiteral("%1 gon").arg(va_gon));
        targeting.move();
        return until([this] { return !targeting.isMoving(); });
    }
    bool measure() {
        recording.measure();
        return until([this] { return !recording.isBusy(); });
    }
    bool recordPoint() {
        recording.all();
        return until([this] { return !recording.isBusy(); });
    }

    std::unique_ptr<transport::ByteLink> makeLink() {
        auto pair = transport::makeMemoryPair(clock);
        if (!plugged) {
            pair.first->unplug();
            return std::move(pair.first);
        }
        instrument_end = std::move(pair.second);
        (void)instrument_end->open();
        instrument_end->on_received = [this](std::string_view bytes) {
            sent += bytes;
            if (answers) {
                station.receive(bytes);
            }
        };
        instrument_end->on_break = [this] { station.receiveBreak(); };
        station.send = [this](std::string_view bytes) {
            instrument_end->write(on_the_way ? on_the_way(std::string(bytes)) : std::string(bytes));
        };
        return std::move(pair.first);
    }
    InstrumentWiring wiring() {
        return {.threading = Threading::kCallersThread, .clock = &clock,
                .make_link = [this](const SerialChoice&) { return makeLink(); },
                .find_patch = targeting::findHere(targeting::PatchMatcher()), .connection = {}};
    }

    core::VirtualClock clock;
    core::VideoGate gate;
    QTemporaryDir folder;
    std::shared_ptr<const simulator::Scene> scene = std::make_shared<const simulator::Scene>(
        std::vector<simulator::Panel>{wall("wall", -20, 20, 15), wall("black", 7, 11, 14.9, true)});
    std::shared_ptr<simulator::TruePointing> true_pointing = std::make_shared<simulator::TruePointing>();
    simulator::Station station;
    std::unique_ptr<transport::MemoryLink> instrument_end;
    bool plugged = true;
    bool answers = true;
    std::function<std::string(std::string)> on_the_way;  ///< what becomes of the instrument's answers; empty: nothing
    std::string sent;  ///< everything that reached the instrument

    QUndoStack undo;
    Preferences preferences{QString()};
    MessageCentre messages;
    RangeKeeper range{25.0};
    InstrumentDesk instrument{gate, wiring()};
    JobDesk job_desk{Threading::kCallersThread};
    PointsModel points{job_desk, preferences, messages, undo};
    PlannedPointsModel planned{job_desk, preferences, messages, undo};
    StationPresenter station_page{job_desk, points, instrument, preferences, messages, undo};
    LivePresenter live{instrument, points, station_page, range, job_desk, preferences, messages, gate, clock};
    TargetingPresenter targeting{instrument, live, points, station_page, range, preferences, messages};
    RecordingPresenter recording{instrument, job_desk, points, station_page, range, preferences, messages, clock};
    HandSource* camera = new HandSource;  // NOLINT: the live presenter takes it over
};

/// Text of the newest bar, for assertions.
inline QString newestBar(const MessageCentre& messages) {
    return messages.bars().empty() ? QString() : messages.bars().back().happened + u' ' + messages.bars().back().remedy;
}

}  // namespace pmts::app
