#include "tests/devices/firmware/planar/random_board_travels.h"

namespace halbench::devices::firmware {
namespace {

TEST(PlanarProfile, boardKeepsItsLimitsWithoutJumpsAndArrivesOverAMillionRandomMoves) {
    expectBoardTravels(2, 1000000);
}

} // namespace
} // namespace halbench::devices::firmware
