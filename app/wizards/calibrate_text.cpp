#include "app/wizards/calibrate_text.h"

#include "app/wizards/identify_text.h"
#include "app/workbench/wall_clock.h"
#include "control/base/unit_text.h"
#include "widgets/controls/progress_row.h"
#include "widgets/language/display_units.h"
#include "widgets/language/greek_angles.h"
#include "widgets/language/phrasebook.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace halbench::app {
namespace {

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::CalibrateWords)
};

struct Shown {
    QString unit;
    double factor;
};

Shown shownUnit(const std::string& unit, const DisplayUnits& units) {
    if (unit == "T") {
        return {QStringLiteral("mT"), 1e3};
    }
    if (unit == "T/A") {
        return {QStringLiteral("mT/A"), 1e3};
    }
    if (unit == "m") {
        return {QStringLiteral("mm"), 1e3};
    }
    if (unit == "rad") {
        const widgets::DisplayUnit shown = widgets::displayUnit("rad", units.angle);
        return {shown.text, shown.factor};
    }
    return {QString::fromStdString(unitText(unit)), 1.0};
}

/// "sensor0.gain_r_theta": what, in which channels, of which sensor; "rotor.harmonic_4_2". Empty otherwise.
QString channelName(const std::string& figure) {
    const QString text = QString::fromStdString(figure);
    const std::pair<const char*, QString> kinds[] = {
        {".gain_", Words::tr("gain error %1 of sensor %2")},
        {".skew_", Words::tr("cross-axis share %1 of sensor %2")},
        {".offset_", Words::tr("offset %1 of sensor %2")},
        {".turn_", Words::tr("frame about %1 of sensor %2")},
        {".place_", Words::tr("place along %1 of sensor %2")},
        {".coil_", Words::tr("coil field %1 of sensor %2")}};
    for (const auto& [kind, words] : kinds) {
        const int at = text.indexOf(QLatin1String(kind));
        if (text.startsWith(QLatin1String("sensor")) && at > 0) {
            QString part = text.mid(at + static_cast<int>(std::string_view(kind).size()));
            return words.arg(part.replace(QLatin1Char('_'), QLatin1Char('-')), text.mid(6, at - 6));
        }
    }
    const QLatin1String harmonic("rotor.harmonic_");
    if (text.startsWith(harmonic)) {
        return Words::tr("harmonic (%1)")
            .arg(text.mid(harmonic.size()).replace(QLatin1Char('_'), QLatin1Char(',')));
    }
    return {};
}

/// "chip2.gain_x", "crosstalk.7" and "error_x_before" in words; others as they are.
QString chipName(const QString& figure) {
    const std::pair<const char*, QString> parts[] = {
        {"amplitude", Words::tr("chip %1: amplitude of the field")},
        {"gain_x", Words::tr("chip %1: gain error along x'")},
        {"gain_y", Words::tr("chip %1: gain error along y'")},
        {"cross_xy", Words::tr("chip %1: share of y' in x'")},
        {"cross_yx", Words::tr("chip %1: share of x' in y'")},
        {"offset_x", Words::tr("chip %1: offset along x'")},
        {"offset_y", Words::tr("chip %1: offset along y'")},
        {"place_x", Words::tr("chip %1: place along x'")},
        {"place_y", Words::tr("chip %1: place along y'")}};
    for (const auto& [part, text] : parts) {
        if (figure.startsWith(QLatin1String("chip")) &&
            figure.endsWith(QLatin1Char('.') + QLatin1String(part))) {
            return text.arg(figure.mid(4, figure.indexOf(QLatin1Char('.')) - 4));
        }
    }
    if (figure.startsWith(QLatin1String("crosstalk."))) {
        constexpr int Coils = 6;
        const int index = figure.mid(10).toInt() - 1;
        return Words::tr("field of coil %1 at chip %2 along %3")
            .arg(index % Coils + 1)
            .arg(index / (2 * Coils) + 1)
            .arg((index / Coils) % 2 == 0 ? QStringLiteral("x'") : QStringLiteral("y'"));
    }
    const QStringList error = figure.split(QLatin1Char('_'));
    if (error.size() == 3 && error.front() == QLatin1String("error")) {
        return (error.back() == QLatin1String("before") ? Words::tr("periodic error along %1, before")
                                                        : Words::tr("periodic error along %1, remaining"))
            .arg(error[1]);
    }
    return figure;
}

QString nameOf(const std::string& figure) {
    const std::pair<const char*, QString> names[] = {
        {"hall.offset_a", Words::tr("offset of Hall sensor A")},
        {"hall.offset_b", Words::tr("offset of Hall sensor B")},
        {"hall.gain_ratio", Words::tr("gain ratio B/A")},
        {"hall.quadrature", Words::tr("orthogonality error of the Hall sensors")},
        {"hall.amplitude", Words::tr("amplitude of the field")},
        {"stray.coefficient", Words::tr("stray field of the coils")},
        {"angle_error.rms", Words::tr("angle error removed by the map, rms")},
        {"static_friction.current", Words::tr("breakaway current")},
        {"rotor.strength", Words::tr("strength q of the rotor's field")},
        {"rotor.drift", Words::tr("drift of the field with temperature")},
        {"sensor.deviation", Words::tr("noise of a reading")},
        {"sensor.tolerance", Words::tr("error left in a reading")}};
    for (const auto& [name, text] : names) {
        if (figure == name) {
            return text;
        }
    }
    if (const QString channel = channelName(figure); !channel.isEmpty()) {
        return channel;
    }
    for (const auto& [prefix, text] :
         {std::pair("errormap.cos", Words::tr("angle error, harmonic %1, cosine")),
          std::pair("errormap.sin", Words::tr("angle error, harmonic %1, sine"))}) {
        if (figure.rfind(prefix, 0) == 0) { // its harmonic of the rotor's angle follows
            return text.arg(QString::fromStdString(figure.substr(std::string_view(prefix).size())));
        }
    }
    return chipName(QString::fromStdString(figure));
}

QString currentText(double current_A) {
    return widgets::fixedText(current_A, 1) + QStringLiteral(" A");
}

/// The parameter that takes a figure: "chip.gain_x_2" for "chip2.gain_x", else that of its name.
std::string parameterOf(const std::string& figure) {
    const std::size_t point = figure.find('.');
    if (point == 5 && figure.starts_with("chip")) {
        return "chip." + figure.substr(point + 1) + "_" + figure.substr(4, 1);
    }
    return figure.starts_with("crosstalk.") ? "chip.crosstalk_" + figure.substr(point + 1) : figure;
}

/// The value that the figure's parameter has now, or had; a dash for one that no parameter takes.
QString besideText(const std::string& name, double factor, const CalibrateResult& result,
                   const std::map<std::string, double>* deviceValues) {
    const auto before = std::find_if(result.before.begin(), result.before.end(),
                                     [&](const ParameterValue& value) { return value.name == name; });
    if (before == result.before.end()) {
        return QStringLiteral("\u2013");
    }
    if (deviceValues != nullptr) {
        if (const auto now = deviceValues->find(name); now != deviceValues->end()) {
            return widgets::numberText(now->second * factor, 4);
        }
    }
    return widgets::numberText(before->value * factor, 4);
}

} // namespace

QString axesCalibrationOutlook(const CalibratePrediction& prediction) {
    return Words::tr(
               "Motion over more than a pitch in each direction for %1 minutes of device time, up to %2 A in "
               "a coil. Nothing is changed until you press Apply.")
        .arg(widgets::durationText(prediction.duration_s),
             currentText(prediction.peakCurrent_A).remove(QStringLiteral(" A")));
}

QString calibrationOutlook(const CalibrateConfig& config, const DisplayUnits& units) {
    QStringList lines;
    for (const Calibration which : config.which) {
        switch (which) {
        case Calibration::Hall:
            lines << Words::tr("Hall: slow rotation in both directions at %1.")
                         .arg(currentText(config.spinCurrent_A));
            break;
        case Calibration::Stray:
            lines << Words::tr(
                         "Stray field: the rotor is held at three angles with up to %1, without torque.")
                         .arg(currentText(config.strayCurrent_A));
            break;
        case Calibration::StaticFriction:
            lines << Words::tr("Static friction: the current rises to %1 or until the rotor starts, %2 times "
                               "in each direction.")
                         .arg(currentText(config.frictionCurrent_A))
                         .arg(config.frictionStarts);
            break;
        }
    }
    if (lines.isEmpty()) {
        return Words::tr("Choose at least one calibration.");
    }
    const DisplayQuantity speed = displayQuantity("rad/s", units);
    lines << Words::tr("Device stops at %1 %2. Nothing is changed until you press Apply.")
                 .arg(widgets::fixedText(config.speedLimit_rad_s * speed.factor, 0), speed.unit);
    return lines.join(QLatin1Char('\n'));
}

QString handMotionOutlook(const CalibrateConfig& config) {
    if (config.which.empty()) {
        return Words::tr("Choose at least one calibration.");
    }
    return Words::tr(
        "Move the rotor by hand for a minute: tilt it to all sides, up to 45°, and spin it. A "
        "simulated rotor moves with motion=tumble in its address. The sphere shows which directions "
        "of the shaft still need data.\nNothing is armed. The calibration changes when you "
        "apply it; a simulated coil is switched meanwhile and set back.");
}

QString handMotionNeeds(bool isEnough, const std::vector<std::string>& missing, const std::string& order) {
    if (isEnough) {
        return Words::tr("The motion determines every value. More of it makes the intervals smaller.");
    }
    if (missing.empty()) {
        return Words::tr("Move the rotor: tilt it and spin it.");
    }
    QStringList orientations;
    for (const std::string& orientation : missing) {
        orientations << widgets::greekAngles(widgets::inWords(orientation));
    }
    return Words::tr("Still needed most: %1 (%2)")
        .arg(orientations.join(QStringLiteral("; ")), widgets::greekAngles(widgets::inWords(order)));
}

std::vector<widgets::EstimateRow> calibrationRows(const CalibrateResult& result,
                                                  const std::map<std::string, double>* deviceValues,
                                                  const DisplayUnits& units) {
    std::vector<widgets::EstimateRow> rows;
    for (const CalibrationFigure& figure : result.figures) {
        const Shown shown = shownUnit(figure.unit, units);
        const auto scaled = [&](double value) { return value * shown.factor; };
        widgets::EstimateRow row;
        row.name = nameOf(figure.name);
        row.unit = shown.unit;
        if (figure.estimate.value) {
            row.value = scaled(*figure.estimate.value);
        }
        if (figure.estimate.interval95) {
            row.low95 = scaled(figure.estimate.interval95->first);
            row.high95 = scaled(figure.estimate.interval95->second);
        }
        row.source = besideText(parameterOf(figure.name), shown.factor, result, deviceValues);
        row.remark = QString::fromStdString(figure.name);
        rows.push_back(std::move(row));
    }
    return rows;
}

QString calibrationGain(const CalibrateResult& result, const DisplayUnits& units) {
    if (!(result.residualBefore_rad > 0.0)) {
        return {};
    }
    const bool isOfHall = std::any_of(result.figures.begin(), result.figures.end(),
                                      [](const auto& figure) { return figure.name.rfind("hall.", 0) == 0; });
    if (!isOfHall) {
        return Words::tr("Angle error, rms: %1 with the values from before in this record, %2 expected with "
                         "the proposed ones.")
            .arg(angleText(result.residualBefore_rad, units), angleText(result.residualAfter_rad, units));
    }
    return Words::tr("Residual angle error: %1 with the previous values, %2 with the proposed values.")
               .arg(angleText(result.residualBefore_rad, units), angleText(result.residualAfter_rad, units)) +
           QLatin1Char(' ') +
           Words::tr("Root mean square over one turn of the difference between measured angle and ellipse "
                     "angle, before the map.");
}

QString breakawayNote(const CalibrateResult& result) {
    if (result.staticFriction.empty()) {
        return {};
    }
    return Words::tr("The breakaway current starts the rotor from rest. Identify gives another figure: "
                     "K_f/φ, the friction current during rotation, usually less.") +
           QStringLiteral(" <a href=\"identification.md#62-two-currents-of-friction\">") +
           Words::tr("What is the difference?") + QStringLiteral("</a>");
}

QString earlierCalibrationText(const ResultHeader& header) {
    return Words::tr("Measured before this connection, device %1.")
        .arg(header.device ? QString::fromStdString(header.device->id) : Words::tr("unknown device"));
}

QString projectCalibrationText(const ResultHeader& header) {
    const QString device =
        header.device ? QString::fromStdString(header.device->id) : Words::tr("unknown device");
    return isOfVirtualTime(header)
               ? Words::tr("From the project: calibrated in virtual time, device %1.").arg(device)
               : Words::tr("From the project: calibrated %1, device %2.")
                     .arg(localDate(header.started), device);
}

} // namespace halbench::app
