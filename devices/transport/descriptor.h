#pragma once

#include <utility>

namespace halbench::devices {

/// Owns one file descriptor: a socket, or an end of a pseudo terminal.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int number) : m_number(number) {}
    Descriptor(Descriptor&& other) noexcept : m_number(std::exchange(other.m_number, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept;
    Descriptor(const Descriptor&) = delete;
    ~Descriptor() { close(); }

    bool isOpen() const { return m_number >= 0; }
    int number() const { return m_number; }
    void close() noexcept;
    /// Waits for something to read; false after the time, or when a signal interrupted the wait.
    bool isReadableWithin(double timeout_s) const;

private:
    int m_number = -1;
};

} // namespace halbench::devices
