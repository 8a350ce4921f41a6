#pragma once

#include "pmts/transport/byte_link.hpp"
#include "pmts/transport/session_log.hpp"

#include <memory>

namespace pmts::transport {

/// A link that shows an onlooker every byte of both directions and its loss (the sentence, UTF-8), on the link's thread.
class TapLink : public ByteLink {
public:
    using OnTraffic = std::function<void(Direction direction, std::string_view bytes)>;

    TapLink(std::unique_ptr<ByteLink> inner, OnTraffic on_traffic);

    [[nodiscard]] core::Result<void> open() override { return inner_->open(); }
    void close() override { inner_->close(); }
    [[nodiscard]] bool isOpen() const override { return inner_->isOpen(); }
    void write(std::string_view bytes) override;
    [[nodiscard]] core::Result<void> setControlLines(const ControlLines& lines) override {
        return inner_->setControlLines(lines);
    }
    [[nodiscard]] core::Result<void> setBreak(bool on) override { return inner_->setBreak(on); }
    [[nodiscard]] QString description() const override { return inner_->description(); }

    [[nodiscard]] ByteLink& inner() { return *inner_; }

private:
    std::unique_ptr<ByteLink> inner_;
    OnTraffic on_traffic_;
};

}  // namespace pmts::transport
