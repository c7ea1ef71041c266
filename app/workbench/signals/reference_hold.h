#pragma once

#include "control/history/sample_history.h"

#include <optional>
#include <string>

namespace halbench::app {

/// The angle at which a reference in position mode stands or is held: what the board adds to the set-point
/// (resources/help/monitor.md, "Reference generator"). Read from the samples while it runs; it stays when the
/// reference has ended.
class ReferenceHold {
public:
    /// A mode was entered: nothing is held.
    void clear();
    /// A start is sent: it counts as running until the samples of the next half second say otherwise.
    void begin();
    /// Newest samples; in position mode with what its set-point counts from.
    void look(const control::SampleHistory& history, bool isArmed, std::optional<double> origin_rad,
              double setpoint_rad, const std::string& reference = "reference");

    bool isRunning() const { return m_isRunning || m_expected > 0; }
    /// A reference ran since clear().
    bool hasRun() const { return m_hasRun; }
    double angle_rad() const { return m_angle_rad; }

private:
    bool m_isRunning = false;
    int m_expected = 0; ///< looks that a start may take to be seen
    bool m_hasRun = false;
    double m_angle_rad = 0.0;
};

/// Whether a board begins the next reference at the angle that is held. Before 0.2.0 the board's library (its
/// EPK begins with the version) counted every start from where the mode was entered: a leap. Of a board that
/// does not say its version it is not known either.
bool continuesReference(const std::string& firmware);

} // namespace halbench::app
