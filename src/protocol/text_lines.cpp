#include "text_lines.hpp"

#include <QCoreApplication>

namespace pmts::protocol {

namespace {

constexpr std::size_t kShown = 80;

}  // namespace

QString clipped(std::string_view text) {
    return text.size() <= kShown ? QString::fromLatin1(text) : QString::fromLatin1(text.substr(0, kShown)) + u'…';
}

tl::unexpected<core::Error> unreadableLine(std::size_t line, std::string_view text) {
    return core::fail(core::ErrorKind::kBadInput,
                      QCoreApplication::translate("LineCapture", "Line %1 of the capture cannot be read.").arg(line),
                      QCoreApplication::translate("LineCapture", "Export it again, or choose another format."),
                      clipped(text));
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace pmts::protocol
