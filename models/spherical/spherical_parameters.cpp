#include "models/spherical/spherical_parameters.h"

#include "control/base/assert.h"
#include "control/base/choice_words.h"
#include "control/base/units.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

using P = SphericalParameters;
using Spec = SphericalParameterSpec;

constexpr double Milli = 1e-3;
constexpr double Micro = 1e-6;
constexpr double Degree = Pi / 180.0;

constexpr std::string_view FaultWords = "none|dead|stuck|clipped";
constexpr std::string_view NoiseKey = "noise";

// A value that every specimen shares, a choice among words, an error drawn unless it is written down.
#define HB_SHARED(key, unit, min, max, toSi, provenance, meaning, member)                                    \
    Spec {                                                                                                   \
        key, unit, min, max, toSi, provenance, meaning, [](P& p) -> double& { return p.member; }             \
    }
#define HB_CHOICE(key, words, meaning, member)                                                               \
    Spec {                                                                                                   \
        key, "", 0.0, lastChoice(words), 1.0, 'A', meaning, [](P& p) -> double& { return p.member; },        \
            nullptr, true, words                                                                             \
    }
#define HB_DRAWN(key, unit, limit, toSi, meaning, member)                                                    \
    Spec {                                                                                                   \
        key, unit, -(limit), limit, toSi, 'A', meaning, nullptr,                                             \
            [](P& p) -> std::optional<double>& { return p.member; }                                          \
    }
#define HB_ERROR(n, i, axis, k)                                                                              \
    HB_DRAWN("s" n "_gain_error_" axis, "", 0.2, 1.0, "gain error of sensor " n " along " axis "; drawn",    \
             errors[i].gain_ratio[k]),                                                                       \
        HB_DRAWN("s" n "_offset_" axis "_uT", "uT", 2e4, Micro,                                              \
                 "offset of sensor " n " along " axis "; drawn", errors[i].offset_T[k])
#define HB_MOUNT(n, i, axis, k)                                                                              \
    HB_DRAWN("s" n "_turn_" axis "_deg", "deg", 20.0, Degree,                                                \
             "mounting error of sensor " n " about stator " axis "; drawn", errors[i].turn_rad[k]),          \
        HB_DRAWN("s" n "_shift_" axis "_mm", "mm", 3.0, Milli,                                               \
                 "place error of sensor " n " along stator " axis "; drawn", errors[i].shift_m[k])
#define HB_SENSOR(n, i)                                                                                      \
    HB_SHARED("s" n "_alpha_deg", "deg", -180.0, 180.0, Degree, 'S', "placement of sensor " n " about X",    \
              placement[i].alpha_rad),                                                                       \
        HB_SHARED("s" n "_beta_deg", "deg", -180.0, 180.0, Degree, 'S', "placement of sensor " n " about Y", \
                  placement[i].beta_rad),                                                                    \
        HB_SHARED("s" n "_gamma_deg", "deg", -180.0, 180.0, Degree, 'S',                                     \
                  "placement of sensor " n " about Z", placement[i].gamma_rad),                              \
        HB_ERROR(n, i, "r", 0), HB_ERROR(n, i, "theta", 1), HB_ERROR(n, i, "phi", 2),                        \
        HB_MOUNT(n, i, "x", 0), HB_MOUNT(n, i, "y", 1), HB_MOUNT(n, i, "z", 2),                              \
        HB_CHOICE("s" n "_fault_r", FaultWords, "fault of channel R of sensor " n, fault[3 * i]),            \
        HB_CHOICE("s" n "_fault_theta", FaultWords, "fault of channel Theta of sensor " n,                   \
                  fault[3 * i + 1]),                                                                         \
        HB_CHOICE("s" n "_fault_phi", FaultWords, "fault of channel Phi of sensor " n, fault[3 * i + 2])

const std::array Specs = {
    HB_SHARED("R0_mm", "mm", 5.0, 500.0, Milli, 'S', "outer radius of the rotor", magnet.outerRadius_m),
    HB_SHARED("Ri_mm", "mm", 1.0, 500.0, Milli, 'S', "radius of the rotor's core", magnet.coreRadius_m),
    HB_SHARED("pole_deg", "deg", 1.0, 90.0, Degree, 'S', "pole angle of the magnet", magnet.poleAngle_rad),
    HB_SHARED("Br", "T", 0.01, 2.0, 1.0, 'S', "remanence", magnet.remanence_T),
    HB_SHARED("mu_r", "", 1.0, 2.0, 1.0, 'S', "relative recoil permeability",
              magnet.recoilPermeability_ratio),
    HB_SHARED("mu_m", "", 1.0, 1e4, 1.0, 'D', "relative permeability of the core",
              magnet.corePermeability_ratio),
    HB_SHARED("a2", "", 0.1, 10.0, 1.0, 'S', "azimuthal coefficient", magnet.azimuthalCoefficient),
    HB_CHOICE("device", "exact|paper", "device model: exact, or additive angles as published", device),
    HB_SHARED("r_mm", "mm", 5.0, 500.0, Milli, 'S', "distance of the sensors from the centre",
              sensorRadius_m),
    HB_CHOICE("frames", "zyx|xyz|nat", "how placement angles turn a sensor; nat is unrolled", frames),
    HB_CHOICE("harmonics", "none|h1|h2", "further harmonics: h1 as finite elements, h2 stress", harmonics),
    HB_DRAWN("A42_mT", "mT", 500.0, Milli, "harmonic (4,2) at 50 mm instead of the preset's", amplitude_T[0]),
    HB_DRAWN("A62_mT", "mT", 500.0, Milli, "harmonic (6,2) at 50 mm instead of the preset's", amplitude_T[1]),
    HB_DRAWN("A66_mT", "mT", 500.0, Milli, "harmonic (6,6) at 50 mm instead of the preset's", amplitude_T[2]),
    HB_DRAWN("A1010_mT", "mT", 500.0, Milli, "harmonic (10,10) at 50 mm instead of the preset's",
             amplitude_T[3]),
    HB_SENSOR("0", 0),
    HB_SENSOR("1", 1),
    HB_SENSOR("2", 2),
    HB_SHARED("gain_sigma", "", 0.0, 0.1, 1.0, 'A', "spread of the drawn gains, 1 sigma", gainSpread_ratio),
    HB_SHARED("offset_sigma_uT", "uT", 0.0, 1e4, Micro, 'A', "spread of the drawn offsets, 1 sigma",
              offsetSpread_T),
    HB_SHARED("cross_sigma", "", 0.0, 0.1, 1.0, 'A', "spread of the drawn cross-axis shares, 1 sigma",
              crossSpread_ratio),
    HB_SHARED("turn_sigma_deg", "deg", 0.0, 10.0, Degree, 'A', "spread of the drawn mounting angles, 1 sigma",
              turnSpread_rad),
    HB_SHARED("shift_sigma_mm", "mm", 0.0, 1.0, Milli, 'A', "spread of the drawn places, 1 sigma",
              shiftSpread_m),
    HB_CHOICE("noise", "none|averaged|single-shot|poor",
              "noise of a usual part: noise_uT is 0, 25, 100 or 1000 uT", noisePreset),
    HB_SHARED("noise_uT", "uT", 0.0, 1e5, Micro, 'A', "noise of a reading, rms", noise_T),
    HB_CHOICE("adc", "300mT|400mT|130mT|100mT", "range of the converter: 12 bit, 130mT in steps of 98 uT",
              converter),
    HB_SHARED("stray_x_uT", "uT", -1e5, 1e5, Micro, 'A', "uniform stray field along X", strayField_T[0]),
    HB_SHARED("stray_y_uT", "uT", -1e5, 1e5, Micro, 'A', "uniform stray field along Y", strayField_T[1]),
    HB_SHARED("stray_z_uT", "uT", -1e5, 1e5, Micro, 'A', "uniform stray field along Z", strayField_T[2]),
    HB_SHARED("coil_theta_deg", "deg", 0.0, 180.0, Degree, 'S', "place of the stator coil, from Z",
              coilTheta_rad),
    HB_SHARED("coil_phi_deg", "deg", -180.0, 180.0, Degree, 'S', "place of the stator coil, from X",
              coilPhi_rad),
    HB_SHARED("coil_distance_mm", "mm", 5.0, 1000.0, Milli, 'A', "distance of the coil's centre",
              coilDistance_m),
    HB_SHARED("coil_radius_mm", "mm", 0.5, 200.0, Milli, 'A', "radius of the stator coil", coilRadius_m),
    HB_SHARED("coil_turns", "", 1.0, 1e4, 1.0, 'S', "turns of the stator coil", coilTurns),
    HB_SHARED("coil_A", "A", -100.0, 100.0, 1.0, 'A', "current of the stator coil", coilCurrent_A),
    HB_SHARED("ambient_C", "degC", -40.0, 125.0, 1.0, 'A', "temperature at the start", ambient_degC),
    HB_SHARED("warm_rise_K", "K", -60.0, 100.0, 1.0, 'A', "final rise of the magnet", warmRise_K),
    HB_SHARED("warm_time_s", "s", 0.1, 1e5, 1.0, 'A', "time constant of the rise", warmTime_s),
    HB_SHARED("strength_per_K", "1/K", -0.01, 0.01, 1.0, 'A', "relative change of the field with temperature",
              strengthTemperature_per_K),
    HB_DRAWN("temp_error_K", "K", 10.0, 1.0, "error of the temperature sensor; drawn", temperatureError_K),
    HB_SHARED("temp_sigma_K", "K", 0.0, 5.0, 1.0, 'A', "spread of the drawn temperature errors, 1 sigma",
              temperatureSpread_K),
    HB_CHOICE("motion", "setpoint|published1|published2|published3|published4|tumble|walk",
              "motion of the rotor; published1 to published4 are trajectories", motion),
    HB_SHARED("alpha_deg", "deg", -180.0, 180.0, Degree, 'A', "start, rotation about X", start.alpha_rad),
    HB_SHARED("beta_deg", "deg", -90.0, 90.0, Degree, 'A', "start, rotation about Y", start.beta_rad),
    HB_SHARED("gamma_deg", "deg", -180.0, 180.0, Degree, 'A', "start, spin about the shaft", start.gamma_rad),
    HB_SHARED("rate_deg_s", "deg/s", 0.01, 1e4, Degree, 'A', "rate towards a set-point, spin of tumbling",
              rate_rad_s),
    HB_SHARED("spin_deg", "deg", -180.0, 180.0, Degree, 'A', "spin along the published trajectories",
              spin_rad),
    HB_SHARED("sample_s", "s", 1e-3, 100.0, 1.0, 'A', "time between two published samples", sampleTime_s),
    HB_SHARED("tilt_deg", "deg", 0.1, 180.0, Degree, 'A', "tilt of tumbling, limit of the random walk",
              tilt_rad),
    HB_SHARED("tumble_Hz", "Hz", 0.0, 100.0, 1.0, 'A', "frequency of tumbling about X", tumbleFrequency_Hz),
    HB_SHARED("walk_deg", "deg", 0.0, 360.0, Degree, 'A', "random walk: rms of an axis after one second",
              walk_rad_per_rootS),
};

constexpr std::array<std::pair<int, int>, 4> AmplitudeShapes = {{{4, 2}, {6, 2}, {6, 6}, {10, 10}}};

} // namespace

std::span<const SphericalParameterSpec> sphericalParameterSpecs() {
    return Specs;
}

const SphericalParameterSpec* findSphericalParameter(std::string_view key) {
    const auto found =
        std::find_if(Specs.begin(), Specs.end(), [key](const Spec& spec) { return spec.key == key; });
    return found == Specs.end() ? nullptr : &*found;
}

std::vector<std::string> sphericalParameterWords(std::string_view key) {
    const Spec* spec = findSphericalParameter(key);
    return spec == nullptr ? std::vector<std::string>() : choiceWords(spec->words);
}

std::string sphericalParameterKeys() {
    std::string keys;
    for (const Spec& spec : Specs) {
        keys += (keys.empty() ? "" : ", ") + std::string(spec.key);
    }
    return keys + ", seed, imperfections, chain";
}

Result<void> setSphericalParameter(SphericalParameters& parameters, std::string_view key, double value) {
    const Spec* spec = findSphericalParameter(key);
    if (spec == nullptr) {
        return failure(ErrorCode::UnknownName, fmt::format("the spherical motor has no parameter '{}'", key),
                       "Known keys: " + sphericalParameterKeys() + ".");
    }
    const std::string hint =
        spec->isWhole ? fmt::format("Allowed: {}.", fmt::join(sphericalParameterWords(key), ", "))
                      : fmt::format("Allowed: {} to {}{}{}. Known keys: {}.", spec->min, spec->max,
                                    spec->unit.empty() ? "" : " ", spec->unit, sphericalParameterKeys());
    if (!std::isfinite(value)) {
        return failure(ErrorCode::NotFinite, fmt::format("{} is not a finite number", spec->key), hint);
    }
    if (value < spec->min || value > spec->max || (spec->isWhole && value != std::round(value))) {
        return failure(ErrorCode::OutOfRange, fmt::format("{} = {} is out of range", spec->key, value), hint);
    }
    if (spec->value != nullptr) {
        spec->value(parameters) = value * spec->toSi;
        if (spec->key == NoiseKey) {
            parameters.noise_T = NoisePresets_T[static_cast<std::size_t>(value)];
        }
    } else {
        spec->specimen(parameters) = value * spec->toSi;
    }
    return {};
}

std::optional<double> sphericalParameter(const SphericalParameters& parameters, std::string_view key) {
    const Spec* spec = findSphericalParameter(key);
    HB_ASSERT(spec != nullptr);
    SphericalParameters copy = parameters;
    if (spec->value != nullptr) {
        return spec->value(copy) / spec->toSi;
    }
    const std::optional<double> si = spec->specimen(copy);
    return si ? std::optional<double>(*si / spec->toSi) : std::nullopt;
}

Result<void> checkSphericalParameters(const SphericalParameters& parameters) {
    if (auto checked = checkSphericalRotorMagnet(parameters.magnet); !checked) {
        return checked;
    }
    const CurrentLoop coil = statorCoilOf(parameters);
    if (auto checked = checkCurrentLoop(coil); !checked) {
        return checked;
    }
    if (coil.centre_m.norm() <= parameters.magnet.outerRadius_m) {
        return failure(ErrorCode::OutOfRange, "The stator coil lies inside the rotor.",
                       "Make coil_distance_mm larger than R0_mm.");
    }
    if (auto checked = checkRotorMotion(motionOf(parameters)); !checked) {
        return checked;
    }
    return checkSensorPoses(sensorPoses(parameters.placement,
                                        static_cast<SensorFrames>(static_cast<int>(parameters.frames)),
                                        parameters.sensorRadius_m),
                            parameters.magnet.outerRadius_m);
}

SphericalParameters withoutImperfections(SphericalParameters parameters) {
    parameters.gainSpread_ratio = parameters.offsetSpread_T = parameters.crossSpread_ratio = 0.0;
    parameters.turnSpread_rad = parameters.shiftSpread_m = parameters.temperatureSpread_K = 0.0;
    for (FieldSensorErrors& error : parameters.errors) {
        error.gain_ratio.fill(0.0);
        error.offset_T.fill(0.0);
        error.turn_rad.fill(0.0);
        error.shift_m.fill(0.0);
    }
    parameters.temperatureError_K = 0.0;
    parameters.noise_T = parameters.noisePreset = 0.0;
    parameters.fault = {};
    parameters.strayField_T.setZero();
    parameters.coilCurrent_A = 0.0;
    parameters.warmRise_K = 0.0;
    return parameters;
}

SphericalParameters withIdealChain(SphericalParameters parameters) {
    parameters = withoutImperfections(parameters);
    parameters.isIdealChain = true;
    return parameters;
}

RotorFieldConfig rotorFieldOf(const SphericalParameters& parameters) {
    RotorFieldConfig field;
    field.strength_T = tensorStrength_T(parameters.magnet, field.referenceRadius_m);
    field.harmonics = harmonicPreset(static_cast<HarmonicPreset>(static_cast<int>(parameters.harmonics)));
    for (std::size_t i = 0; i < AmplitudeShapes.size(); ++i) {
        if (!parameters.amplitude_T[i]) {
            continue;
        }
        const auto [degree, order] = AmplitudeShapes[i];
        const auto isShape = [degree = degree, order = order](const SphericalHarmonicTerm& term) {
            return term.degree == degree && term.order == order;
        };
        const auto given = std::find_if(field.harmonics.begin(), field.harmonics.end(), isShape);
        if (given != field.harmonics.end()) {
            given->amplitude_T = *parameters.amplitude_T[i];
        } else {
            field.harmonics.push_back({degree, order, *parameters.amplitude_T[i]});
        }
    }
    return field;
}

CurrentLoop statorCoilOf(const SphericalParameters& parameters) {
    CurrentLoop coil;
    const double s = std::sin(parameters.coilTheta_rad);
    coil.axis = {s * std::cos(parameters.coilPhi_rad), s * std::sin(parameters.coilPhi_rad),
                 std::cos(parameters.coilTheta_rad)};
    coil.centre_m = parameters.coilDistance_m * coil.axis;
    coil.radius_m = parameters.coilRadius_m;
    coil.turns = parameters.coilTurns;
    return coil;
}

RotorMotionConfig motionOf(const SphericalParameters& parameters) {
    RotorMotionConfig motion;
    motion.kind = static_cast<MotionKind>(static_cast<int>(parameters.motion));
    motion.start = parameters.start;
    motion.rate_rad_s = parameters.rate_rad_s;
    motion.spin_rad = parameters.spin_rad;
    motion.sampleTime_s = parameters.sampleTime_s;
    motion.tilt_rad = parameters.tilt_rad;
    motion.tumbleFrequency_Hz = parameters.tumbleFrequency_Hz;
    motion.walk_rad_per_rootS = parameters.walk_rad_per_rootS;
    return motion;
}

} // namespace halbench::models
