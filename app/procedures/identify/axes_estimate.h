#pragma once

#include "app/procedures/identify/axes_identification.h"
#include "app/procedures/identify/axis_motion.h"

#include <optional>

namespace halbench::app {

/// Model, absolute constants and verdict from the fits of the axes, one after the other.
class AxesEstimate {
public:
    explicit AxesEstimate(std::optional<double> mass_kg) : m_mass_kg(mass_kg) {}

    void add(const devices::AxisSpec& axis, const Result<AxisFit>& fit, const MeasuredTiming& timing);
    /// The axes are independent: their joint covariance has one block each.
    AxesIdentifyResult result() &&;

private:
    void addCovariance(const std::string& axis, const AxisFit& fit);
    void addConstants(const devices::AxisSpec& axis, const AxisFit& fit);
    void judge(const IdentifiedAxis& axis, const AxisFit& fit);

    std::optional<double> m_mass_kg;
    AxesIdentifyResult m_result;
    std::vector<AxisFit> m_fits;
};

} // namespace halbench::app
