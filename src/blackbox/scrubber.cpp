#include "pmts/blackbox/scrubber.hpp"

#include <QCborArray>
#include <QCborMap>
#include <QRegularExpression>
#include <QUrl>

#include <algorithm>

namespace pmts::blackbox {
namespace {

bool isPartOfWord(const QString& text, qsizetype at) {
    return at >= 0 && at < text.size() && (text[at].isLetterOrNumber() || text[at] == u'_');
}

QString withRule(QString text, const QString& wanted, const QString& instead, bool whole_word) {
    for (qsizetype at = text.indexOf(wanted, 0, Qt::CaseInsensitive); at >= 0;
         at = text.indexOf(wanted, at, Qt::CaseInsensitive)) {
        if (whole_word && (isPartOfWord(text, at - 1) || isPartOfWord(text, at + wanted.size()))) {
            ++at;
            continue;
        }
        text.replace(at, wanted.size(), instead);
        at += instead.size();
    }
    return text;
}

/// Addresses of cameras carry a name and a password, in front of the host or behind it. A password may hold `@` and `/`.
QString withoutLogins(QString text) {
    static const QRegularExpression kBeforeHost(QStringLiteral(R"(//(?:[^\s/:@]+:[^\s"“”]*|[^\s/"“”]*)@)"));
    static const QRegularExpression kBehindHost(
        QStringLiteral(R"(\b(usr|user|username|login|pwd|pass|passwd|password|token)=[^&\s"“”]+)"),
        QRegularExpression::CaseInsensitiveOption);
    return text.replace(kBeforeHost, QStringLiteral("//<login>@")).replace(kBehindHost, QStringLiteral("\\1=<login>"));
}

/// Of `/mnt/Anna Beispiel/plan.csv` the last part stays. Folders of the system say nothing about anybody; names may hold
/// single blanks; what follows `>` is below a folder that is hidden already.
QString withoutFolders(QString text) {
    static const QRegularExpression kFolders(
        QStringLiteral(R"((?<![\w>.\]~%-])(?:(?<!/)|(?<=file://))/(?!(?:dev|usr|etc|proc|sys|lib\w*|s?bin)/))"
                       R"((?:[^/\s"“”<>|]++(?: [^/\s"“”<>|]++)*+/)++)"),
        QRegularExpression::UseUnicodePropertiesOption);
    return text.contains(u'/') ? text.replace(kFolders, QStringLiteral("<folder>/")) : text;
}

}  // namespace

void Scrubber::hide(const QString& text, const QString& instead) {
    if (text.size() < 2) {
        return;
    }
    add({.text = text, .instead = instead, .whole_word = false});
    const QString encoded = QString::fromLatin1(QUrl::toPercentEncoding(text, "/"));
    if (encoded != text) {
        add({.text = encoded, .instead = instead, .whole_word = false});
    }
}

void Scrubber::hideWord(const QString& word, const QString& instead) {
    if (!word.isEmpty()) {
        add({.text = word, .instead = instead, .whole_word = true});
    }
}

void Scrubber::add(Rule rule) {
    const auto shorter = std::find_if(rules_.begin(), rules_.end(),
                                      [&rule](const Rule& other) { return other.text.size() < rule.text.size(); });
    rules_.insert(shorter, std::move(rule));
}

QString Scrubber::scrubbed(QString text) const {
    text = withoutLogins(std::move(text));
    for (const Rule& rule : rules_) {
        text = withRule(std::move(text), rule.text, rule.instead, rule.whole_word);
    }
    return withoutFolders(std::move(text));
}

/// As UTF-8 where it is that, else byte by byte: both ways back are without loss.
QByteArray Scrubber::scrubbedBytes(const QByteArray& bytes) const {
    const QString text = QString::fromUtf8(bytes);
    return text.toUtf8() == bytes ? scrubbed(text).toUtf8() : scrubbed(QString::fromLatin1(bytes)).toLatin1();
}

QCborValue Scrubber::scrubbed(const QCborValue& value) const {
    if (value.isString()) {
        return scrubbed(value.toString());
    }
    if (value.isByteArray()) {
        return scrubbedBytes(value.toByteArray());
    }
    if (value.isArray()) {
        QCborArray array;
        for (const QCborValue& item : value.toArray()) {
            array.append(scrubbed(item));
        }
        return array;
    }
    if (value.isMap()) {
        QCborMap map;
        for (const auto& [key, item] : value.toMap()) {
            map.insert(scrubbed(QCborValue(key)), scrubbed(QCborValue(item)));
        }
        return map;
    }
    return value;
}

}  // namespace pmts::blackbox
