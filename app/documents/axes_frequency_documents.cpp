#include "app/documents/axes_frequency_documents.h"

#include "app/documents/document_parts.h"
#include "app/documents/frequency_parts.h"
#include "app/documents/text/numbers.h"
#include "control/base/units.h"
#include "control/lti/frequency_response.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace halbench::app {
namespace {

using Complex = std::complex<double>;

JsonValue matrixOf(const Eigen::MatrixXcd& value, const Eigen::MatrixXd& radius) {
    JsonValue rows = JsonValue::array();
    for (Eigen::Index i = 0; i < value.rows(); ++i) {
        JsonValue row = JsonValue::array();
        for (Eigen::Index j = 0; j < value.cols(); ++j) {
            row.push(circleBody(value(i, j), radius(i, j)));
        }
        rows.push(row);
    }
    return rows;
}

JsonValue figureOf(const control::LoopFigure& figure) {
    JsonValue body = JsonValue::object();
    body.set("re", figure.value.real()).set("im", figure.value.imag());
    return body.set("radius", figure.radius);
}

JsonValue sizeOf(const control::LoopFigure& figure) {
    JsonValue body = JsonValue::object();
    return body.set("value", figure.value.real()).set("radius", figure.radius);
}

JsonValue pointOf(const AxesFrequencyPoint& point) {
    JsonValue coherence = JsonValue::array();
    JsonValue used = JsonValue::array();
    JsonValue loops = JsonValue::array();
    JsonValue loci = JsonValue::array();
    for (std::size_t i = 0; i < point.isUsed.size(); ++i) {
        coherence.push(point.plant.coherence(static_cast<Eigen::Index>(i)));
        used.push(static_cast<bool>(point.isUsed[i]));
        loops.push(circleBody(point.loop.loops[i].value, point.loop.loops[i].radius));
        loci.push(figureOf(point.loop.loci[i]));
    }
    JsonValue entry = JsonValue::object();
    entry.set("frequency_hz", point.plant.frequency_rad_s / (2.0 * Pi));
    entry.set("coherence", coherence).set("used", used).set("averages", point.plant.averages);
    entry.set("plant", matrixOf(point.plant.value, point.plant.radius));
    entry.set("loops", loops).set("loci", loci);
    entry.set("sensitivity", sizeOf(point.loop.sensitivity));
    return entry.set("complementary_sensitivity", sizeOf(point.loop.complementary));
}

JsonValue peakOf(const MeasuredPeak& peak) {
    const bool isTold = peak.withheld == MeasuredPeak::Withheld::No;
    JsonValue interval;
    if (isTold) {
        interval = JsonValue::array();
        interval.push(std::max(0.0, peak.value - peak.radius)).push(peak.value + peak.radius);
    }
    JsonValue body = JsonValue::object();
    body.set("value", isTold ? JsonValue(peak.value) : JsonValue()).set("ci95", interval);
    body.set("frequency_rad_s", isTold ? JsonValue(peak.frequency_rad_s) : JsonValue());
    return body.set("withheld",
                    isTold ? JsonValue()
                           : JsonValue(peak.withheld == MeasuredPeak::Withheld::Edge ? "edge" : "no_point"));
}

JsonValue sectionsOf(const control::SampledPositionLaw& law) {
    JsonValue sections = JsonValue::array();
    for (const control::LawSection<double>& section : law.sections) {
        JsonValue entry = JsonValue::object();
        entry.set("b0", section.b0).set("b1", section.b1).set("b2", section.b2);
        sections.push(entry.set("a1", section.a1).set("a2", section.a2));
    }
    return sections;
}

JsonValue axisOf(const AxisResponse& response) {
    JsonValue gains = JsonValue::object();
    gains.set("kp", response.law.kp_A_per_rad).set("ki", response.law.ki_A_per_rad_s);
    gains.set("kd", response.law.kd_As_per_rad).set("filter_s", response.law.derivativeFilter_s);
    if (!response.law.sections.empty()) {
        gains.set("sections", sectionsOf(response.law));
    }
    JsonValue margins = JsonValue::object();
    margins.set("phase_margin_deg", marginBody(response.margins.phase_deg));
    margins.set("gain_margin_db", marginBody(response.margins.gain_dB));
    JsonValue body = JsonValue::object();
    body.set("axis", response.axis.id).set("position_unit", response.axis.positionUnit);
    body.set("effort_unit", response.axis.effortUnit);
    return body.set("gains", gains).set("margins", margins);
}

JsonValue excitationOf(const AxesFrequencyResult& result) {
    JsonValue bands = JsonValue::array();
    for (const AxesFrequencyBand& band : result.bands) {
        JsonValue effort = JsonValue::array();
        for (const double amplitude : band.effort) {
            effort.push(amplitude);
        }
        JsonValue entry = JsonValue::object();
        entry.set("from_hz", band.from_Hz).set("to_hz", band.to_Hz);
        bands.push(entry.set("lines_per_axis", band.linesPerAxis).set("effort", effort));
    }
    JsonValue body = JsonValue::object();
    body.set("kind", "multisine").set("from_hz", result.config.from_Hz).set("to_hz", result.config.to_Hz);
    body.set("effort_ratio", result.config.effort_ratio).set("periods", result.config.periods);
    return body.set("bands", bands).set("least_coherence", result.config.leastCoherence);
}

/// One curve over all points, with its circles.
struct Curve {
    std::string name;
    std::function<Complex(const AxesFrequencyPoint&)> value;
    std::function<double(const AxesFrequencyPoint&)> radius;
};

std::vector<Curve> curvesOf(const AxesFrequencyResult& result) {
    std::vector<Curve> curves;
    const auto count = static_cast<Eigen::Index>(result.axes.size());
    const auto id = [&](Eigen::Index i) { return result.axes[static_cast<std::size_t>(i)].axis.id; };
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = 0; j < count; ++j) {
            curves.push_back({"plant_" + id(i) + "_" + id(j),
                              [i, j](const auto& point) { return point.plant.value(i, j); },
                              [i, j](const auto& point) { return point.plant.radius(i, j); }});
        }
    }
    for (std::size_t i = 0; i < result.axes.size(); ++i) {
        curves.push_back({"loop_" + result.axes[i].axis.id,
                          [i](const auto& point) { return point.loop.loops[i].value; },
                          [i](const auto& point) { return point.loop.loops[i].radius; }});
    }
    for (std::size_t i = 0; i < result.axes.size(); ++i) {
        curves.push_back({"locus_" + std::to_string(i + 1),
                          [i](const auto& point) { return point.loop.loci[i].value; },
                          [i](const auto& point) { return point.loop.loci[i].radius; }});
    }
    return curves;
}

std::string errorText(Complex value, double radius) {
    const double ratio = radius / std::abs(value);
    return ratio < 1.0 ? formatNumber(-20.0 * std::log10(1.0 - ratio)) : std::string();
}

} // namespace

JsonValue axesFrequencyBody(const AxesFrequencyResult& result) {
    JsonValue axes = JsonValue::array();
    for (const AxisResponse& response : result.axes) {
        axes.push(axisOf(response));
    }
    JsonValue points = JsonValue::array();
    for (const AxesFrequencyPoint& point : result.points) {
        points.push(pointOf(point));
    }
    JsonValue body = JsonValue::object();
    body.set("excitation", excitationOf(result));
    body.set("sample_period_s", result.period_s).set("delay_samples", result.delaySamples);
    body.set("axes", axes).set("sensitivity_peak", peakOf(result.sensitivity));
    body.set("complementary_peak", peakOf(result.complementary)).set("points", points);
    body.set("limited_ratio", result.limited_ratio).set("duration_s", result.duration_s);
    return body.set("highest_temperature_degC", finiteOrNull(result.highestTemperature_degC));
}

std::string axesFrequencyTable(const AxesFrequencyResult& result) {
    const std::vector<Curve> curves = curvesOf(result);
    std::string text = "frequency_hz";
    std::vector<std::vector<double>> size_dB, phase_deg;
    for (const Curve& curve : curves) {
        text += "," + curve.name + "_db," + curve.name + "_deg," + curve.name + "_error_db";
        control::FrequencyResponse response;
        for (const AxesFrequencyPoint& point : result.points) {
            response.frequency_rad_s.push_back(point.plant.frequency_rad_s);
            response.value.push_back(curve.value(point));
        }
        size_dB.push_back(control::magnitude_dB(response));
        phase_deg.push_back(control::phase_deg(response));
    }
    text += ",sensitivity_db,complementary_db";
    for (const AxisResponse& response : result.axes) {
        text += ",coherence_" + response.axis.id;
    }
    text += ",used\n";
    for (std::size_t row = 0; row < result.points.size(); ++row) {
        const AxesFrequencyPoint& point = result.points[row];
        text += formatNumber(point.plant.frequency_rad_s / (2.0 * Pi));
        for (std::size_t i = 0; i < curves.size(); ++i) {
            text += "," + formatNumber(size_dB[i][row]) + "," + formatNumber(phase_deg[i][row]) + "," +
                    errorText(curves[i].value(point), curves[i].radius(point));
        }
        text += "," + formatNumber(20.0 * std::log10(point.loop.sensitivity.value.real()));
        text += "," + formatNumber(20.0 * std::log10(point.loop.complementary.value.real()));
        for (const double coherence : point.plant.coherence) {
            text += "," + formatNumber(coherence);
        }
        text += point.isWhole() ? ",1\n" : ",0\n";
    }
    return text;
}

} // namespace halbench::app
