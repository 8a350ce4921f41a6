#pragma once

#include "pmts/app/line/instrument_health.hpp"
#include "pmts/geometry/two_faces.hpp"

#include <QObject>
#include <QStringList>

#include <optional>
#include <vector>

namespace pmts::app {

/// What the accepted test of the connected instrument says now: none, good, expired or beyond its limits.
[[nodiscard]] StatusItem axisTestState(const InstrumentCareSettings& care, const QString& serial_number,
                                       const std::optional<double>& temperature_degc, const QDateTime& utc_now);
/// `6.0 mgon (19.5")`, with its standard deviation where there is one.
[[nodiscard]] QString axisErrorText(const geometry::AxisError& error);

/// Collimation and index test (features S10): the same target several times in both faces. Whoever aims, the eyepiece
/// or the picture, the circles are read when the instrument stands still. The result is kept with date and temperature.
class AxisTestPresenter : public QObject {
    Q_OBJECT
public:
    static constexpr int kReadings = 5;  ///< of the circles for one pointing

    AxisTestPresenter(InstrumentDesk& instrument, InstrumentHealth& health, Preferences& preferences,
                      MessageCentre& messages, const core::Clock& clock, QObject* parent = nullptr);

    [[nodiscard]] const std::vector<geometry::FacePair>& pairs() const { return pairs_; }
    [[nodiscard]] bool isReading() const { return !readings_.empty() || wants_reading_; }
    [[nodiscard]] bool isTurning() const { return turn_ticket_ != 0; }
    /// Both faces are there, in two pairs at least.
    [[nodiscard]] bool canAccept() const { return pairs_.size() >= 2 && !half_ && of_serial_; }
    [[nodiscard]] bool isEmpty() const { return pairs_.empty() && !half_; }
    [[nodiscard]] QString instruction() const;            ///< what to do next
    [[nodiscard]] QStringList headers() const;
    [[nodiscard]] std::vector<QStringList> rows() const;  ///< one for each pair
    [[nodiscard]] std::optional<geometry::AxisErrors> result() const;
    [[nodiscard]] StatusItem resultState() const;         ///< the result in words, with what to think of it
    [[nodiscard]] StatusItem kept() const;                ///< of the connected instrument
    /// What is noted with the test: typed, or of the instrument; absent: not known.
    [[nodiscard]] std::optional<double> temperatureDegc() const;
    [[nodiscard]] QString temperatureText() const;        ///< which one it is, in words
    [[nodiscard]] QString typedTemperature() const { return typed_temperature_; }
    [[nodiscard]] const InstrumentCareSettings& care() const { return preferences_.settings().instrument_care; }
    void setCare(const InstrumentCareSettings& care);     ///< limits of the test and of both faces

public Q_SLOTS:
    void take();         ///< the target is aimed at
    void turnToOther();  ///< the same target in the other face; it is to be aimed at again
    /// Degrees Celsius, in place of the instrument's own; empty: that one again. What is no temperature is said.
    void typeTemperature(const QString& text);
    void accept();
    void discard();
    void cancel();

Q_SIGNALS:
    void changed();

private:
    void follow();
    void onConnection(ConnectionState state);
    void onIdentity();
    void dropPointings();
    void addReading(const TimedPointing& reading);
    void finishPointing();
    void addPointing(const geometry::Pointing& pointing);
    void onFailed(Ticket ticket, const core::Error& error);
    void say(const QString& happened, const QString& remedy);
    [[nodiscard]] QString serialNumber() const;

    InstrumentDesk& instrument_;
    InstrumentHealth& health_;
    Preferences& preferences_;
    MessageCentre& messages_;
    const core::Clock& clock_;
    std::optional<QString> of_serial_;  ///< of the instrument whose pointings these are; absent: none is taken
    std::optional<double> measured_degc_;  ///< what it said last, while pointings are taken
    QString typed_temperature_;
    std::vector<geometry::FacePair> pairs_;
    std::optional<geometry::Pointing> half_;  ///< pointing of a pair whose other face is missing
    std::vector<geometry::Pointing> readings_;
    bool wants_reading_ = false;
    bool reminded_ = false;  ///< of the connected instrument
    Ticket turn_ticket_ = 0;
};

}  // namespace pmts::app
