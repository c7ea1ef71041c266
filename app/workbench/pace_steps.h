#pragma once

#include <QString>

#include <vector>

class QWidget;

namespace halbench::app {

class Workbench;

/// Device seconds per wall second that can be chosen, from the slowest; 0, the last, is virtual time.
const std::vector<double>& paceSteps();

/// "10 times slower", "real time", "20 times"
QString paceWords(double speed_ratio);

/// The next slower or faster step of a speed that need be none of them; at the end the same. Virtual time is
/// faster than all and is not reached by steps.
double slowerPace(double speed_ratio);
double fasterPace(double speed_ratio);

/// Whether the time of what is connected can be paced now: simulated or replayed, and no procedure runs.
bool canBePaced(Workbench& bench);

/// Less and greater as keys of that panel.
void addPaceKeys(Workbench& bench, QWidget& panel);

} // namespace halbench::app
