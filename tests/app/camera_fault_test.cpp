#include "app/field_fixture.hpp"

#include "pmts/app/desk/job_presenter.hpp"

#include <QEventLoop>
#include <QSaveFile>
#include <QTimer>

namespace pmts::app {
namespace {

/// Virtual V4L2 cameras (tests/support/virtual_v4l2) seen from the status line and the message bars.
class CameraFaultTest : public FieldTest {
protected:
    CameraFaultTest() { qputenv("PMTS_VIRTUAL_CAMERAS", cameras.path().toUtf8()); }
    ~CameraFaultTest() override {
        live.setSource(nullptr);
        qunsetenv("PMTS_VIRTUAL_CAMERAS");
    }

    void plug(const QByteArray& text) const {
        QSaveFile file(cameras.filePath(QStringLiteral("video0")));
        file.open(QIODevice::WriteOnly);
        file.write(text);
        file.commit();
    }
    void choose() {
        connection.chooseCamera({.kind = video::SourceKind::kV4l2,
                                 .location = cameras.filePath(QStringLiteral("video0")),
                                 .name = QStringLiteral("Webcam")});
    }
    /// The camera's worker keeps real time: waits for its next word, generously.
    bool untilStatus(DeviceState state, const char* words) {
        const auto is_so = [&] {
            return status.line().camera.state == state && status.line().camera.details.contains(QLatin1String(words));
        };
        QEventLoop loop;
        QTimer late;
        late.setSingleShot(true);
        QObject::connect(&late, &QTimer::timeout, &loop, [&loop] { loop.exit(1); });
        QObject::connect(&status, &StatusPresenter::changed, &loop, [&] {
            if (is_so()) {
                loop.exit(0);
            }
        });
        late.start(30s);
        return is_so() || loop.exec() == 0;
    }

    QTemporaryDir cameras;
    SimulationDesk simulation;
    JobPresenter job{job_desk, preferences, messages};
    ConnectionPresenter connection{instrument, simulation, live, gate, preferences, messages};
    ControlPresenter control{instrument, preferences, messages, clock};
    StatusPresenter status{job, station_page, connection, live, control, instrument};
};

TEST_F(CameraFaultTest, MissingCameraIsSaidInTheStatusLineAndABar) {
    choose();
    EXPECT_TRUE(untilStatus(DeviceState::kFailed, "Webcam is not connected. Plug it in")) << status.line().camera.details.toStdString();
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("Webcam is not connected."));
    EXPECT_EQ(messages.bars().back().action, MessageAction::kOpenConnectionPage);
}

TEST_F(CameraFaultTest, BusyCameraIsSaidAndRunsWhenItIsFree) {
    plug("card=Webcam\nbusy=1");
    choose();
    ASSERT_TRUE(untilStatus(DeviceState::kFailed, "used by another program")) << status.line().camera.details.toStdString();
    plug("card=Webcam");
    EXPECT_TRUE(untilStatus(DeviceState::kGood, "delivers pictures"));
    EXPECT_TRUE(messages.bars().empty()) << "solved";
}

TEST_F(CameraFaultTest, UnpluggedCameraIsSaidAndComesBackByItself) {
    plug("card=Webcam");
    choose();
    ASSERT_TRUE(untilStatus(DeviceState::kGood, "delivers pictures"));
    QFile::remove(cameras.filePath(QStringLiteral("video0")));
    ASSERT_TRUE(untilStatus(DeviceState::kFailed, "Webcam is not connected.")) << status.line().camera.details.toStdString();
    plug("card=Webcam");
    EXPECT_TRUE(untilStatus(DeviceState::kGood, "delivers pictures"));
}

}  // namespace
}  // namespace pmts::app
