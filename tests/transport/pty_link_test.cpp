#include "pmts/transport/pty_link.hpp"

#include "support/matchers.hpp"
#include "transport/link_probe.hpp"

#include <QFile>
#include <QFileInfo>
#include <QSocketNotifier>
#include <QTemporaryDir>

#include <array>
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace pmts::transport {
namespace {

using core::ErrorKind;
using test::comesToRest;
using test::FailedWith;
using test::LinkProbe;
using test::waitUntil;

/// Any other program at the slave: plain system calls, none of our code.
class Client {
public:
    explicit Client(const QString& path)
        : fd_(::open(QFile::encodeName(path).constData(), O_RDWR | O_NOCTTY | O_NONBLOCK)) {}
    ~Client() { ::close(fd_); }
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    void send(std::string_view bytes) const {
        ASSERT_EQ(::write(fd_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
    /// Waits for as many bytes as expected, with a generous limit; returns more when there are more.
    [[nodiscard]] std::string read(std::size_t expected) const {
        std::string bytes;
        pollfd readable{.fd = fd_, .events = POLLIN, .revents = 0};
        while (bytes.size() < expected && ::poll(&readable, 1, 20'000) > 0 && readAvailable(bytes)) {
        }
        return bytes;
    }
    bool readAvailable(std::string& bytes) const {
        std::array<char, 4096> buffer{};
        const auto size = ::read(fd_, buffer.data(), buffer.size());
        bytes.append(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
        return size > 0;
    }
    [[nodiscard]] int fd() const { return fd_; }
    [[nodiscard]] bool isHungUp() const { return ::write(fd_, "x", 1) < 0 && errno == EIO; }

private:
    int fd_;
};

class PtyLinkTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(link.open().has_value()); }

    PtyLink link;
    LinkProbe probe{link};
};

TEST_F(PtyLinkTest, BytesPassUnchangedBothWays) {
    const Client client(link.slaveName());
    std::string every_byte;
    for (int value = 0; value < 256; ++value) {
        every_byte += static_cast<char>(value);
    }
    client.send(every_byte);
    ASSERT_TRUE(waitUntil([&] { return probe.received.size() >= 256; }));
    EXPECT_EQ(probe.received, every_byte);
    link.write(every_byte);
    EXPECT_EQ(client.read(256), every_byte);
}

TEST_F(PtyLinkTest, ClientsComeAndGoWithoutLossOrUnrest) {
    for (int visit = 0; visit < 5; ++visit) {
        {
            const Client client(link.slaveName());
            client.send("RG\r");
            ASSERT_TRUE(waitUntil([&] { return probe.received == "RG\r"; }));
        }
        probe.received.clear();
        EXPECT_TRUE(comesToRest()) << "the master fires over and over while no client is there";
    }
    EXPECT_TRUE(probe.losses.empty());
    EXPECT_TRUE(link.isOpen());
}

TEST_F(PtyLinkTest, NewClientFindsNoAnswersOfTheOneBefore) {
    {
        const Client client(link.slaveName());
        link.write("0\r\n7=177.5612\r\n>");  // never read
    }
    link.write("301\r\n>");  // nobody is there
    const Client next(link.slaveName());
    ASSERT_TRUE(comesToRest());
    link.write(">");
    EXPECT_EQ(next.read(1), ">");
}

TEST_F(PtyLinkTest, LineIsRawAgainAfterAClientThatSetEcho) {
    {
        const Client shell(link.slaveName());
        termios line{};
        ASSERT_EQ(::tcgetattr(shell.fd(), &line), 0);
        line.c_lflag |= ECHO | ICANON;
        ASSERT_EQ(::tcsetattr(shell.fd(), TCSANOW, &line), 0);
    }
    ASSERT_TRUE(comesToRest());
    const Client next(link.slaveName());
    link.write("RG\r");
    EXPECT_EQ(next.read(3), "RG\r");
    ASSERT_TRUE(comesToRest());
    EXPECT_EQ(probe.received, "") << "the line echoes";
}

TEST_F(PtyLinkTest, KilledClientDoesNotKeepThePortClaimed) {
    {
        const Client killed(link.slaveName());
        ASSERT_EQ(::ioctl(killed.fd(), TIOCEXCL), 0);  // as QSerialPort does; never given back
    }
    ASSERT_TRUE(comesToRest());
    const Client next(link.slaveName());
    int claimed = -1;
    ASSERT_EQ(::ioctl(next.fd(), TIOCGEXCL, &claimed), 0);
    EXPECT_EQ(claimed, 0);
}

TEST_F(PtyLinkTest, KnowsWhetherAClientIsThere) {
    EXPECT_FALSE(link.hasClient());
    {
        const Client client(link.slaveName());
        EXPECT_TRUE(waitUntil([&] { return link.hasClient(); }));
    }
    EXPECT_TRUE(waitUntil([&] { return !link.hasClient(); }));
}

TEST_F(PtyLinkTest, ClientThatDoesNotReadBlocksNobody) {
    const Client client(link.slaveName());
    const std::string block(1000, 'x');
    for (int i = 0; i < 200; ++i) {
        link.write(block);
    }
    EXPECT_TRUE(comesToRest());
    std::string read;
    const QSocketNotifier wake(client.fd(), QSocketNotifier::Read);
    EXPECT_TRUE(waitUntil([&] {
        client.readAvailable(read);
        return read.size() >= 60000;
    })) << "what fits is kept and goes out when the client reads again";
}

TEST_F(PtyLinkTest, ClosingIsTheCablePulledForTheClient) {
    const Client client(link.slaveName());
    link.close();
    EXPECT_TRUE(client.isHungUp());
    EXPECT_EQ(link.slaveName(), QString());
    link.write("lost");
    ASSERT_TRUE(link.open().has_value());
    EXPECT_FALSE(link.slaveName().isEmpty());
}

TEST_F(PtyLinkTest, ShowsHowTheClientHasSetItsPort) {
    const Client client(link.slaveName());
    termios line{};
    ASSERT_EQ(::tcgetattr(client.fd(), &line), 0);
    ::cfsetspeed(&line, B4800);
    line.c_cflag |= PARODD | CSTOPB;
    ASSERT_EQ(::tcsetattr(client.fd(), TCSANOW, &line), 0);
    EXPECT_EQ(link.clientLine(), (PtyClientLine{.baud = 4800, .odd_parity = true, .two_stop_bits = true}));
    link.close();
    EXPECT_FALSE(link.clientLine().has_value());
}

TEST(PtyLinkPathTest, LinkIsThereWhileOpenAndReplacesAStaleOne) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("instrument"));
    ASSERT_TRUE(QFile::link(QStringLiteral("/dev/pts/9999"), path));
    PtyLink link(path);
    ASSERT_TRUE(link.open().has_value());
    EXPECT_EQ(QFileInfo(path).symLinkTarget(), link.slaveName());
    link.close();
    EXPECT_FALSE(QFileInfo(path).isSymLink());
}

TEST(PtyLinkPathTest, FileInTheWayIsNeverReplaced) {
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("notes.txt")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    PtyLink link(file.fileName());
    EXPECT_THAT(link.open(), FailedWith(ErrorKind::kPortUnavailable));
    EXPECT_FALSE(link.isOpen());
    EXPECT_TRUE(QFileInfo(file.fileName()).isFile());
    EXPECT_THAT(PtyLink(QStringLiteral("/no/such/folder/x")).open(), FailedWith(ErrorKind::kPortUnavailable));
}

TEST(PtyLinkPathTest, LinkThatPointsElsewhereByNowIsLeftAlone) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("instrument"));
    PtyLink first(path);
    PtyLink second(path);
    ASSERT_TRUE(first.open().has_value());
    ASSERT_TRUE(second.open().has_value());
    first.close();
    EXPECT_EQ(QFileInfo(path).symLinkTarget(), second.slaveName());
}

}  // namespace
}  // namespace pmts::transport
