#pragma once

#include "control/base/random.h"
#include "devices/firmware/planar/hb_planar.h"
#include "models/planar/hall_chip.h"
#include "models/planar/pose_estimator.h"

#include <array>
#include <memory>

namespace halbench::devices::firmware {

/// Evenly between minus and plus this.
inline double within(Random& random, double limit) {
    return limit * (2.0 * random.uniform() - 1.0);
}

/// The calibration that a new board starts with.
inline hb_planar_calibration initialCalibration() {
    const auto board = std::make_unique<hb_planar>();
    hb_planar_init(board.get(), nullptr, nullptr);
    return board->pages[0];
}

/// The same chips in double precision.
inline models::PoseSensing sensingOf(const hb_planar_calibration& page) {
    models::PoseSensing sensing;
    sensing.waveNumber_per_m = 2.0 * 3.14159265358979323846 / static_cast<double>(page.coils.pitch_m);
    for (std::size_t j = 0; j < HB_CHIPS; ++j) {
        sensing.place_m[j] = {static_cast<double>(page.chips.place_x_m[j]),
                              static_cast<double>(page.chips.place_y_m[j])};
        sensing.amplitude_T[j] = static_cast<double>(page.chips.amplitude_T[j]);
        sensing.sensitivity[j].setIdentity();
        sensing.offset_T[j].setZero();
    }
    sensing.deviation_T = static_cast<double>(page.chips.deviation_T);
    return sensing;
}

using Fields = std::array<float, HB_CHIP_FIELDS>;

/// What perfect chips see at a pose.
inline models::ChipFields_T fieldsAt(const models::PoseSensing& sensing, const models::PlanarPose& pose) {
    models::ChipFields_T fields;
    for (std::size_t j = 0; j < HB_CHIPS; ++j) {
        fields.segment<2>(2 * static_cast<Eigen::Index>(j)) =
            models::chipField_T(sensing.waveNumber_per_m, sensing.amplitude_T[j], sensing.place_m[j], pose);
    }
    return fields;
}

inline Fields single(const models::ChipFields_T& fields) {
    Fields result{};
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = static_cast<float>(fields(static_cast<Eigen::Index>(i)));
    }
    return result;
}

} // namespace halbench::devices::firmware
