#include "pmts/core/quantity_expression.hpp"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pmts::core {
namespace {

QString tr(const char* sentence) { return QCoreApplication::translate("pmts::core", sentence); }

/// Operators as people write them, reduced to the four of the keyboard; as long as the text.
QString plainOperators(QStringView text) {
    QString plain = text.toString();
    plain.replace(QChar(0x2212), u'-');
    plain.replace(QChar(0x00D7), u'*').replace(QChar(0x22C5), u'*').replace(QChar(0x00B7), u'*');
    plain.replace(QChar(0x00F7), u'/').replace(QChar(0x2215), u'/');
    return plain;
}

/// A number without any unit; the decimal comma counts as a point.
std::optional<double> bareNumber(QStringView token) {
    static const QRegularExpression form(QStringLiteral(R"(^(\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d+)?$)"));
    if (!form.match(token.toString()).hasMatch()) {
        return std::nullopt;
    }
    return token.toString().replace(u',', u'.').toDouble();
}

/// What a part of the expression is worth, and as what.
struct Value {
    enum class Kind {
        kBare,  ///< typed without a unit: a number, or a quantity in the field's unit, as its neighbours need
        kNumber,    ///< the ratio of two quantities: never a quantity again by itself
        kQuantity,  ///< in the base unit
    };
    Kind kind = Kind::kBare;
    double amount = 0.0;

    [[nodiscard]] bool isQuantity() const { return kind == Kind::kQuantity; }
};

/// Recursive descent over
///     sum = product { (+|-) product }    product = signed { (*|/) signed }    signed = [+|-] (token |
///     bracket)
class Evaluator {
public:
    Evaluator(const QString& text, const ReadQuantity& read) : text_(text), read_(read) {}

    Result<double> answer() {
        const auto value = sum();
        if (!value) {
            return tl::unexpected(value.error());
        }
        if (here() != kEnd) {
            return here() == u')' || here() == u']' ? wrong(tr("a bracket is closed that was never opened"))
                                                    : wrong(tr("an operator is missing"));
        }
        if (value->kind == Value::Kind::kNumber) {
            at_ = 0;
            return wrong(tr("the result is a plain ratio; a quantity was expected"));
        }
        const auto quantity = asQuantity(*value);
        if (quantity && !std::isfinite(quantity->amount)) {
            at_ = 0;
            return wrong(tr("the result is too large"));
        }
        return quantity.map([](const Value& v) { return v.amount; });
    }

private:
    static constexpr char16_t kEnd = 0;
    static constexpr int kDeepest = 100;

    [[nodiscard]] char16_t here() {
        while (at_ < text_.size() && text_[at_].isSpace()) {
            ++at_;
        }
        return at_ < text_.size() ? text_[at_].unicode() : kEnd;
    }

    [[nodiscard]] tl::unexpected<Error> wrong(const QString& what) const {
        return fail(ErrorKind::kBadInput,
                    tr("\"%1\" cannot be worked out: at character %2, %3.").arg(text_).arg(at_ + 1).arg(what),
                    tr("Numbers may be joined by + - * / and brackets, for example 2*(1.5+0.3)."));
    }

    Result<Value> sum() {
        auto left = product();
        while (left && (here() == u'+' || here() == u'-')) {
            const qsizetype operator_at = at_;
            const double sign = text_[at_++] == u'-' ? -1.0 : 1.0;
            const auto right = product();
            left = right ? added(*left, *right, sign, operator_at) : right;
        }
        return left;
    }

    Result<Value> product() {
        auto left = signedPart();
        while (left && (here() == u'*' || here() == u'/')) {
            const qsizetype operator_at = at_;
            const bool divides = text_[at_++] == u'/';
            auto right = signedPart();
            if (!right) {
                return right;
            }
            left = divides ? divided(*left, *right, operator_at) : multiplied(*left, *right, operator_at);
        }
        return left;
    }

    Result<Value> signedPart() {
        const char16_t sign = here();
        if (sign == u'+' || sign == u'-') {
            ++at_;
        }
        auto value = part();
        if (value && sign == u'-') {
            value->amount = -value->amount;
        }
        return value;
    }

    Result<Value> part() {
        const char16_t first = here();
        if (first == u'(' || first == u'[') {
            return bracket(first == u'(' ? u')' : u']');
        }
        return token();
    }

    Result<Value> bracket(char16_t closing) {
        if (++depth_ > kDeepest) {
            return wrong(tr("there are too many brackets inside one another"));
        }
        ++at_;
        auto inside = sum();
        if (!inside) {
            return inside;
        }
        if (here() != closing) {
            return wrong(here() == kEnd                     ? tr("a bracket is not closed")
                         : here() == u')' || here() == u']' ? tr("the wrong kind of bracket is closed")
                                                            : tr("an operator is missing"));
        }
        ++at_;
        --depth_;
        return inside;
    }

    Result<Value> token() {
        (void)here();
        const qsizetype from = at_;
        while (at_ < text_.size() && !endsToken(from)) {
            ++at_;
        }
        const QStringView typed = QStringView(text_).mid(from, at_ - from).trimmed();
        if (typed.isEmpty()) {
            return wrong(tr("a number is missing"));
        }
        if (const auto number = bareNumber(typed)) {
            return Value{Value::Kind::kBare, *number};
        }
        const auto quantity = read_(typed);
        if (!quantity) {
            at_ = from;
            return wrong(tr("\"%1\" is not understood").arg(typed));
        }
        return Value{Value::Kind::kQuantity, *quantity};
    }

    /// At an operator or bracket; the sign of an exponent (`1e-3`) is none.
    [[nodiscard]] bool endsToken(qsizetype from) const {
        if (!QStringLiteral("+-*/()[]").contains(text_[at_])) {
            return false;
        }
        static const QRegularExpression mantissa(QStringLiteral(R"(^(\d+[.,]?\d*|[.,]\d+)[eE]$)"));
        const bool sign = text_[at_] == u'+' || text_[at_] == u'-';
        return !sign || !mantissa.match(text_.mid(from, at_ - from)).hasMatch();
    }

    Result<Value> asQuantity(const Value& value) {
        if (value.isQuantity()) {
            return value;
        }
        const auto one = read_(u"1");
        return one.map([&](double amount) { return Value{Value::Kind::kQuantity, value.amount * amount}; });
    }

    Result<Value> added(const Value& a, const Value& b, double sign, qsizetype operator_at) {
        if (a.isQuantity() != b.isQuantity()) {
            if ((a.isQuantity() ? b : a).kind == Value::Kind::kNumber) {
                at_ = operator_at;
                return wrong(tr("a quantity and a plain ratio cannot be added"));
            }
            const auto left = asQuantity(a);
            const auto right = asQuantity(b);
            if (!left || !right) {
                return left ? right : left;
            }
            return Value{Value::Kind::kQuantity, left->amount + sign * right->amount};
        }
        return Value{std::max(a.kind, b.kind), a.amount + sign * b.amount};
    }

    Result<Value> multiplied(const Value& a, const Value& b, qsizetype operator_at) {
        if (a.isQuantity() && b.isQuantity()) {
            at_ = operator_at;
            return wrong(tr("two quantities with units cannot be multiplied"));
        }
        return Value{std::max(a.kind, b.kind), a.amount * b.amount};
    }

    Result<Value> divided(const Value& a, const Value& b, qsizetype operator_at) {
        if (b.amount == 0.0) {
            at_ = operator_at;
            return wrong(tr("something is divided by zero"));
        }
        if (b.isQuantity() && !a.isQuantity()) {
            at_ = operator_at;
            return wrong(tr("a plain number cannot be divided by a quantity with a unit"));
        }
        const auto kind = b.isQuantity() ? Value::Kind::kNumber : std::max(a.kind, b.kind);
        return Value{kind, a.amount / b.amount};
    }

    const QString& text_;
    const ReadQuantity& read_;
    qsizetype at_ = 0;
    int depth_ = 0;
};

}  // namespace

Result<double> evaluateQuantity(QStringView text, const ReadQuantity& read) {
    const QString plain = plainOperators(text);
    return Evaluator(plain, read).answer();
}

Result<Angle> angleFromExpression(QStringView text, AngleUnit default_unit) {
    if (auto single = angleFromText(text, default_unit)) {
        return single;
    }
    const auto gon = evaluateQuantity(text, [default_unit](QStringView quantity) {
        return angleFromText(quantity, default_unit).map([](Angle angle) { return angle.gon(); });
    });
    return gon.map([](double value) { return Angle::fromGon(value); });
}

Result<double> lengthFromExpression(QStringView text, LengthUnit default_unit) {
    if (auto single = lengthFromText(text, default_unit)) {
        return single;
    }
    return evaluateQuantity(
        text, [default_unit](QStringView quantity) { return lengthFromText(quantity, default_unit); });
}

Result<double> numberFromExpression(QStringView text) {
    return evaluateQuantity(text, [](QStringView quantity) -> Result<double> {
        if (const auto number = bareNumber(quantity)) {
            return *number;
        }
        return fail(ErrorKind::kBadInput, tr("\"%1\" is not a number.").arg(quantity));
    });
}

}  // namespace pmts::core
