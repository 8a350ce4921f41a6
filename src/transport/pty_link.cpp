#include "pmts/transport/pty_link.hpp"

#include "pmts/core/logging.hpp"
#include "pmts/core/task.hpp"
#include "pty_device.hpp"

#include <QFile>
#include <QSocketNotifier>

#include <array>
#include <cerrno>
#include <sys/inotify.h>
#include <unistd.h>

namespace pmts::transport {
namespace {

/// A client that does not read loses what is beyond this, as on a wire.
constexpr std::size_t kMostWaitingBytes = std::size_t{64} * 1024;

}  // namespace

class PtyLink::Impl {
public:
    Impl(PtyLink& owner, QString link_path) : owner_(owner), link_path_(std::move(link_path)) {}
    ~Impl() { close(); }

    core::Result<void> open() {
        auto device = openPtyDevice();
        if (!device) {
            return tl::unexpected(std::move(device).error());
        }
        if (!link_path_.isEmpty()) {
            PMTS_TRY(placeLink(link_path_, device->slave_name));
        }
        pty_ = std::move(*device);
        watchMaster();
        watchClients();
        return {};
    }

    void close() {
        if (!isOpen()) {
            return;
        }
        if (!link_path_.isEmpty()) {
            removeLink(link_path_, pty_.slave_name);
        }
        drop(readable_);
        drop(writable_);
        drop(client_events_);
        pty_ = {};
        inotify_.reset();
        waiting_.clear();
        clients_ = 0;
    }

    void write(std::string_view bytes) {
        takeClientEvents();
        if (!isOpen() || !hasClient() || waiting_.size() + bytes.size() > kMostWaitingBytes) {
            return;
        }
        waiting_ += bytes;
        writeWaiting();
    }

    [[nodiscard]] bool isOpen() const { return pty_.master.isOpen(); }
    [[nodiscard]] bool hasClient() const { return isOpen() && (!inotify_.isOpen() || clients_ > 0); }
    [[nodiscard]] std::optional<PtyClientLine> clientLine() const { return isOpen() ? pty_.line() : std::nullopt; }
    [[nodiscard]] const QString& slaveName() const { return pty_.slave_name; }
    [[nodiscard]] const QString& linkPath() const { return link_path_; }

private:
    /// A notifier may be dropped inside its own signal.
    static void drop(std::unique_ptr<QSocketNotifier>& notifier) {
        if (notifier) {
            notifier->setEnabled(false);
            notifier->disconnect();
            notifier.release()->deleteLater();
        }
    }

    void watchMaster() {
        readable_ = std::make_unique<QSocketNotifier>(pty_.master.get(), QSocketNotifier::Read);
        QObject::connect(readable_.get(), &QSocketNotifier::activated, readable_.get(),
                         [this] { takeBytes(); });
        writable_ = std::make_unique<QSocketNotifier>(pty_.master.get(), QSocketNotifier::Write);
        writable_->setEnabled(false);
        QObject::connect(writable_.get(), &QSocketNotifier::activated, writable_.get(),
                         [this] { writeWaiting(); });
    }

    /// Our own slave descriptor hides from the master whether a client is there: the file system tells.
    void watchClients() {
        inotify_ = FileDescriptor(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
        const QByteArray slave = QFile::encodeName(pty_.slave_name);
        if (::inotify_add_watch(inotify_.get(), slave.constData(), IN_OPEN | IN_CLOSE) < 0) {
            qCWarning(core::logTransport) << "clients of" << pty_.slave_name << "cannot be watched";
            inotify_.reset();
            return;
        }
        client_events_ = std::make_unique<QSocketNotifier>(inotify_.get(), QSocketNotifier::Read);
        QObject::connect(client_events_.get(), &QSocketNotifier::activated, client_events_.get(),
                         [this] { takeClientEvents(); });
    }

    void takeClientEvents() {
        alignas(inotify_event) std::array<char, 4096> buffer;
        for (ssize_t size = 0;
             inotify_.isOpen() && (size = ::read(inotify_.get(), buffer.data(), buffer.size())) > 0;) {
            for (const char* at = buffer.data(); at < buffer.data() + size;) {
                const auto* event = reinterpret_cast<const inotify_event*>(at);
                clientEvent(event->mask);
                at += sizeof(inotify_event) + event->len;
            }
        }
    }

    void clientEvent(std::uint32_t mask) {
        if ((mask & IN_OPEN) != 0) {
            ++clients_;
        } else if ((mask & IN_CLOSE) != 0 && clients_ > 0 && --clients_ == 0) {
            waiting_.clear();
            pty_.resetLine();
        }
    }

    void takeBytes() {
        takeClientEvents();  // an answer must not be thrown away for a client not yet counted
        std::array<char, 4096> buffer;
        const ssize_t size = ::read(pty_.master.get(), buffer.data(), buffer.size());
        if (size > 0) {
            if (const auto receive = owner_.on_received) {
                receive({buffer.data(), static_cast<std::size_t>(size)});
            }
        } else if (size == 0 || (errno != EAGAIN && errno != EINTR)) {
            lose();
        }
    }

    void writeWaiting() {
        const ssize_t size = ::write(pty_.master.get(), waiting_.data(), waiting_.size());
        if (size > 0) {
            waiting_.erase(0, static_cast<std::size_t>(size));
        }
        writable_->setEnabled(!waiting_.empty());
    }

    void lose() {
        close();
        core::post([this, alive = std::weak_ptr<bool>(alive_)] {
            if (!alive.expired() && owner_.on_lost) {
                const auto report = owner_.on_lost;
                report({.kind = core::ErrorKind::kLinkLost,
                        .happened = QStringLiteral("The pseudo-terminal has gone."),
                        .remedy = {},
                        .info_code = std::nullopt,
                        .detail = {}});
            }
        });
    }

    PtyLink& owner_;
    QString link_path_;
    PtyDevice pty_;
    FileDescriptor inotify_;
    std::unique_ptr<QSocketNotifier> readable_;
    std::unique_ptr<QSocketNotifier> writable_;
    std::unique_ptr<QSocketNotifier> client_events_;
    std::string waiting_;
    int clients_ = 0;
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

PtyLink::PtyLink(QString link_path) : impl_(std::make_unique<Impl>(*this, std::move(link_path))) {}

PtyLink::~PtyLink() = default;

core::Result<void> PtyLink::open() { return isOpen() ? core::Result<void>() : impl_->open(); }

void PtyLink::close() { impl_->close(); }

bool PtyLink::isOpen() const { return impl_->isOpen(); }

void PtyLink::write(std::string_view bytes) { impl_->write(bytes); }

QString PtyLink::description() const {
    const QString name = isOpen() ? slaveName() : QStringLiteral("pseudo-terminal");
    return impl_->linkPath().isEmpty() ? name : QStringLiteral("%1 (%2)").arg(impl_->linkPath(), name);
}

QString PtyLink::slaveName() const { return impl_->slaveName(); }

std::optional<PtyClientLine> PtyLink::clientLine() const { return impl_->clientLine(); }

bool PtyLink::hasClient() const { return impl_->hasClient(); }

}  // namespace pmts::transport
