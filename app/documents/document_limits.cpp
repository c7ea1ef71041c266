#include "app/documents/document_limits.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace halbench::app {

namespace {

constexpr double None = std::numeric_limits<double>::infinity();

enum class Kind { Any, Above, Whole }; // `Above`: the lower end itself is excluded

struct KeyLimits {
    std::string_view key;
    double low;
    double high;
    Kind kind = Kind::Any;
};

constexpr std::array Limits = {
    // times and counts
    KeyLimits{"sample_period_s", 0.0, None, Kind::Above},
    KeyLimits{"delay_samples", 0.0, 2.0, Kind::Whole}, // of the boards' law
    KeyLimits{"duration_s", 0.0, None}, KeyLimits{"lag_s", 0.0, None},
    KeyLimits{"draws", 0.0, None, Kind::Whole}, KeyLimits{"cycles", 0.0, None, Kind::Whole},
    KeyLimits{"blocks", 0.0, None, Kind::Whole}, KeyLimits{"periods", 0.0, None, Kind::Whole},
    KeyLimits{"averages", 0.0, None, Kind::Whole}, KeyLimits{"lines", 0.0, None, Kind::Whole},
    KeyLimits{"lines_per_axis", 0.0, None, Kind::Whole},
    // measures of a fit
    KeyLimits{"r_squared", 0.0, 1.0}, KeyLimits{"asymmetry", -1.0, 1.0}, // (a - b)/(a + b) of two amounts
    KeyLimits{"residual_rms_rad_s", 0.0, None}, KeyLimits{"weight", 0.0, None},
    KeyLimits{"misfit_ratio", 0.0, None}, KeyLimits{"radius", 0.0, None},
    KeyLimits{"scatter_radius", 0.0, None}, KeyLimits{"frequency_scatter_ratio", 0.0, None},
    KeyLimits{"growth_ratio", 0.0, None}, KeyLimits{"unstable_fraction", 0.0, 1.0},
    KeyLimits{"coherence", 0.0, 1.0}, KeyLimits{"least_coherence", 0.0, 1.0},
    KeyLimits{"residual_before_deg", 0.0, 180.0}, KeyLimits{"residual_after_deg", 0.0, 180.0},
    KeyLimits{"angle_error.rms", 0.0, Pi}, KeyLimits{"highest_temperature_degC", -273.15, None},
    // oscillations
    KeyLimits{"frequency_hz", 0.0, None, Kind::Above}, KeyLimits{"from_hz", 0.0, None, Kind::Above},
    KeyLimits{"to_hz", 0.0, None, Kind::Above}, KeyLimits{"frequency_rad_s", 0.0, None},
    KeyLimits{"corner_rad_s", 0.0, None, Kind::Above}, KeyLimits{"amplitude_rad", 0.0, None},
    KeyLimits{"weave_ratio", 0.0, None}, KeyLimits{"ultimate_gain", 0.0, None, Kind::Above},
    KeyLimits{"ultimate_period", 0.0, None, Kind::Above},
    KeyLimits{"ultimate_gain_A_per_rad", 0.0, None, Kind::Above},
    KeyLimits{"ultimate_period_s", 0.0, None, Kind::Above},
    // targets of a design
    KeyLimits{"zeta", 0.0, None, Kind::Above}, KeyLimits{"omega_rad_s", 0.0, None, Kind::Above},
    KeyLimits{"bandwidth_hz", 0.0, None, Kind::Above}, KeyLimits{"phase_margin_deg", -180.0, 180.0},
    KeyLimits{"max_sensitivity", 1.0, None}, // no loop has less
    KeyLimits{"current_limit_A", 0.0, None, Kind::Above}, KeyLimits{"step_deg", 0.0, None, Kind::Above},
    // the control law: feed-forward and friction assist are amounts of the motor
    KeyLimits{"filter_s", 0.0, None}, KeyLimits{"feedforward_inertia", 0.0, None},
    KeyLimits{"feedforward_viscous", 0.0, None}, KeyLimits{"feedforward_coulomb", 0.0, None},
    KeyLimits{"feedforward_coulomb_speed", 0.0, None}, KeyLimits{"stiction_current", 0.0, None},
    KeyLimits{"stiction_threshold", 0.0, Pi}, KeyLimits{"stiction_speed", 0.0, None},
    // sensors
    KeyLimits{"hall.amplitude", 0.0, None, Kind::Above}, KeyLimits{"hall.gain_ratio", 0.0, None, Kind::Above},
    KeyLimits{"hall.quadrature", -Pi / 2.0, Pi / 2.0}, // there both sensors are one
};
constexpr std::string_view AngleErrorMap = "errormap.";
constexpr KeyLimits OfAngleErrors{AngleErrorMap, -Pi, Pi};

std::optional<KeyLimits> limitsOf(std::string_view key) {
    const auto* const found =
        std::find_if(Limits.begin(), Limits.end(), [&](const KeyLimits& entry) { return entry.key == key; });
    if (found != Limits.end()) {
        return *found;
    }
    const bool isAngleError = key.starts_with(AngleErrorMap) && key != "errormap.enabled";
    return isAngleError ? std::optional(OfAngleErrors) : std::nullopt;
}

bool isWithin(const KeyLimits& limits, double value) {
    constexpr double Rounding_ratio = 1e-9; // of numbers that went through a text
    const auto rounding = [](double limit) { return Rounding_ratio * std::abs(limit); };
    const bool isAboveLow =
        limits.kind == Kind::Above ? value > limits.low : value >= limits.low - rounding(limits.low);
    const bool isBelowHigh = limits.high == None || value <= limits.high + rounding(limits.high);
    return isAboveLow && isBelowHigh && (limits.kind != Kind::Whole || value == std::floor(value));
}

std::string problemOf(const KeyLimits& limits, double value) {
    if (limits.kind == Kind::Whole) {
        return limits.high == None
                   ? fmt::format("is {:.6g}, must be a whole number not below {:.6g}", value, limits.low)
                   : fmt::format("is {:.6g}, must be a whole number from {:.6g} to {:.6g}", value, limits.low,
                                 limits.high);
    }
    if (limits.high != None) {
        return fmt::format("is {:.6g}, must be from {:.6g} to {:.6g}", value, limits.low, limits.high);
    }
    return limits.kind == Kind::Above ? fmt::format("is {:.6g}, must be above {:.6g}", value, limits.low)
                                      : fmt::format("is {:.6g}, must not be below {:.6g}", value, limits.low);
}

Error complaint(const std::string& origin, const std::string& path, const std::string& what) {
    return {ErrorCode::InvalidInput, fmt::format("{}: \"{}\" {}", origin, path, what),
            "correct the value or write the file again"};
}

/// Goes through a document and keeps the first complaint.
class LimitsReader {
public:
    explicit LimitsReader(std::string origin) : m_origin(std::move(origin)) {}

    void read(const JsonValue& value, const std::string& path, std::string_view key) {
        if (m_error) {
            return;
        }
        if (value.isNumber()) {
            check(value.number(), path, key);
        } else if (value.isArray()) {
            readArray(value, path, key);
        } else if (value.isObject()) {
            readObject(value, path, key);
        }
    }

    const std::optional<Error>& error() const { return m_error; }

private:
    void readArray(const JsonValue& value, const std::string& path, std::string_view key) {
        std::size_t index = 0;
        for (const JsonValue& item : value.items()) {
            const JsonValue* name = item.find("name"); // {name, value, unit}
            const bool isNamed = name != nullptr && name->isText();
            read(item, fmt::format("{}[{}]", path, index++), isNamed ? std::string_view(name->text()) : key);
        }
    }

    /// The value of a quantity counts as its key; how far its interval reaches is the measurement's.
    void readObject(const JsonValue& value, const std::string& path, std::string_view key) {
        for (const JsonMember& entry : value.members()) {
            const std::string place = path.empty() ? entry.key : path + '.' + entry.key;
            read(entry.value, place, entry.key == "value" ? key : std::string_view(entry.key));
        }
    }

    void check(double value, const std::string& path, std::string_view key) {
        const std::optional<KeyLimits> limits = limitsOf(key);
        if (limits && !isWithin(*limits, value)) {
            m_error = complaint(m_origin, path, problemOf(*limits, value));
        }
    }

    std::string m_origin;
    std::optional<Error> m_error;
};

using Matrix = std::vector<std::vector<double>>;

/// Nothing where the matrix is no square of numbers.
std::optional<Matrix> matrixOf(const JsonValue& document) {
    const JsonValue* covariance = document.find("covariance");
    const JsonValue* rows = covariance == nullptr ? nullptr : covariance->find("matrix");
    if (rows == nullptr || !rows->isArray()) {
        return std::nullopt;
    }
    Matrix matrix;
    for (const JsonValue& row : rows->items()) {
        if (!row.isArray() || row.items().size() != rows->items().size()) {
            return std::nullopt;
        }
        matrix.emplace_back();
        for (const JsonValue& item : row.items()) {
            if (!item.isNumber()) {
                return std::nullopt;
            }
            matrix.back().push_back(item.number());
        }
    }
    return matrix;
}

} // namespace

Result<void> checkLimits(const JsonValue& document, const std::string& origin) {
    LimitsReader reader(origin);
    reader.read(document, "", "");
    return reader.error() ? failure(*reader.error()) : Result<void>();
}

Result<void> checkCovarianceLimits(const JsonValue& document, const std::string& origin) {
    constexpr double Rounding_ratio = 1e-6; // of matrices that went through a text
    const std::optional<Matrix> matrix = matrixOf(document);
    for (std::size_t i = 0; matrix && i < matrix->size(); ++i) {
        const double variance = (*matrix)[i][i];
        if (variance < 0.0) {
            return failure(complaint(origin, fmt::format("covariance.matrix[{}][{}]", i, i),
                                     fmt::format("is {:.6g}, no variance is negative", variance)));
        }
        for (std::size_t j = 0; j < i; ++j) {
            const double one = (*matrix)[i][j];
            const double other = (*matrix)[j][i];
            const double most = std::sqrt(variance * (*matrix)[j][j]) * (1.0 + Rounding_ratio);
            const std::string place = fmt::format("covariance.matrix[{}][{}]", i, j);
            if (std::abs(one - other) > Rounding_ratio * std::max(std::abs(one), std::abs(other))) {
                return failure(
                    complaint(origin, place,
                              fmt::format("is {:.6g} and [{}][{}] {:.6g}: must be equal", one, j, i, other)));
            }
            if (std::abs(one) > most) {
                return failure(
                    complaint(origin, place,
                              fmt::format("is {:.6g}, a correlation beyond 1: at most {:.6g}", one, most)));
            }
        }
    }
    return {};
}

} // namespace halbench::app
