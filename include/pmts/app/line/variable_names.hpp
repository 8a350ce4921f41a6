#pragma once

#include "pmts/core/result.hpp"

#include <QMap>
#include <QString>

namespace pmts::app {

/// What people call the variables and labels they have found out: `A,166` is `VA in gon`. Kept in a JSON file.
class VariableNames {
public:
    explicit VariableNames(QString path) : path_(std::move(path)) {}

    /// A file that is missing holds no names; one that cannot be read is kFile or kBadInput.
    [[nodiscard]] core::Result<void> load();
    /// An empty name takes it away. The file is written whole or not at all.
    [[nodiscard]] core::Result<void> set(const QString& variable, const QString& name);
    [[nodiscard]] QString of(const QString& variable) const { return names_.value(variable); }
    [[nodiscard]] const QMap<QString, QString>& all() const { return names_; }

private:
    QString path_;
    QMap<QString, QString> names_;
};

/// `A,166`, the key of a name.
[[nodiscard]] QString variableKey(char unit, int variable);

}  // namespace pmts::app
