#pragma once

#include "pmts/core/angle_text.hpp"
#include "pmts/core/length_text.hpp"
#include "pmts/core/result.hpp"

#include <QStringView>

#include <functional>

namespace pmts::core {

/// Reads one quantity without operators (`12.5 gon`, `5'`, `1.6`) into the base unit of its field.
using ReadQuantity = std::function<Result<double>(QStringView)>;

/// Evaluates + - * / and ( ) or [ ] over quantities, in the base unit: `12.5 gon + 5'`, `2*(1.5+0.3)`, `3 m /
/// 4`. Ordinary precedence, left to right. A number without a unit is a factor beside * and /, and has the
/// field's unit beside a quantity under + and -, or when it is the answer. Quantity times quantity, a number
/// divided by a quantity and an answer that is a bare ratio (`6 m / 2 m`) are refused. Fails with
/// ErrorKind::kBadInput: a sentence with the character's position, counted from 1.
[[nodiscard]] Result<double> evaluateQuantity(QStringView text, const ReadQuantity& read);

/// What a field of angles understands: angleFromText() with arithmetic.
[[nodiscard]] Result<Angle> angleFromExpression(QStringView text, AngleUnit default_unit);

/// What a field of lengths understands: lengthFromText() with arithmetic; metres.
[[nodiscard]] Result<double> lengthFromExpression(QStringView text, LengthUnit default_unit);

/// What a field of plain numbers (ppm, deg C, mbar) understands.
[[nodiscard]] Result<double> numberFromExpression(QStringView text);

}  // namespace pmts::core
