#pragma once

#include "app/procedures/apply/apply_procedure.h"

namespace halbench::app {

/// The move that a verification is.
MoveConfig moveOf(const ApplyVerification& verification);

/// One verification move for a procedure that holds a RestoreGuard: enters Verify, predicts it for the law as
/// the device has it, makes it, and writes into `result` how both agree; its quality is Refused when they do
/// not, or when too much of the move was not seen. A bounded axis steps towards the middle of its travel,
/// whatever the sign of the amplitude; at the end of its travel it leaves that first (leave_end.h).
/// Errors: of the motor, of the device, of the abort.
Result<void> verifyMove(devices::Device& device, const ApplyVerification& verification,
                        const ProcedureObserver& observer, ApplyResult& result);

} // namespace halbench::app
