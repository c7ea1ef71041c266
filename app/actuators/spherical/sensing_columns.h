#pragma once

#include "control/base/result.h"
#include "control/base/sample_block.h"
#include "control/base/unit_conversion.h"

#include <string>
#include <vector>

namespace halbench::app {

/// A column of a recording, and the way to the unit that it is wanted in.
struct SensingColumn {
    std::size_t index = 0;
    UnitConversion toUnit;

    std::vector<double> values(const Recording& recording) const;
};

enum class ColumnsWithoutUnit { Refused, Taken };

/// Names of all columns with their units, for messages: "time, field_0_r [mT]".
std::string columnNames(const Recording& recording);

/// The column of a signal as sidecars ("field.0.r"), plain columns ("field_0_r") and other tools
/// ("field_0_r_mT", "field.0.r [mT]") name it. A column in a unit of another quantity is refused unless there
/// is one that fits. What stands behind a name and is no unit makes another name: `coil_current_set`. Errors:
/// UnknownName with the columns that there are, InvalidInput for another unit.
Result<SensingColumn> sensingColumn(const Recording& recording, const std::string& name,
                                    const std::string& unit, ColumnsWithoutUnit withoutUnit);

} // namespace halbench::app
