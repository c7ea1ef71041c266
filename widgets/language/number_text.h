#pragma once

#include <QString>

class QWidget;

namespace halbench::widgets {

/// Why parseNumber() (display_units.h) refuses a text and what it takes instead, in one sentence; empty when
/// it does not refuse it.
QString numberProblem(const QString& text, const QString& unitText = {});

/// The same, but nothing while typing on can still make a number of it, as of "", "-", "1e" or "12 de" with
/// the unit "deg": what is half typed is no mistake yet.
QString typingProblem(const QString& text, const QString& unitText = {});

/// As a tooltip that breaks its lines: one long line would reach beyond the screen.
QString bubbleOf(const QString& words);
/// Says it in place, beside the field, without taking the focus; empty: takes it away.
void sayAt(QWidget& field, const QString& words);

} // namespace halbench::widgets
