#include "control/robustness/state_powers.h"

#include "control/base/assert.h"

#include <algorithm>

namespace halbench::control {

namespace {

using Lanes = BatchState::Lanes;
constexpr std::size_t Rotor = 4; ///< angle, speed, integral and last angle; the waiting currents follow

std::vector<Lanes> packed(const BatchState& state, std::size_t delay) {
    std::vector<Lanes> vector{state.angle, state.speed, state.integral, state.last};
    for (std::size_t i = 0; i < delay; ++i) {
        vector.push_back(state.pending[(state.sample + i) % BatchState::MostPending]);
    }
    vector.push_back(Lanes::Ones());
    return vector;
}

void unpack(const std::vector<Lanes>& vector, std::size_t delay, BatchState& state) {
    state.angle = vector[0];
    state.speed = vector[1];
    state.integral = vector[2];
    state.last = vector[3];
    for (std::size_t i = 0; i < delay; ++i) {
        state.pending[(state.sample + i) % BatchState::MostPending] = vector[Rotor + i];
    }
}

} // namespace

StatePowers::StatePowers(const Sample& sample, std::size_t delay_samples, const BatchRun& run,
                         std::size_t longest)
    : m_delay(delay_samples), m_size(Rotor + delay_samples + 1) {
    HB_ASSERT(run.pointsPerSample == 1);
    Matrix one;
    for (std::size_t column = 0; column < m_size; ++column) {
        BatchState state;
        std::vector<Lanes> unit(m_size, Lanes::Zero());
        unit[column] = Lanes::Ones();
        unpack(unit, m_delay, state);
        const bool isInput = column + 1 == m_size;
        sample(state, isInput ? run.reference_rad : 0.0, isInput ? run.load_A : 0.0);
        std::vector<Lanes> after = packed(state, m_delay);
        after.back() = isInput ? Lanes::Ones().eval() : Lanes::Zero().eval();
        one.insert(one.end(), after.begin(), after.end());
    }
    m_powers.push_back(one);
    for (std::size_t samples = 2; samples <= longest; samples *= 2) {
        m_powers.push_back(square(m_powers.back()));
    }
}

std::size_t StatePowers::shortest(std::size_t delay_samples) {
    constexpr std::size_t Usual = 64;
    const std::size_t size = Rotor + delay_samples + 1;
    return std::max(Usual, size * size);
}

void StatePowers::leap(BatchState& state, std::size_t samples) const {
    HB_ASSERT(samples < std::size_t{2} << (m_powers.size() - 1));
    Vector vector = packed(state, m_delay);
    for (std::size_t power = 0; power < m_powers.size(); ++power) {
        if ((samples >> power & 1U) != 0) {
            vector = product(m_powers[power], vector);
        }
    }
    state.sample += samples;
    state.point += samples;
    unpack(vector, m_delay, state);
}

StatePowers::Vector StatePowers::product(const Matrix& matrix, const Vector& vector) const {
    Vector result(m_size, Lanes::Zero());
    for (std::size_t column = 0; column < m_size; ++column) {
        for (std::size_t row = 0; row < m_size; ++row) {
            result[row] += matrix[column * m_size + row] * vector[column];
        }
    }
    return result;
}

StatePowers::Matrix StatePowers::square(const Matrix& matrix) const {
    Matrix result;
    for (std::size_t column = 0; column < m_size; ++column) {
        const auto begin = matrix.begin() + static_cast<std::ptrdiff_t>(column * m_size);
        const Vector moved = product(matrix, Vector(begin, begin + static_cast<std::ptrdiff_t>(m_size)));
        result.insert(result.end(), moved.begin(), moved.end());
    }
    return result;
}

} // namespace halbench::control
