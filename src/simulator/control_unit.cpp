#include "pmts/simulator/control_unit.hpp"

#include "paced_line.hpp"
#include "pmts/protocol/reply.hpp"

#include <QByteArray>

#include <algorithm>
#include <cmath>
#include <random>
#include <regex>

namespace pmts::simulator {
namespace {

using namespace std::chrono_literals;

constexpr double kBitsPerByte = 10.0;
constexpr core::Duration kPollPause = 400ms;
constexpr int kMostPolls = 20;  ///< as other programs do (protocol page, fault table)
constexpr int kPointNumber = 5;

/// One command and what its whole answer must look like.
struct Ask {
    std::string command;
    std::regex answer;
};

std::string escaped(std::string_view bytes) {
    std::string text;
    for (const char c : bytes) {
        text += c == '\r' ? "\\r" : c == '\n' ? "\\n" : std::string(1, c);
    }
    return text;
}

Ask readAngle(int label) {
    const auto text = std::to_string(label);
    return {"RG," + text + "\r", std::regex(text + R"(=-?\d+\.\d+\r\n|1\r\n)")};  // 1: tilted
}

Ask readText(int label, const std::string& data) {
    const auto text = std::to_string(label);
    return {"RG," + text + "\r", std::regex(text + "=" + data + "\r\n")};
}

Ask writeText(int label, const std::string& data) {
    return {"WG," + std::to_string(label) + "=" + data + "\r", std::regex(R"((0(\.\d)?\r\n)?)")};
}

Ask trigger() { return {"TG\r", std::regex(R"((0(\.\d)?\r\n)?)")}; }

/// Status, angles, perhaps the distance; or the status alone when there is nothing new (3, 4, 7) or no echo (166).
Ask readMeasurement() {
    return {"RG\r", std::regex(R"(0\r\n7=-?[\d.]+\r\n8=-?[\d.]+\r\n(9=[\d.]+\r\n)?|(1|3|4|7|166)(\.\d)?\r\n)")};
}

bool endsPolling(const std::string& block) {
    return block.find("9=") != std::string::npos || block.starts_with("3") || block.starts_with("166");
}

}  // namespace

class ControlUnit::Impl {
public:
    Impl(ControlUnit& unit, ControlUnitSettings settings, core::Clock& clock)
        : owner_(unit),
          settings_(std::move(settings)),
          clock_(clock),
          random_(settings_.seed),
          reader_(settings_.end_mark == 0 ? std::nullopt : std::optional(static_cast<char>(settings_.end_mark))),
          wire_(clock, [this](std::string_view bytes) {
              if (owner_.send) {
                  owner_.send(bytes);
              }
          }) {
        if (settings_.baud > 0) {
            wire_.setByteTime(scaled(core::Duration(std::llround(kBitsPerByte / settings_.baud * 1e9))));
        }
    }

    void start() { pause(randomPause()); }

    void stop() {
        timer_.cancel();
        quiet_.cancel();
        asked_.reset();
    }

    void receive(std::string_view bytes) {
        for (const auto& block : reader_.feed(bytes)) {
            takeBlock(block);
        }
        if (!reader_.endMark() && reader_.hasPending()) {
            quiet_ = clock_.callAfter(scaled(settings_.quiet_time), [this] { takeBlock(*reader_.flush()); });
        }
    }

    [[nodiscard]] const ControlUnitCounts& counts() const { return counts_; }

private:
    [[nodiscard]] core::Duration scaled(core::Duration span) const {
        return core::Duration(std::llround(static_cast<double>(span.count()) / settings_.time_scale));
    }

    [[nodiscard]] core::Duration randomPause() {
        std::uniform_int_distribution<std::int64_t> any(settings_.shortest_pause.count(),
                                                        settings_.longest_pause.count());
        return core::Duration(any(random_));
    }

    void pause(core::Duration span) {
        timer_ = clock_.callAfter(scaled(span), [this] { askNext(); });
    }

    void askNext() {
        if (owner_.is_plugged && !owner_.is_plugged()) {
            pause(settings_.longest_pause);
            return;
        }
        if (reader_.endMark() && reader_.hasPending()) {
            reportForeign(*reader_.flush());  // half a block and then silence
        }
        asked_ = chooseNext();
        ++counts_.asked;
        wire_.put(asked_->command);
        timer_ = clock_.callAfter(scaled(settings_.patience), [this] { giveUp(); });
        if (!reader_.endMark() && asked_->command.front() != 'R') {
            quiet_ = clock_.callAfter(scaled(2 * settings_.quiet_time), [this] { takeBlock({}); });
        }
    }

    Ask chooseNext() {
        if (polls_left_ > 0) {
            --polls_left_;
            return readMeasurement();
        }
        if (reads_back_) {
            reads_back_ = false;
            return readText(kPointNumber, std::to_string(point_number_));
        }
        switch (std::uniform_int_distribution<int>(0, 9)(random_)) {
            case 0:
                polls_left_ = kMostPolls;
                return trigger();
            case 1:
                reads_back_ = true;
                return writeText(kPointNumber, std::to_string(++point_number_));
            case 2:
                return readText(55, settings_.serial_number.toStdString());
            case 3:
            case 4:
            case 5:
                return readAngle(7);
            default:
                return readAngle(8);
        }
    }

    void takeBlock(const std::string& block) {
        if (!asked_) {
            takeUnasked(block);
            return;
        }
        if (!std::regex_match(block, asked_->answer)) {
            reportForeign(block);
            return;
        }
        ++counts_.answered;
        polls_left_ = asked_->command == "RG\r" && endsPolling(block) ? 0 : polls_left_;
        asked_.reset();
        pause(polls_left_ > 0 ? kPollPause : randomPause());
    }

    void takeUnasked(const std::string& block) {
        const auto reply = protocol::parseReply(block);
        const bool has_labels = std::ranges::all_of(reply.items, [](const auto& item) { return item.label.has_value(); });
        if (reply.items.empty() || reply.damaged || !has_labels) {
            reportForeign(block);
        } else {
            ++counts_.unasked;
        }
    }

    void giveUp() {
        ++counts_.unanswered;
        polls_left_ = 0;
        reads_back_ = false;
        asked_.reset();
        askNext();
    }

    void reportForeign(const std::string& block) {
        ++counts_.foreign;
        if (owner_.on_foreign) {
            const auto asked = asked_ ? escaped(asked_->command) : std::string("nothing");
            owner_.on_foreign(QStringLiteral("the control unit asked %1 and got \"%2\"")
                                  .arg(QString::fromStdString(asked), QString::fromLatin1(QByteArray::fromStdString(escaped(block)))));
        }
    }

    ControlUnit& owner_;
    ControlUnitSettings settings_;
    core::Clock& clock_;
    std::mt19937 random_;
    protocol::BlockReader reader_;
    PacedLine wire_;
    ControlUnitCounts counts_;
    std::optional<Ask> asked_;
    int polls_left_ = 0;
    int point_number_ = 1000;
    bool reads_back_ = false;
    core::Timer timer_, quiet_;
};

ControlUnit::ControlUnit(ControlUnitSettings settings, core::Clock& clock)
    : impl_(std::make_unique<Impl>(*this, std::move(settings), clock)) {}
ControlUnit::~ControlUnit() = default;

void ControlUnit::start() { impl_->start(); }
void ControlUnit::stop() { impl_->stop(); }
void ControlUnit::receive(std::string_view bytes) { impl_->receive(bytes); }
const ControlUnitCounts& ControlUnit::counts() const { return impl_->counts(); }

}  // namespace pmts::simulator
