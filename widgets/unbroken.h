#pragma once

#include <QString>

namespace halbench::widgets {

/// The same words for a line that may be wrapped, but neither at their spaces nor at a slash: a number stays
/// with its unit, and "r/min" in one piece.
QString unbroken(QString text);

} // namespace halbench::widgets
