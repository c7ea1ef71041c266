#pragma once

#include "control/base/result.h"
#include "devices/firmware/htm/hb_htm.h"
#include "models/htm/htm_plant.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace halbench::devices {

/// The embedded motor: plant model and the controller board's own code on one virtual clock.
/// Tick k happens at t = k ms: the board samples the sensors, computes and drives; then the plant runs to
/// (k + 1) ms (resources/help/htm-theory.md section 3.8). Tick 0 happens at power-on, inside make(), so that
/// every signal is valid from the start. The board serves XCP packets between ticks at once.
/// Two signals more than a real board: truth.position, truth.speed. Thread: any one; nothing is shared
/// between boards. Neither copied nor moved, because the board's code points into itself.
class SimulatedBoard {
public:
    /// The line the board is told it hangs on: the A2L block that describes it, and the longest measurement
    /// packet it carries.
    struct Line {
        const char* a2l = nullptr; ///< outlives the board; nullptr: TCP
        std::uint16_t maxDto = 0;  ///< 0: the board's own limit
    };
    /// Errors: OutOfRange (parameters that make no amplifier).
    static Result<std::unique_ptr<SimulatedBoard>> make(const models::HtmParameters& parameters,
                                                        std::uint64_t seed, Line line = {nullptr, 0});

    SimulatedBoard(const SimulatedBoard&) = delete;
    SimulatedBoard& operator=(const SimulatedBoard&) = delete;

    static constexpr double Tick_s = 1e-3;

    /// Time of the tick done last.
    double time_s() const { return static_cast<double>(m_ticks) * Tick_s; }
    /// Lets a millisecond pass, then does the tick at its end.
    void tick();
    /// Runs all ticks up to `time_s`; does nothing when it is already past it.
    void advanceTo(double time_s);

    void receive(std::span<const std::uint8_t> packet);
    /// Octets of the next packet for the master, put into `packet`; 0 if there is none.
    std::size_t transmit(std::span<std::uint8_t> packet);
    /// Message counter of the packet transmitted last.
    std::uint16_t messageCounter() const { return hb_board_counter(&m_board.board); }

    /// From now on Hall sensor a reads this code whatever the field is: a broken sensor, for tests.
    void breakHallSensor(double code) { m_brokenHallCode = code; }

    const models::HtmPlant& plant() const { return m_plant; }
    /// What the board holds, for tests.
    const hb_htm& firmware() const { return m_board; }

private:
    struct Truth {
        double position_rad;
        double speed_rad_s;
    };
    static const hb_signal TruthSignals[2];
    static std::uint8_t store(void* context, const void* page);

    SimulatedBoard(models::HtmPlant plant, std::uint64_t seed, Line line);
    hb_htm_calibration initialCalibration();
    void sampleAndDrive();
    void updateTruth();
    void redrawFrictionAtNewSegment();
    models::HtmDrive driveOf(const hb_htm_outputs& outputs) const;

    models::HtmPlant m_plant;
    hb_htm m_board{};
    hb_htm_calibration m_stored{};
    std::string m_identity;
    Truth m_truth{};
    double m_turns_rad = 0.0;  ///< whole turns between the plant's angle and the board's
    std::uint64_t m_ticks = 0; ///< after the one at power-on
    std::uint16_t m_segment = 0;
    std::uint32_t m_referenceTicks = 0;
    std::optional<double> m_brokenHallCode;
};

} // namespace halbench::devices
