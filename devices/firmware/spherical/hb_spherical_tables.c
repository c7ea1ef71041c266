/* SPDX-License-Identifier: MIT */
#include "devices/firmware/board/hb_board_tables.h"
#include "devices/firmware/spherical/hb_spherical_internal.h"

/* Names, units and limits of the board. Defaults: the published placement and field
 * (resources/help/spherical-theory.md sections 2 and 3). */

static hb_rom_char FaultChoices[] = "none|-|-|-|-|-|-|value not finite|-";
static hb_rom_char StatusChoices[] = HB_STATUS_CHOICES;
static hb_rom_char OffOn[] = HB_SWITCH_CHOICES;
static hb_rom_char HeldFresh[] = "held|of this sample";
static hb_rom_char FrameChoices[] = "Rz Ry Rx|Rx Ry Rz|unrolled";

#define QUARTER_TURN 1.5707963F
#define HALF_TURN 3.1415927F
#define EIGHTH_TURN 0.78539816F
/* Of sensors that were never calibrated: gains 1 %, offsets 1 mT, frames 1 degree, places 0.1 mm
 * (resources/help/spherical-theory.md section 8). */
#define ASSEMBLY_TOLERANCE_T 3.65e-3F

#define SIGNAL(name, unit, member, lower, upper, text)                                                       \
    HB_SIGNAL(name, unit, HB_FLOAT32, hb_spherical_signals, member, 1.0F, lower, upper, NULL, text)
#define ANGLE(name, member, lower, upper, text) SIGNAL(name, "rad", orientation.member, lower, upper, text)
#define CHANNEL(r, theta, phi, member, sensor, text)                                                         \
    SIGNAL(r, "T", member[3 * sensor], -0.5F, 0.5F, text " along R of sensor " #sensor),                     \
        SIGNAL(theta, "T", member[3 * sensor + 1], -0.5F, 0.5F, text " along Theta of sensor " #sensor),     \
        SIGNAL(phi, "T", member[3 * sensor + 2], -0.5F, 0.5F, text " along Phi of sensor " #sensor)

static const hb_signal Signals[] HB_ROM = {
    ANGLE("orientation.alpha", angle_rad[0], -HALF_TURN, HALF_TURN, "Rotation about stator X, third"),
    ANGLE("orientation.beta", angle_rad[1], -QUARTER_TURN, QUARTER_TURN, "Rotation about stator Y, second"),
    ANGLE("orientation.gamma", angle_rad[2], -HALF_TURN, HALF_TURN,
          "Rotation about stator Z, first: the spin"),
    ANGLE("shaft.theta", shaft_rad[0], 0.0F, HALF_TURN, "Direction of the shaft, from Z"),
    ANGLE("shaft.phi", shaft_rad[1], 0.0F, 2.0F * HALF_TURN, "Direction of the shaft, from X"),
    ANGLE("shaft.cone95", cone95_rad, 0.0F, HALF_TURN,
          "Half-angle of the cone that holds the shaft with 95 %"),
    SIGNAL("orientation.w", "", orientation.quaternion[0], -1.0F, 1.0F, "Quaternion, real part"),
    SIGNAL("orientation.x", "", orientation.quaternion[1], -1.0F, 1.0F, "Quaternion, X"),
    SIGNAL("orientation.y", "", orientation.quaternion[2], -1.0F, 1.0F, "Quaternion, Y"),
    SIGNAL("orientation.z", "", orientation.quaternion[3], -1.0F, 1.0F, "Quaternion, Z"),
    SIGNAL("strength", "T", orientation.strength_T, 0.0F, 1.0F, "Strength q of the field tensor at 50 mm"),
    SIGNAL("strength.expected", "T", expected_T, 0.0F, 1.0F, "The same by calibration and temperature"),
    SIGNAL("chi_square", "", orientation.chi_square, 0.0F, 1.0e9F,
           "Squared residuals over the deviation, 4 on average when all is well"),
    CHANNEL("field.0.r", "field.0.theta", "field.0.phi", field_T, 0, "Field"),
    CHANNEL("field.1.r", "field.1.theta", "field.1.phi", field_T, 1, "Field"),
    CHANNEL("field.2.r", "field.2.theta", "field.2.phi", field_T, 2, "Field"),
    CHANNEL("residual.0.r", "residual.0.theta", "residual.0.phi", orientation.residual_T, 0, "Residual"),
    CHANNEL("residual.1.r", "residual.1.theta", "residual.1.phi", orientation.residual_T, 1, "Residual"),
    CHANNEL("residual.2.r", "residual.2.theta", "residual.2.phi", orientation.residual_T, 2, "Residual"),
    SIGNAL("coil.current", "A", coil_current_A, -100.0F, 100.0F, "Current of the stator coil"),
    SIGNAL("temperature", "degC", temperature_degC, -50.0F, 150.0F, "Temperature at the magnet"),
    HB_STATE("channels_left_out", hb_spherical_signals, HB_UWORD, left_out, 511.0F, NULL,
             "1, 2, 4 ...: channels that are not used, added"),
    HB_STATE("integrity", hb_spherical_signals, HB_UBYTE, integrity, 31.0F, NULL,
             "1 channel left out, 2 held, 4 residual, 8 strength, 16 untested, added"),
    HB_STATE("orientation.fresh", hb_spherical_signals, HB_UBYTE, is_fresh, 1.0F, HeldFresh,
             "Whether these readings determined the orientation"),
    HB_BOARD_SIGNALS(hb_spherical_signals, board, StatusChoices, FaultChoices, HB_FAULT_COUNT - 1.0F),
#if HB_FEATURE_CAPTURE
    HB_BOARD_CAPTURE_SIGNALS(hb_spherical_signals, board),
#endif
};

#define PAGED(name, unit, member, initial, lower, upper, choices, text)                                      \
    HB_PAGED_PARAM(name, unit, hb_spherical_calibration, member, initial, lower, upper, choices, text)
#define LISTED(name, unit, member, initial, limit, text)                                                     \
    HB_PARAM_LIST(HB_PAGED, name, unit, HB_FLOAT32, hb_spherical_calibration, sensors.member,                \
                  HB_FIELD_CHANNELS, initial, -(limit), limit, text)
#define PLACE(alpha, beta, gamma, radius, number, a, b, g)                                                   \
    PAGED(alpha, "rad", sensors.alpha_rad[number], a, -HALF_TURN, HALF_TURN, NULL,                           \
          "Placement of the sensor about stator X"),                                                         \
        PAGED(beta, "rad", sensors.beta_rad[number], b, -HALF_TURN, HALF_TURN, NULL,                         \
              "Placement of the sensor about stator Y"),                                                     \
        PAGED(gamma, "rad", sensors.gamma_rad[number], g, -HALF_TURN, HALF_TURN, NULL,                       \
              "Placement of the sensor about stator Z"),                                                     \
        PAGED(radius, "m", sensors.radius_m[number], 0.05F, 0.005F, 0.5F, NULL,                              \
              "Distance of the sensor from the centre")

static const hb_parameter Parameters[] HB_ROM = {
    HB_SET_FIRST(hb_spherical_calibration, set_first),
    PLACE("sensor.alpha_0", "sensor.beta_0", "sensor.gamma_0", "sensor.radius_0", 0, 0.0F, 0.0F, 0.0F),
    PLACE("sensor.alpha_1", "sensor.beta_1", "sensor.gamma_1", "sensor.radius_1", 1, 0.0F, 0.0F, EIGHTH_TURN),
    PLACE("sensor.alpha_2", "sensor.beta_2", "sensor.gamma_2", "sensor.radius_2", 2, EIGHTH_TURN, EIGHTH_TURN,
          -QUARTER_TURN),
    PAGED("sensor.frames", "", frames, 0.0F, 0.0F, 2.0F, FrameChoices, "Order of the placement angles"),
    LISTED("sensor.turn", "rad", turn_rad, 0.0F, 0.5F,
           "Mounting error of sensor 0, 1, 2 about stator X, Y, Z"),
    LISTED("sensor.gain", "", gain, 0.0F, 0.5F, "Gain error of R, Theta, Phi of sensor 0, 1, 2"),
    LISTED("sensor.skew", "", skew, 0.0F, 0.3F,
           "Cross-axis share R-Theta, R-Phi, Theta-Phi of sensor 0, 1, 2"),
    LISTED("sensor.offset", "T", offset_T, 0.0F, 0.1F, "Offset of R, Theta, Phi of sensor 0, 1, 2"),
    LISTED("sensor.coil", "T/A", coil_T_per_A, 0.0F, 0.1F,
           "Field of the stator coil at R, Theta, Phi of sensor 0, 1, 2"),
    PAGED("sensor.deviation", "T", sensors.deviation_T, 1.0e-4F, 1.0e-7F, 0.05F, NULL,
          "Deviation of a reading: noise"),
    PAGED("sensor.tolerance", "T", sensors.tolerance_T, ASSEMBLY_TOLERANCE_T, 0.0F, 0.1F, NULL,
          "Deviation that errors of the calibration leave in a reading"),
    PAGED("rotor.strength", "T", rotor.strength_T, 0.0991864782F, 1.0e-3F, 1.0F, NULL,
          "Strength q of the field tensor at 50 mm"),
    HB_PARAM_LIST(HB_PAGED, "rotor.harmonic", "T", HB_FLOAT32, hb_spherical_calibration, rotor.harmonic_T,
                  HB_FIELD_HARMONICS, 0.0F, -0.5F, 0.5F,
                  "Amplitudes of the harmonics (4,2), (6,2), (6,6), (10,10) at 50 mm"),
    PAGED("rotor.drift", "1/K", drift_per_K, -1.1e-3F, -0.01F, 0.01F, NULL,
          "Relative change of the field with temperature"),
    PAGED("rotor.reference", "degC", reference_degC, 25.0F, -40.0F, 125.0F, NULL,
          "Temperature of the calibrated strength"),
    PAGED("limit.strength", "", strength_tolerance, 0.05F, 1.0e-3F, 1.0F, NULL,
          "Share of the strength beyond which it is flagged"),
    PAGED("limit.chi_square", "", chi_square_limit, 47.9F, 1.0F, 1.0e9F, NULL,
          "Chi-square that is flagged; 1e-9 of healthy readings exceed it"),
    PAGED("coil.compensation", "", coil_compensation, 1.0F, 0.0F, 1.0F, OffOn, "Subtract the coil's field"),
    HB_SET_LAST(hb_spherical_calibration, set_last),

    HB_LIVE_PARAM("channels.off", "", hb_spherical_live, HB_UWORD, channels_off, 0.0F, 0.0F, 511.0F, NULL,
                  "1, 2, 4 ...: channels to leave out, added"),
    HB_LIVE_PARAM("hb.watchdog_ms", "ms", hb_spherical_live, HB_UWORD, board.watchdog_ms, 0.0F, 0.0F,
                  HB_LONGEST_WATCHDOG_MS, NULL, "Silence of the host that ends its session")
        HB_BOARD_TRIAL(hb_spherical_live, board),
#if HB_FEATURE_CAPTURE
    HB_BOARD_CAPTURE(hb_spherical_live, capture),
#endif
};

static const hb_event Events[] HB_ROM = {{"fast", HB_TICK_MS, 6}};

const HB_FLASH hb_actuator hb_spherical_actuator = {
    .model = "spherical",
    .signals = Signals,
    .parameters = Parameters,
    .events = Events,
    .signal_count = sizeof Signals / sizeof Signals[0],
    .parameter_count = sizeof Parameters / sizeof Parameters[0],
    .faults = FaultChoices,
    .page_octets = sizeof(hb_spherical_calibration),
    .live_octets = sizeof(hb_spherical_live),
    .live_offset = offsetof(hb_spherical_live, board),
    .signal_offset = offsetof(hb_spherical_signals, board),
#if HB_FEATURE_CAPTURE
    .capture_offset = offsetof(hb_spherical_live, capture),
#endif
    .event_count = 1,
    .loop_ticks = 1,
    .sense = hb_spherical_sense,
    .supervise = hb_spherical_pass,
    .control = hb_spherical_pass,
    .drive = hb_spherical_pass,
    .enter_mode = hb_spherical_enter_mode,
    .check = hb_spherical_check,
    .stop_reference = hb_spherical_stop_reference,
    .advance = hb_spherical_advance,
};
