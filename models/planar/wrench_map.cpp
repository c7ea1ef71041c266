#include "models/planar/wrench_map.h"

namespace halbench::models {
namespace {

std::variant<WindingsWrench, PrismWrench, PublishedWrench> make(WrenchModel model,
                                                                const PlanarGeometry& geometry, int orders) {
    switch (model) {
    case WrenchModel::Prism:
        return PrismWrench(geometry, orders);
    case WrenchModel::Published:
        return PublishedWrench(geometry);
    case WrenchModel::Windings:
        break;
    }
    return WindingsWrench(geometry, orders);
}

} // namespace

WrenchMap::WrenchMap(WrenchModel model, const PlanarGeometry& geometry, int orders)
    : m_model(make(model, geometry, orders)) {}

CoilWrench WrenchMap::at(const PlanarPose& pose) const {
    return std::visit([&](const auto& model) { return model.at(pose); }, m_model);
}

} // namespace halbench::models
