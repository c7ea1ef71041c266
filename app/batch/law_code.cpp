#include "app/batch/law_code.h"

#include "app/batch/output_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {
namespace {

constexpr const char* Equation = R"( *   u = KP e + x + KD (ref' - (angle[k] - angle[k-1])/TS)
 *       + INERTIA ref'' + VISCOUS ref' + COULOMB sat(ref'/COULOMB_SPEED)
 *       + (|ref'| < STICTION_SPEED and |e| > STICTION_THRESHOLD) STICTION sgn(e)
 *   e = ref - angle, u limited to +-LIMIT; while it is limited x changes only if e u < 0:
 *   x += TS KI e
)";

constexpr const char* Functions = R"(
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

static inline double position_law_sign(double value) {
    return (double)(value > 0.0) - (double)(value < 0.0);
}

/* Once every TS: the current in A. The reference's speed and acceleration are 0 where it rests. */
static inline double position_law_step(position_law* law, double angle_rad, double ref_rad, double ref_rad_s,
                                       double ref_rad_s2) {
    double error = ref_rad - angle_rad;
    double moved = law->is_started ? angle_rad - law->previous_angle_rad : 0.0;
    double speed = ref_rad_s < 0.0 ? -ref_rad_s : ref_rad_s;
    double distance = error < 0.0 ? -error : error;
    double friction = speed >= COULOMB_SPEED ? position_law_sign(ref_rad_s) : ref_rad_s / COULOMB_SPEED;
    double demand = KP * error + law->integral_A + KD * (ref_rad_s - moved / TS) + INERTIA * ref_rad_s2 +
                    VISCOUS * ref_rad_s + COULOMB * friction;
    double current;
    if (speed < STICTION_SPEED && distance > STICTION_THRESHOLD) {
        demand += STICTION * position_law_sign(error);
    }
    current = demand > LIMIT ? LIMIT : demand < -LIMIT ? -LIMIT : demand;
    if (current == demand || error * demand < 0.0) {
        law->integral_A += TS * KI * error;
    }
    law->previous_angle_rad = angle_rad;
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

std::string constant(const char* name, double value, const char* unit) {
    std::string number = fmt::format("{:.17g}", value); // the same bits when read
    number += number.find_first_of(".e") == std::string::npos ? ".0" : "";
    return fmt::format("static const double {} = {}; /* {} */\n", name, number, unit);
}

} // namespace

std::string lawCode(const control::PositionLaw& law, const LoopConditions& conditions,
                    const LawOrigin& origin) {
    std::string text = "/* Position law, written by halbench " HALBENCH_VERSION ".\n";
    if (!origin.method.empty()) {
        text += fmt::format(" * Gains by method {}.\n", inComment(origin.method));
    }
    if (origin.device) {
        text +=
            fmt::format(" * Motor: {} {}.\n", inComment(origin.device->model), inComment(origin.device->id));
    }
    text += fmt::format(" *\n{} *\n * Units: A, rad, s. Its loop was judged with one call every TS.\n */\n",
                        Equation);
    text += constant("TS", conditions.timing.period_s, "s");
    text += constant("KP", law.gains.proportional, "A/rad");
    text += constant("KI", law.gains.integral, "A/(rad s)");
    text += constant("KD", law.gains.derivative, "A s/rad");
    text += constant("INERTIA", law.inertia_A_s2_rad, "A s^2/rad");
    text += constant("VISCOUS", law.viscous_A_s_rad, "A s/rad");
    text += constant("COULOMB", law.coulomb_A, "A");
    text += constant("COULOMB_SPEED", law.coulombSpeed_rad_s, "rad/s");
    text += constant("STICTION", law.stictionCurrent_A, "A");
    text += constant("STICTION_THRESHOLD", law.stictionThreshold_rad, "rad");
    text += constant("STICTION_SPEED", law.stictionSpeed_rad_s, "rad/s");
    text += constant("LIMIT", conditions.currentLimit_A, "A");
    return text + Functions;
}

Result<void> writeLaw(const std::string& path, const control::PositionLaw& law,
                      const LoopConditions& conditions, const LawOrigin& origin) {
    return path.empty() ? Result<void>() : writeFile(path, lawCode(law, conditions, origin));
}

} // namespace halbench::app
