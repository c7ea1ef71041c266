#pragma once

#include "app/documents/axis_model_file.h"

namespace halbench::app {

/// The published platen as if it had been identified exactly: damping 0.1 N s/m and 1e-4 N m s, inertia
/// 1e-3 kg m^2 (resources/help/planar-theory.md section 3).
inline AxisModelFile platenModelFile(double mass_kg = 0.64) {
    const auto known = [](double value, const char* unit) {
        return control::Estimate{value, std::pair(0.99 * value, 1.01 * value),
                                 control::EstimateSource::Identified, unit};
    };
    AxisModelFile file;
    file.header.schema = AxisModelSchema;
    file.header.device.emplace();
    file.header.device->model = "planar";
    for (const char* axis : {"x", "y"}) {
        file.model.axes.push_back({axis, "m", "N", known(0.1 / mass_kg, "1/s"),
                                   known(1.0 / mass_kg, "m/(s^2*N)"), known(0.0, "N"),
                                   MeasuredTiming{1e-3, 1}});
    }
    file.model.axes.push_back({"phi", "rad", "N*m", known(0.1, "1/s"), known(1e3, "rad/(s^2*N*m)"),
                               known(0.0, "N*m"), MeasuredTiming{1e-3, 1}});
    return file;
}

} // namespace halbench::app
