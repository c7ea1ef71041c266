#pragma once

#include "control/base/result.h"
#include "devices/device.h"

#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

/// The stages every procedure walks through, in this order; it may skip some. The fault-injection suite is
/// generated from this list: a state without its cases fails the test.
enum class ProcedureState { Prepare, Excite, Record, Fit, Judge, Propose, Apply, Verify, Done, Restored };

inline constexpr std::array AllProcedureStates = {
    ProcedureState::Prepare, ProcedureState::Excite,  ProcedureState::Record, ProcedureState::Fit,
    ProcedureState::Judge,   ProcedureState::Propose, ProcedureState::Apply,  ProcedureState::Verify,
    ProcedureState::Done,    ProcedureState::Restored};

std::string_view procedureStateName(ProcedureState state);

/// One remark on the quality of a result: what was seen and what to do about it.
struct Finding {
    std::string code; ///< stable snake_case word, e.g. "inertia_not_given"
    std::string message;
    std::string hint;

    bool operator==(const Finding&) const = default;
};

enum class Verdict { Good, Doubtful, Refused };

std::string_view verdictName(Verdict verdict);

struct DataQuality {
    Verdict verdict = Verdict::Good;
    std::vector<Finding> findings;
};

/// Asked between steps; an error (Interrupted, Terminated) ends what asks.
using AbortCheck = std::function<Result<void>()>;

/// Callbacks of a procedure to its driver (wizard page, batch, test). Called on the procedure's
/// thread; every member may be empty.
struct ProcedureObserver {
    std::function<void(ProcedureState)> onState;
    std::function<void(double fraction, const std::string& text)> onProgress;
    std::function<void(SampleBlockPtr)> onBlock;
    AbortCheck checkAbort; ///< ends the procedure through its restore path
};

/// The observer, of whose blocks `take` hears first.
ProcedureObserver listeningIn(const ProcedureObserver& observer,
                              std::function<void(const SampleBlock&)> take);

/// Takes a snapshot of the device's transactional parameters on construction and puts it back, disarmed, on
/// every way out unless `keep()` was called after a verified change.
/// Thread: the procedure's. The destructor never throws; a lost device is left to the board's watchdog.
class RestoreGuard {
public:
    /// `others`: parameters to restore that are not transactional on this device (a board without pages).
    static Result<RestoreGuard> take(devices::Device& device, std::span<const std::string> others = {});
    RestoreGuard(RestoreGuard&& other) noexcept;
    RestoreGuard& operator=(RestoreGuard&&) = delete;
    RestoreGuard(const RestoreGuard&) = delete;
    ~RestoreGuard();

    /// The changed parameters stay; only disarming remains to be done at the end.
    void keep();
    /// Restores now and says whether the device confirmed it.
    Result<void> restore();
    const std::vector<ParameterValue>& snapshot() const { return m_snapshot; }

private:
    RestoreGuard(devices::Device& device, std::vector<ParameterValue> snapshot);
    devices::Device* m_device;
    std::vector<ParameterValue> m_snapshot;
    bool m_isKept = false;
};

} // namespace halbench::app
