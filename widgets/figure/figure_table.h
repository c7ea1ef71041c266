#pragma once

#include "widgets/figure/figure.h"

#include <string>

namespace halbench::widgets {

/// The numbers that a figure is drawn from, as a comma separated table: for each curve a column of its
/// horizontal and one of its vertical values (and of the parameter where it has one), titled `curve quantity
/// [unit]`. A band gives its lower and its upper edge over one horizontal column. Curves that share their
/// horizontal values share the column; the first of an axis bears no curve's name. Numbers have every digit,
/// what is not finite is left empty, shorter columns end earlier.
std::string figureTable(const Figure& figure);

} // namespace halbench::widgets
