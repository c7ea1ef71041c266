#pragma once

#include "control/base/result.h"
#include "control/law/pid.h"
#include "control/law/position_loop.h"
#include "control/lti/transfer_function.h"

namespace halbench::control {

/// gain exp(-s deadTime)/((timeConstant s + 1)(secondTime s + 1)); integrating: gain exp(...)/(s (secondTime
/// s
/// + 1)), the gain then per second.
struct LaggedProcess {
    double gain = 1.0;
    double timeConstant_s = 0.0;
    double secondTime_s = 0.0;
    double deadTime_s = 0.0;
    bool isIntegrating = false;
};

/// The motor under torque current, k/(s (s + a)): integrating with gain k/a and the lag 1/a, behind the half
/// sample of the held current and the computing delay. Error: OutOfRange without damping (a = 0 has no lag).
Result<LaggedProcess> laggedProcess(const PositionPlant& plant, const LoopTiming& timing);

/// SIMC (Skogestad 2003, "Simple analytic rules for model reduction and PID controller tuning"), series form:
///   K = timeConstant/(gain (closedTime + deadTime)),  T_i = min(timeConstant, 4 (closedTime + deadTime)),
///   T_d = secondTime; integrating: K = 1/(gain (closedTime + deadTime)), T_i = 4 (closedTime + deadTime).
/// A second lag longer than 4 (closedTime + deadTime) is taken as an integration: T_d = that, K in
/// proportion. closedTime = deadTime is the tight choice, margins of about 3 and 60 degrees. Errors:
/// OutOfRange, NotFinite.
Result<PidGains> simcGains(const LaggedProcess& process, double closedTime_s);

/// Lambda tuning (Dahlin 1968; Rivera 1986), standard form. A lag gets a PI: K = timeConstant/(gain (lambda +
/// deadTime)), T_i = timeConstant: cancels the lag, first order with the time constant lambda. An integrating
/// process with a lag gets a PID (Chien, Fruehauf 1990): with t = 2 lambda + deadTime, K = (t + secondTime)/
/// (gain (lambda + deadTime)^2), T_i = t + secondTime, T_d = t secondTime/T_i: cancels the lag too, and the
/// closed loop is 1/(lambda s + 1)^2 but for its zero, as far as 1 - deadTime s is the dead time. Errors:
/// OutOfRange, NotFinite.
Result<PidGains> lambdaGains(const LaggedProcess& process, double lambda_s);

/// The gain at which a loop of proportional control swings for ever, and the period of that.
struct UltimatePoint {
    double gain = 0.0;
    double period_s = 0.0;
};
/// From a model: its first crossing of the negative real axis. Error: Refused when it has none.
Result<UltimatePoint> ultimatePoint(const TransferFunction& plant);
/// From a relay experiment (Astrom, Hagglund 1984): K_u = 4 level/(pi sqrt(A^2 - hysteresis^2)) by the
/// describing function. Errors: OutOfRange (level or period not positive, amplitude not beyond the
/// hysteresis).
Result<UltimatePoint> ultimatePoint(double level, double hysteresis, double amplitude, double period_s);

/// Ziegler, Nichols 1942, standard form: P 0.5 K_u; PI 0.45 K_u, T_u/1.2; PID 0.6 K_u, T_u/2, T_u/8. Aims at
/// a quarter of decay from swing to swing: little damping, a starting point and not a goal.
enum class ControllerKind { P, Pi, Pid };
PidGains zieglerNicholsGains(const UltimatePoint& ultimate, ControllerKind kind);

} // namespace halbench::control
