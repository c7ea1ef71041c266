#pragma once

#include <QString>

namespace halbench::widgets {

/// The same words for a line that may be wrapped, but neither at their spaces nor at a slash: a number stays
/// with its unit, and "r/min" in one piece.
QString unbroken(QString text);

/// A sentence that may be wrapped anywhere but between a number and its unit.
QString withUnitsKept(QString sentence);

} // namespace halbench::widgets
