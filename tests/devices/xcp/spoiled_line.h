#pragma once

#include "devices/simulated/loopback_transport.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace halbench::devices::xcp {

enum class Loss { None, Command, Answer, AnswerLate };

inline std::string nameOfLoss(const testing::TestParamInfo<Loss>& info) {
    const char* names[] = {"nothing", "theCommand", "theAnswer", "theAnswerLate"};
    return names[static_cast<std::size_t>(info.param)];
}

/// Spoils the next command of one kind, once: it, or its answer, does not come or comes too late.
class SpoiledLine : public LoopbackTransport {
public:
    using IsMeant = std::function<bool(std::span<const std::uint8_t> packet)>;

    SpoiledLine(std::shared_ptr<SimulatedBoard> board, double late_s, IsMeant meant = {})
        : LoopbackTransport(std::move(board), false), isMeant(std::move(meant)), m_late_s(late_s) {}

    IsMeant isMeant;
    Loss loss = Loss::None;
    int sent = 0;                     ///< commands of this kind, spoiled ones too
    std::function<void()> onSpoiling; ///< the spoiled command is about to be sent
    std::function<void()> meanwhile;  ///< it has been heard, and nobody knows

    Result<void> send(std::span<const std::uint8_t> packet) override {
        const bool isThis = isMeant && isMeant(packet);
        sent += isThis ? 1 : 0;
        if (!isThis || loss == Loss::None) {
            return LoopbackTransport::send(packet);
        }
        if (onSpoiling) {
            onSpoiling();
        }
        m_spoils = std::exchange(loss, Loss::None);
        return m_spoils == Loss::Command ? Result<void>() : LoopbackTransport::send(packet);
    }

    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override {
        if (m_heldBack && now_s() >= m_due_s) {
            packet = *std::exchange(m_heldBack, std::nullopt);
            return true;
        }
        Result<bool> received = LoopbackTransport::receive(packet, timeout_s);
        if (m_spoils > Loss::Command && received && *received && packet[0] == 0xFF) {
            if (std::exchange(m_spoils, Loss::None) == Loss::AnswerLate) {
                m_heldBack = packet;
                m_due_s = now_s() + m_late_s;
            }
            if (meanwhile) {
                std::exchange(meanwhile, nullptr)();
            }
            return false;
        }
        return received;
    }

private:
    double m_late_s; ///< of an answer; longer than the master waits
    Loss m_spoils = Loss::None;
    std::optional<std::vector<std::uint8_t>> m_heldBack;
    double m_due_s = 0.0;
};

} // namespace halbench::devices::xcp
