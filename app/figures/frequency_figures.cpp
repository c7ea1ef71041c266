#include "app/figures/frequency_figures.h"

#include "app/figures/coherence_panel.h"
#include "app/figures/loop_curves.h"
#include "app/procedures/frequency/frequency_plan.h"
#include "control/base/units.h"
#include "widgets/figure/figures.h"

#include <QtCore/QCoreApplication>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

using widgets::CurveStyle;
using Complex = std::complex<double>;
using Direction = widgets::ReferenceLine::Direction;

constexpr int RotorColour = 1;
constexpr double None = std::numeric_limits<double>::quiet_NaN(); // interrupts a line

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::FrequencyFigures)
};

std::string utf8(const QString& text) {
    return text.toStdString();
}

struct Circle {
    Complex value;
    double radius = 0.0;
};

Circle circleOf(const FrequencyResultPoint& point, FrequencyView view) {
    switch (view) {
    case FrequencyView::OpenLoop:
        break;
    case FrequencyView::Plant:
        return {point.measured.value, point.radius};
    case FrequencyView::ClosedLoop: // dT = dL/(1 + L)^2
        return {point.closedLoop, point.openLoopRadius / std::norm(1.0 + point.openLoop)};
    }
    return {point.openLoop, point.openLoopRadius};
}

/// Of the rotor that fits, at a frequency.
Complex rotorValue(const FrequencyResult& result, FrequencyView view, double frequency_rad_s) {
    const Complex G = control::sampledPlantResponse(result.fit->rotor, result.period_s, frequency_rad_s);
    if (view == FrequencyView::Plant) {
        return G;
    }
    const Complex late =
        std::polar(1.0, -frequency_rad_s * result.period_s * static_cast<double>(result.law.delaySamples));
    const Complex L = late * control::feedbackResponse(result.law, frequency_rad_s) * G;
    return view == FrequencyView::ClosedLoop ? L / (1.0 + L) : L;
}

double decibel(double ratio) {
    return 20.0 * std::log10(ratio);
}

/// The phase nearest to `near_deg`.
double unwrapped(double phase_rad, double near_deg) {
    const double phase_deg = radiansToDegrees(phase_rad);
    return phase_deg + 360.0 * std::round((near_deg - phase_deg) / 360.0);
}

/// Magnitude and phase of one curve, and what its points may be wrong by.
struct Track {
    std::vector<double> frequency_Hz, magnitude_dB, phase_deg;

    void add(double at_Hz, double size_dB, double angle_deg) {
        frequency_Hz.push_back(at_Hz);
        magnitude_dB.push_back(size_dB);
        phase_deg.push_back(angle_deg);
    }
    widgets::BodeContent::Response as(const QString& label, CurveStyle style, int colour) const {
        return {utf8(label), frequency_Hz, magnitude_dB, phase_deg, style, colour};
    }
};

struct Tracks {
    Track used, rest, low, high;
};

Tracks tracksOf(const FrequencyResult& result, FrequencyView view) {
    Tracks tracks;
    double near_deg = view == FrequencyView::ClosedLoop ? 0.0 : -180.0;
    for (const FrequencyResultPoint& point : result.points) {
        const double at_Hz = point.measured.frequency_rad_s / (2.0 * Pi);
        const Circle circle = circleOf(point, view);
        const double size = std::abs(circle.value);
        const double phase_deg = unwrapped(std::arg(circle.value), near_deg);
        (point.isUsed ? tracks.used : tracks.rest).add(at_Hz, decibel(size), phase_deg);
        near_deg = point.isUsed ? phase_deg : near_deg;
        const bool isBounded = point.isUsed && circle.radius < size; // else the circle holds zero
        const double half_deg = isBounded ? radiansToDegrees(std::asin(circle.radius / size)) : None;
        tracks.low.add(at_Hz, isBounded ? decibel(size - circle.radius) : None, phase_deg - half_deg);
        tracks.high.add(at_Hz, isBounded ? decibel(size + circle.radius) : None, phase_deg + half_deg);
    }
    return tracks;
}

Track rotorTrack(const FrequencyResult& result, FrequencyView view) {
    constexpr int Places = 200;
    const double first_rad_s = result.points.front().measured.frequency_rad_s;
    const double ratio = result.points.back().measured.frequency_rad_s / first_rad_s;
    Track track;
    double near_deg = view == FrequencyView::ClosedLoop ? 0.0 : -180.0;
    for (int i = 0; i <= Places; ++i) {
        const double w = first_rad_s * std::pow(ratio, static_cast<double>(i) / Places);
        const Complex value = rotorValue(result, view, w);
        near_deg = unwrapped(std::arg(value), near_deg);
        track.add(w / (2.0 * Pi), decibel(std::abs(value)), near_deg);
    }
    return track;
}

/// A margin with half of its interval's width.
std::string marginText(const QString& words, const control::MeasuredMargin& margin, const char* unit) {
    const double half = 0.5 * (margin.interval->second - margin.interval->first);
    return fmt::format("{} {:.1f} \u00b1 {:.1f}{}", utf8(words), *margin.value, half, unit);
}

void markMargins(widgets::BodeContent& content, const control::MeasuredMargins& margins) {
    content.magnitudeLines = {{Direction::Horizontal, 0.0, "0 dB"}};
    content.phaseLines = {{Direction::Horizontal, -180.0, "\u2212180\u00b0"}};
    if (margins.phase_deg.value) {
        const double crossover_Hz = *margins.phase_deg.frequency_rad_s / (2.0 * Pi);
        content.magnitudeLines.push_back({Direction::Vertical, crossover_Hz, {}});
        content.phaseLines.push_back({Direction::Vertical, crossover_Hz,
                                      marginText(Words::tr("phase margin"), margins.phase_deg, "\u00b0")});
    }
    if (margins.gain_dB.value) {
        const double crossover_Hz = *margins.gain_dB.frequency_rad_s / (2.0 * Pi);
        content.magnitudeLines.push_back({Direction::Vertical, crossover_Hz,
                                          marginText(Words::tr("gain margin"), margins.gain_dB, " dB")});
        content.phaseLines.push_back({Direction::Vertical, crossover_Hz, {}});
    }
}

QString titleOf(FrequencyView view) {
    return view == FrequencyView::OpenLoop ? Words::tr("Measured open loop")
           : view == FrequencyView::Plant  ? Words::tr("Measured plant: angle over current, rad/A")
                                           : Words::tr("Measured closed loop");
}

widgets::Panel coherenceOf(const FrequencyResult& result) {
    std::vector<double> frequency_Hz;
    std::vector<double> coherence;
    std::vector<bool> isUsed;
    for (const FrequencyResultPoint& point : result.points) {
        frequency_Hz.push_back(point.measured.frequency_rad_s / (2.0 * Pi));
        coherence.push_back(point.measured.coherence);
        isUsed.push_back(point.isUsed);
    }
    return coherencePanel(frequency_Hz, coherence, isUsed, result.config.leastCoherence);
}

/// Slope of the reference, which the board does not tell.
std::vector<double> referenceSpeed(const Recording& recording) {
    const std::vector<double> reference = recording.column("reference");
    std::vector<double> speed(reference.size(), None);
    for (std::size_t row = 1; row < reference.size(); ++row) {
        const double step_s = recording.time_s[row] - recording.time_s[row - 1];
        speed[row] = step_s > 0.0 ? (reference[row] - reference[row - 1]) / step_s : None;
    }
    return speed;
}

} // namespace

widgets::Figure frequencyFigure(const FrequencyResult& result, FrequencyView view) {
    widgets::BodeContent content;
    content.title = utf8(titleOf(view));
    const Tracks tracks = tracksOf(result, view);
    const std::pair<const Track*, widgets::BodeContent::Response> all[] = {
        {&tracks.used, tracks.used.as(Words::tr("measured"), CurveStyle::Points, MarkColour)},
        {&tracks.rest,
         tracks.rest.as(Words::tr("measured, low coherence"), CurveStyle::HollowPoints, MarkColour)},
        {&tracks.used, tracks.low.as(Words::tr("95 % region"), CurveStyle::DottedLine, MarkColour)},
        {&tracks.used, tracks.high.as({}, CurveStyle::DottedLine, MarkColour)}};
    for (const auto& [needed, response] : all) {
        if (!needed->frequency_Hz.empty()) {
            content.responses.push_back(response);
        }
    }
    if (result.fit && !result.points.empty()) {
        content.responses.push_back(
            rotorTrack(result, view).as(Words::tr("fitted rotor"), CurveStyle::DashedLine, RotorColour));
    }
    if (view == FrequencyView::OpenLoop) {
        markMargins(content, result.margins);
    }
    widgets::Figure figure = widgets::bodeFigure(content);
    figure.panels.push_back(coherenceOf(result));
    return figure;
}

std::optional<widgets::Figure> excitationFigure(const FrequencyResult& result) {
    return excitationFigure(result.recording);
}

std::optional<widgets::Figure> excitationFigure(const Recording& recording) {
    if (!recording.layout || recording.rows() == 0) {
        return std::nullopt;
    }
    widgets::Figure figure;
    figure.title = utf8(Words::tr("Excitation as recorded"));
    figure.x = {utf8(Words::tr("time")), "s", false, {}, {}, {}};
    const auto add = [&](const QString& words, const char* unit, std::vector<double> values) {
        widgets::Panel panel;
        panel.y = {utf8(words), unit, false, {}, {}, {}};
        panel.height_px = 140;
        panel.curves = {{{}, recording.time_s, std::move(values), CurveStyle::Line, 0}};
        figure.panels.push_back(std::move(panel));
    };
    add(Words::tr("reference speed"), "rad/s", referenceSpeed(recording));
    add(Words::tr("speed"), "rad/s", recording.column("speed"));
    add(Words::tr("current amplitude"), "A", recording.column("current_command"));
    return figure;
}

} // namespace halbench::app
