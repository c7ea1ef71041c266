#pragma once

#include "app/documents/result_header.h"
#include "app/procedures/identify/identify_procedure.h"
#include "app/workbench/display_quantity.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/controls/verdict_view.h"

#include <QString>

#include <vector>

namespace halbench::app {

/// Texts of the window about the result of a procedure; pure functions of values.

/// Travel, speed, time and temperature of the sweep, before anything moves.
struct SweepOutlook {
    IdentifyPrediction prediction;
    double largestSpeed_rad_s = 0.0;
    double turns = 0.0; ///< all directions together, roughly
};
/// For the published motor, as long as no other is known.
SweepOutlook sweepOutlook(const IdentifyConfig& config, double start_degC);
QString outlookText(const IdentifyConfig& config, const SweepOutlook& outlook, const DisplayUnits& units);

/// One estimate; its interval only where it was identified.
widgets::EstimateRow estimateRow(const QString& name, const control::Estimate& estimate);
/// The four constants, then the ratios that need no given constant.
std::vector<widgets::EstimateRow> estimateRows(const IdentifyResult& result);
/// "Good: ..." in one line.
QString verdictTitle(const DataQuality& quality);

/// Remedy for the constants that could not be identified (resources/help/identification.md section
/// 1); empty when nothing is missing.
QString missingText(const IdentifyResult& result);

/// That K_f/phi is not the current that Calibrate finds, with a link to the help; empty without K_f/phi.
QString frictionNote(const IdentifyResult& result);

/// Device, firmware, overrides, software, seed, start on the wall's clock and device time that it took.
QString provenanceText(const ResultHeader& header, double duration_s,
                       std::optional<double> highestTemperature_degC);
/// That it came with the project: when it was identified, and on which device.
QString projectModelText(const ResultHeader& header);
/// Whether it took place in virtual time, which knows no date.
bool isOfVirtualTime(const ResultHeader& header);
/// Whether the device that is connected is the one of the project's result; nothing is connected without it.
QString projectDeviceText(const ResultHeader& header, const devices::DeviceInfo* connected);

/// What is wrong and, where there is one, the remedy behind an arrow.
QString problemText(const Error& error);

} // namespace halbench::app
