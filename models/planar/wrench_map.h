#pragma once

#include "models/planar/prism_wrench.h"
#include "models/planar/published_wrench.h"
#include "models/planar/windings_wrench.h"

#include <variant>

namespace halbench::models {

/// Models of the coils' forces, from the most exact to the simplest; a device and its controller may use
/// different ones. Source: resources/help/planar-theory.md sections 5.1 to 5.3.
enum class WrenchModel { Windings, Prism, Published };

/// Wrench per ampere of each coil as a function of the pose, by one of the models. A value: copies are
/// independent, evaluation changes nothing.
class WrenchMap {
public:
    /// The first `orders` harmonics, 1 ... 3; the published model has the fundamental only.
    WrenchMap(WrenchModel model, const PlanarGeometry& geometry, int orders = MatrixOrderCount);

    CoilWrench at(const PlanarPose& pose) const;

private:
    std::variant<WindingsWrench, PrismWrench, PublishedWrench> m_model;
};

} // namespace halbench::models
