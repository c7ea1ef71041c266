#pragma once

#include "app/documents/result_header.h"
#include "devices/formats/csv_import.h"
#include "devices/recording/recording_meta.h"

#include <string>

namespace halbench::app {

/// Data quality of an imported recording: units that are not known, steps of the time that differ, rows
/// that are missing. `import` may be absent: before anything was read.
DataQuality qualityOf(const devices::CsvPlan& plan, const devices::CsvImport* import);

/// halbench.import/1: dialect, columns, first lines, questions, and what was read.
JsonValue importDocument(const ResultHeader& header, const devices::CsvPlan& plan,
                         const devices::CsvImport* import);

/// What the sidecar of an imported recording says: nothing is known of its device.
devices::RecordingMeta importedMeta(const ResultHeader& header, const Recording& recording);

/// The same for people, before anything was read.
std::string previewText(const devices::CsvPlan& plan);

} // namespace halbench::app
