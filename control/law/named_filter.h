#pragma once

#include "control/law/filtered_law.h"

namespace halbench::control {

/// The lead, lag, notch or low-pass that a section of the board is, when its coefficients are those of one
/// to single precision; else the section itself. Inverse of `filterSections`: with s' = d/(d + 2) Tustin's
/// rule is s = (w/tan(w T/2)) s', so that the roots of the section in s' tell the figures. Those are taken
/// with the fewest digits that give the same coefficients in single precision.
LoopFilter namedFilter(const LawSection<double>& section, double period_s);

/// Whether two sections are the same one once the board has them.
bool isSameOnBoard(const LawSection<double>& one, const LawSection<double>& other);

} // namespace halbench::control
