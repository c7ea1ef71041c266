#include "app/procedures/base/procedure.h"

#include <algorithm>
#include <utility>

namespace halbench::app {
namespace {

// Marks that the link itself counts up in every transaction; putting an old count back would look torn.
bool isTransactionMark(const std::string& name) {
    return name == "set.first" || name == "set.last";
}

// Not on the pages, but a board that idled before shall idle again.
constexpr const char* ModeName = "hb.mode";
// A board without it only senses: there is nothing to disarm.
constexpr const char* ArmName = "hb.arm";

std::vector<std::string> restorableNames(const devices::Catalogue& catalogue) {
    std::vector<std::string> names;
    if (catalogue.findParameter(ModeName) != nullptr) {
        names.push_back(ModeName);
    }
    for (const ParameterSpec& spec : catalogue.parameters) {
        if (spec.isTransactional && spec.access == ParameterAccess::ReadWrite &&
            !isTransactionMark(spec.name)) {
            names.push_back(spec.name);
        }
    }
    return names;
}

// With a trial open, the board itself goes back to the calibration it had when the trial began as soon as
// its master is lost (resources/help/protocol.md 3.15); a board without it keeps what was written last.
constexpr const char* TrialName = "hb.trial";

Result<void> writeTrial(devices::Device& device, double value) {
    if (device.catalogue().findParameter(TrialName) == nullptr) {
        return {};
    }
    const ParameterValue trial[] = {{TrialName, value}};
    return device.writeParameters(trial);
}

} // namespace

RestoreGuard::RestoreGuard(devices::Device& device, std::vector<ParameterValue> snapshot)
    : m_device(&device), m_snapshot(std::move(snapshot)) {}

RestoreGuard::RestoreGuard(RestoreGuard&& other) noexcept
    : m_device(std::exchange(other.m_device, nullptr)), m_snapshot(std::move(other.m_snapshot)),
      m_isKept(other.m_isKept) {}

Result<RestoreGuard> RestoreGuard::take(devices::Device& device, std::span<const std::string> others) {
    std::vector<std::string> names = restorableNames(device.catalogue());
    for (const std::string& name : others) {
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            names.push_back(name);
        }
    }
    const Result<std::vector<double>> values = device.readParameters(names);
    if (!values) {
        return failure(values.error());
    }
    std::vector<ParameterValue> snapshot;
    for (std::size_t i = 0; i < names.size(); ++i) {
        snapshot.push_back({names[i], (*values)[i]});
    }
    if (auto opened = writeTrial(device, 1.0); !opened) {
        return failure(opened.error());
    }
    return RestoreGuard(device, std::move(snapshot));
}

RestoreGuard::~RestoreGuard() {
    if (m_device != nullptr) {
        (void)restore(); // a lost device is left to the board's watchdog and trial
    }
}

void RestoreGuard::keep() {
    m_isKept = true;
}

Result<void> RestoreGuard::restore() {
    devices::Device* device = std::exchange(m_device, nullptr);
    if (device == nullptr) {
        return {};
    }
    device->stopStream();
    const bool canArm = device->catalogue().findParameter(ArmName) != nullptr;
    const Result<void> disarmed = canArm ? device->disarm() : Result<void>();
    Result<void> written;
    if (!m_isKept) {
        written = device->writeParameters(m_snapshot);
    }
    const Result<void> closed = written ? writeTrial(*device, 0.0) : Result<void>();
    if (!disarmed) {
        return disarmed;
    }
    return written ? closed : written;
}

} // namespace halbench::app
