#pragma once

#include "pmts/simulator/station.hpp"

#include <map>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace pmts::simulator {

/// A fault as it was ordered.
struct Fault {
    QString name;
    double value = 0.0;
    bool off = false;  ///< `NAME=off`
    std::string on;    ///< only for commands that begin with this text
    int times = 1;     ///< how often a one-time fault strikes; 0: every time
    std::optional<unsigned> seed;
};

/// `NAME[=VALUE][,on=COMMAND][,times=N][,seed=N]`. Fails with kBadInput naming what was not known.
[[nodiscard]] core::Result<Fault> parseFault(const QString& text);
[[nodiscard]] const FaultKind* findFaultKind(const QString& name);

/// The faults that wait for their moment.
class FaultBox {
public:
    explicit FaultBox(unsigned seed) : random_(seed * 2246822519U + 3U) {}

    void add(const Fault& fault);
    void clear() { faults_.clear(); }
    [[nodiscard]] bool has(const char* name) const { return value(name).has_value(); }
    [[nodiscard]] std::optional<double> value(const char* name) const;  ///< without using it up
    /// A one-time fault that strikes this command: uses it up once.
    [[nodiscard]] std::optional<double> take(const char* name, std::string_view command);

    /// A fault had an effect; take() and throughBadLine() count theirs themselves.
    void strike(const QString& name) { ++struck_[name]; }
    [[nodiscard]] int timesStruck(const QString& name) const;

    /// What a bad line leaves of these bytes: some lost (`drop`), some changed (`garble=P`).
    [[nodiscard]] std::string throughBadLine(std::string_view bytes);
    /// About a fifth of the bytes changed, one at least.
    [[nodiscard]] std::string garbled(std::string_view bytes);

private:
    [[nodiscard]] bool chance(double probability);
    [[nodiscard]] char otherThan(char byte);

    std::vector<Fault> faults_;
    std::map<QString, int> struck_;  ///< by name; clear() leaves it
    std::mt19937 random_;
};

}  // namespace pmts::simulator
