#include "tests/devices/firmware/mps2/emulator/mps2_board.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace halbench::mps2 {
namespace {

constexpr std::size_t AnswerHead = 8; // said, counts

void append16(std::vector<std::uint8_t>& octets, std::uint16_t value) {
    octets.push_back(static_cast<std::uint8_t>(value & 0xFFU));
    octets.push_back(static_cast<std::uint8_t>(value >> 8U));
}

void append32(std::vector<std::uint8_t>& octets, std::uint32_t value) {
    append16(octets, static_cast<std::uint16_t>(value & 0xFFFFU));
    append16(octets, static_cast<std::uint16_t>(value >> 16U));
}

std::uint32_t at(const std::vector<std::uint8_t>& octets, std::size_t place, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
        value |= static_cast<std::uint32_t>(octets.at(place + i)) << (8U * i);
    }
    return value;
}

std::vector<std::uint8_t> octetsOf(const std::vector<float>& readings, const PlantLine& line) {
    std::vector<std::uint8_t> octets;
    for (std::size_t i = 0; i < line.codes; ++i) {
        append16(octets, static_cast<std::uint16_t>(std::lround(readings[i]) & 0xFFFF));
    }
    for (std::size_t i = line.codes; i < readings.size(); ++i) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &readings[i], sizeof bits);
        append32(octets, bits);
    }
    return octets;
}

} // namespace

Result<std::unique_ptr<Mps2Board>> Mps2Board::make(const std::string& program,
                                                   std::unique_ptr<devices::Plant> plant, PlantLine line) {
    auto emulator = Emulator::start(program);
    if (!emulator) {
        return failure(emulator.error());
    }
    std::unique_ptr<Mps2Board> board(new Mps2Board(std::move(*emulator), std::move(plant), line));
    if (auto done = board->sampleAndDrive(); !done) {
        return failure(done.error());
    }
    return board;
}

Result<std::vector<std::uint8_t>> Mps2Board::exchange(char kind, std::span<const std::uint8_t> octets) {
    std::vector<std::uint8_t> order{static_cast<std::uint8_t>(kind)};
    order.insert(order.end(), octets.begin(), octets.end());
    std::vector<std::uint8_t> answer;
    Result<void> done = m_emulator->write(Emulator::Port::Plant, order);
    if (done) {
        done = m_emulator->read(Emulator::Port::Plant, AnswerHead + 2 * m_line.outputs, answer);
    }
    if (!done) {
        return failure(done.error());
    }
    const std::uint32_t said = at(answer, 0, 4);
    m_counts = at(answer, 4, 4);
    if (done = m_emulator->read(Emulator::Port::Xcp, said - m_saidOctets, m_said); !done) {
        return failure(done.error());
    }
    m_saidOctets = said;
    answer.erase(answer.begin(), answer.begin() + AnswerHead);
    return answer;
}

Result<void> Mps2Board::sampleAndDrive() {
    std::vector<float> readings(m_line.codes + m_line.floats);
    m_plant->read(readings);
    const auto answer = exchange('T', octetsOf(readings, m_line));
    if (!answer) {
        return failure(answer.error());
    }
    std::vector<float> outputs;
    for (std::size_t i = 0; i < m_line.outputs; ++i) {
        outputs.push_back(static_cast<float>(at(*answer, 2 * i, 2)));
    }
    m_plant->drive(outputs);
    const double cost = Emulator::instructions(m_counts);
    ++m_costs.count;
    m_costs.total_instructions += cost;
    m_costs.worst_instructions = std::max(m_costs.worst_instructions, cost);
    return {};
}

Result<void> Mps2Board::tick() {
    m_plant->advance(m_line.subSteps);
    ++m_ticks;
    return sampleAndDrive();
}

Result<void> Mps2Board::send(std::span<const std::uint8_t> octets) {
    if (auto written = m_emulator->write(Emulator::Port::Xcp, octets); !written) {
        return written;
    }
    m_sentOctets += static_cast<std::uint32_t>(octets.size());
    std::vector<std::uint8_t> heard;
    append32(heard, m_sentOctets);
    const auto answer = exchange('S', heard);
    return answer ? Result<void>() : failure(answer.error());
}

} // namespace halbench::mps2
