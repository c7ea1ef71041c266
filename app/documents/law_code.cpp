#include "app/documents/law_code.h"

#include "app/documents/filtered_gains.h"
#include "app/documents/text/output_file.h"
#include "control/law/filtered_delta.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace halbench::app {
namespace {

constexpr const char* BoardEquation = R"( *   u = KP e + x + KD (ref' - (angle[k] - angle[k-1])/TS)
 *       + INERTIA ref'' + VISCOUS ref' + COULOMB sat(ref'/COULOMB_SPEED)
 *       + (|ref'| < STICTION_SPEED and |e| > STICTION_THRESHOLD) STICTION sgn(e)
 *   e = ref - angle, u limited to +-LIMIT; while it is limited x changes only if e u < 0:
 *   x += TS KI e
)";
constexpr const char* FilteredEquation = R"( *   u = F [ KP (WEIGHT_B ref - angle) + x + KD d ]
 *       + INERTIA ref'' + VISCOUS ref' + COULOMB sat(ref'/COULOMB_SPEED)
 *       + (|ref'| < STICTION_SPEED and |e| > STICTION_THRESHOLD) STICTION sgn(e)
 *   d = (TF d + TS ((1 - WEIGHT_C) ref' + (w[k] - w[k-1])/TS))/(TF + TS), w = WEIGHT_C ref - angle:
 *   of a jump of ref the derivative sees the share WEIGHT_C, of a smooth one always the speed
 *   F: the sections in series, (B0 D^2 + B1 D + B2)/(D^2 + A1 D + A2) in the shift D = z - 1
 *   e = ref - angle, u limited to +-LIMIT; while it is limited x changes only if e u < 0, F goes on:
 *   x += TS KI e
)";

constexpr const char* BoardMemory = R"(
typedef struct {
    double integral_A;
    double previous_angle_rad;
    int is_started;
} position_law;

/* Before the first sample, and whenever the motor was disarmed. */
static inline void position_law_start(position_law* law) {
    law->integral_A = 0.0;
    law->previous_angle_rad = 0.0;
    law->is_started = 0;
}
)";
constexpr const char* SectionMemory = R"(
/* In the shift D = z - 1 slow filters keep their digits. */
typedef struct {
    double first;
    double second;
} position_law_section;
)";
constexpr const char* SectionStep = R"(
static inline double position_law_filtered(position_law* law, double current) {
    int i;
    for (i = 0; i < SECTIONS; ++i) {
        position_law_section* section = &law->sections[i];
        const double* f = FILTERS[i];
        double filtered = f[0] * current + section->first;
        section->first += section->second + (f[1] * current - f[3] * filtered);
        section->second += f[2] * current - f[4] * filtered;
        current = filtered;
    }
    return current;
}
)";

constexpr const char* Sign = R"(
static inline double position_law_sign(double value) {
    return (double)(value > 0.0) - (double)(value < 0.0);
}
)";
constexpr const char* StepHead = R"(
/* Once every TS: the current in A. The reference's speed and acceleration are 0 where it rests. */
static inline double position_law_step(position_law* law, double angle_rad, double ref_rad, double ref_rad_s,
                                       double ref_rad_s2) {
    double error = ref_rad - angle_rad;
)";
constexpr const char* BoardMoved =
    R"(    double moved = law->is_started ? angle_rad - law->previous_angle_rad : 0.0;
)";
constexpr const char* FilteredMoved = R"(    double weighted = WEIGHT_C * ref_rad - angle_rad;
    double moved = law->is_started ? weighted - law->previous_weighted_rad : 0.0;
)";
constexpr const char* StepBody = R"(    double speed = ref_rad_s < 0.0 ? -ref_rad_s : ref_rad_s;
    double distance = error < 0.0 ? -error : error;
    double friction = speed >= COULOMB_SPEED ? position_law_sign(ref_rad_s) : ref_rad_s / COULOMB_SPEED;
)";
constexpr const char* BoardDemand =
    R"(    double demand = KP * error + law->integral_A + KD * (ref_rad_s - moved / TS) + INERTIA * ref_rad_s2 +
                    VISCOUS * ref_rad_s + COULOMB * friction;
    double current;
)";
constexpr const char* StepTail = R"(    if (speed < STICTION_SPEED && distance > STICTION_THRESHOLD) {
        demand += STICTION * position_law_sign(error);
    }
    current = demand > LIMIT ? LIMIT : demand < -LIMIT ? -LIMIT : demand;
    if (current == demand || error * demand < 0.0) {
        law->integral_A += TS * KI * error;
    }
)";
constexpr const char* BoardEnd = R"(    law->previous_angle_rad = angle_rad;
    law->is_started = 1;
    return current;
}
)";
constexpr const char* FilteredEnd = R"(    law->previous_weighted_rad = weighted;
    law->is_started = 1;
    return current;
}
)";

/// Text of a file must not end the comment that it stands in.
std::string inComment(std::string text) {
    std::replace_if(
        text.begin(), text.end(),
        [](char sign) { return sign == '*' || sign == '/' || static_cast<unsigned char>(sign) < ' '; }, ' ');
    return text;
}

std::string number(double value) {
    const std::string text = fmt::format("{:.17g}", value); // the same bits when read
    return text + (text.find_first_of(".e") == std::string::npos ? ".0" : "");
}

std::string constant(const char* name, double value, const char* unit) {
    return fmt::format("static const double {} = {}; /* {} */\n", name, number(value), unit);
}

std::string head(const LawOrigin& origin, const char* equation) {
    std::string text = "/* Position law, written by halbench " HALBENCH_VERSION ".\n";
    if (!origin.method.empty()) {
        text += fmt::format(" * Gains by method {}.\n", inComment(origin.method));
    }
    if (origin.device) {
        text +=
            fmt::format(" * Motor: {} {}.\n", inComment(origin.device->model), inComment(origin.device->id));
    }
    return text +
           fmt::format(" *\n{} *\n * Units: A, rad, s. Its loop was judged with one call every TS.\n */\n",
                       equation);
}

std::string constants(const control::PositionLaw& law, const control::PidGains& gains,
                      const LoopConditions& conditions) {
    std::string text = constant("TS", conditions.timing.period_s, "s");
    text += constant("KP", gains.proportional, "A/rad");
    text += constant("KI", gains.integral, "A/(rad s)");
    text += constant("KD", gains.derivative, "A s/rad");
    text += constant("INERTIA", law.inertia_A_s2_rad, "A s^2/rad");
    text += constant("VISCOUS", law.viscous_A_s_rad, "A s/rad");
    text += constant("COULOMB", law.coulomb_A, "A");
    text += constant("COULOMB_SPEED", law.coulombSpeed_rad_s, "rad/s");
    text += constant("STICTION", law.stictionCurrent_A, "A");
    text += constant("STICTION_THRESHOLD", law.stictionThreshold_rad, "rad");
    text += constant("STICTION_SPEED", law.stictionSpeed_rad_s, "rad/s");
    return text + constant("LIMIT", conditions.currentLimit_A, "A");
}

/// What only a filtered law has, as the program's own filters have it.
std::string filteredConstants(const control::FilteredLaw& filtered, const control::PidGains& gains,
                              const std::vector<control::LawSection<double>>& sections) {
    std::string text = constant("WEIGHT_B", filtered.proportionalWeight, "set-point weight of KP");
    text += constant("WEIGHT_C", filtered.derivativeWeight, "set-point weight of KD");
    text += constant("TF", gains.filter_s.value_or(0.0), "s, filter on the derivative");
    if (sections.empty()) {
        return text;
    }
    text += fmt::format("enum {{ SECTIONS = {} }};\n", sections.size());
    text += "static const double FILTERS[SECTIONS][5] = { /* B0, B1, B2, A1, A2, in D = z - 1 */\n";
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const control::LawSection<double>& f = sections[i];
        text += fmt::format("    {{{}, {}, {}, {}, {}}}, /* {} */\n", number(f.b0), number(f.b1),
                            number(f.b2), number(f.a1), number(f.a2), filterWords(filtered.filters[i]));
    }
    return text + "};\n";
}

std::string filteredMemory(bool hasFilters) {
    std::string text = hasFilters ? SectionMemory : "";
    text += "\ntypedef struct {\n    double integral_A;\n    double rate_rad_s;\n"
            "    double previous_weighted_rad;\n";
    text += hasFilters ? "    position_law_section sections[SECTIONS];\n" : "";
    text += "    int is_started;\n} position_law;\n"
            "\n/* Before the first sample, and whenever the motor was disarmed. */\n"
            "static inline void position_law_start(position_law* law) {\n";
    text += hasFilters ? "    int i;\n" : "";
    text += "    law->integral_A = 0.0;\n    law->rate_rad_s = 0.0;\n    law->previous_weighted_rad = 0.0;\n";
    text += hasFilters ? "    for (i = 0; i < SECTIONS; ++i) {\n        law->sections[i].first = 0.0;\n"
                         "        law->sections[i].second = 0.0;\n    }\n"
                       : "";
    return text + "    law->is_started = 0;\n}\n";
}

std::string filteredDemand(bool hasFilters) {
    std::string text =
        "    double current;\n    double demand;\n"
        "    law->rate_rad_s = (TF * law->rate_rad_s + TS * ((1.0 - WEIGHT_C) * ref_rad_s + moved / TS)) /\n"
        "                      (TF + TS);\n"
        "    demand = KP * (WEIGHT_B * ref_rad - angle_rad) + law->integral_A + KD * law->rate_rad_s;\n";
    text += hasFilters ? "    demand = position_law_filtered(law, demand);\n" : "";
    return text + "    demand += INERTIA * ref_rad_s2 + VISCOUS * ref_rad_s + COULOMB * friction;\n";
}

std::string boardCode(const control::PositionLaw& law, const LoopConditions& conditions,
                      const LawOrigin& origin) {
    return head(origin, BoardEquation) + constants(law, law.gains, conditions) + BoardMemory + Sign +
           StepHead + BoardMoved + StepBody + BoardDemand + StepTail + BoardEnd;
}

} // namespace

Result<std::string> lawCode(const LoopLaw& law, const LoopConditions& conditions, const LawOrigin& origin) {
    if (!law.filtered) {
        return boardCode(law.law, conditions, origin);
    }
    const control::FilteredLaw& filtered = *law.filtered;
    const double period_s = conditions.timing.period_s;
    const auto gains = control::checkedGains(filtered, period_s);
    const auto sections = control::filterSections(filtered.filters, period_s);
    if (!gains || !sections) {
        return failure(gains ? sections.error() : gains.error());
    }
    const bool hasFilters = !sections->empty();
    return head(origin, FilteredEquation) + constants(law.law, *gains, conditions) +
           filteredConstants(filtered, *gains, *sections) + filteredMemory(hasFilters) + Sign +
           (hasFilters ? SectionStep : "") + StepHead + FilteredMoved + StepBody +
           filteredDemand(hasFilters) + StepTail + FilteredEnd;
}

Result<void> writeLaw(const std::string& path, const LoopLaw& law, const LoopConditions& conditions,
                      const LawOrigin& origin) {
    if (path.empty()) {
        return {};
    }
    const auto code = lawCode(law, conditions, origin);
    return code ? writeFile(path, *code) : Result<void>(failure(code.error()));
}

} // namespace halbench::app
