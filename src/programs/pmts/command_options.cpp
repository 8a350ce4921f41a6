#include "command_options.hpp"

namespace pmts {

core::Result<void> readOptions(QCommandLineParser& parser, const QStringList& arguments,
                               std::initializer_list<ValueOption> options, const QString& flag) {
    for (const auto& [name, value, usual] : options) {
        parser.addOption(QCommandLineOption(QString::fromLatin1(name), {}, QString::fromLatin1(value), QString::fromLatin1(usual)));
    }
    parser.addOption(QCommandLineOption(flag));
    if (!parser.parse(QStringList(QStringLiteral("pmts")) + arguments) || !parser.positionalArguments().isEmpty()) {
        return core::fail(core::ErrorKind::kBadInput,
                          parser.errorText().isEmpty() ? QStringLiteral("There is a word too many.") : parser.errorText(),
                          QStringLiteral("See pmts --help."));
    }
    return {};
}

tl::unexpected<core::Error> unreadable(const QString& option, const QString& example) {
    return core::fail(core::ErrorKind::kBadInput, QStringLiteral("--%1 is not understood.").arg(option),
                      QStringLiteral("Write it as --%1 %2.").arg(option, example));
}

}  // namespace pmts
