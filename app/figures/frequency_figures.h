#pragma once

#include "app/procedures/frequency/frequency_procedure.h"
#include "app/procedures/frequency/measured_loop.h"
#include "widgets/figure/figure.h"

#include <optional>

namespace halbench::app {

/// The pictures of a frequency response, in a report and in the window alike.

/// What of it is drawn.
enum class FrequencyView { OpenLoop, Plant, ClosedLoop };

/// Magnitude, phase and coherence over one frequency axis. Points of too little coherence are hollow; dotted
/// lines hold the 95 % of the others, a dashed one is the rotor that fits. Margins that are not withheld are
/// marked in the open loop.
widgets::Figure frequencyFigure(const FrequencyResult& result, FrequencyView view);

/// Reference speed, speed and current as recorded; nothing without rows.
std::optional<widgets::Figure> excitationFigure(const FrequencyResult& result);
/// The same of any record with reference, speed and current.
std::optional<widgets::Figure> excitationFigure(const Recording& recording);

} // namespace halbench::app
