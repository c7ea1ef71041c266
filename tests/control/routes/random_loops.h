#pragma once

#include "control/lti/discretize.h"
#include "tests/control/random_systems.h"
#include "tests/control/routes/state_routes.h"

namespace halbench::control {

/// A random open loop as a polynomial and, by another way, as states: with an integrator or two, unstable,
/// with as many zeros as poles, and (every second) sampled with none to two samples of delay.
struct RandomLoop {
    TransferFunction rational;
    StateSpace states;
};

inline RandomLoop randomLoop(Random& random, int round, int mostOrder = 4) {
    const int order = 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(mostOrder)));
    TransferFunction loop = randomSystem(random, order, false, round % 5 == 0);
    if (round % 3 == 0) {
        Polynomial denominator = loop.denominator();
        denominator.resize(denominator.size() + 1 + random.below(2), 0.0);
        loop = *TransferFunction::make(loop.numerator(), denominator, TimeBase::continuous());
    }
    if (round % 2 == 0) {
        return {loop, sectionsOf(loop)};
    }
    constexpr double Period_s = 0.05;
    const auto late = TransferFunction::delay(static_cast<int>(random.below(3)), Period_s);
    return {*series(*discretize(loop, Period_s, Hold::Zoh{}), late),
            *series(*discretize(sectionsOf(loop), Period_s, Hold::Zoh{}), toStateSpace(late))};
}

} // namespace halbench::control
