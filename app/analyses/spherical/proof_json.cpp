#include "app/analyses/spherical/proof_json.h"

#include "app/actuators/spherical/rotation_order.h"
#include "app/analyses/spherical/placement_choice.h"
#include "app/documents/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

using models::CoverageVerdict;

std::string_view nameOf(CoverageVerdict verdict) {
    return models::CoverageVerdictNames[static_cast<std::size_t>(verdict)];
}

CoverageVerdict verdictOf(const models::CoverageProof& proof) {
    const auto has = [&](CoverageVerdict verdict) {
        return std::any_of(proof.component.begin(), proof.component.end(),
                           [verdict](const auto& component) { return component.verdict == verdict; });
    };
    return has(CoverageVerdict::Refuted) ? CoverageVerdict::Refuted
           : has(CoverageVerdict::Open)  ? CoverageVerdict::Open
                                         : CoverageVerdict::Proven;
}

} // namespace

JsonValue proofJson(const models::CoverageProof& proof) {
    JsonValue components = JsonValue::array();
    int proven = 0;
    for (std::size_t i = 0; i < models::ComponentCount; ++i) {
        const models::ComponentProof& part = proof.component[i];
        proven += part.verdict == CoverageVerdict::Proven;
        JsonValue component = JsonValue::object();
        component.set("component", ComponentNames[i]).set("verdict", nameOf(part.verdict));
        component.set("bound_T", part.bound_T).set("least_T", part.least_T);
        component.set("least_at",
                      anglesJson(part.leastAt.alpha_rad, part.leastAt.beta_rad, part.leastAt.gamma_rad));
        components.push(component.set("cells", part.cells));
    }
    JsonValue document = JsonValue::object();
    document.set("verdict", nameOf(verdictOf(proof))).set("proven_components", proven);
    return document.set("bound_T", proof.bound_T()).set("components", components);
}

int decimalsBelow(double reading_T, double limit_T) {
    constexpr int Most = 6;
    int decimals = 2;
    const auto isHidden = [&] {
        const double scale = std::pow(10.0, decimals);
        return std::round(1e3 * reading_T * scale) >= std::round(1e3 * limit_T * scale);
    };
    while (decimals < Most && isHidden()) {
        ++decimals;
    }
    return decimals;
}

std::string proofText(const models::CoverageProof& proof, double threshold_T) {
    std::string text;
    for (std::size_t i = 0; i < models::ComponentCount; ++i) {
        const models::ComponentProof& part = proof.component[i];
        const std::string pose =
            anglesText(part.leastAt.alpha_rad, part.leastAt.beta_rad, part.leastAt.gamma_rad);
        switch (part.verdict) {
        case CoverageVerdict::Proven:
            text += fmt::format("  {:<6} proven: at least {:.2f} mT everywhere, {:.2f} mT met at {} deg\n",
                                ComponentNames[i], 1e3 * part.bound_T, 1e3 * part.least_T, pose);
            break;
        case CoverageVerdict::Refuted:
            text += fmt::format(
                "  {:<6} counterexample: no sensor reads {} mT at {} deg, the largest {:.{}f} mT\n",
                ComponentNames[i], formatNumber(1e3 * threshold_T), pose, 1e3 * part.least_T,
                decimalsBelow(part.least_T, threshold_T));
            break;
        case CoverageVerdict::Open:
            text += fmt::format("  {:<6} open: between {:.4f} and {:.4f} mT, undecided after {} cells\n",
                                ComponentNames[i], 1e3 * part.bound_T, 1e3 * part.least_T, part.cells);
            break;
        }
    }
    return text + fmt::format("  poses are (alpha, beta, gamma): {}\n", orientationOrder());
}

} // namespace halbench::app
