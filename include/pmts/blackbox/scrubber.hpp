#pragma once

#include <QByteArray>
#include <QCborValue>
#include <QString>

#include <utility>
#include <vector>

namespace pmts::blackbox {

/// Takes what says who and where somebody is out of texts: folders of the home, names of user and machine. Without any rule
/// it takes logins out of addresses, and of absolute paths everything but the last part (folders of the system stay).
class Scrubber {
public:
    /// Every place where the text stands; also percent-encoded. Longer ones first wins. Empty texts and `/` are passed over.
    void hide(const QString& text, const QString& instead);
    /// Only where it stands as a word: a user called `log` must not take the log away.
    void hideWord(const QString& word, const QString& instead);

    [[nodiscard]] QString scrubbed(QString text) const;
    /// UTF-8 or bytes of the wire.
    [[nodiscard]] QByteArray scrubbedBytes(const QByteArray& bytes) const;
    /// Texts and byte strings in it, at any depth, also the keys.
    [[nodiscard]] QCborValue scrubbed(const QCborValue& value) const;

private:
    struct Rule {
        QString text;
        QString instead;
        bool whole_word = false;
    };
    void add(Rule rule);

    std::vector<Rule> rules_;  ///< the longest first
};

}  // namespace pmts::blackbox
