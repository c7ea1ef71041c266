#include "app/documents/model_file.h"

#include "app/documents/document_limits.h"
#include "app/documents/document_parts.h"
#include "app/documents/document_units.h"
#include "app/documents/text/output_file.h"
#include "app/procedures/base/doubtful_source.h"
#include "control/base/units.h"
#include "control/law/board_gains.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace halbench::app {

namespace {

/// Walks a document and keeps the first complaint, so that reading stays one statement a value.
class DocumentReader {
public:
    DocumentReader(const JsonValue& root, std::string origin, std::string command)
        : m_root(root), m_origin(std::move(origin)), m_command(std::move(command)) {}

    void requireSchema(const std::string& family, int version) {
        const JsonValue* schema = m_root.find("schema");
        const std::string text = schema != nullptr && schema->isText() ? schema->text() : "";
        const std::string expected = fmt::format("{}/{}", family, version);
        if (text == expected) {
            return;
        }
        if (text.rfind(family + "/", 0) == 0) {
            fail("schema", fmt::format("is \"{}\", this version reads \"{}\"", text, expected));
        } else {
            fail("schema",
                 text.empty() ? "is missing" : fmt::format("is \"{}\", not \"{}\"", text, expected));
        }
    }

    /// The value under a dotted path; nullptr after a complaint when it must be there.
    const JsonValue* find(const std::string& path, bool isRequired) {
        const JsonValue* value = &m_root;
        for (std::size_t begin = 0; value != nullptr && begin <= path.size();) {
            const std::size_t end = std::min(path.find('.', begin), path.size());
            value = value->find(path.substr(begin, end - begin));
            begin = end + 1;
        }
        if (value == nullptr && isRequired) {
            fail(path, "is missing");
        }
        return value;
    }

    double number(const std::string& path) {
        const JsonValue* value = find(path, true);
        if (value != nullptr && !value->isNumber()) {
            fail(path, "must be a finite number");
            return 0.0;
        }
        return value == nullptr ? 0.0 : value->number();
    }

    /// From 0 to `largest`; anything else is a complaint and 0.
    double wholeNumber(const std::string& path, double largest) {
        const double value = number(path);
        if (!(value >= 0.0 && value <= largest) || value != std::floor(value)) {
            fail(path, fmt::format("must be a whole number from 0 to {}", largest));
            return 0.0;
        }
        return value;
    }

    /// Absent and null mean the same.
    std::optional<double> optionalNumber(const std::string& path) {
        const JsonValue* value = find(path, false);
        if (value == nullptr || value->isNull()) {
            return std::nullopt;
        }
        return number(path);
    }

    std::string text(const std::string& path) {
        const JsonValue* value = find(path, true);
        if (value != nullptr && !value->isText()) {
            fail(path, "must be a text");
            return {};
        }
        return value == nullptr ? std::string() : value->text();
    }

    void fail(const std::string& key, const std::string& what) {
        fail(key, what, fmt::format("write the file again with 'halbench {} --out'", m_command));
    }

    void fail(const std::string& key, const std::string& what, const std::string& hint) {
        if (!m_error) {
            m_error = Error{ErrorCode::InvalidInput, fmt::format("{}: \"{}\" {}", m_origin, key, what), hint};
        }
    }

    const std::optional<Error>& error() const { return m_error; }

private:
    const JsonValue& m_root;
    std::string m_origin;
    std::string m_command;
    std::optional<Error> m_error;
};

struct ModelQuantity {
    const char* path;
    const char* symbol;
};

constexpr std::array ModelQuantities = {
    ModelQuantity{"parameters.viscous_damping", "c"},   ModelQuantity{"parameters.coulomb_friction", "Kf"},
    ModelQuantity{"parameters.torque_constant", "phi"}, ModelQuantity{"parameters.inertia", "J"},
    ModelQuantity{"ratios.c_over_J", "c_over_J"},       ModelQuantity{"ratios.Kf_over_J", "Kf_over_J"},
    ModelQuantity{"ratios.phi_over_J", "phi_over_J"},   ModelQuantity{"ratios.c_over_phi", "c_over_phi"},
    ModelQuantity{"ratios.Kf_over_phi", "Kf_over_phi"},
};

struct ModelRatio {
    const char* symbol;
    const char* above;
    const char* below;
};

bool isGiven(DocumentReader& reader, std::string_view symbol) {
    constexpr std::array Sources = {std::pair{std::string_view("c"), "parameters.viscous_damping.source"},
                                    std::pair{std::string_view("Kf"), "parameters.coulomb_friction.source"},
                                    std::pair{std::string_view("phi"), "parameters.torque_constant.source"},
                                    std::pair{std::string_view("J"), "parameters.inertia.source"}};
    const auto found = std::find_if(Sources.begin(), Sources.end(),
                                    [&](const auto& source) { return source.first == symbol; });
    const JsonValue* source = found == Sources.end() ? nullptr : reader.find(found->second, false);
    return source != nullptr && source->isText() && source->text() == "given";
}

constexpr std::array ModelRatios = {
    ModelRatio{"c_over_J", "c", "J"},       ModelRatio{"Kf_over_J", "Kf", "J"},
    ModelRatio{"phi_over_J", "phi", "J"},   ModelRatio{"c_over_phi", "c", "phi"},
    ModelRatio{"Kf_over_phi", "Kf", "phi"},
};

/// Half of the program works with ratios, half with absolute values: one number that was changed alone would
/// give two motors.
/// Two constants that are given may differ from the ratio that was measured: identify says so itself.
void checkRatios(DocumentReader& reader, const MotorEstimate& estimate) {
    constexpr double Rounding_ratio = 5e-3; // of numbers that somebody wrote with three digits
    const auto valueOf = [&](const char* symbol) -> std::optional<double> {
        const auto found = estimate.values.find(symbol);
        return found == estimate.values.end() ? std::nullopt : std::optional(found->second);
    };
    constexpr std::array Constants = {"c", "Kf", "phi", "J"};
    const auto given = std::count_if(Constants.begin(), Constants.end(),
                                     [&](const char* constant) { return isGiven(reader, constant); });
    if (given > 1) {
        return;
    }
    for (const ModelRatio& ratio : ModelRatios) {
        const auto stated = valueOf(ratio.symbol);
        const auto above = valueOf(ratio.above);
        const auto below = valueOf(ratio.below);
        if (!stated || !above || !below || *below == 0.0) {
            continue;
        }
        const double computed = *above / *below;
        if (!(std::abs(*stated - computed) <=
              Rounding_ratio * std::max(std::abs(*stated), std::abs(computed)))) {
            reader.fail(fmt::format("ratios.{}.value", ratio.symbol),
                        fmt::format("is {:.6g}, but the parameters say {}/{} = {:.6g}", *stated, ratio.above,
                                    ratio.below, computed),
                        "the values of a model depend on each other: identify again with --given, e.g. "
                        "'halbench identify FILE.csv --given J=5.5e-4 --out'");
        }
    }
}

std::vector<double> readRow(DocumentReader& reader, const JsonValue& row) {
    std::vector<double> numbers;
    if (!row.isArray()) {
        reader.fail("covariance.matrix", "must be a list of lists of numbers");
        return numbers;
    }
    for (const JsonValue& item : row.items()) {
        if (!item.isNumber()) {
            reader.fail("covariance.matrix", "must hold finite numbers");
            return numbers;
        }
        numbers.push_back(item.number());
    }
    return numbers;
}

void readCovariance(DocumentReader& reader, MotorEstimate& estimate) {
    const JsonValue* names = reader.find("covariance.names", true);
    const JsonValue* matrix = reader.find("covariance.matrix", true);
    if (names == nullptr || matrix == nullptr || !names->isArray() || !matrix->isArray() ||
        names->items().size() != matrix->items().size()) {
        reader.fail("covariance", "needs as many rows as names");
        return;
    }
    for (const JsonValue& name : names->items()) {
        estimate.covarianceNames.push_back(name.isText() ? name.text() : std::string());
    }
    for (const JsonValue& row : matrix->items()) {
        estimate.covariance.push_back(readRow(reader, row));
        if (estimate.covariance.back().size() != names->items().size()) {
            reader.fail("covariance.matrix", "must be square");
        }
    }
}

/// Files of older versions do not say it.
MeasuredTiming readTiming(DocumentReader& reader) {
    MeasuredTiming timing;
    timing.period_s = reader.optionalNumber("sample_period_s");
    if (reader.optionalNumber("delay_samples")) {
        timing.delay_samples = static_cast<int>(reader.wholeNumber("delay_samples", 2.0));
    }
    return timing;
}

std::optional<devices::DeviceInfo> readDevice(DocumentReader& reader) {
    const JsonValue* device = reader.find("device", true);
    if (device == nullptr || !device->isObject()) {
        return std::nullopt;
    }
    devices::DeviceInfo info;
    info.model = reader.text("device.model");
    info.id = reader.text("device.id");
    info.firmware = reader.text("device.firmware");
    const JsonValue* simulated = reader.find("device.simulated", true);
    info.isSimulated = simulated != nullptr && simulated->isBoolean() && simulated->boolean();
    info.overrides = deviceOf(device)->overrides; // else the same simulated motor would be another one
    return info;
}

std::optional<control::PidForm> formNamed(const std::string& name) {
    for (const control::PidForm form :
         {control::PidForm::Parallel, control::PidForm::Standard, control::PidForm::Series}) {
        if (name == control::pidFormName(form)) {
            return form;
        }
    }
    return std::nullopt;
}

/// What a file asks for beyond the board's law, a set-point weight or a notch, is not left out: the loop
/// would be another one than it says.
void refuseUnknown(DocumentReader& reader) {
    static constexpr std::array Known = {"kp",
                                         "ki",
                                         "kd",
                                         "k",
                                         "ti",
                                         "td",
                                         "filter_s",
                                         "feedforward_inertia",
                                         "feedforward_viscous",
                                         "feedforward_coulomb",
                                         "feedforward_coulomb_speed",
                                         "stiction_current",
                                         "stiction_threshold",
                                         "stiction_speed"};
    const JsonValue* gains = reader.find("gains", true);
    if (gains == nullptr || !gains->isObject()) {
        return;
    }
    for (const JsonMember& gain : gains->members()) {
        const bool isKnown =
            std::any_of(Known.begin(), Known.end(), [&gain](const char* name) { return gain.key == name; });
        if (!isKnown && !gain.value.isNull()) {
            reader.fail("gains." + gain.key, "not available in the device's control law",
                        "omit it to use these gains; weights and filters are assessed by 'halbench analyse' "
                        "and 'halbench tune --gains'");
        }
    }
}

/// The three numbers in the form that the file is written in.
control::PidGains readGains(DocumentReader& reader) {
    control::PidGains gains;
    const auto form = formNamed(reader.text("form"));
    if (!form) {
        reader.fail("form", "must be \"parallel\", \"standard\" or \"series\"");
    }
    gains.form = form.value_or(control::PidForm::Parallel);
    const bool isParallel = gains.form == control::PidForm::Parallel;
    gains.proportional = reader.number(isParallel ? "gains.kp.value" : "gains.k.value");
    gains.derivative = reader.number(isParallel ? "gains.kd.value" : "gains.td.value");
    // Without integral action its time is infinite, which JSON cannot say: null.
    gains.integral =
        isParallel
            ? reader.number("gains.ki.value")
            : reader.optionalNumber("gains.ti.value").value_or(std::numeric_limits<double>::infinity());
    gains.filter_s = reader.optionalNumber("gains.filter_s.value");
    return gains;
}

control::DesignTargets targetsOf(const JsonValue* targets) {
    return {numberIn(targets, "zeta"),
            numberIn(targets, "omega_rad_s"),
            numberIn(targets, "bandwidth_hz"),
            numberIn(targets, "phase_margin_deg"),
            numberIn(targets, "max_sensitivity"),
            numberIn(targets, "current_limit_A"),
            numberIn(targets, "step_deg"),
            numberIn(targets, "ultimate_gain_A_per_rad"),
            numberIn(targets, "ultimate_period_s")};
}

/// A sampled loop has no frequency beyond half its rate.
void checkTargets(DocumentReader& reader, const control::DesignTargets& targets,
                  const control::LoopTiming& timing) {
    const double half_Hz = 0.5 / timing.period_s;
    const auto check = [&](const char* key, const std::optional<double>& value, double most) {
        if (value && *value >= most) {
            reader.fail(
                key, fmt::format("is {:.6g}, must be below {:.6g}, half of the sampling rate", *value, most));
        }
    };
    check("targets.bandwidth_hz", targets.bandwidth_Hz, half_Hz);
    check("targets.omega_rad_s", targets.omega_rad_s, 2.0 * Pi * half_Hz);
}

/// An interval of what must be positive, as far as the file has one.
std::optional<std::pair<double, double>> intervalAt(DocumentReader& reader, const std::string& path) {
    const JsonValue* interval = reader.find(path + ".ci95", false);
    if (interval == nullptr || !interval->isArray() || interval->items().size() != 2 ||
        !interval->items()[0].isNumber() || !interval->items()[1].isNumber()) {
        return std::nullopt; // checkIntervals() has judged it
    }
    return std::pair(interval->items()[0].number(), interval->items()[1].number());
}

void checkIntervals(DocumentReader& reader) {
    for (const ModelQuantity& quantity : ModelQuantities) {
        const JsonValue* written = reader.find(quantity.path, false);
        if (const auto problem = written != nullptr ? intervalProblem(*written) : std::nullopt) {
            reader.fail(std::string(quantity.path) + ".ci95", *problem);
        }
    }
}

/// No motor has a constant below zero. Damping and friction may come out a little below it within their
/// interval.
void checkSigns(DocumentReader& reader, const MotorEstimate& estimate) {
    for (const ModelQuantity& quantity : ModelQuantities) {
        const auto found = estimate.values.find(quantity.symbol);
        const std::string_view symbol = quantity.symbol;
        const bool mayBeZero = symbol.starts_with("c") || symbol.starts_with("Kf");
        if (found == estimate.values.end() || found->second > 0.0 || (mayBeZero && found->second == 0.0)) {
            continue;
        }
        const auto interval = intervalAt(reader, quantity.path);
        if (!mayBeZero || !interval || interval->second < 0.0) {
            reader.fail(std::string(quantity.path) + ".value",
                        fmt::format("is {:.6g}, not possible for a motor", found->second),
                        "check the signs of current and angle in the recording, then identify again");
        }
    }
}

/// What must be positive is known to be so: an interval that reaches zero leaves even its sign open.
void checkPositive(DocumentReader& reader) {
    for (const char* path : {"parameters.torque_constant", "parameters.inertia", "ratios.phi_over_J"}) {
        if (const auto interval = intervalAt(reader, path); interval && interval->first <= 0.0) {
            reader.fail(std::string(path) + ".ci95",
                        fmt::format("reaches from {:.6g} to {:.6g}: whether it is above zero is unknown",
                                    interval->first, interval->second),
                        "identify again with larger currents");
        }
    }
}

/// A damping rate that may be negative leaves the loop in doubt, whatever the file's verdict says.
DataQuality judgedQuality(DocumentReader& reader, DataQuality quality) {
    const auto damping = intervalAt(reader, "ratios.c_over_J");
    if (damping && damping->first < 0.0) {
        quality.verdict = std::max(quality.verdict, Verdict::Doubtful);
        quality.findings.push_back(
            {"damping_below_zero",
             fmt::format("lower end of the interval of c/J: {:.4g} 1/s", damping->first),
             "use a longer time at each current"});
    }
    return quality;
}

} // namespace

Result<ModelFile> parseModel(const std::string& text, const std::string& origin) {
    const Result<JsonValue> root = parseDocument(text, origin);
    if (!root) {
        return failure(root.error());
    }
    DocumentReader reader(*root, origin, "identify");
    reader.requireSchema("halbench.identification", 1);
    ModelFile file;
    for (const ModelQuantity& quantity : ModelQuantities) {
        reader.find(quantity.path, true);
        const std::optional<double> value = reader.optionalNumber(std::string(quantity.path) + ".value");
        if (value) {
            file.estimate.values[quantity.symbol] = *value;
        }
    }
    checkIntervals(reader);
    checkPositive(reader);
    checkSigns(reader, file.estimate);
    checkRatios(reader, file.estimate);
    readCovariance(reader, file.estimate);
    file.estimate.timing = readTiming(reader);
    file.device = readDevice(reader);
    file.seed = static_cast<std::uint64_t>(reader.wholeNumber("seed", 9.0e15));
    (void)reader.text("data_quality.verdict");
    if (reader.error()) {
        return failure(*reader.error());
    }
    if (const Result<void> possible = checkCovarianceLimits(*root, origin); !possible) {
        return failure(possible.error());
    }
    const DataQuality quality = judgedQuality(reader, qualityOf(member(&*root, "data_quality")));
    if (quality.verdict == Verdict::Refused) {
        return failure(ErrorCode::Refused, origin + ": this estimate was rejected",
                       "check its findings, then identify again");
    }
    file.estimate.doubts = doubtsOfModel(quality);
    return file;
}

Result<void> refuseAxes(const std::string& text, const std::string& origin) {
    const Result<JsonValue> root = parseJson(text, origin);
    return root && root->find("axes") != nullptr
               ? failure(ErrorCode::InvalidInput, origin + ": gains of several axes, not of a single loop",
                         "assess them with the model of those axes")
               : Result<void>();
}

Result<GainsFile> parseGains(const std::string& text, const std::string& origin) {
    if (const Result<void> single = refuseAxes(text, origin); !single) {
        return failure(single.error());
    }
    const Result<JsonValue> root = parseDocument(text, origin);
    if (!root) {
        return failure(root.error());
    }
    DocumentReader reader(*root, origin, "tune");
    reader.requireSchema("halbench.gains", 1);
    GainsFile file;
    control::PositionLaw& law = file.law;
    law.gains = readGains(reader);
    refuseUnknown(reader);
    const control::PositionLaw none;
    const auto optional = [&](const char* key, double otherwise) {
        return reader.optionalNumber(fmt::format("gains.{}.value", key)).value_or(otherwise);
    };
    law.inertia_A_s2_rad = optional("feedforward_inertia", 0.0);
    law.viscous_A_s_rad = optional("feedforward_viscous", 0.0);
    law.coulomb_A = optional("feedforward_coulomb", 0.0);
    law.coulombSpeed_rad_s = optional("feedforward_coulomb_speed", none.coulombSpeed_rad_s);
    law.stictionCurrent_A = optional("stiction_current", 0.0);
    law.stictionThreshold_rad = optional("stiction_threshold", none.stictionThreshold_rad);
    law.stictionSpeed_rad_s = optional("stiction_speed", none.stictionSpeed_rad_s);
    file.timing.period_s = reader.number("sample_period_s");
    if (reader.optionalNumber("delay_samples")) {
        file.timing.delay_samples = static_cast<int>(reader.wholeNumber("delay_samples", 2.0));
    }
    file.method = textIn(&*root, "method");
    file.targets = targetsOf(member(&*root, "targets"));
    checkTargets(reader, file.targets, file.timing);
    file.started = textIn(&*root, "started");
    file.device = deviceOf(member(&*root, "device"));
    if (reader.error()) {
        return failure(*reader.error());
    }
    const bool isFiltered = law.gains.filter_s.value_or(0.0) != 0.0;
    const Result<control::PidGains> board = control::boardGains(law.gains);
    if (!board) {
        const std::string& why = board.error().message;
        return failure(board.error().code,
                       isFiltered ? fmt::format("{}: gains.filter_s: {}", origin, why)
                                  : fmt::format("{}: gains: {}", origin, why),
                       board.error().hint);
    }
    law.gains = *board;
    if (const Result<void> valid = control::checkTiming(file.timing); !valid) {
        return failure(ErrorCode::InvalidInput, origin + ": " + valid.error().message, valid.error().hint);
    }
    return file;
}

Result<CalibrationFile> parseCalibration(const std::string& text, const std::string& origin) {
    const Result<JsonValue> root = parseDocument(text, origin);
    if (!root) {
        return failure(root.error());
    }
    DocumentReader reader(*root, origin, "calibrate");
    reader.requireSchema("halbench.calibration", 1);
    CalibrationFile file;
    file.quality = qualityOf(member(&*root, "data_quality"));
    const JsonValue* applied = reader.find("applied", true);
    file.isApplied = applied != nullptr && applied->isBoolean() && applied->boolean();
    const JsonValue* figures = reader.find("figures", true);
    // The figure's own name holds a dot, so it is no path.
    const JsonValue* stray =
        figures != nullptr && figures->isObject() ? figures->find("stray.coefficient") : nullptr;
    if (stray != nullptr) {
        const JsonValue* value = stray->find("value");
        const JsonValue* interval = stray->find("ci95");
        if (value != nullptr && value->isNumber() && interval != nullptr && interval->isArray() &&
            interval->items().size() == 2 && interval->items()[0].isNumber() &&
            interval->items()[1].isNumber()) {
            file.stray_T_per_A = value->number();
            file.stray95_T_per_A = {interval->items()[0].number(), interval->items()[1].number()};
        } else if (value == nullptr || !value->isNull()) {
            reader.fail("figures.stray.coefficient", "needs a value and the two ends of its interval");
        }
    }
    if (reader.error()) {
        return failure(*reader.error());
    }
    return file;
}

Result<ModelFile> readModelFile(const std::string& path) {
    const Result<std::string> text = readFile(path);
    if (!text) {
        return failure(text.error());
    }
    return parseModel(*text, path);
}

Result<GainsFile> readGainsFile(const std::string& path) {
    const Result<std::string> text = readFile(path);
    if (!text) {
        return failure(text.error());
    }
    return parseGains(*text, path);
}

Result<CalibrationFile> readCalibrationFile(const std::string& path) {
    const Result<std::string> text = readFile(path);
    if (!text) {
        return failure(text.error());
    }
    return parseCalibration(*text, path);
}

} // namespace halbench::app
