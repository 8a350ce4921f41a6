#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/desk/instrument_desk.hpp"

#include <QObject>

#include <array>

namespace pmts::app {

/// A line of the doctor's check list: lamp, what is looked at, what came of it and what to set on the instrument.
struct CheckItem {
    DeviceState state = DeviceState::kIdle;
    QString title;
    QString sentence;

    [[nodiscard]] bool operator==(const CheckItem&) const = default;
};

/// What has to be right for an instrument to answer, from the port to the output, filled in while it is being connected and
/// emptied when it is gone. Listens to the desk only: what is asked is what connecting asks anyway. On the bus nothing is
/// asked: there it is the port, the stream and its angles, and the other items have no title.
class ConnectionChecks : public QObject {
    Q_OBJECT
public:
    enum Check { kPort, kBytes, kGrammar, kEndMark, kUnits, kSerialNumber, kOutput, kStream = kBytes, kAngles = kGrammar };
    static constexpr std::size_t kCount = 7;

    explicit ConnectionChecks(InstrumentDesk& instrument, QObject* parent = nullptr);

    [[nodiscard]] const std::array<CheckItem, kCount>& items() const { return items_; }

Q_SIGNALS:
    void changed();

private:
    void begin();
    void onConnection(ConnectionState state);
    void showConnected();
    void onFailed(const core::Error& error);
    void onPointing();
    [[nodiscard]] bool isBus() const { return instrument_.choice().dialect == instrument::LineDialect::kBus; }
    void onTransaction(const scheduler::TransactionRecord& record);
    void judgeFirst(const scheduler::TransactionRecord& record);
    void judgeUnits(const std::string& received);
    void judgeSerialNumber(const std::string& received);
    void judgeSilence();
    void onUnasked();
    void set(Check check, DeviceState state, const QString& sentence);

    InstrumentDesk& instrument_;
    std::array<CheckItem, kCount> items_;
    ConnectionState last_state_ = ConnectionState::kDisconnected;
    std::string heard_;  ///< all that came before an answer was understood
};

}  // namespace pmts::app
