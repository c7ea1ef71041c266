#include "app/workbench/signals/reference_hold.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace halbench::app {

namespace {

constexpr int FramesToBegin = 15; ///< of 33 ms

} // namespace

void ReferenceHold::clear() {
    *this = ReferenceHold();
}

void ReferenceHold::begin() {
    m_hasRun = true;
    m_expected = FramesToBegin;
}

void ReferenceHold::look(const control::SampleHistory& history, bool isArmed,
                         std::optional<double> origin_rad, double setpoint_rad,
                         const std::string& referenceName) {
    const auto running = history.latest("reference.running");
    const bool wasRunning = m_isRunning;
    m_isRunning = isArmed && running && running->value > 0.5;
    m_hasRun = m_hasRun || m_isRunning;
    m_expected = m_isRunning || !isArmed ? 0 : std::max(m_expected - 1, 0);
    const auto reference = history.latest(referenceName);
    // Once more after its end: the last sample before may be older.
    if ((m_isRunning || wasRunning) && isArmed && origin_rad && reference &&
        std::isfinite(reference->value)) {
        m_angle_rad = reference->value - *origin_rad - setpoint_rad;
    }
}

bool continuesReference(const std::string& firmware) {
    int major = 0;
    int minor = 0;
    int patch = 0;
    char dash = 0;
    const int found = std::sscanf(firmware.c_str(), "%3d.%3d.%3d%c", &major, &minor, &patch, &dash);
    return found == 4 && dash == '-' && (major > 0 || minor >= 2);
}

} // namespace halbench::app
