#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace halbench::control {

/// Values that come at the end and go at the front, side by side in memory: looking through many of them, in
/// order, is several times faster than in a deque.
template <typename T>
class FrontQueue {
public:
    std::size_t size() const { return m_values.size() - m_gone; }
    bool empty() const { return size() == 0; }
    T& operator[](std::size_t index) { return m_values[m_gone + index]; }
    const T& operator[](std::size_t index) const { return m_values[m_gone + index]; }
    const T& front() const { return m_values[m_gone]; }
    const T& back() const { return m_values.back(); }
    T& back() { return m_values.back(); }
    const T* begin() const { return m_values.data() + m_gone; }
    const T* end() const { return m_values.data() + m_values.size(); }

    void push_back(T value) { m_values.push_back(std::move(value)); }
    /// In a constant number of steps on average: what is gone is cleared away when it is half of all.
    void pop_front() {
        m_values[m_gone++] = T();
        if (2 * m_gone >= m_values.size()) {
            m_values.erase(m_values.begin(), m_values.begin() + static_cast<std::ptrdiff_t>(m_gone));
            m_gone = 0;
        }
    }

private:
    std::vector<T> m_values;
    std::size_t m_gone = 0; ///< so many at the front do not count any more
};

} // namespace halbench::control
