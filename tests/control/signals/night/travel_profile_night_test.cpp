#include "tests/control/signals/random_travels.h"

namespace halbench::control {
namespace {

TEST(TravelProfile, keepsItsLimitsWithoutJumpsAndArrivesOverAMillionRandomMoves) {
    expectTravels(3, 1000000);
}

} // namespace
} // namespace halbench::control
