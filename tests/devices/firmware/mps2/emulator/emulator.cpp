#include "tests/devices/firmware/mps2/emulator/emulator.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>

namespace halbench::mps2 {
namespace {

constexpr int Silence_ms = 60000; // an emulator that hangs; a busy machine answers within some seconds

std::string chardev(const char* name, int number) {
    return fmt::format("socket,id={},fd={}", name, number);
}

/// The arguments of one board whose serial ports are these descriptors.
std::vector<std::string> argumentsOf(const std::string& program, int xcp, int plant) {
    return {QEMU_SYSTEM_ARM, "-M",
            "mps2-an386",    "-icount",
            "shift=7",       "-nodefaults",
            "-display",      "none",
            "-monitor",      "none",
            "-nic",          "none",
            "-chardev",      chardev("xcp", xcp),
            "-serial",       "chardev:xcp",
            "-chardev",      chardev("plant", plant),
            "-serial",       "chardev:plant",
            "-kernel",       program};
}

/// In the child, with what may be called there. It ends with the thread that started it.
[[noreturn]] void become(char* const* arguments, int xcp, int plant, int messages) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const bool isKept = ::fcntl(xcp, F_SETFD, 0) == 0 && ::fcntl(plant, F_SETFD, 0) == 0 &&
                        ::dup2(messages, STDERR_FILENO) == STDERR_FILENO;
    if (isKept) {
        ::execv(arguments[0], arguments);
    }
    ::_exit(127);
}

} // namespace

Result<std::unique_ptr<Emulator>> Emulator::start(const std::string& program) {
    if (!std::filesystem::exists(program)) {
        return failure(ErrorCode::InvalidInput, program + " does not exist", "Build it first.");
    }
    std::unique_ptr<Emulator> emulator(new Emulator);
    std::array<devices::Descriptor, 2> theirs;
    for (std::size_t i = 0; i < theirs.size(); ++i) {
        int pair[2];
        if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) != 0) {
            return emulator->lost(std::strerror(errno));
        }
        emulator->m_streams[i].socket = devices::Descriptor(pair[0]);
        theirs[i] = devices::Descriptor(pair[1]);
    }
    std::vector<std::string> texts = argumentsOf(program, theirs[0].number(), theirs[1].number());
    std::vector<char*> arguments;
    for (std::string& text : texts) {
        arguments.push_back(text.data());
    }
    arguments.push_back(nullptr);
    emulator->m_messages = devices::Descriptor(::memfd_create("qemu", MFD_CLOEXEC));
    emulator->m_process = ::fork();
    if (emulator->m_process == 0) {
        become(arguments.data(), theirs[0].number(), theirs[1].number(), emulator->m_messages.number());
    }
    if (emulator->m_process < 0) {
        return emulator->lost(std::strerror(errno));
    }
    return emulator;
}

tl::unexpected<Error> Emulator::lost(const std::string& event) const {
    std::array<char, 2048> words;
    const ssize_t count = ::pread(m_messages.number(), words.data(), words.size(), 0);
    return failure(ErrorCode::DeviceLost, "qemu-system-arm: " + event,
                   std::string(words.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))));
}

Emulator::~Emulator() {
    if (m_process > 0) {
        ::kill(m_process, SIGKILL);
        ::waitpid(m_process, nullptr, 0);
    }
}

Result<void> Emulator::write(Port port, std::span<const std::uint8_t> octets) {
    const int number = m_streams[static_cast<std::size_t>(port)].socket.number();
    while (!octets.empty()) {
        const ssize_t count = ::send(number, octets.data(), octets.size(), MSG_NOSIGNAL);
        if (count < 0 && errno != EINTR) {
            return lost(std::strerror(errno));
        }
        octets = octets.subspan(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
    return {};
}

Result<void> Emulator::receive() {
    std::array<pollfd, 2> entries{};
    for (std::size_t i = 0; i < entries.size(); ++i) {
        entries[i] = {m_streams[i].socket.number(), POLLIN, 0};
    }
    const int ready = ::poll(entries.data(), entries.size(), Silence_ms);
    if (ready == 0) {
        return lost("the program says nothing");
    }
    for (std::size_t i = 0; ready > 0 && i < entries.size(); ++i) {
        if (entries[i].revents == 0) {
            continue;
        }
        std::array<std::uint8_t, 4096> octets;
        const ssize_t count = ::recv(entries[i].fd, octets.data(), octets.size(), 0);
        if (count <= 0 && errno != EINTR) {
            return lost("it has ended");
        }
        m_streams[i].received.insert(m_streams[i].received.end(), octets.begin(), octets.begin() + count);
    }
    return {};
}

Result<void> Emulator::read(Port port, std::size_t count, std::vector<std::uint8_t>& octets) {
    std::vector<std::uint8_t>& received = m_streams[static_cast<std::size_t>(port)].received;
    while (received.size() < count) {
        if (auto waited = receive(); !waited) {
            return waited;
        }
    }
    const auto end = received.begin() + static_cast<std::ptrdiff_t>(count);
    octets.insert(octets.end(), received.begin(), end);
    received.erase(received.begin(), end);
    return {};
}

double Emulator::instructions(std::uint32_t counts) {
    // The timer's phase costs one count, a third of an instruction.
    return std::round(counts * (TimerCount_ns / Instruction_ns));
}

} // namespace halbench::mps2
