#pragma once

#include "app/documents/result_header.h"
#include "app/procedures/calibrate/calibrate_procedure.h"

#include <string>

namespace halbench::app {

/// CAL.json with everything it shows: figures, proposed values, findings, provenance.
struct CalibrationRecord {
    ResultHeader header;
    CalibrateResult result;
};

/// `origin` names the text in messages. Errors: as of parseCalibration().
Result<CalibrationRecord> parseCalibrationRecord(const std::string& text, const std::string& origin);

} // namespace halbench::app
