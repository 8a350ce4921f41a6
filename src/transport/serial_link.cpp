#include "pmts/transport/serial_link.hpp"

#include "pmts/core/logging.hpp"
#include "pmts/core/task.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSerialPort>
#include <QStringList>

#include <stdexcept>

namespace pmts::transport {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("SerialLink", text); }

/// One name for one device: Qt locks a port by its name, and a link to it would not be locked out.
QString deviceName(const QString& port_name) {
    const QString canonical = QFileInfo(port_name).canonicalFilePath();
    return port_name.contains(u'/') && !canonical.isEmpty() ? canonical : port_name;
}

QSerialPort::Parity qtParity(Parity parity) {
    switch (parity) {
        case Parity::kNone:
            return QSerialPort::NoParity;
        case Parity::kOdd:
            return QSerialPort::OddParity;
        case Parity::kEven:
            return QSerialPort::EvenParity;
    }
    throw std::logic_error("unknown parity");
}

QSerialPort::FlowControl qtFlowControl(FlowControl flow_control) {
    switch (flow_control) {
        case FlowControl::kNone:
            return QSerialPort::NoFlowControl;
        case FlowControl::kHardware:
            return QSerialPort::HardwareControl;
        case FlowControl::kSoftware:
            return QSerialPort::SoftwareControl;
    }
    throw std::logic_error("unknown flow control");
}

core::Error unavailable(const QString& happened, const QString& remedy, const QString& detail) {
    return {.kind = core::ErrorKind::kPortUnavailable,
            .happened = happened,
            .remedy = remedy,
            .info_code = std::nullopt,
            .detail = detail};
}

core::Error openError(const QString& name, QSerialPort::SerialPortError error, const QString& detail) {
    const QFileInfo file(name);
    if (error == QSerialPort::DeviceNotFoundError) {
        return unavailable(tr("The port %1 is not there.").arg(name),
                           tr("Plug the cable in, or choose another port."), detail);
    }
    if (error == QSerialPort::PermissionError && file.exists() && !(file.isReadable() && file.isWritable())) {
        return unavailable(tr("You may not use the port %1.").arg(name),
                           tr("Add your user to the group of the port (often dialout), then log in again."),
                           detail);
    }
    if (error == QSerialPort::PermissionError) {
        return unavailable(tr("Another program has the port %1.").arg(name),
                           tr("Close that program, then connect again."), detail);
    }
    return unavailable(tr("%1 cannot be opened as a serial port.").arg(name), tr("Choose another port."),
                       detail);
}

/// Errors after which Qt repeats its signal for ever until the port is closed.
bool isLoss(QSerialPort::SerialPortError error) {
    switch (error) {
        case QSerialPort::ReadError:
        case QSerialPort::WriteError:
        case QSerialPort::ResourceError:
        case QSerialPort::DeviceNotFoundError:
        case QSerialPort::PermissionError:
        case QSerialPort::UnknownError:
            return true;
        default:
            return false;
    }
}

}  // namespace

QString SerialSettings::lineText() const {
    const QChar parity_letter = parity == Parity::kNone ? u'N' : parity == Parity::kOdd ? u'O' : u'E';
    return QStringLiteral("%1 %2%3%4").arg(baud).arg(data_bits).arg(parity_letter).arg(stop_bits);
}

class SerialLink::Impl {
public:
    Impl(SerialLink& owner, SerialSettings settings) : owner_(owner), settings_(std::move(settings)) {}
    ~Impl() { close(); }

    core::Result<void> open() {
        close();  // a loss that is not reported yet is over
        auto port = std::make_unique<QSerialPort>(deviceName(settings_.port_name));
        port->setBaudRate(settings_.baud);
        if (!port->open(QIODevice::ReadWrite)) {
            return tl::unexpected(openError(settings_.port_name, port->error(), port->errorString()));
        }
        applySettings(*port);
        port->clear();  // what waits since before we came is not for us
        QObject::connect(port.get(), &QSerialPort::readyRead, port.get(), [this] { takeBytes(); });
        QObject::connect(port.get(), &QSerialPort::errorOccurred, port.get(),
                         [this](auto error) { takeError(error); });
        port_ = std::move(port);
        return {};
    }

    /// The port may be closed inside its own signals: it is deleted later.
    void close() {
        ++generation_;
        losing_ = false;
        if (port_) {
            port_->disconnect();
            port_->flush();
            if (port_->isBreakEnabled()) {
                port_->setBreakEnabled(false);  // the device would keep it
            }
            port_->close();
            port_.release()->deleteLater();
        }
    }

    void write(std::string_view bytes) {
        if (isOpen()) {
            port_->write(bytes.data(), static_cast<qint64>(bytes.size()));
            port_->flush();  // now, not in the next turn of the event loop
        }
    }

    core::Result<void> setControlLines(const ControlLines& lines) {
        if (!isOpen()) {
            return core::fail(core::ErrorKind::kNotConnected, tr("The port %1 is closed.").arg(settings_.port_name));
        }
        const bool dtr_set = !lines.dtr || port_->setDataTerminalReady(*lines.dtr);
        const bool rts_set = !lines.rts || port_->setRequestToSend(*lines.rts);
        const QString detail = port_->errorString();
        port_->clearError();
        if (dtr_set && rts_set) {
            return {};
        }
        return core::fail(core::ErrorKind::kUnsupported,
                          tr("The port %1 could not set its DTR and RTS lines.").arg(settings_.port_name),
                          tr("Choose a port that has them, without hardware handshake."), detail);
    }

    core::Result<void> setBreak(bool on) {
        if (!isOpen()) {
            return core::fail(core::ErrorKind::kNotConnected, tr("The port %1 is closed.").arg(settings_.port_name));
        }
        if (port_->setBreakEnabled(on)) {
            return {};
        }
        const QString detail = port_->errorString();
        port_->clearError();
        return core::fail(core::ErrorKind::kUnsupported, tr("The port %1 cannot send a BREAK.").arg(settings_.port_name),
                          tr("Switch the instrument on by its own key."), detail);
    }

    [[nodiscard]] bool isOpen() const { return port_ && !losing_; }

    [[nodiscard]] QString description() const {
        const QString text = tr("%1 at %2").arg(settings_.port_name, settings_.lineText());
        return unsupported_.isEmpty()
                   ? text
                   : tr("%1 (not supported: %2)").arg(text, unsupported_.join(QStringLiteral(", ")));
    }

private:
    void applySettings(QSerialPort& port) {
        unsupported_.clear();
        note(port.setDataBits(static_cast<QSerialPort::DataBits>(settings_.data_bits)),
             tr("%1 data bits").arg(settings_.data_bits));
        note(port.setParity(qtParity(settings_.parity)), tr("parity"));
        note(port.setStopBits(settings_.stop_bits == 2 ? QSerialPort::TwoStop : QSerialPort::OneStop),
             tr("%1 stop bits").arg(settings_.stop_bits));
        note(port.setFlowControl(qtFlowControl(settings_.flow_control)), tr("flow control"));
        port.clearError();
    }

    void note(bool supported, const QString& setting) {
        if (!supported) {
            unsupported_ << setting;
            qCWarning(core::logTransport) << settings_.port_name << "does not support" << setting;
        }
    }

    void takeBytes() {
        const QByteArray bytes = port_->readAll();
        if (const auto receive = owner_.on_received; receive && !losing_) {
            receive({bytes.constData(), static_cast<std::size_t>(bytes.size())});
        }
    }

    void takeError(QSerialPort::SerialPortError error) {
        if (error == QSerialPort::UnsupportedOperationError) {
            qCWarning(core::logTransport) << settings_.port_name << port_->errorString();
        }
        if (!isLoss(error) || std::exchange(losing_, true)) {
            return;
        }
        core::post([this, alive = std::weak_ptr<bool>(alive_), generation = generation_,
                    detail = port_->errorString()] {
            if (!alive.expired() && generation == generation_) {
                finishLoss(detail);
            }
        });
    }

    void finishLoss(const QString& detail) {
        close();
        if (const auto report = owner_.on_lost) {
            report({.kind = core::ErrorKind::kLinkLost,
                    .happened = tr("The connection over %1 is lost.").arg(settings_.port_name),
                    .remedy = tr("Check the cable and the instrument's power."),
                    .info_code = std::nullopt,
                    .detail = detail});
        }
    }

    SerialLink& owner_;
    SerialSettings settings_;
    std::unique_ptr<QSerialPort> port_;
    QStringList unsupported_;
    bool losing_ = false;
    unsigned generation_ = 0;  ///< of the open port: a late report must not hit the next one
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

SerialLink::SerialLink(SerialSettings settings) : impl_(std::make_unique<Impl>(*this, std::move(settings))) {}

SerialLink::~SerialLink() = default;

core::Result<void> SerialLink::open() { return isOpen() ? core::Result<void>() : impl_->open(); }

void SerialLink::close() { impl_->close(); }

bool SerialLink::isOpen() const { return impl_->isOpen(); }

void SerialLink::write(std::string_view bytes) { impl_->write(bytes); }

core::Result<void> SerialLink::setControlLines(const ControlLines& lines) { return impl_->setControlLines(lines); }

core::Result<void> SerialLink::setBreak(bool on) { return impl_->setBreak(on); }

QString SerialLink::description() const { return impl_->description(); }

}  // namespace pmts::transport
