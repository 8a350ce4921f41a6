#pragma once

#include "pmts/transport/byte_link.hpp"

#include <memory>

namespace pmts::instrument {

/// A link whose far part is changed at every reconnect, so that what stands on it stays.
class RelayLink final : public transport::ByteLink {
public:
    /// Closes and drops the earlier one. Not from inside one of its callbacks.
    void replace(std::unique_ptr<transport::ByteLink> inner);

    [[nodiscard]] core::Result<void> open() override;
    void close() override;
    [[nodiscard]] bool isOpen() const override;
    void write(std::string_view bytes) override;
    [[nodiscard]] core::Result<void> setControlLines(const transport::ControlLines& lines) override;
    [[nodiscard]] core::Result<void> setBreak(bool on) override;
    [[nodiscard]] QString description() const override;

    /// After on_lost: everybody on the line has been told.
    std::function<void(const core::Error&)> on_gone;

private:
    std::unique_ptr<transport::ByteLink> inner_;
};

}  // namespace pmts::instrument
