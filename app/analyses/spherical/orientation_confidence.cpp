#include "app/analyses/spherical/orientation_confidence.h"

#include "app/documents/calibration_file.h"
#include "app/documents/text/output_file.h"
#include "control/base/distributions.h"

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

constexpr double Unlikely = 0.01;
constexpr double MicroTesla = 1e6;

/// What a calibration leaves out is as on the device of the readings.
SensingBoard boardWith(const AnalysisValues& given, const std::vector<ParameterValue>& calibrated) {
    std::vector<ParameterValue> values = given.device.value_or(std::vector<ParameterValue>());
    values.insert(values.end(), calibrated.begin(), calibrated.end());
    return notedSensingBoard(values);
}

/// The values of a calibration, of a step or a file.
Result<SensingBoard> calibratedBoard(const AnalysisValues& given, const std::string& path) {
    if (given.calibrated) {
        return boardWith(given, *given.calibrated);
    }
    const Result<std::string> text = readFile(path);
    if (!text) {
        return failure(text.error());
    }
    const Result<CalibrationRecord> record = parseCalibrationRecord(*text, path);
    if (!record) {
        return failure(record.error());
    }
    const std::vector<ParameterValue>& values = record->result.proposed;
    const bool isOfSensors = std::any_of(values.begin(), values.end(),
                                         [](const auto& value) { return value.name == "sensor.gain_1"; });
    if (!isOfSensors) {
        return failure(ErrorCode::InvalidInput, path + ": holds no calibration of nine field readings",
                       "make one with halbench calibrate DEVICE hall --out CAL.json");
    }
    return boardWith(given, values);
}

/// Terms without amplitude cost time and change nothing.
void dropSilentTerms(models::RotorFieldConfig& field) {
    std::erase_if(field.harmonics, [](const auto& term) { return term.amplitude_T == 0.0; });
}

} // namespace

std::vector<AnalysisKey> confidenceKeys() {
    using enum AnalysisKeyType;
    return {
        {"noise_uT", Number, 1e-3, 1e5, "",
         "noise of a reading, rms; default 100, or what the calibration found"},
        {"tolerance", Choice, 0, 0, "assembly|none",
         "errors of sensors without a calibration that cone and intervals hold: gains 1 %, offsets 1 mT, "
         "frames 1 degree, places 0.1 mm, or none; default assembly"},
        {"calibration", Text, 0, 0, "",
         "result of 'calibrate' that corrects the readings: a file, in an experiment also a step"},
    };
}

Result<OrientationConfidence> OrientationConfidence::make(const AnalysisValues& values,
                                                          const PlacementChoice& choice) {
    if (const std::string path = values.text("calibration"); !path.empty()) {
        if (!values.text("placement").empty() || !values.text("harmonics").empty() ||
            !values.text("frames").empty() || values.number("radius_mm") || values.number("q_T")) {
            return failure(
                ErrorCode::Usage,
                "a calibration says itself where the sensors are, how strong the field is and which "
                "harmonics it has",
                "leave --placement, --frames, --radius-mm, --q-T and --harmonics out");
        }
        const Result<SensingBoard> board = calibratedBoard(values, path);
        if (!board) {
            return failure(board.error());
        }
        return ofBoard(values, *board);
    }
    if (const std::optional<SensingBoard> board = chosenBoard(values);
        board && values.text("harmonics").empty()) {
        OrientationConfidence confidence = ofBoard(values, *board);
        if (values.text("tolerance") == "none") {
            confidence.m_tolerance_T = 0.0;
        }
        return confidence;
    }
    models::RotorFieldConfig field;
    field.strength_T = choice.device.strength_T;
    field.harmonics = models::harmonicPreset(static_cast<models::HarmonicPreset>(
        choiceIndex(std::array<std::string_view, 3>{"none", "h1", "h2"}, values.text("harmonics"))));
    OrientationConfidence confidence(models::nominalCalibration(choice.poses(), field));
    confidence.m_deviation_T = noiseChoice_T(values);
    if (values.text("tolerance") != "none") {
        confidence.m_remaining.emplace(confidence.m_calibration,
                                       models::assemblyRemainder(confidence.m_calibration, {}),
                                       values.isSet("stray"));
        confidence.m_tolerance_T = confidence.m_remaining->readingDeviation_T();
    }
    return confidence;
}

OrientationConfidence OrientationConfidence::ofBoard(const AnalysisValues& values,
                                                     const SensingBoard& board) {
    OrientationConfidence confidence(board.calibration);
    dropSilentTerms(confidence.m_calibration.field);
    confidence.m_deviation_T = values.numberOr("noise_uT", MicroTesla * board.deviation_T) / MicroTesla;
    confidence.m_tolerance_T = board.tolerance_T;
    return confidence;
}

models::SphericalSensing OrientationConfidence::sensing(double deviation_T) const {
    return models::sensingOf(m_calibration, deviation_T);
}

models::SphericalReadings OrientationConfidence::corrected_T(models::SphericalReadings readings_T,
                                                             const models::ChannelMask& used,
                                                             double coilCurrent_A) const {
    for (std::size_t c = 0; c < used.size(); ++c) {
        const auto row = static_cast<Eigen::Index>(c);
        if (!used[c]) { // no field: it must not reach the other axes of its sensor
            readings_T[row] = m_calibration.sensors[c / 3].offset_T[row % 3] +
                              coilCurrent_A * m_calibration.coil_T_per_A[row];
        }
    }
    return models::correctedReadings_T(m_calibration, readings_T, coilCurrent_A);
}

double OrientationConfidence::errorShare() const {
    return std::pow(m_tolerance_T / m_deviation_T, 2);
}

Eigen::Matrix3d OrientationConfidence::covariance_rad2(const models::OrientationEstimate& estimate) const {
    const double share = errorShare();
    Eigen::Matrix3d covariance = estimate.covariance_rad2;
    if (estimate.freedom > 0 &&
        control::chiSquareTail(estimate.chiSquare / (1.0 + share), estimate.freedom) < Unlikely) {
        covariance *= estimate.chiSquare / estimate.freedom - share;
    }
    if (m_remaining) {
        return covariance + m_remaining->covariance_rad2(estimate.rotation);
    }
    // What a calibration leaves is mostly a rotation of all sensors, alike about every axis: that of the
    // shaft's tilt.
    const Eigen::Matrix<double, 3, 2> across = estimate.rotation.leftCols<2>();
    const double tilt_rad2 = 0.5 * share * (across.transpose() * estimate.covariance_rad2 * across).trace();
    return covariance + tilt_rad2 * Eigen::Matrix3d::Identity();
}

} // namespace halbench::app
