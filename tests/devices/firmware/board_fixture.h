#pragma once

#include "devices/firmware/htm/hb_htm.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace halbench::devices::firmware {

using Octets = std::vector<std::uint8_t>;

inline constexpr double Pi = std::numbers::pi;
inline constexpr double FieldAmplitude_T = 0.157;

/// Exact code of a field at 25 degC, the inverse of resources/help/htm-theory.md 3.4 without rounding.
inline double hallCode(double field_T) {
    return (2.5 + 12.5 * field_T) * 1024.0 / 5.0 - 0.5;
}

inline double temperatureCode(double temperature_degC) {
    return (0.75 + 0.01 * (temperature_degC - 25.0)) * 1024.0 / 5.0 - 0.5;
}

/// One board on a table: a rotor that is held at `angle_rad`, a master that speaks raw octets.
class BoardFixture {
public:
    explicit BoardFixture(const hb_htm_config* config = nullptr) : m_board(std::make_unique<hb_htm>()) {
        hb_htm_init(m_board.get(), config);
    }

    hb_htm& board() { return *m_board; }
    hb_htm_outputs outputs{};
    double angle_rad = 0.3;
    double temperature_degC = 25.0;

    hb_htm_inputs inputs() const {
        hb_htm_inputs in{};
        in.hall_code[0] = static_cast<float>(hallCode(FieldAmplitude_T * std::cos(angle_rad)));
        in.hall_code[1] = static_cast<float>(hallCode(FieldAmplitude_T * std::sin(angle_rad)));
        in.temperature_code[0] = in.temperature_code[1] =
            static_cast<float>(temperatureCode(temperature_degC));
        return in;
    }

    void tick(int count = 1) {
        for (int i = 0; i < count; ++i) {
            const hb_htm_inputs in = inputs();
            hb_htm_fast_tick(m_board.get(), &in, &outputs);
        }
    }

    void send(const Octets& packet) {
        hb_board_receive(&m_board->board, packet.data(), static_cast<std::uint16_t>(packet.size()));
    }

    std::vector<Octets> received() {
        std::vector<Octets> packets;
        std::uint8_t buffer[HB_MAX_DTO];
        while (const std::uint16_t length = hb_board_transmit(&m_board->board, buffer, sizeof buffer)) {
            packets.emplace_back(buffer, buffer + length);
        }
        return packets;
    }

    /// The answer to a command; events and samples before it are dropped. Empty if there is none.
    Octets command(const Octets& packet) {
        send(packet);
        for (Octets& answer : received()) {
            if (answer[0] >= 0xFE) {
                return answer;
            }
        }
        return {};
    }

    void connect() { command({0xFF, 0x00}); }

    static Octets le32(std::uint32_t value) {
        return {static_cast<std::uint8_t>(value), static_cast<std::uint8_t>(value >> 8),
                static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 24)};
    }

    static Octets octetsOf(float value) {
        std::uint32_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        return le32(bits);
    }

    static std::uint32_t u32(const Octets& octets, std::size_t at) {
        return octets[at] | (octets[at + 1] << 8) | (octets[at + 2] << 16) |
               (static_cast<std::uint32_t>(octets[at + 3]) << 24);
    }

    /// SHORT_DOWNLOAD to a parameter given by its offset in the live or paged structure.
    Octets write(std::uint32_t address, const Octets& octets) {
        Octets packet{0xED, static_cast<std::uint8_t>(octets.size()), 0, 0};
        const Octets where = le32(address);
        packet.insert(packet.end(), where.begin(), where.end());
        packet.insert(packet.end(), octets.begin(), octets.end());
        return command(packet);
    }

    Octets read(std::uint32_t address, std::uint8_t count, std::uint8_t extension = 0) {
        Octets packet{0xF4, count, 0, extension};
        const Octets where = le32(address);
        packet.insert(packet.end(), where.begin(), where.end());
        return command(packet);
    }

    Octets writeLive(std::size_t offset, const Octets& octets) {
        return write(0x8000U + static_cast<std::uint32_t>(offset), octets);
    }
    Octets writePaged(std::size_t offset, float value) {
        return write(0x10000U + static_cast<std::uint32_t>(offset), octetsOf(value));
    }

    Octets arm() { return writeLive(offsetof(hb_htm_live, board.arm), {1}); }
    Octets setMode(std::uint8_t mode) { return writeLive(offsetof(hb_htm_live, board.mode), {mode}); }
    Octets setSetpoint(float value) { return writeLive(offsetof(hb_htm_live, setpoint), octetsOf(value)); }
    Octets stop() { return command({0xF1, 0x45}); }
    Octets reset() { return command({0xF1, 0x52}); }

    /// Connected, one tick done, armed in this mode; a silent master is no reason to stop here.
    void driveIn(std::uint8_t mode) {
        tick();
        connect();
        setMode(mode);
        arm();
        m_board->live.board.watchdog_ms = 0;
    }

    bool isOutputZero() const {
        return outputs.phase_current_A[0] == 0.0F && outputs.phase_current_A[1] == 0.0F &&
               outputs.dac_code[0] == 2048 && outputs.dac_code[1] == 2048 && outputs.output_enabled == 0;
    }

private:
    std::unique_ptr<hb_htm> m_board;
};

/// One more signal of the caller's own, as the simulation adds its truth.
inline hb_signal truthSignal() {
    hb_signal signal{};
    signal.entry.type = HB_FLOAT64;
    signal.entry.words = "truth.position\0\0";
    signal.scale = 1.0F;
    return signal;
}

inline const Octets Accepted{0xFF};
inline Octets refused(std::uint8_t code) {
    return {0xFE, code};
}

} // namespace halbench::devices::firmware
