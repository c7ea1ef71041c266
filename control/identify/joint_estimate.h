#pragma once

#include "control/base/result.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::control {

/// Constants that the user knows, SI; taken as exact.
struct GivenConstants {
    std::optional<double> inertia_kg_m2;
    std::optional<double> viscousDamping_Nm_s;
    std::optional<double> coulombFriction_Nm;
    std::optional<double> torqueConstant_Nm_per_A;

    bool isEmpty() const {
        return !inertia_kg_m2 && !viscousDamping_Nm_s && !coulombFriction_Nm && !torqueConstant_Nm_per_A;
    }
};

enum class EstimateSource { Identified, Given, NotIdentifiable };

/// "identified", "given", "not identifiable"
const char* estimateSourceName(EstimateSource source);

/// A number with its 95 % interval, or the statement that the data do not hold it.
struct Estimate {
    std::optional<double> value;
    std::optional<std::pair<double, double>> interval95;
    EstimateSource source = EstimateSource::NotIdentifiable;
    std::string unit;
};

} // namespace halbench::control
