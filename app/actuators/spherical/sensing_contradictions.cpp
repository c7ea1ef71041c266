#include "app/actuators/spherical/sensing_contradictions.h"

#include <array>

namespace halbench::app {
namespace {

constexpr std::array Published = {
    Contradiction{"Rows 2 and 3 of the first field equation.",
                  "k_theta and k_phi are exchanged: curl and divergence of that field do not vanish.",
                  "B_theta and B_phi as in the publication's own sensor model."},
    Contradiction{"Denominator under k_phi.",
                  "It lost one term and holds a piece of the numerator: 0.2702 T instead of 0.1984 T.",
                  "One denominator for all three, from the boundary problem."},
    Contradiction{"beta for the pole angle and for a rotation.",
                  "One letter for 60° of the magnet and for the tilt about Y.",
                  "The pole angle has its own name."},
    Contradiction{"Three printed rotation matrices.",
                  "They are transposes: their product is M(-alpha, -beta, -gamma), which turns Phi by 180°; "
                  "angles, projections and hemisphere rule agree with M.",
                  "M = Rx(alpha) Ry(beta) Rz(gamma)."},
    Contradiction{"Phi by an arc tangent of a quotient.", "Half of the directions come out 180° off.",
                  "atan2, modulo 360°."},
    Contradiction{"R0 = 45.6 mm as the place of the sensors.",
                  "The table has 50 mm; the fields differ by 44.5 %.", "50 mm, a parameter."},
    Contradiction{"Auxiliary sensors see the main one's field at angles less their placement.",
                  "No rotation does that: used on a real device it errs by 18.9° rms over the workspace.",
                  "The device is exact; the additive model is there for comparison."},
    Contradiction{"Placement within the symmetry plane.", "The rule is not defined.", "It is not enforced."},
    Contradiction{"All readings exceed 0.01 T in the whole workspace.",
                  "At zero tilt the Theta readings of the first two sensors vanish for every spin and the "
                  "third twice a turn: 0, 0 and -9.3 µT at (0, 0, 17.63°).",
                  "The counterexample is shown; a placement that is proven to cover is recommended."},
    Contradiction{
        "Criteria T1 and T2 and their maxima.",
        "The reduction over the poses is not stated, the last term of T2 is misprinted, the maximum of T2 is "
        "reproduced by no reduction.",
        "Signed and absolute, mean, maximum, minimum and home with the rank of the published place."},
    Contradiction{"Trigger of the auxiliary sensors, and the largest residual.",
                  "Without absolute value half of the readings trigger; the largest residual does not select "
                  "a good sensor.",
                  "Both triggers and three rules can be chosen; as printed by default."},
    Contradiction{"Index i in F.", "It counts sensors and components.",
                  "Components are summed, sensors maximised."},
    Contradiction{"Gradient projection.",
                  "Its Jacobian is square: the projection is zero and the step is Newton's, undefined where "
                  "it is singular.",
                  "Pseudo-inverse by singular values."},
    Contradiction{"The command decides at the equator.",
                  "With two or more sensors the orientation is unique.", "No command is needed."},
    Contradiction{"Trajectories 1 to 4 in the workspace.",
                  "10, 10, 0 and 9 of 25 points lie outside, their spin is not given.",
                  "Solved everywhere; spin 0, and 20° beside it."},
    Contradiction{"0.01 T exceeds harmonics and coil field.",
                  "No evidence; a magnetised band alone would have 0.157 T of the next harmonic.",
                  "The threshold is a parameter; harmonics are calibrated."},
    Contradiction{"Validation of the method.", "One model makes the data and inverts them.",
                  "Models are crossed; harmonics, noise and coil are added."},
    Contradiction{"Fitness levels 0.01 and 0.001.",
                  "They have no unit; in T² they allow residuals of 0.1 and 0.03 T.",
                  "The level is a parameter with its unit."},
};

} // namespace

std::span<const Contradiction> sensingContradictions() {
    return Published;
}

} // namespace halbench::app
