#include "tests/devices/simulated/planar/positioner.h"

// A table of poses in the board: it is followed by the board's own clock, and whatever ends a motion ends it.

namespace halbench::devices {
namespace {

constexpr double Table = 5.0; // path.shape

/// Two pieces, made by hand: x goes from rest to -0.05 m/s with -0.1 m/s^2 in half a second, and on at that
/// speed for as long; it ends 12.5 + 25 mm away, where the board holds it.
class Tabled : public Positioner {
public:
    Tabled() : Positioner("chain=ideal") {
        set("coil.force_constant", WindingsForce_N_per_A);
        set("feedforward.x.inertia", 0.64);
        set("window.x", 0.09);
        arm(HB_PLANAR_POSITION);
        wait(0.5);
    }
    void store(double number, double value_m, double speed_m_s, double acceleration_m_s2, double duration_s) {
        set("table.x.value", value_m);
        set("table.x.speed", speed_m_s);
        set("table.x.acceleration", acceleration_m_s2);
        set("table.duration", duration_s);
        set("table.number", number);
    }
    void start() {
        store(1.0, 0.0, 0.0, -0.1, 0.5);
        store(2.0, -0.0125, -0.05, 0.0, 0.5);
        set("table.count", 2.0);
        set("path.shape", Table);
        set("reference.start", 1.0);
    }
};

/// The board's clock goes on between two commands, as that of a real one does.
class TickingLine : public LoopbackTransport {
public:
    explicit TickingLine(std::shared_ptr<SimulatedBoard> board)
        : LoopbackTransport(board, false), m_ticking(std::move(board)) {}
    Result<void> send(std::span<const std::uint8_t> packet) override {
        m_ticking->tick();
        m_ticking->tick();
        return LoopbackTransport::send(packet);
    }

private:
    std::shared_ptr<SimulatedBoard> m_ticking;
};

// The board takes the order before the master reads back what it wrote.
TEST(PlanarTable, startOfAPathIsNoErrorWhereTheBoardTakesItAtOnce) {
    auto made = makeSimulatedBoard(*parseDeviceUri("sim:planar?chain=ideal"), {});
    ASSERT_TRUE(made);
    const std::shared_ptr<SimulatedBoard> board = std::move(*made);
    auto device = openXcpDevice(std::make_unique<TickingLine>(board), {});
    ASSERT_TRUE(device) << device.error().message;
    const auto write = [&device](const std::vector<ParameterValue>& values) {
        const auto written = (*device)->writeParameters(values);
        EXPECT_TRUE(written) << values.front().name << ": " << written.error().message;
    };
    write({{"hb.mode", static_cast<double>(HB_PLANAR_POSITION)}});
    ASSERT_TRUE((*device)->arm());
    ASSERT_TRUE((*device)->clock().waitFor(0.5));
    write({{"table.x.value", 0.0}, {"table.x.speed", -1e-3}, {"table.duration", 2.0}, {"table.number", 1.0}});
    for (const double shape : {Table, 1.0}) { // a circle likewise
        write({{"table.count", 1.0},
               {"path.radius", 1e-3},
               {"path.speed", 1e-3},
               {"path.acceleration", 0.1},
               {"path.shape", shape},
               {"reference.start", 1.0}});
        const auto running = (*device)->readSignals(std::vector<std::string>{"reference.running"});
        ASSERT_TRUE(running);
        EXPECT_EQ(running->front(), 1.0) << shape;
        write({{"reference.start", 0.0}});
    }
}

TEST(PlanarTable, isFollowedAndHeldAtItsEnd) {
    Tabled planar;
    const double start_m = planar.signal("reference.x");
    const double y_m = planar.signal("reference.y");
    planar.start();
    planar.wait(0.3);
    // -a t^2/2 of half a second is -12.5 mm; the start came within a tick of two before.
    EXPECT_LT(planar.signal("reference.x") - start_m, -0.5 * 0.1 * 0.29 * 0.29);
    EXPECT_EQ(planar.signal("reference.running"), 1.0);
    EXPECT_EQ(planar.signal("reference.segment"), 1.0);
    planar.wait(0.4);
    EXPECT_EQ(planar.signal("reference.segment"), 2.0);
    planar.wait(0.5);
    EXPECT_EQ(planar.signal("reference.running"), 0.0);
    EXPECT_NEAR(planar.signal("reference.x") - start_m, -0.0375, 1e-7);
    EXPECT_NEAR(planar.signal("reference.y"), y_m, 1e-9); // has no piece that moves it
    EXPECT_EQ(planar.signal("fault"), 0.0);
}

TEST(PlanarTable, takesNoPieceWhileItRuns) {
    Tabled planar;
    planar.start();
    planar.wait(0.1);
    EXPECT_FALSE(planar.canSet("table.number", 1.0));
    planar.wait(1.2);
    EXPECT_TRUE(planar.canSet("table.number", 1.0));
    EXPECT_FALSE(planar.canSet("table.number", HB_PIECES + 1.0));
}

TEST(PlanarTable, endOfTheReferenceHoldsTheAxisWhereItIs) {
    Tabled planar;
    planar.start();
    planar.wait(0.6);
    planar.set("reference.start", 0.0);
    planar.wait(0.01);
    const double held_m = planar.signal("reference.x");
    EXPECT_EQ(planar.signal("reference.running"), 0.0);
    planar.wait(0.3);
    EXPECT_EQ(planar.signal("reference.x"), held_m);
}

TEST(PlanarTable, stopBrakesAndLatchesAndTheTableGoesNotOn) {
    Tabled planar;
    planar.start();
    planar.wait(0.7);
    planar.device().stop();
    for (int tick = 0; tick < 310; ++tick) {
        planar.board().tick();
    }
    EXPECT_LT(std::fabs(planar.truth().platen.velocity.x_m_s), 5e-3);
    EXPECT_EQ(planar.firmware().signals.board.status, HB_STATUS_STOPPED);
    EXPECT_EQ(planar.firmware().pieces.running, 0);
}

TEST(PlanarTable, silenceOfTheMasterEndsIt) {
    Tabled planar;
    planar.store(1.0, 0.0, -0.01, 0.0, 6.0);
    planar.set("table.count", 1.0);
    planar.set("path.shape", Table);
    planar.set("reference.start", 1.0);
    const auto tick = [&](int count) {
        for (int i = 0; i < count; ++i) {
            planar.board().tick(); // nobody asks
        }
    };
    for (int i = 0; i < 5000 && planar.firmware().signals.board.status == HB_STATUS_ARMED; ++i) {
        tick(1);
    }
    EXPECT_EQ(planar.firmware().signals.board.status, HB_STATUS_WATCHDOG);
    EXPECT_EQ(planar.firmware().pieces.running, 0);
    tick(301);
    EXPECT_LT(std::fabs(planar.truth().platen.velocity.x_m_s), 5e-3);
}

TEST(PlanarTable, orderThatWasNotTakenIsNoneForLater) {
    Tabled planar;
    planar.set("path.shape", Table);
    planar.set("reference.start", 0.0); // as the host ends what it could not start
    planar.wait(0.01);
    EXPECT_EQ(planar.firmware().live.path.shape, HB_PATH_NONE);
    planar.set("path.shape", Table);
    planar.set("hb.mode", HB_MODE_IDLE);
    EXPECT_EQ(planar.firmware().live.path.shape, HB_PATH_NONE);
}

// Pieces of an earlier, longer motion lie behind those of this one; a start with their number mixes both.
TEST(PlanarTable, runsOnlyWithThePiecesThatBelongTogether) {
    Tabled planar;
    const auto runsWith = [&planar](double count) {
        planar.set("table.count", count);
        planar.set("path.shape", Table);
        planar.set("reference.start", 1.0);
        planar.wait(0.05);
        const bool runs = planar.signal("reference.running") == 1.0;
        planar.set("reference.start", 0.0);
        planar.wait(0.05);
        return runs;
    };
    for (int number = 1; number <= 4; ++number) {
        planar.store(number, 0.0, 0.0, 0.0, 0.5);
    }
    EXPECT_TRUE(runsWith(4.0));
    planar.store(1.0, 0.0, 0.0, 0.0, 0.5);
    planar.store(2.0, 0.0, 0.0, 0.0, 0.5);
    planar.store(2.0, 0.0, 0.0, 0.0, 0.5); // repeated on a line that lost the answer
    EXPECT_FALSE(runsWith(4.0));
    EXPECT_FALSE(runsWith(1.0));
    EXPECT_FALSE(runsWith(0.0));
    EXPECT_TRUE(runsWith(2.0));
    EXPECT_TRUE(runsWith(2.0)) << "the same motion again";
    planar.store(4.0, 0.0, 0.0, 0.0, 0.5); // one is missing
    EXPECT_FALSE(runsWith(4.0));
    planar.store(1.0, 0.002, 0.0, 0.0, 0.5); // 2 mm beside the axis
    EXPECT_FALSE(runsWith(1.0));
}

TEST(PlanarTable, endsWhereTheNextPieceBeginsElsewhere) {
    Tabled planar;
    const double start_m = planar.signal("reference.x");
    planar.store(1.0, 0.0, -0.01, 0.0, 0.3);
    planar.store(2.0, -0.013, -0.01, 0.0, 0.3); // 10 mm farther than the first ends
    planar.set("table.count", 2.0);
    planar.set("path.shape", Table);
    planar.set("reference.start", 1.0);
    planar.wait(0.5);
    EXPECT_EQ(planar.signal("reference.running"), 0.0);
    EXPECT_NEAR(planar.signal("reference.x") - start_m, -0.003, 1e-6);
    EXPECT_EQ(planar.signal("fault"), 0.0);
}

} // namespace
} // namespace halbench::devices
