#include "app/wizards/identify_text.h"

#include "app/procedures/identify/identify_plan.h"
#include "app/workbench/wall_clock.h"
#include "control/base/unit_text.h"
#include "control/base/units.h"
#include "widgets/controls/progress_row.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/language/unbroken.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

using control::Estimate;
using control::EstimateSource;

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::IdentifyWords)
};

QString number(double value, int decimals) {
    return widgets::fixedText(value, decimals);
}

QString sourceText(EstimateSource source) {
    switch (source) {
    case EstimateSource::Identified:
        return Words::tr("identified");
    case EstimateSource::Given:
        return Words::tr("given");
    case EstimateSource::NotIdentifiable:
        break;
    }
    return Words::tr("not identifiable");
}

QString ratioName(const std::string& key) {
    const std::pair<const char*, QString> names[] = {
        {"c_over_J", "c/J"},
        {"Kf_over_J", "K_f/J"},
        {"phi_over_J", "\u03c6/J"},
        {"c_over_phi", "c/\u03c6"},
        {"Kf_over_phi", Words::tr("K_f/\u03c6, friction as a current")}};
    for (const auto& [name, text] : names) {
        if (key == name) {
            return text;
        }
    }
    return QString::fromStdString(key);
}

} // namespace

widgets::EstimateRow estimateRow(const QString& name, const Estimate& estimate) {
    widgets::EstimateRow row{name,
                             estimate.value,
                             {},
                             {},
                             QString::fromStdString(unitText(estimate.unit)),
                             sourceText(estimate.source),
                             {}};
    if (estimate.interval95 && estimate.source == EstimateSource::Identified) {
        row.low95 = estimate.interval95->first;
        row.high95 = estimate.interval95->second;
    }
    if (estimate.source == EstimateSource::NotIdentifiable) {
        row.remark = Words::tr("Angle and current give only ratios; see below for the missing scale");
    }
    return row;
}

SweepOutlook sweepOutlook(const IdentifyConfig& config, double start_degC) {
    SweepOutlook outlook;
    outlook.prediction = predictIdentify(config, start_degC);
    const auto currents = sweepCurrents_A(config.sweep, 1e3);
    if (!currents) {
        return outlook;
    }
    const PilotEstimate motor = nominalMotor();
    double angle_rad = 0.0;
    for (const PlateauRun& run : planRuns(config, *currents, motor)) {
        for (const double current_A : run.currents_A) {
            const double steady_rad_s = std::max(0.0, motor.steadySpeed_rad_s(std::fabs(current_A)));
            // After the dwell that is left of the settling: what a short run-up does not reach.
            const double reached = -std::expm1(-motor.damping_per_s * run.dwell_s);
            outlook.largestSpeed_rad_s = std::max(outlook.largestSpeed_rad_s, reached * steady_rad_s);
            angle_rad += reached * steady_rad_s * run.dwell_s;
        }
    }
    outlook.largestSpeed_rad_s = std::min(outlook.largestSpeed_rad_s, config.speedLimit_rad_s);
    outlook.turns = angle_rad / (2.0 * Pi);
    return outlook;
}

QString outlookText(const IdentifyConfig& config, const SweepOutlook& outlook, const DisplayUnits& units) {
    const QString way = config.directions == SweepDirections::Both      ? Words::tr("both directions")
                        : config.directions == SweepDirections::Forward ? Words::tr("forward")
                                                                        : Words::tr("in reverse");
    QString text =
        Words::tr(
            "The rotor will turn %1, about %2 turns in all, at up to %3, for %4 minutes of device time.")
            .arg(way, number(std::round(outlook.turns / 10.0) * 10.0, 0),
                 speedText(outlook.largestSpeed_rad_s, units),
                 widgets::durationText(outlook.prediction.duration_s));
    text += QLatin1Char('\n');
    const double warmest_degC = outlook.prediction.highestTemperature_degC;
    const QString current_A = number(outlook.prediction.peakCurrent_A, 1);
    text += warmest_degC < config.refuseTemperature_degC
                ? Words::tr("Maximum current %1 A, maximum coil temperature %2 °C.")
                      .arg(current_A, number(warmest_degC, 0))
                : Words::tr("Current up to %1 A. The run pauses for cooling if the coils come near %2 °C.")
                      .arg(current_A, number(config.refuseTemperature_degC, 0));
    text += QLatin1Char(' ');
    text += Words::tr("Device stops at %1. Gains and limits are always restored.")
                .arg(speedText(config.speedLimit_rad_s, units));
    if (!config.given.inertia_kg_m2 && !config.given.torqueConstant_Nm_per_A) {
        text += QLatin1Char('\n');
        text += Words::tr("Without inertia J or torque constant φ only ratios are identified; that is "
                          "sufficient for tuning.");
    }
    return text;
}

std::vector<widgets::EstimateRow> estimateRows(const IdentifyResult& result) {
    std::vector<widgets::EstimateRow> rows = {
        estimateRow(Words::tr("viscous damping c"), result.viscousDamping),
        estimateRow(Words::tr("Coulomb friction K_f"), result.coulombFriction),
        estimateRow(Words::tr("torque constant \u03c6"), result.torqueConstant),
        estimateRow(Words::tr("inertia J"), result.inertia)};
    for (const auto& [key, ratio] : result.ratios) {
        rows.push_back(estimateRow(ratioName(key), ratio));
    }
    if (result.asymmetry) {
        rows.push_back(estimateRow(Words::tr("asymmetry of the friction"), *result.asymmetry));
    }
    return rows;
}

QString verdictTitle(const DataQuality& quality) {
    switch (quality.verdict) {
    case Verdict::Good:
        return quality.findings.empty() ? Words::tr("Good: the model fits the data")
                                        : Words::tr("Good; see the remarks below");
    case Verdict::Doubtful:
        return Words::tr("Doubtful: check the findings first");
    case Verdict::Refused:
        break;
    }
    return Words::tr("Rejected: no reliable result");
}

QString missingText(const IdentifyResult& result) {
    const std::pair<const Estimate*, QString> constants[] = {{&result.inertia, "J"},
                                                             {&result.torqueConstant, "\u03c6"},
                                                             {&result.viscousDamping, "c"},
                                                             {&result.coulombFriction, "K_f"}};
    QStringList missing;
    for (const auto& [estimate, symbol] : constants) {
        if (estimate->source == EstimateSource::NotIdentifiable) {
            missing << symbol;
        }
    }
    if (missing.isEmpty()) {
        return {};
    }
    QStringList lines = {
        Words::tr(
            "Not identifiable: %1. Angle and current give only ratios. To get the scale, provide one of:")
            .arg(missing.join(QStringLiteral(", ")))};
    const bool hasTransients = result.ratios.count("c_over_J") > 0;
    if (hasTransients) {
        lines << Words::tr("• inertia J of all rotating parts (drawing or weighing): gives c, K_f and φ");
        lines << Words::tr("• torque constant φ (data sheet): gives J, c and K_f");
        lines << Words::tr("• without data: fix a part of known inertia to the rotor and identify again");
    } else {
        lines << Words::tr("• torque constant φ (data sheet): gives c and K_f, not J");
        lines << Words::tr("• run-ups and coast-downs besides the plateaus: then J or φ is sufficient");
    }
    lines << Words::tr("Not required for tuning: the ratios are sufficient.");
    return lines.join(QLatin1Char('\n'));
}

QString frictionNote(const IdentifyResult& result) {
    const auto found = result.ratios.find("Kf_over_phi");
    if (found == result.ratios.end() || !found->second.value) {
        return {};
    }
    return Words::tr("K_f/φ is the friction current during rotation. Calibrate gives another figure: the "
                     "breakaway current from rest, usually more.") +
           QStringLiteral(" <a href=\"identification.md#62-two-currents-of-friction\">") +
           Words::tr("What is the difference?") + QStringLiteral("</a>");
}

bool isOfVirtualTime(const ResultHeader& header) {
    return header.started == ResultHeader().started; // virtual time begins there
}

QString provenanceText(const ResultHeader& header, double duration_s,
                       std::optional<double> highestTemperature_degC) {
    QStringList parts;
    if (header.device) {
        const devices::DeviceInfo& device = *header.device;
        parts << Words::tr("Device %1, firmware %2")
                     .arg(QString::fromStdString(device.id), QString::fromStdString(device.firmware));
        QStringList overrides;
        for (const auto& [key, value] : device.overrides) {
            overrides << QString::fromStdString(key) + QLatin1Char('=') + QString::fromStdString(value);
        }
        if (!overrides.isEmpty()) {
            parts << Words::tr("overrides %1").arg(overrides.join(QStringLiteral(", ")));
        }
    } else {
        parts << Words::tr("Unknown device");
    }
    parts << Words::tr("Halbench %1").arg(QString::fromStdString(header.software));
    parts << Words::tr("seed %1").arg(header.seed);
    parts << (isOfVirtualTime(header) ? Words::tr("in virtual time, without a date")
                                      : Words::tr("started %1").arg(localDate(header.started)));
    if (duration_s > 0.0) {
        parts << Words::tr("%1 minutes of device time").arg(widgets::durationText(duration_s));
    }
    if (highestTemperature_degC) {
        parts << Words::tr("coils up to %1 °C").arg(number(*highestTemperature_degC, 1));
    }
    return widgets::withUnitsKept(parts.join(QStringLiteral(" \u00b7 ")));
}

QString projectModelText(const ResultHeader& header) {
    const QString device =
        header.device ? QString::fromStdString(header.device->id) : Words::tr("unknown device");
    return isOfVirtualTime(header)
               ? Words::tr("From the project: identified in virtual time, device %1.").arg(device)
               : Words::tr("From the project: identified %1, device %2.")
                     .arg(localDate(header.started), device);
}

QString projectDeviceText(const ResultHeader& header, const devices::DeviceInfo* connected) {
    if (connected == nullptr) {
        return Words::tr("No device is connected for comparison.");
    }
    return header.device && isSameDevice(*header.device, *connected)
               ? Words::tr("Same as the connected device.")
               : Words::tr("Another device is connected: %1.").arg(QString::fromStdString(connected->id));
}

QString problemText(const Error& error) {
    const QString hint = widgets::inWords(error.hint);
    return widgets::inWords(error.message) + (hint.isEmpty() ? hint : QStringLiteral(" \u2192 ") + hint);
}

} // namespace halbench::app
