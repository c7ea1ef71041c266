#include "devices/transport/hid_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>

namespace halbench::devices {

namespace {

constexpr auto SendTimeout = std::chrono::milliseconds(1000);
/// For a thread that has nothing to do; one that the system holds is left behind.
constexpr auto EndTimeout = std::chrono::milliseconds(50);
constexpr const char* PluggedHint = "check the cable and that the device is on";

} // namespace

struct HidWriter::Shared {
    std::mutex mutex;
    std::condition_variable changed;
    HidHandle device; ///< the thread's
    std::deque<HidReport> waiting;
    bool isWriting = false;
    bool isEnding = false;
    bool hasEnded = false;
    bool isUnplugged = false;
};

HidWriter::HidWriter(HidHandle device, std::string description)
    : m_shared(std::make_shared<Shared>()), m_description(std::move(description)) {
    m_shared->device = std::move(device);
    m_thread = std::thread([shared = m_shared] { run(shared); });
}

HidWriter::~HidWriter() {
    std::unique_lock lock(m_shared->mutex);
    m_shared->isEnding = true;
    m_shared->changed.notify_all();
    const bool hasEnded = m_shared->changed.wait_for(lock, EndTimeout, [this] { return m_shared->hasEnded; });
    lock.unlock();
    if (hasEnded) {
        m_thread.join();
    } else {
        m_thread.detach(); // it closes the device when the system lets it go
    }
}

void HidWriter::run(const std::shared_ptr<Shared>& shared) {
    std::unique_lock lock(shared->mutex);
    for (;;) {
        shared->changed.wait(lock, [&] { return shared->isEnding || !shared->waiting.empty(); });
        if (shared->isEnding) {
            break;
        }
        std::array<std::uint8_t, HidReportOctets + 1> numbered{}; // report number 0: the only one
        std::copy(shared->waiting.front().begin(), shared->waiting.front().end(), numbered.begin() + 1);
        shared->waiting.pop_front();
        shared->isWriting = true;
        lock.unlock();
        const bool isTaken = hid_write(shared->device.get(), numbered.data(), numbered.size()) >= 0;
        lock.lock();
        shared->isWriting = false;
        shared->isUnplugged = shared->isUnplugged || !isTaken;
        shared->changed.notify_all();
    }
    shared->device.reset();
    shared->hasEnded = true;
    shared->changed.notify_all();
}

Result<void> HidWriter::write(std::span<const std::uint8_t> octets) {
    const std::vector<HidReport> reports = reportsFor(octets);
    std::unique_lock lock(m_shared->mutex);
    m_shared->waiting.insert(m_shared->waiting.end(), reports.begin(), reports.end());
    m_shared->changed.notify_all();
    const bool isDone = m_shared->changed.wait_for(lock, SendTimeout, [this] {
        return m_shared->isUnplugged || (m_shared->waiting.empty() && !m_shared->isWriting);
    });
    if (m_shared->isUnplugged) {
        return failure(ErrorCode::DeviceLost,
                       fmt::format("{}: the device was unplugged or switched off", m_description),
                       PluggedHint);
    }
    if (!isDone) {
        m_shared->waiting.clear(); // a command that is told lost is not carried out later
        return failure(ErrorCode::DeviceLost,
                       fmt::format("{}: the device accepts no more commands", m_description), PluggedHint);
    }
    return {};
}

} // namespace halbench::devices
