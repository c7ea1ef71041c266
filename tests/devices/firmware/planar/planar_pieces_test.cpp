#include "control/signals/pose_motion.h"
#include "devices/firmware/planar/hb_planar_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace halbench::devices::firmware {
namespace {

constexpr float Origin[HB_PIECE_AXES] = {0.01F, -0.02F, 0.001F};

void store(hb_pieces& pieces, const control::PoseMotion& motion) {
    for (std::size_t i = 0; i < motion.pieces().size(); ++i) {
        const control::MotionPiece& exact = motion.pieces()[i];
        hb_piece piece{};
        piece.duration_s = static_cast<float>(exact.duration_s);
        for (std::size_t axis = 0; axis < motion.axisCount(); ++axis) {
            const control::PieceStart& start = exact.axes[axis];
            piece.axis[axis] = {static_cast<float>(start.value), static_cast<float>(start.speed),
                                static_cast<float>(start.acceleration), static_cast<float>(start.jerk)};
        }
        hb_pieces_store(&pieces, static_cast<std::uint16_t>(i + 1), &piece);
    }
}

/// Second route: the motion in double precision, tick by tick.
void expectSame(const control::PoseMotion& motion, double reach) {
    const auto pieces = std::make_unique<hb_pieces>();
    store(*pieces, motion);
    hb_pieces_start(pieces.get(), static_cast<std::uint16_t>(motion.pieces().size()), Origin);
    ASSERT_EQ(pieces->running, 1);
    int tick = 0;
    hb_reference_point point[HB_PIECE_AXES];
    for (; pieces->running != 0 && tick < 100000; ++tick, hb_pieces_advance(pieces.get())) {
        hb_pieces_point(pieces.get(), point);
        for (std::size_t axis = 0; axis < motion.axisCount(); ++axis) {
            const control::TravelPoint exact = motion.at(axis, 1e-3 * tick);
            const double value = static_cast<double>(point[axis].value) - static_cast<double>(Origin[axis]);
            // Single precision resolves the position with its origin to 2e-9; the time to 1e-7 of a second
            // each piece.
            ASSERT_NEAR(value, exact.value, 4e-6 * reach + 4e-9) << tick << " axis " << axis;
            ASSERT_NEAR(static_cast<double>(point[axis].speed), exact.speed, 1e-5) << tick;
        }
    }
    EXPECT_NEAR(1e-3 * tick, motion.duration_s(), 1.5e-3);
    hb_pieces_point(pieces.get(), point);
    for (std::size_t axis = 0; axis < motion.axisCount(); ++axis) {
        EXPECT_NEAR(static_cast<double>(point[axis].value) - static_cast<double>(Origin[axis]),
                    motion.at(axis, 1e6).value, 4e-6 * reach + 4e-9);
        EXPECT_EQ(point[axis].speed, 0.0F);
        EXPECT_EQ(point[axis].acceleration, 0.0F);
    }
}

TEST(PlanarPieces, followASplineOfDoublePrecision) {
    std::vector<double> time_s;
    control::PoseRows rows;
    for (int i = 1; i <= 100; ++i) {
        time_s.push_back(0.0337 * i);
        rows.push_back(
            {0.01 * std::sin(0.2 * i), 0.01 * (1.0 - std::cos(0.15 * i)), 1e-3 * std::sin(0.1 * i)});
    }
    const auto motion = control::PoseMotion::through(time_s, rows);
    ASSERT_TRUE(motion);
    expectSame(*motion, 0.02);
}

TEST(PlanarPieces, followTravelsWithDwells) {
    const control::AxisGroup groups[] = {{{0, 1}, {0.02, 0.5, 20.0}}, {{2}, {0.02, 1.0, std::nullopt}}};
    const auto motion = control::PoseMotion::visiting(
        {{3e-3, 4e-3, 1e-3}, {0.0, 4e-3, 1e-3}, {0.0, 0.0, 0.0}}, groups, 0.1234);
    ASSERT_TRUE(motion);
    expectSame(*motion, 5e-3);
}

hb_piece standing(float duration_s) {
    hb_piece piece{};
    piece.duration_s = duration_s;
    return piece;
}

TEST(PlanarPieces, doNotRunWithoutPiecesOrWithTooMany) {
    const auto pieces = std::make_unique<hb_pieces>();
    for (const std::uint16_t count : {std::uint16_t{0}, std::uint16_t{HB_PIECES + 1}}) {
        hb_pieces_start(pieces.get(), count, Origin);
        EXPECT_EQ(pieces->running, 0);
    }
    hb_pieces_start(pieces.get(), HB_PIECES, Origin); // of no duration: over at once
    EXPECT_EQ(pieces->running, 0);
    hb_reference_point point[HB_PIECE_AXES];
    hb_pieces_point(pieces.get(), point);
    EXPECT_EQ(point[0].value, Origin[0]);
}

TEST(PlanarPieces, takeNoNumberThatTheyDoNotHaveAndNothingWhileTheyRun) {
    const auto pieces = std::make_unique<hb_pieces>();
    const hb_piece piece = standing(0.005F);
    for (const std::uint16_t number : {std::uint16_t{0}, std::uint16_t{HB_PIECES + 1}}) {
        hb_pieces_store(pieces.get(), number, &piece);
    }
    hb_pieces_start(pieces.get(), HB_PIECES, Origin);
    EXPECT_EQ(pieces->running, 0); // nothing was stored
    hb_pieces_store(pieces.get(), 1, &piece);
    hb_pieces_start(pieces.get(), 1, Origin);
    EXPECT_EQ(pieces->running, 1);
    const hb_piece longer = standing(1.0F);
    hb_pieces_store(pieces.get(), 1, &longer);
    int ticks = 0;
    for (; pieces->running != 0 && ticks < 100; ++ticks) {
        hb_pieces_advance(pieces.get());
    }
    EXPECT_EQ(ticks, 5);
}

} // namespace
} // namespace halbench::devices::firmware
