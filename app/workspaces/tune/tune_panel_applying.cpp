// How the Tune panel brings gains onto the device.
#include "app/procedures/apply/live_apply_procedure.h"
#include "app/workspaces/tune/tune_panel.h"

#include <QCheckBox>
#include <QPointer>

#include <functional>
#include <utility>

namespace halbench::app {

/// At once or in small steps: one procedure, one answer.
void TunePanel::startApplying(const LoopLaw& law, std::vector<ParameterValue> values) {
    std::function<Result<ApplyResult>(devices::Device&, const ProcedureObserver&)> work;
    const MotorEstimate motor = motorEstimate(*m_bench.identification());
    if (m_inSteps->isChecked()) {
        LiveApplyConfig config;
        config.target = law.law;
        config.motor = motor;
        config.conditions = m_conditions;
        work = [config](devices::Device& device, const ProcedureObserver& observer) -> Result<ApplyResult> {
            auto walked = runLiveApply(device, config, observer);
            return walked ? Result<ApplyResult>(std::move(walked->apply)) : failure(walked.error());
        };
    } else {
        const ApplyConfig config{std::move(values), stepVerification(motor)};
        work = [config](devices::Device& device, const ProcedureObserver& observer) {
            return runApply(device, config, observer);
        };
    }
    const QPointer<TunePanel> self(this);
    m_isApplying = m_bench.session().runProcedure(tr("Apply"), std::move(work),
                                                  [self](const Result<ApplyResult>& result) {
                                                      if (self) {
                                                          self->finishApply(result);
                                                      }
                                                  });
}

} // namespace halbench::app
