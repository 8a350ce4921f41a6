#include "adapter_port.hpp"

#include <QCoreApplication>

#include <algorithm>

namespace pmts::app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("AdapterPort", text); }

class AnothersPort final : public transport::ByteLink {
public:
    explicit AnothersPort(const QString& path) : path_(path) {}

    core::Result<void> open() override {
        return core::fail(core::ErrorKind::kPortUnavailable, tr("The adapter is not plugged in; %1 is another one now.").arg(path_),
                          tr("Plug the adapter in, or choose another port."));
    }
    void close() override {}
    [[nodiscard]] bool isOpen() const override { return false; }
    void write(std::string_view /*bytes*/) override {}
    [[nodiscard]] QString description() const override { return path_; }

private:
    QString path_;
};

}  // namespace

QString pathNow(const SerialChoice& choice, const std::vector<transport::PortInfo>& present) {
    const auto port = choice.adapter.usb_vendor ? transport::findAgain(choice.adapter, present) : std::nullopt;
    return port ? port->path : choice.path;
}

bool isAnothersPort(const SerialChoice& choice, const std::vector<transport::PortInfo>& present) {
    const auto named = std::ranges::find(present, choice.path, &transport::PortInfo::path);
    return choice.adapter.usb_vendor && named != present.end() && !transport::findAgain(choice.adapter, {*named});
}

std::unique_ptr<transport::ByteLink> anothersPort(const QString& path) { return std::make_unique<AnothersPort>(path); }

}  // namespace pmts::app
