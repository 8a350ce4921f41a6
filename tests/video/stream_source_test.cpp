#include "support.hpp"

#include <QTcpServer>
#include <QTcpSocket>
#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include <set>

namespace pmts::video {
namespace {

/// A network camera: motion JPEG over HTTP, 25 pictures a second to whoever asks.
class HttpCamera : public QObject {
public:
    HttpCamera() {
        cv::imencode(".jpg", cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(150)), jpeg_);
        connect(&server_, &QTcpServer::newConnection, this,
                [this] { greet(server_.nextPendingConnection()); });
        connect(&pace_, &QTimer::timeout, this, [this] { sendPicture(); });
        server_.listen(QHostAddress::LocalHost);
        pace_.start(40);
    }
    [[nodiscard]] QString url() const {
        return QStringLiteral("http://127.0.0.1:%1/live.mjpg").arg(server_.serverPort());
    }
    void hangUp() {
        for (QTcpSocket* socket : std::set<QTcpSocket*>(watching_)) {
            socket->abort();
        }
    }

private:
    void greet(QTcpSocket* socket) {
        watching_.insert(socket);
        connect(socket, &QTcpSocket::disconnected, this, [this, socket] {
            watching_.erase(socket);
            socket->deleteLater();
        });
        socket->write("HTTP/1.0 200 OK\r\nContent-Type: multipart/x-mixed-replace; boundary=picture\r\n\r\n");
    }
    void sendPicture() {
        const QByteArray head = "--picture\r\nContent-Type: image/jpeg\r\nContent-Length: " +
                                QByteArray::number(static_cast<qulonglong>(jpeg_.size())) + "\r\n\r\n";
        for (QTcpSocket* socket : watching_) {
            socket->write(head);
            socket->write(reinterpret_cast<const char*>(jpeg_.data()), static_cast<qint64>(jpeg_.size()));
            socket->write("\r\n");
        }
    }

    std::vector<std::uint8_t> jpeg_;
    std::set<QTcpSocket*> watching_;
    QTimer pace_;
    QTcpServer server_;  // goes first, with its sockets, which say good-bye to watching_
};

TEST(StreamSourceTest, ShowsANetworkCameraAndReconnectsWhenItHangsUp) {
    HttpCamera camera;
    core::VideoGate gate;
    const auto source = makeVideoSource({SourceKind::kStream, camera.url(), QStringLiteral("mast")}, gate);
    Watcher seen(*source);
    source->start({});
    ASSERT_TRUE(until([&] { return source->state() == SourceState::kRunning && seen.newest; }));
    EXPECT_EQ(seen.newest->image.size(), cv::Size(64, 48));

    camera.hangUp();

    ASSERT_TRUE(until([&] { return seen.hasProblemWith("has stopped sending"); }));
    ASSERT_TRUE(until([&] { return source->state() == SourceState::kRunning; }));
}

TEST(StreamSourceTest, NobodyThereIsASentenceWithoutThePassword) {
    core::VideoGate gate;
    const auto source = makeVideoSource(
        {SourceKind::kStream, QStringLiteral("http://user:secret@127.0.0.1:1/live"), QStringLiteral("mast")},
        gate);
    const Watcher seen(*source);
    source->start({});
    ASSERT_TRUE(until([&] { return seen.hasProblemWith("does not answer"); }));
    EXPECT_FALSE(seen.hasProblemWith("secret"));
}

}  // namespace
}  // namespace pmts::video
