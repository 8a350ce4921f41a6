#include "pmts/survey/point.hpp"

namespace pmts::survey {
namespace {

bool isDigit(QChar c) { return c >= u'0' && c <= u'9'; }

/// Decimal digits plus one; grows by a digit after 9, 99, ... Text, so that an ID of any length counts.
QString plusOne(QString digits) {
    for (qsizetype i = digits.size() - 1; i >= 0; --i) {
        if (digits[i] != u'9') {
            digits[i] = QChar(digits[i].unicode() + 1);
            return digits;
        }
        digits[i] = u'0';
    }
    return u'1' + digits;
}

}  // namespace

QString nextPointId(const QString& id) {
    qsizetype end = id.size();
    while (end > 0 && !isDigit(id[end - 1])) {
        --end;
    }
    if (end == 0) {
        return id + u'1';
    }
    qsizetype begin = end;
    while (begin > 0 && isDigit(id[begin - 1])) {
        --begin;
    }
    return id.left(begin) + plusOne(id.mid(begin, end - begin)) + id.mid(end);
}

QString freePointId(QString id, const std::function<bool(const QString&)>& is_used) {
    while (is_used(id)) {
        id = nextPointId(id);
    }
    return id;
}

}  // namespace pmts::survey
