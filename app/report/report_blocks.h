#pragma once

#include "app/report/report.h"

#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// Ready-made blocks for what nearly every report shows.

/// A number with six significant digits, or so many that the interval's half-width shows two; '-' for a
/// missing one.
std::string reportNumber(std::optional<double> value);
std::string reportNumber(double value, double halfWidth);

/// One identified, given or not identifiable quantity.
struct ReportEstimate {
    std::string name; ///< in words, e.g. "viscous damping c"
    std::string unit;
    std::optional<double> value;
    std::optional<double> ci95Low;
    std::optional<double> ci95High;
    std::string source; ///< "identified", "given", "not identifiable"
};
ReportTable estimateTable(const std::string& caption, const std::vector<ReportEstimate>& estimates);

/// One check of an experiment; a missing value fails and says so.
struct ReportCheck {
    std::string quantity;
    std::string unit;
    std::optional<double> value;
    std::optional<double> min;
    std::optional<double> max;
    bool passed = false;
};
ReportTable checkTable(const std::vector<ReportCheck>& checks);

/// Name, value and unit; e.g. gains, or parameters at start.
struct ReportQuantity {
    std::string name;
    std::optional<double> value;
    std::string unit;
};
ReportTable quantityTable(const std::string& caption, const std::vector<ReportQuantity>& quantities);

/// A parameter before and after a step.
struct ReportChange {
    std::string name;
    std::string unit;
    double before = 0.0;
    double after = 0.0;
};
/// More than the rounding of a board's single-precision number.
bool differs(const ReportChange& change);
ReportTable changeTable(const std::string& caption, const std::vector<ReportChange>& changes);

} // namespace halbench::app
