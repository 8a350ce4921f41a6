#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/task.hpp"
#include "pmts/instrument/line_symptom.hpp"
#include "pmts/transport/byte_link.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace pmts::instrument {

struct ProbeSettings {
    core::Duration settle = std::chrono::milliseconds(200);        ///< after opening: some adapters restart
    core::Duration answer_limit = std::chrono::milliseconds(800);  ///< beside the time the bytes need
    core::Duration quiet = std::chrono::milliseconds(300);         ///< without a byte: that was all
};

/// What is tried now.
struct ProbeStep {
    transport::SerialSettings line;
    int done = 0, of = 0;
};

/// The most telling that a port has shown.
struct ProbedPort {
    transport::SerialSettings line;
    LineEvidence evidence;
    std::string heard;
    std::optional<core::Error> trouble;  ///< it could not be opened
};

struct ProbeOutcome {
    std::optional<ProbedPort> found;  ///< where the instrument answers or the bus streams, and how the line is set there
    std::vector<ProbedPort> ports;    ///< all that were looked at
};

/// Looks for an instrument on ports with the line settings that instruments use (protocol page 1.1), by a harmless question:
/// the line is cleared by a bare CR, which carries no command, then label 79 is read. The first answer ends the search.
class LineProbe {
public:
    using MakeLink = std::function<std::unique_ptr<transport::ByteLink>(const transport::SerialSettings&)>;

    /// The clock outlives the probe, and both outlive run().
    LineProbe(MakeLink make_link, core::Clock& clock, ProbeSettings settings = {});

    /// 9600 8N1 first, then the other speeds, then the other framings at each speed; each on every port in turn.
    [[nodiscard]] static std::vector<transport::SerialSettings> usualLines();
    [[nodiscard]] core::Task<core::Result<ProbeOutcome>> run(std::vector<QString> ports, std::stop_token stop);

    std::function<void(const ProbeStep&)> on_step;

private:
    struct Ear;
    struct Search;
    [[nodiscard]] core::Task<core::Result<void>> askNext(std::shared_ptr<Search> search, std::stop_token stop);
    [[nodiscard]] core::Task<core::Result<ProbedPort>> ask(transport::SerialSettings line, std::stop_token stop);
    [[nodiscard]] core::Task<core::Result<std::string>> exchange(std::shared_ptr<Ear> ear, std::string question,
                                                                 core::Duration limit, std::stop_token stop);
    void say(const transport::SerialSettings& line);

    MakeLink make_link_;
    core::Clock& clock_;
    ProbeSettings settings_;
    int done_ = 0, of_ = 0;
};

}  // namespace pmts::instrument
