#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/line/instrument_air.hpp"
#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/settings/preferences.hpp"

#include <QObject>

#include <map>
#include <optional>
#include <set>

namespace pmts::app {

/// Face, compensator, battery and level of the instrument: what is known, from what, and how old it is. The protocol
/// has no question for battery and level; they show in the status of measurements (info 8, 9 and 1).
class InstrumentHealth : public QObject {
    Q_OBJECT
public:
    InstrumentHealth(InstrumentDesk& instrument, Preferences& preferences, MessageCentre& messages,
                     const core::Clock& clock, QObject* parent = nullptr);

    [[nodiscard]] bool isConnected() const;
    /// Labels and the compensator are reached; not on the bus.
    [[nodiscard]] bool canAsk() const { return instrument_.speaksExternal(); }
    [[nodiscard]] StatusItem face() const;
    [[nodiscard]] StatusItem compensator() const;
    [[nodiscard]] StatusItem battery() const;
    [[nodiscard]] StatusItem level() const;
    [[nodiscard]] StatusItem airUsed() const;
    /// The worst of them, for the lamp of the page.
    [[nodiscard]] DeviceState state() const;
    [[nodiscard]] const std::optional<bool>& compensatorOn() const { return compensator_on_; }  ///< label 22
    [[nodiscard]] const std::optional<double>& temperatureDegc() const { return air_.temperature_degc; }  ///< label 56
    /// As the instrument told it since it was connected.
    [[nodiscard]] const InstrumentAir& air() const { return air_; }
    void showAir(const InstrumentAir& air);  ///< of a recording
    [[nodiscard]] bool isCalibrating() const { return calibration_ticket_ != 0; }
    [[nodiscard]] QString calibrationText() const { return calibration_text_; }
    [[nodiscard]] const instrument::TargetTest& targetTest() const;

public Q_SLOTS:
    void refresh();  ///< asks for label 22 and those of the air, but for what the instrument has refused
    void switchCompensator(bool on);
    /// The instrument turns by itself, half a turn and back: ask before.
    void calibrateCompensator();
    void answer(bool yes);
    void cancel();
    void setTargetTest(const pmts::instrument::TargetTest& test);

Q_SIGNALS:
    void changed();
    void questionAsked();  ///< the instrument waits for yes or no: answer()

private:
    void noteTransaction(const scheduler::TransactionRecord& record);
    void noteStatus(int code, bool is_measurement);
    void keepAir(int label, const QString& data);
    void onLabel(Ticket ticket, int label, const QString& data);
    void onFailed(Ticket ticket, const core::Error& error);
    void endCalibration(const QString& text);
    void forget();
    [[nodiscard]] QString age(const QDateTime& since) const;

    InstrumentDesk& instrument_;
    Preferences& preferences_;
    MessageCentre& messages_;
    const core::Clock& clock_;
    std::optional<bool> face_two_;
    std::optional<bool> compensator_on_;
    InstrumentAir air_;
    QDateTime air_at_;
    std::map<Ticket, int> air_tickets_;  ///< with the label
    std::set<int> without_;              ///< labels this instrument does not have
    std::optional<int> battery_code_;  ///< 8 or 9; absent: none stands
    QDateTime battery_at_, fine_at_, tilted_at_;
    bool tilted_ = false;
    Ticket switch_ticket_ = 0, calibration_ticket_ = 0, compensator_ticket_ = 0;
    QString calibration_text_;
};

}  // namespace pmts::app
