#pragma once

#include "control/base/random.h"
#include "control/law/position_loop.h"
#include "control/lti/state_space.h"

#include <Eigen/Core>
#include <vector>

namespace halbench::control {

/// The board's loop written out once more, by matrix exponentials and states alone: a second route to all
/// that control/design computes from polynomials.
struct OwnLoop {
    PositionPlant plant;
    PidGains gains; ///< parallel, per radian, without a filter
    LoopTiming timing;

    /// exp of [0 1; 0 -a] with the current k [0; 1] beside it, over a time.
    Eigen::Matrix3d motion(double time_s) const;

    /// Open loop from the error to the angle: states angle, speed, integral current, last input, delayed
    /// currents.
    StateSpace open() const;

    double poleRadius() const;

    struct Run {
        std::vector<double> angle_rad; ///< `points` a sample
        std::vector<double> current_A; ///< of the law, likewise
        std::vector<double> sample_rad;
    };
    /// From rest; the derivative acts on the angle alone. `load_A` acts beside the law's current.
    Run run(double reference_rad, double load_A, int samples, int points) const;
};

/// A motor, a board and the gains of the recommended shape between half and somewhat more of what is
/// recommended there: stable.
OwnLoop randomStableLoop(Random& random);

} // namespace halbench::control
