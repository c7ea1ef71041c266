#include "app/procedures/frequency/frequency_board.h"

#include "app/procedures/identify/identify_plan.h"
#include "app/procedures/tune/position_law_parameters.h"

#include <fmt/format.h>

namespace halbench::app {

Result<void> checkFrequencyBoard(const devices::Catalogue& catalogue, const FrequencyConfig& config) {
    for (const char* name : {"position", "speed", "reference", "current_command"}) {
        if (catalogue.findSignal(name) == nullptr) {
            return failure(ErrorCode::DeviceRefused, fmt::format("the device has no signal '{}'", name),
                           "a frequency response needs a board with a position loop of its own");
        }
    }
    if (config.excitation == Excitation::SteppedSine ||
        catalogue.findParameter("reference.frequency_end") != nullptr) {
        return {};
    }
    return failure(ErrorCode::DeviceRefused, "the generator of this device has neither multisine nor chirp",
                   "use a stepped sine");
}

FrequencyMargins frequencyMargins(const devices::Catalogue& catalogue,
                                  const control::SampledPositionLaw& law) {
    FrequencyMargins margins;
    margins.law = law;
    const auto period = catalogue.knownConstants.find("T_s");
    margins.period_s = period == catalogue.knownConstants.end() ? margins.period_s : period->second;
    margins.law.period_s = margins.period_s;
    const PilotEstimate nominal = nominalMotor();
    margins.plant = {nominal.damping_per_s, nominal.torque_rad_s2_A,
                     nominal.friction_rad_s2 / nominal.torque_rad_s2_A};
    return margins;
}

Result<FrequencyMargins> readFrequencyMargins(devices::Device& device) {
    constexpr const char* LawForm = "control.law";
    if (device.catalogue().findParameter(LawForm) != nullptr) {
        const std::string name[] = {LawForm};
        const auto form = device.readParameters(name);
        if (!form) {
            return failure(form.error());
        }
        if (form->front() != 0.0) {
            return failure(ErrorCode::Refused,
                           "the device uses the printed difference equation, which has no gains",
                           "set control.law=0 first; nothing was armed");
        }
    }
    const auto law = readPositionLaw(device);
    if (!law) {
        return failure(law.error());
    }
    return frequencyMargins(device.catalogue(), *law);
}

} // namespace halbench::app
