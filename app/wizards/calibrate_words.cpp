#include "app/wizards/calibrate_words.h"

#include "app/wizards/identify_words.h"
#include "app/workbench/wall_clock.h"
#include "control/base/unit_text.h"
#include "widgets/language/display_units.h"

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
    if (unit == "rad") {
        const widgets::DisplayUnit shown = widgets::displayUnit("rad", units.angle);
        return {shown.text, shown.factor};
    }
    return {QString::fromStdString(unitText(unit)), 1.0};
}

QString nameOf(const std::string& figure) {
    const std::pair<const char*, QString> names[] = {
        {"hall.offset_a", Words::tr("offset of Hall sensor A")},
        {"hall.offset_b", Words::tr("offset of Hall sensor B")},
        {"hall.gain_ratio", Words::tr("gain of B over A")},
        {"hall.quadrature", Words::tr("error of the right angle")},
        {"hall.amplitude", Words::tr("amplitude of the field")},
        {"stray.coefficient", Words::tr("stray field of the coils")},
        {"angle_error.rms", Words::tr("angle error that the map takes away, rms")},
        {"static_friction.current", Words::tr("breakaway current, from rest")}};
    for (const auto& [name, text] : names) {
        if (figure == name) {
            return text;
        }
    }
    for (const auto& [prefix, text] : {std::pair("errormap.cos", Words::tr("angle error, cosine part %1")),
                                       std::pair("errormap.sin", Words::tr("angle error, sine part %1"))}) {
        if (figure.rfind(prefix, 0) == 0) { // its harmonic of the rotor's angle follows
            return text.arg(QString::fromStdString(figure.substr(std::string_view(prefix).size())));
        }
    }
    return QString::fromStdString(figure);
}

QString currentText(double current_A) {
    return widgets::fixedText(current_A, 1) + QStringLiteral(" A");
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

QString calibrationOutlook(const CalibrateConfig& config, const DisplayUnits& units) {
    QStringList lines;
    for (const Calibration which : config.which) {
        switch (which) {
        case Calibration::Hall:
            lines << Words::tr("Hall: the rotor turns slowly both ways at %1.")
                         .arg(currentText(config.spinCurrent_A));
            break;
        case Calibration::Stray:
            lines << Words::tr("Stray field: the rotor is held at three angles, without torque, at up to %1.")
                         .arg(currentText(config.strayCurrent_A));
            break;
        case Calibration::StaticFriction:
            lines << Words::tr("Static friction: the current rises to at most %1 until the rotor starts, %2 "
                               "times each way.")
                         .arg(currentText(config.frictionCurrent_A))
                         .arg(config.frictionStarts);
            break;
        }
    }
    if (lines.isEmpty()) {
        return Words::tr("Choose at least one calibration.");
    }
    const DisplayQuantity speed = displayQuantity("rad/s", units);
    lines << Words::tr("The board ends the motion at %1 %2. Nothing is changed until you apply it.")
                 .arg(widgets::fixedText(config.speedLimit_rad_s * speed.factor, 0), speed.unit);
    return lines.join(QLatin1Char('\n'));
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
        row.source = besideText(figure.name, shown.factor, result, deviceValues);
        row.remark = QString::fromStdString(figure.name);
        rows.push_back(std::move(row));
    }
    return rows;
}

QString calibrationGain(const CalibrateResult& result, const DisplayUnits& units) {
    if (!(result.residualBefore_rad > 0.0)) {
        return {};
    }
    return Words::tr("Residual angle error: %1 with the values from before, %2 with the proposed ones.")
               .arg(angleText(result.residualBefore_rad, units), angleText(result.residualAfter_rad, units)) +
           QLatin1Char(' ') +
           Words::tr("It is the root mean square (rms) over a turn of the distance between the angle that is "
                     "read and that of the ellipse, before the map.");
}

QString breakawayNote(const CalibrateResult& result) {
    if (result.staticFriction.empty()) {
        return {};
    }
    return Words::tr(
               "The breakaway current is the one that starts the rotor from rest. Identify finds another "
               "figure: K_f/\u03c6, the current that friction takes while it moves, usually less.") +
           QStringLiteral(" <a href=\"identification.md#62-two-currents-of-friction\">") +
           Words::tr("What is the difference?") + QStringLiteral("</a>");
}

QString earlierCalibrationText(const ResultHeader& header) {
    return Words::tr("Measured before the last connect, device %1.")
        .arg(header.device ? QString::fromStdString(header.device->id) : Words::tr("device not known"));
}

QString projectCalibrationText(const ResultHeader& header) {
    const QString device =
        header.device ? QString::fromStdString(header.device->id) : Words::tr("device not known");
    return isOfVirtualTime(header)
               ? Words::tr("From the project: calibrated in virtual time, device %1.").arg(device)
               : Words::tr("From the project: calibrated %1, device %2.")
                     .arg(localDate(header.started), device);
}

} // namespace halbench::app
