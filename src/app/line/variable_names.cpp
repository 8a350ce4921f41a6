#include "pmts/app/line/variable_names.hpp"

#include "pmts/app/desk/whole_file.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

namespace pmts::app {
namespace {

QString say(const char* text) { return QCoreApplication::translate("VariableNames", text); }

}  // namespace

core::Result<void> VariableNames::load() {
    names_.clear();
    QFile file(path_);
    if (!file.exists()) {
        return {};
    }
    if (!file.open(QIODevice::ReadOnly)) {
        return core::fail(core::ErrorKind::kFile, say("The names of the variables cannot be read."),
                          say("Check your permission to read the data folder."), file.errorString());
    }
    const QJsonDocument document = QJsonDocument::fromJson(file.readAll());
    if (!document.isObject()) {
        return core::fail(core::ErrorKind::kBadInput, say("The file of the variables' names is damaged."),
                          say("It is written anew with the next name."), path_);
    }
    const QJsonObject object = document.object();
    for (auto entry = object.begin(); entry != object.end(); ++entry) {
        names_.insert(entry.key(), entry.value().toString());
    }
    return {};
}

core::Result<void> VariableNames::set(const QString& variable, const QString& name) {
    if (name.trimmed().isEmpty()) {
        names_.remove(variable);
    } else {
        names_.insert(variable, name.trimmed());
    }
    QJsonObject object;
    for (auto entry = names_.constBegin(); entry != names_.constEnd(); ++entry) {
        object.insert(entry.key(), entry.value());
    }
    return writeWhole(path_, QJsonDocument(object).toJson());
}

QString variableKey(char unit, int variable) {
    return QStringLiteral("%1,%2").arg(QLatin1Char(unit)).arg(variable);
}

}  // namespace pmts::app
