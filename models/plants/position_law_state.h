#pragma once

#include "models/htm/htm_ideal_loop.h"

#include <array>

namespace halbench::models {

/// What the board's position law remembers between its samples; angles from where the rotor was when the loop
/// began, at rest.
class PositionLawState {
public:
    explicit PositionLawState(const PositionLaw& law) : m_law(law) {}

    /// The current that flows from this sample on. Call once a period.
    double step(const ReferencePoint& reference, double angle_rad);

private:
    double positional_A(const ReferencePoint& reference, double angle_rad, double error_rad);
    double literal_A(double error_rad);

    PositionLaw m_law;
    double m_integral_A = 0.0;
    double m_previousAngle_rad = 0.0;
    double m_previousError_rad = 0.0;
    double m_memory_A = 0.0;
    std::array<double, 2> m_delayed_A{};
    bool m_hasPrevious = false;
};

} // namespace halbench::models
