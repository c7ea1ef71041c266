#include "control/base/random.h"

#include "control/base/assert.h"

#include <cmath>

namespace halbench {

namespace {

std::uint64_t splitMix(std::uint64_t& state) {
    state += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
}

std::uint64_t rotateLeft(std::uint64_t value, int count) {
    return (value << count) | (value >> (64 - count));
}

} // namespace

Random::Random(std::uint64_t seed) : m_seed(seed) {
    for (std::uint64_t& word : m_state) {
        word = splitMix(seed);
    }
}

std::uint64_t Random::bits() {
    const std::uint64_t result = rotateLeft(m_state[0] + m_state[3], 23) + m_state[0];
    const std::uint64_t shifted = m_state[1] << 17;
    m_state[2] ^= m_state[0];
    m_state[3] ^= m_state[1];
    m_state[1] ^= m_state[2];
    m_state[0] ^= m_state[3];
    m_state[2] ^= shifted;
    m_state[3] = rotateLeft(m_state[3], 45);
    return result;
}

double Random::uniform() {
    return static_cast<double>(bits() >> 11) * 0x1.0p-53;
}

double Random::gaussian() {
    if (m_hasSpare) {
        m_hasSpare = false;
        return m_spare;
    }
    double u = 0.0;
    double v = 0.0;
    double s = 0.0;
    do {
        u = 2.0 * uniform() - 1.0;
        v = 2.0 * uniform() - 1.0;
        s = u * u + v * v;
    } while (s >= 1.0 || s == 0.0);
    const double scale = std::sqrt(-2.0 * std::log(s) / s);
    m_spare = v * scale;
    m_hasSpare = true;
    return u * scale;
}

std::uint64_t Random::below(std::uint64_t bound) {
    HB_ASSERT(bound > 0);
    const std::uint64_t limit = bound * (UINT64_MAX / bound);
    std::uint64_t draw = 0;
    do {
        draw = bits();
    } while (draw >= limit);
    return draw % bound;
}

Random Random::fork(std::uint64_t stream) const {
    std::uint64_t mixed = m_seed ^ (0xD1B54A32D192ED03ULL * (stream + 1));
    return Random(splitMix(mixed));
}

} // namespace halbench
