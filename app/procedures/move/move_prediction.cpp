#include "app/procedures/move/move_prediction.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/tune/position_law_parameters.h"

namespace halbench::app {

Result<std::optional<MoveFigures>> predictAxisMove(devices::Device& device, const MoveConfig& config,
                                                   const MotorEstimate& estimate, double effortLimit) {
    const auto reference = idealReference(config.reference);
    const auto plant = plantFromEstimate(estimate);
    const auto axis = chosenAxis(device.catalogue(), config.axis);
    if (!plant || !axis) {
        return failure(!plant ? plant.error() : axis.error());
    }
    auto law = readPositionLaw(device, catalogueOfAxis(device.catalogue(), *axis));
    if (!law) {
        return failure(law.error());
    }
    if (!reference) {
        return std::optional<MoveFigures>();
    }
    law->limit_A = effortLimit;
    models::IdealLoopConfig loop;
    loop.rotor.inertia_kg_m2 = 1.0; // the motion depends on the ratios to it only
    loop.rotor.viscousDamping_Nm_s = plant->dampingRate_1_s;
    loop.rotor.coulombFriction_Nm = plant->breakawayCurrent_A * plant->accelerationGain_rad_s2_A;
    loop.torqueConstant_Nm_per_A = plant->accelerationGain_rad_s2_A;
    loop.law = *law;
    loop.reference = *reference;
    loop.duration_s = config.duration_s;
    const models::IdealTrace trace = models::runIdealLoop(loop);
    MoveResponse response{trace.time_s, trace.reference_rad, trace.angle_rad};
    response.rowsPerReference = 1;
    const auto figures = measureMove(response, config);
    return figures ? Result<std::optional<MoveFigures>>(*figures) : failure(figures.error());
}

} // namespace halbench::app
