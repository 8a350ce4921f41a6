#include "station_impl.hpp"

namespace pmts::simulator {
namespace {

constexpr std::string_view kDirectories = "MIUD*";

bool isDirectory(char unit) { return kDirectories.find(unit) != std::string_view::npos; }

/// Letters between the directory and `=` are the number of a transfer protocol.
bool isProtocolNumber(const std::string& arguments) {
    return arguments.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

void Station::Impl::handOut(const CommandLine& command) {
    const bool listing = command.arguments == "C" && !command.data;
    const bool file = command.data && isProtocolNumber(command.arguments) && command.unit != '*';
    if (!isDirectory(command.unit) || command.number || (!listing && !file)) {
        answerStatus(info::kSyntax);
    } else if (listing) {
        answer({std::nullopt, files_.list(command.unit)});
    } else if (const auto lines = files_.lines(command.unit, *command.data)) {
        answer({std::nullopt, *lines});
    } else {
        answerStatus(kNotFound);
    }
}

void Station::Impl::startLoad(const CommandLine& command) {
    const bool file = command.data && isProtocolNumber(command.arguments) && !command.number;
    if (!isDirectory(command.unit) || command.unit == '*' || !file) {
        answerStatus(info::kSyntax);
    } else if (!FileStore::isName(*command.data)) {
        answerStatus(kBadData);
    } else if (files_.exists(command.unit, *command.data)) {
        answerStatus(kFileExists);
    } else if (files_.freeBytes() <= 0) {
        answerStatus(kMemoryFull);
    } else {
        load_ = Load{command.unit, *command.data, {}, {}};
        said_.put("*");
        load_timer_ = clock_.callAfter(settings_.load_time_out, [this] { endLoad(info::kTimeOut); });
    }
}

void Station::Impl::hearFileByte(char byte) {
    load_timer_ = clock_.callAfter(settings_.load_time_out, [this] {
        const bool no_end_mark = end_mark_ == 0;  // then silence is the only end there is
        endLoad(no_end_mark ? kAccepted : info::kTimeOut);
    });
    if (end_mark_ != 0 && byte == static_cast<char>(end_mark_)) {
        endLoad(kAccepted);
    } else if (byte == '\r') {
        keepLoadedLine();
    } else if (byte != '\n') {
        load_->partial += byte;
    }
}

void Station::Impl::keepLoadedLine() {
    if (!load_->partial.empty()) {
        load_->lines.push_back(std::exchange(load_->partial, {}));
    }
}

void Station::Impl::endLoad(int code) {
    load_timer_.cancel();
    keepLoadedLine();
    const Load load = std::move(*load_);
    load_.reset();
    answerDone(code != kAccepted ? code : files_.add(load.directory, load.name, load.lines));
}

void Station::Impl::erase(const CommandLine& command) {
    if (!isDirectory(command.unit) || !command.arguments.empty() || command.number) {
        answerStatus(info::kSyntax);
        return;
    }
    answerDone(files_.erase(command.unit, command.data));
}

void Station::Impl::freeMemory(const CommandLine& command) {
    const bool asked = command.unit == 0 || command.unit == 'G' || command.unit == 'R';
    if (!asked || !command.arguments.empty() || command.number || command.data) {
        answerStatus(info::kSyntax);
    } else if (command.unit == 'R' && withoutControlUnit()) {
        answerStatus(info::kWrongDevice);
    } else {
        const int bytes = command.unit == 'R' ? settings_.memory_bytes : files_.freeBytes();
        answer({std::nullopt, {std::to_string(bytes)}});
    }
}

}  // namespace pmts::simulator
