#include "pmts/transport/replay_link.hpp"

#include "timed_queue.hpp"

#include <QFileInfo>

#include <stdexcept>

namespace pmts::transport {
namespace {

/// A write of the session and what came after it, with times since that write.
struct Exchange {
    std::string sent;  ///< empty for what came before the first write
    std::vector<SessionEvent> answers;
};

std::vector<Exchange> exchangesOf(const Session& session) {
    std::vector<Exchange> exchanges(1);
    core::Duration sent_at{0};
    for (const SessionEvent& event : session.events) {
        if (event.direction == Direction::kSent) {
            exchanges.push_back({.sent = event.bytes, .answers = {}});
            sent_at = event.at;
        } else {
            exchanges.back().answers.push_back({event.at - sent_at, event.direction, event.bytes});
        }
    }
    return exchanges;
}

}  // namespace

class ReplayLink::Player {
public:
    Player(ReplayLink& owner, const Session& session, core::Clock& clock, ReplaySettings settings)
        : owner_(owner),
          exchanges_(exchangesOf(session)),
          clock_(clock),
          settings_(std::move(settings)),
          queue_(clock, [this](const std::vector<SessionEvent>& events) { deliver(events); }) {}

    void open() {
        open_ = true;
        next_ = 1;
        unexpected_.clear();
        play(exchanges_.front());
    }

    void close() {
        open_ = false;
        queue_.clear();
    }

    void write(std::string_view bytes) {
        if (!open_) {
            return;
        }
        if (const Exchange* exchange = find(bytes)) {
            play(*exchange);
        } else {
            unexpected_.emplace_back(bytes);
        }
    }

    [[nodiscard]] bool isOpen() const { return open_; }
    [[nodiscard]] bool isAtEnd() const { return next_ == exchanges_.size() && queue_.isEmpty(); }
    [[nodiscard]] const std::vector<std::string>& unexpected() const { return unexpected_; }
    [[nodiscard]] const ReplaySettings& settings() const { return settings_; }

private:
    /// The next of the log; else the latest answer to a repeated question; else the first one farther on.
    const Exchange* find(std::string_view bytes) {
        if (next_ < exchanges_.size() && exchanges_[next_].sent == bytes) {
            return &exchanges_[next_++];
        }
        for (std::size_t i = next_; i-- > 1;) {
            if (exchanges_[i].sent == bytes) {
                return &exchanges_[i];
            }
        }
        for (std::size_t i = next_; i < exchanges_.size(); ++i) {
            if (exchanges_[i].sent == bytes) {
                next_ = i + 1;
                return &exchanges_[i];
            }
        }
        return nullptr;
    }

    void play(const Exchange& exchange) {
        for (const SessionEvent& answer : exchange.answers) {
            const std::chrono::duration<double, std::nano> wait = answer.at / settings_.speed;
            queue_.push(clock_.now() + std::chrono::duration_cast<core::Duration>(wait), answer);
        }
    }

    void deliver(const std::vector<SessionEvent>& events) {
        const auto alive = owner_.player_;  // a callback may destroy the link
        for (const SessionEvent& event : events) {
            if (!open_ || alive.use_count() == 1) {
                return;
            }
            deliverOne(event);
        }
    }

    void deliverOne(const SessionEvent& event) {
        if (event.direction == Direction::kReceived) {
            if (const auto receive = owner_.on_received) {
                receive(event.bytes);
            }
            return;
        }
        close();
        if (const auto report = owner_.on_lost) {
            report({.kind = core::ErrorKind::kLinkLost,
                    .happened = QString::fromStdString(event.bytes),
                    .remedy = {},
                    .info_code = std::nullopt,
                    .detail = settings_.name});
        }
    }

    ReplayLink& owner_;
    std::vector<Exchange> exchanges_;
    core::Clock& clock_;
    ReplaySettings settings_;
    bool open_ = false;
    std::size_t next_ = 1;
    std::vector<std::string> unexpected_;
    TimedQueue<SessionEvent> queue_;
};

ReplayLink::ReplayLink(Session session, core::Clock& clock, ReplaySettings settings) {
    if (!(settings.speed > 0.0)) {
        throw std::logic_error("a replay has a speed above zero");
    }
    player_ = std::make_shared<Player>(*this, session, clock, std::move(settings));
}

ReplayLink::~ReplayLink() = default;

core::Result<std::unique_ptr<ReplayLink>> ReplayLink::fromFile(const QString& path, core::Clock& clock,
                                                               double speed) {
    auto sessions = readSessionLog(path);
    if (!sessions) {
        return tl::unexpected(std::move(sessions).error());
    }
    return std::make_unique<ReplayLink>(std::move(sessions->back()), clock,
                                        ReplaySettings{.speed = speed, .name = QFileInfo(path).fileName()});
}

core::Result<void> ReplayLink::open() {
    if (!isOpen()) {
        player_->open();
    }
    return {};
}

void ReplayLink::close() { player_->close(); }

bool ReplayLink::isOpen() const { return player_->isOpen(); }

void ReplayLink::write(std::string_view bytes) { player_->write(bytes); }

QString ReplayLink::description() const {
    return QStringLiteral("replay of %1").arg(player_->settings().name);
}

std::vector<std::string> ReplayLink::unexpectedWrites() const { return player_->unexpected(); }

bool ReplayLink::isAtEnd() const { return player_->isAtEnd(); }

}  // namespace pmts::transport
