/* SPDX-License-Identifier: MIT */
#include "devices/firmware/board/hb_board_tables.h"
#include "devices/firmware/planar/hb_planar_internal.h"

/* Names, units and limits of the board. Defaults: the published machine and the gains of
 * resources/help/planar-theory.md section 9. */

static hb_rom_char FaultChoices[] =
    "none|coil temperature above its limit|current above its limit|speed above its window|position left its "
    "window|pose jumped|sensors determine no pose|value not finite|output converter does not answer|vertical "
    "force near the weight";
static hb_rom_char StatusChoices[] = HB_STATUS_CHOICES;
static hb_rom_char OffOn[] = HB_SWITCH_CHOICES;
static hb_rom_char NoYes[] = "no|yes";
static hb_rom_char ModeChoices[] = "idle|coil currents|position|wrench";
static hb_rom_char AllocationChoices[] = "set by set|heading, fundamental|heading, all harmonics";
static hb_rom_char EstimatorChoices[] = "least squares|tracking filter";
static hb_rom_char DelayChoices[] = "none|one sample|two samples";
static hb_rom_char TargetChoices[] = "position|force or torque";
static hb_rom_char ShapeChoices[] = "none|step|ramp|sine|staircase|chirp|multisine|-|trapezoid|s-curve";
static hb_rom_char PathChoices[] = "none|circle|raster|arc|line|table";
static hb_rom_char PathProfileChoices[] = "trapezoid|s-curve";

#define SIGNAL(name, unit, member, limit, text)                                                              \
    HB_SIGNAL(name, unit, HB_FLOAT32, hb_planar_signals, member, 1.0F, -(limit), limit, NULL, text)
#define AXES(x, y, phi, unit, turn_unit, member, limit, turn_limit, text)                                    \
    SIGNAL(x, unit, member[0], limit, text " along x"), SIGNAL(y, unit, member[1], limit, text " along y"),  \
        SIGNAL(phi, turn_unit, member[2], turn_limit, text " about the vertical")
#define COIL(name, number)                                                                                   \
    SIGNAL(name, "A", current_A[number - 1], 5.0F, "Current commanded into coil " #number)
#define HEAT(name, number) SIGNAL(name, "degC", temperature_degC[number - 1], 500.0F, "Coil " #number)
#define CHIP(x, y, number)                                                                                   \
    SIGNAL(x, "T", field_T[2 * number - 2], 0.25F, "Field along x' at chip " #number),                       \
        SIGNAL(y, "T", field_T[2 * number - 1], 0.25F, "Field along y' at chip " #number)

static const hb_signal Signals[] HB_ROM = {
    AXES("position.x", "position.y", "position.phi", "m", "rad", position, 10.0F, 3.2F, "Pose of the platen"),
    AXES("speed.x", "speed.y", "speed.phi", "m/s", "rad/s", speed, 10.0F, 100.0F, "Speed of the platen"),
    AXES("reference.x", "reference.y", "reference.phi", "m", "rad", reference, 1000.0F, 1000.0F,
         "Reference, or effort in mode wrench,"),
    AXES("command.x", "command.y", "command.phi", "N", "N*m", command, 1000.0F, 1000.0F,
         "Command of law and excitation"),
    AXES("effort.x", "effort.y", "effort.phi", "N", "N*m", effort, 100.0F, 10.0F,
         "Force or torque of the currents"),
    COIL("current.coil1", 1),
    COIL("current.coil2", 2),
    COIL("current.coil3", 3),
    COIL("current.coil4", 4),
    COIL("current.coil5", 5),
    COIL("current.coil6", 6),
    CHIP("hall.x1", "hall.y1", 1),
    CHIP("hall.x2", "hall.y2", 2),
    CHIP("hall.x3", "hall.y3", 3),
    HEAT("coil_temperature.coil1", 1),
    HEAT("coil_temperature.coil2", 2),
    HEAT("coil_temperature.coil3", 3),
    HEAT("coil_temperature.coil4", 4),
    HEAT("coil_temperature.coil5", 5),
    HEAT("coil_temperature.coil6", 6),
    SIGNAL("lift", "N", lift_N, 100.0F, "Vertical force of the coils, upward"),
    SIGNAL("chi_square", "", chi_square, 1.0e9F, "Squared residuals of the readings over their deviation"),
    SIGNAL("innovation_square", "", innovation_square, 1.0e9F,
           "Squared innovation of the tracking filter, 6 when all is well"),
    SIGNAL("current_scale", "", current_scale, 1.0F, "Below 1: currents at their limit"),
    HB_SIGNAL("cell.x", "", HB_SWORD, hb_planar_signals, cell[0], 1.0F, -100.0F, 100.0F, NULL,
              "Pitches from the first cell along x"),
    HB_SIGNAL("cell.y", "", HB_SWORD, hb_planar_signals, cell[1], 1.0F, -100.0F, 100.0F, NULL,
              "Pitches from the first cell along y"),
    HB_STATE("chips_left_out", hb_planar_signals, HB_UBYTE, left_out, 7.0F, NULL,
             "1, 2, 4: chips that are not used, added"),
    HB_STATE("homed", hb_planar_signals, HB_UBYTE, homed, 1.0F, NoYes, "The first cell was chosen"),
    HB_BOARD_SIGNALS(hb_planar_signals, board, StatusChoices, FaultChoices, HB_PLANAR_FAULT_COUNT - 1.0F),
    HB_BOARD_REFERENCE_SIGNALS(hb_planar_signals, board),
#if HB_FEATURE_CAPTURE
    HB_BOARD_CAPTURE_SIGNALS(hb_planar_signals, board),
#endif
};

/* From the middle to an end stop. A window wider than the way from stop to stop would never trip. */
#define TRAVEL_M 0.05F
#define TRAVEL_RAD 0.02F

#define PAGED(name, unit, member, initial, lower, upper, choices, text)                                      \
    HB_PAGED_PARAM(name, unit, hb_planar_calibration, member, initial, lower, upper, choices, text)
#define LIVE(name, unit, type, member, initial, lower, upper, choices, text)                                 \
    HB_LIVE_PARAM(name, unit, hb_planar_live, type, member, initial, lower, upper, choices, text)
#define LISTED(name, unit, member, count, initial, lower, upper, text)                                       \
    HB_PARAM_LIST(HB_PAGED, name, unit, HB_FLOAT32, hb_planar_calibration, member, count, initial, lower,    \
                  upper, text)
#define COEFFICIENT(name, index, n, member, initial, lower, upper, text)                                     \
    PAGED(name, "", gains[index].sections[n - 1].member, initial, lower, upper, NULL, text)
#define SECTION(index, n, b0_name, b1_name, b2_name, a1_name, a2_name)                                       \
    COEFFICIENT(b0_name, index, n, b0, 1.0F, -1000.0F, 1000.0F,                                              \
                "Filter section (b0 d^2 + b1 d + b2)/(d^2 + a1 d + a2), d = z - 1"),                         \
        COEFFICIENT(b1_name, index, n, b1, 0.0F, -1000.0F, 1000.0F, "Coefficient b1 of the filter section"), \
        COEFFICIENT(b2_name, index, n, b2, 0.0F, -1000.0F, 1000.0F, "Coefficient b2 of the filter section"), \
        COEFFICIENT(a1_name, index, n, a1, 0.0F, 0.0F, 4.0F,                                                 \
                    "Coefficient a1 of the filter section; 0 switches it off"),                              \
        COEFFICIENT(a2_name, index, n, a2, 0.0F, 0.0F, 4.0F, "Coefficient a2 of the filter section")
#define GAINS(kp_name, ki_name, kd_name, index, per_m, per_ms, s_per_m, kp0, ki0, kd0)                       \
    PAGED(kp_name, per_m, gains[index].kp, kp0, 0.0F, 1.0e6F, NULL, "Proportional gain"),                    \
        PAGED(ki_name, per_ms, gains[index].ki, ki0, 0.0F, 1.0e8F, NULL, "Integral gain"),                   \
        PAGED(kd_name, s_per_m, gains[index].kd, kd0, 0.0F, 1.0e4F, NULL,                                    \
              "Derivative gain on the measured position")
#define WEIGHTS(b_name, c_name, filter_name, index)                                                          \
    PAGED(b_name, "", gains[index].reference_weight, 0.745F, 0.0F, 1.0F, NULL,                               \
          "Set-point weight b of the proportional part"),                                                    \
        PAGED(c_name, "", gains[index].derivative_reference_weight, 0.0F, 0.0F, 1.0F, NULL,                  \
              "Set-point weight c of the derivative part"),                                                  \
        PAGED(filter_name, "s", gains[index].derivative_filter_s, 1.5414941e-3F, 0.0F, 10.0F, NULL,          \
              "Time constant of the derivative's filter")
#define INERTIA(name, unit, index)                                                                           \
    PAGED(name, unit, gains[index].inertia, 0.0F, 0.0F, 100.0F, NULL, "Effort per acceleration of a profile")
/* Chips that the table builds for each of three. */
#define CHIPS(name, unit, member, initial, lower, upper, text)                                               \
    LISTED("chip." name, unit, chips.member, HB_CHIPS, initial, lower, upper, text)
#define PLACE(number, x, y)                                                                                  \
    PAGED("chip.place_x_" #number, "m", chips.place_x_m[number - 1], x, -0.2F, 0.2F, NULL,                   \
          "Place of the chip in platen axes"),                                                               \
        PAGED("chip.place_y_" #number, "m", chips.place_y_m[number - 1], y, -0.2F, 0.2F, NULL,               \
              "Place of the chip in platen axes")
#define REFERENCE(axis, index)                                                                               \
    LIVE("reference." axis ".shape", "", HB_UBYTE, reference[index].shape, 0.0F, 0.0F, HB_PLANAR_S_CURVE,    \
         ShapeChoices, "Shape of the reference"),                                                            \
        LIVE("reference." axis ".amplitude", "", HB_FLOAT32, reference[index].amplitude, 0.0F, -1000.0F,     \
             1000.0F, NULL,                                                                                  \
             "m, rad, N or N*m; height of a step of the staircase, end of the ramp, distance"),              \
        LIVE("reference." axis ".rate", "", HB_FLOAT32, reference[index].rate, 0.0F, -1000.0F, 1000.0F,      \
             NULL, "Slope of the ramp, speed of trapezoid and S-curve, per second"),                         \
        LIVE("reference." axis ".acceleration", "", HB_FLOAT32, acceleration[index], 1.0F, 0.0F, 1000.0F,    \
             NULL, "Largest acceleration of trapezoid and S-curve, per second squared"),                     \
        LIVE("reference." axis ".jerk", "", HB_FLOAT32, jerk[index], 100.0F, 0.0F, 1.0e6F, NULL,             \
             "Largest jerk of the S-curve, per second cubed"),                                               \
        LIVE("reference." axis ".frequency", "Hz", HB_FLOAT32, reference[index].frequency_Hz, 1.0F, 0.0F,    \
             200.0F, NULL, "Frequency of sine; first of chirp and multisine"),                               \
        LIVE("reference." axis ".frequency_end", "Hz", HB_FLOAT32, reference[index].frequency_end_Hz, 10.0F, \
             0.0F, 200.0F, NULL, "Last frequency of chirp and multisine"),                                   \
        LIVE("reference." axis ".period", "s", HB_FLOAT32, reference[index].period_s, 1.0F, 0.001F, 3600.0F, \
             NULL, "Time of one step of the staircase"),                                                     \
        LIVE("reference." axis ".count", "", HB_UWORD, reference[index].count, 10.0F, 1.0F, 1000.0F, NULL,   \
             "Steps of the staircase, lines of the multisine"),                                              \
        LIVE("reference." axis ".duration", "s", HB_FLOAT32, reference[index].duration_s, 10.0F, 0.001F,     \
             100000.0F, NULL, "Time until the generator ends"),                                              \
        LIVE("reference." axis ".base", "", HB_FLOAT32, reference[index].base, 0.0F, -1000.0F, 1000.0F,      \
             NULL, "Constant speed added in mode position, else effort"),                                    \
        LIVE("reference." axis ".target", "", HB_UBYTE, target[index], 0.0F, 0.0F, 1.0F, TargetChoices,      \
             "Where the reference goes in mode position: to the law, or added to its command"),              \
        LIVE("reference." axis ".seed", "", HB_ULONG, reference[index].seed, 0.0F, 0.0F, HB_LARGEST_ULONG,   \
             NULL, "Phases of the multisine; 0 = Schroeder")

#define PIECE(id, index, unit, speed_unit, acceleration_unit, jerk_unit)                                     \
    LIVE("table." id ".value", unit, HB_FLOAT32, piece.axis[index].value, 0.0F, -1000.0F, 1000.0F, NULL,     \
         "Where a piece begins, from where the motion began"),                                               \
        LIVE("table." id ".speed", speed_unit, HB_FLOAT32, piece.axis[index].speed, 0.0F, -1000.0F, 1000.0F, \
             NULL, "At the beginning of the piece"),                                                         \
        LIVE("table." id ".acceleration", acceleration_unit, HB_FLOAT32, piece.axis[index].acceleration,     \
             0.0F, -1.0e6F, 1.0e6F, NULL, "At the beginning of the piece"),                                  \
        LIVE("table." id ".jerk", jerk_unit, HB_FLOAT32, piece.axis[index].jerk, 0.0F, -1.0e9F, 1.0e9F,      \
             NULL, "During the piece")

static const hb_parameter Parameters[] HB_ROM = {
    HB_SET_FIRST(hb_planar_calibration, set_first),
    GAINS("gain.x.kp", "gain.x.ki", "gain.x.kd", 0, "N/m", "N/(m*s)", "N*s/m", 660.48F, 1267.2F, 39.808F),
    WEIGHTS("gain.x.reference_weight", "gain.x.derivative_reference_weight", "gain.x.derivative_filter", 0),
    SECTION(0, 1, "filter.x.1.b0", "filter.x.1.b1", "filter.x.1.b2", "filter.x.1.a1", "filter.x.1.a2"),
    SECTION(0, 2, "filter.x.2.b0", "filter.x.2.b1", "filter.x.2.b2", "filter.x.2.a1", "filter.x.2.a2"),
    SECTION(0, 3, "filter.x.3.b0", "filter.x.3.b1", "filter.x.3.b2", "filter.x.3.a1", "filter.x.3.a2"),
    SECTION(0, 4, "filter.x.4.b0", "filter.x.4.b1", "filter.x.4.b2", "filter.x.4.a1", "filter.x.4.a2"),
    INERTIA("feedforward.x.inertia", "kg", 0),
    GAINS("gain.y.kp", "gain.y.ki", "gain.y.kd", 1, "N/m", "N/(m*s)", "N*s/m", 660.48F, 1267.2F, 39.808F),
    WEIGHTS("gain.y.reference_weight", "gain.y.derivative_reference_weight", "gain.y.derivative_filter", 1),
    SECTION(1, 1, "filter.y.1.b0", "filter.y.1.b1", "filter.y.1.b2", "filter.y.1.a1", "filter.y.1.a2"),
    SECTION(1, 2, "filter.y.2.b0", "filter.y.2.b1", "filter.y.2.b2", "filter.y.2.a1", "filter.y.2.a2"),
    SECTION(1, 3, "filter.y.3.b0", "filter.y.3.b1", "filter.y.3.b2", "filter.y.3.a1", "filter.y.3.a2"),
    SECTION(1, 4, "filter.y.4.b0", "filter.y.4.b1", "filter.y.4.b2", "filter.y.4.a1", "filter.y.4.a2"),
    INERTIA("feedforward.y.inertia", "kg", 1),
    GAINS("gain.phi.kp", "gain.phi.ki", "gain.phi.kd", 2, "N*m/rad", "N*m/(rad*s)", "N*m*s/rad", 3.864F,
          7.92F, 0.1222F),
    WEIGHTS("gain.phi.reference_weight", "gain.phi.derivative_reference_weight", "gain.phi.derivative_filter",
            2),
    SECTION(2, 1, "filter.phi.1.b0", "filter.phi.1.b1", "filter.phi.1.b2", "filter.phi.1.a1",
            "filter.phi.1.a2"),
    SECTION(2, 2, "filter.phi.2.b0", "filter.phi.2.b1", "filter.phi.2.b2", "filter.phi.2.a1",
            "filter.phi.2.a2"),
    SECTION(2, 3, "filter.phi.3.b0", "filter.phi.3.b1", "filter.phi.3.b2", "filter.phi.3.a1",
            "filter.phi.3.a2"),
    SECTION(2, 4, "filter.phi.4.b0", "filter.phi.4.b1", "filter.phi.4.b2", "filter.phi.4.a1",
            "filter.phi.4.a2"),
    INERTIA("feedforward.phi.inertia", "kg*m^2", 2),
    PAGED("platen.mass", "kg", mass_kg, 0.64F, 0.01F, 100.0F, NULL, "Moving mass"),
    PAGED("platen.inertia", "kg*m^2", inertia_kg_m2, 1.0e-3F, 1.0e-5F, 1.0F, NULL,
          "Inertia about the vertical"),
    PAGED("platen.centre_x", "m", centre_x_m, 0.0F, -0.1F, 0.1F, NULL, "Centre of mass in platen axes"),
    PAGED("platen.centre_y", "m", centre_y_m, 0.0F, -0.1F, 0.1F, NULL, "Centre of mass in platen axes"),
    PAGED("coil.force_constant", "N/A", coils.force_constant_N_per_A, -3.09772F, -100.0F, -0.01F, NULL,
          "Force per ampere; negative by the sign of the phases"),
    PAGED("coil.pitch", "m", coils.pitch_m, 0.0508F, 0.001F, 1.0F, NULL, "Pitch of the magnet matrix"),
    PAGED("coil.width", "m", coils.coil_width_m, 6.096e-3F, 0.0F, 0.1F, NULL, "Width of a coil's winding"),
    PAGED("coil.arm", "m", coils.arm56_m, 0.0444F, 0.0F, 0.5F, NULL, "Place of coils 5 and 6 along y'"),
    PAGED("coil.allocation", "", allocation, 0.0F, 0.0F, 2.0F, AllocationChoices,
          "From the wrench to the currents"),
    PAGED("speed.estimator", "", estimator, 0.0F, 0.0F, 1.0F, EstimatorChoices,
          "Pose and speed from the readings"),
    PAGED("speed.filter", "s", speed_filter_s, 2.0e-3F, 0.0F, 0.1F, NULL, "Time constant of the speeds"),
    PAGED("limit.current", "A", limit_current_A, 1.0F, 0.0F, 5.0F, NULL, "Largest current of a coil"),
    PAGED("limit.temperature", "degC", limit_temperature_degC, 80.0F, -40.0F, 100.0F, NULL,
          "Coil temperature that trips"),
    PAGED("limit.lift", "N", limit_lift_N, 5.0F, 0.0F, 1000.0F, NULL, "Vertical force that trips"),
    PAGED("window.x", "m", window_position[0], 0.05F, 0.0F, 2.0F * TRAVEL_M, NULL,
          "Largest excursion from where the mode began"),
    PAGED("window.y", "m", window_position[1], 0.05F, 0.0F, 2.0F * TRAVEL_M, NULL,
          "Largest excursion from where the mode began"),
    PAGED("window.phi", "rad", window_position[2], 0.03F, 0.0F, 2.0F * TRAVEL_RAD, NULL,
          "Largest rotation from where the mode began"),
    PAGED("window.position_enabled", "", window_position_enabled, 1.0F, 0.0F, 1.0F, OffOn, "Position window"),
    PAGED("window.speed", "m/s", window_speed_m_s, 0.4F, 0.0F, 10.0F, NULL, "Largest speed while armed"),
    PAGED("window.speed_phi", "rad/s", window_speed_rad_s, 10.0F, 0.0F, 100.0F, NULL,
          "Largest speed of rotation while armed"),
    PAGED("window.speed_enabled", "", window_speed_enabled, 1.0F, 0.0F, 1.0F, OffOn, "Speed window"),
    PAGED("delay.samples", "", delay_samples, 1.0F, 0.0F, 2.0F, DelayChoices, "Delay of the currents"),
    CHIPS("amplitude", "T", amplitude_T, 0.02F, 1.0e-3F, 0.2F, "Field amplitude at the chip"),
    PLACE(1, -63.5e-3F, -19.05e-3F),
    PLACE(2, 63.5e-3F, -19.05e-3F),
    PLACE(3, 0.0F, 19.05e-3F),
    CHIPS("gain_x", "", gain_x, 0.0F, -0.5F, 0.5F, "Error of the sensitivity along x'"),
    CHIPS("gain_y", "", gain_y, 0.0F, -0.5F, 0.5F, "Error of the sensitivity along y'"),
    CHIPS("cross_xy", "", cross_xy, 0.0F, -0.3F, 0.3F, "Share of the field along y' in the reading of x'"),
    CHIPS("cross_yx", "", cross_yx, 0.0F, -0.3F, 0.3F, "Share of the field along x' in the reading of y'"),
    CHIPS("offset_x", "T", offset_x_T, 0.0F, -0.05F, 0.05F, "Offset of the reading of x'"),
    CHIPS("offset_y", "T", offset_y_T, 0.0F, -0.05F, 0.05F, "Offset of the reading of y'"),
    LISTED("chip.crosstalk", "T/A", chips.crosstalk_T_per_A, HB_CHIP_FIELDS* HB_COILS, 0.0F, -0.05F, 0.05F,
           "Field of coil 1 ... 6 at chip 1 along x', along y', at chip 2, ..."),
    PAGED("chip.deviation", "T", chips.deviation_T, 3.0e-4F, 1.0e-7F, 0.05F, NULL,
          "Deviation of a reading: noise and what calibration leaves"),
    HB_SET_LAST(hb_planar_calibration, set_last),

    HB_BOARD_ARM(hb_planar_live, board, ModeChoices, 3.0F),
    LIVE("hb.setpoint.x", "", HB_FLOAT32, setpoint[0], 0.0F, -1000.0F, 1000.0F, NULL,
         "m from where the mode began, or N"),
    LIVE("hb.setpoint.y", "", HB_FLOAT32, setpoint[1], 0.0F, -1000.0F, 1000.0F, NULL,
         "m from where the mode began, or N"),
    LIVE("hb.setpoint.phi", "", HB_FLOAT32, setpoint[2], 0.0F, -1000.0F, 1000.0F, NULL,
         "rad from where the mode began, or N*m"),
    HB_PARAM_LIST(HB_LIVE, "hb.current", "A", HB_FLOAT32, hb_planar_live, current_A, HB_COILS, 0.0F, -5.0F,
                  5.0F, "Current of one coil in mode coil currents"),
    HB_BOARD_WATCHDOG(hb_planar_live, board),
    LIVE("hb.home", "", HB_UBYTE, home, 0.0F, 0.0F, 1.0F, NULL, "1 counts cells from the present one"),
    REFERENCE("x", 0),
    REFERENCE("y", 1),
    REFERENCE("phi", 2),
    LIVE(
        "path.shape", "", HB_UBYTE, path.shape, 0.0F, 0.0F, HB_PATH_TABLE, PathChoices,
        "Path that x and y (of a table all axes) follow from the next start on, once, instead of references"),
    LIVE("path.profile", "", HB_UBYTE, path.is_s_curve, 0.0F, 0.0F, 1.0F, PathProfileChoices,
         "Speed along the path: with jumps of the acceleration or with a largest jerk"),
    LIVE("path.radius", "m", HB_FLOAT32, path.radius, 1.0e-3F, -1.0F, 1.0F, NULL,
         "Of the circle, whose centre lies so far in the direction of x, or of the arc"),
    LIVE("path.turns", "", HB_UWORD, path.turns, 1.0F, 1.0F, 1000.0F, NULL, "Of the circle"),
    LIVE("path.width", "m", HB_FLOAT32, path.width, 1.0e-3F, -1.0F, 1.0F, NULL, "Length of a line, along x"),
    LIVE("path.pitch", "m", HB_FLOAT32, path.pitch, 1.0e-4F, -1.0F, 1.0F, NULL, "From line to line, along y"),
    LIVE("path.lines", "", HB_UWORD, path.lines, 10.0F, 1.0F, 1000.0F, NULL, "Of the raster"),
    LIVE("path.angle", "rad", HB_FLOAT32, path.angle, 1.57079633F, -1000.0F, 1000.0F, NULL,
         "Of the arc, counter-clockwise"),
    LIVE("path.heading", "rad", HB_FLOAT32, path.heading, 0.0F, -1000.0F, 1000.0F, NULL,
         "Direction in which arc and line begin, from x towards y"),
    LIVE("path.length", "m", HB_FLOAT32, path.length, 1.0e-3F, -1.0F, 1.0F, NULL, "Of the line"),
    LIVE("path.speed", "m/s", HB_FLOAT32, path.speed, 0.01F, 0.0F, 10.0F, NULL, "Largest speed on the path"),
    LIVE("path.acceleration", "m/s^2", HB_FLOAT32, path.acceleration, 1.0F, 0.0F, 1000.0F, NULL,
         "Largest acceleration on the path"),
    LIVE("path.jerk", "m/s^3", HB_FLOAT32, path.jerk, 100.0F, 0.0F, 1.0e6F, NULL, "Largest jerk on the path"),
    PIECE("x", 0, "m", "m/s", "m/s^2", "m/s^3"),
    PIECE("y", 1, "m", "m/s", "m/s^2", "m/s^3"),
    PIECE("phi", 2, "rad", "rad/s", "rad/s^2", "rad/s^3"),
    LIVE("table.duration", "s", HB_FLOAT32, piece.duration_s, 0.0F, 0.0F, 3600.0F, NULL,
         "How long the piece lasts"),
    LIVE("table.number", "", HB_UWORD, piece_number, 0.0F, 0.0F, HB_PIECES, NULL,
         "Writing n stores the piece as number n of the table"),
    LIVE("table.count", "", HB_UWORD, piece_count, 0.0F, 0.0F, HB_PIECES, NULL,
         "Pieces that path.shape = table follows"),
    HB_BOARD_START(hb_planar_live, board),
#if HB_FEATURE_CAPTURE
    HB_BOARD_CAPTURE(hb_planar_live, capture),
#endif
};

static const hb_event Events[] HB_ROM = {{"fast", HB_TICK_MS, 6}};

const HB_FLASH hb_actuator hb_planar_actuator = {
    .model = "planar",
    .signals = Signals,
    .parameters = Parameters,
    .events = Events,
    .signal_count = sizeof Signals / sizeof Signals[0],
    .parameter_count = sizeof Parameters / sizeof Parameters[0],
    .faults = FaultChoices,
    .page_octets = sizeof(hb_planar_calibration),
    .live_octets = sizeof(hb_planar_live),
    .live_offset = offsetof(hb_planar_live, board),
    .signal_offset = offsetof(hb_planar_signals, board),
    .output_offset = offsetof(hb_planar_signals, current_A),
#if HB_FEATURE_CAPTURE
    .capture_offset = offsetof(hb_planar_live, capture),
#endif
    .output_count = HB_COILS,
    .event_count = 1,
    .loop_ticks = 1,
    .axis_count = HB_AXES,
#if HB_FEATURE_BRAKE
    .brake = hb_planar_brake,
    .brake_ms = 300,
    .braking_faults = (1UL << HB_FAULT_TEMPERATURE) | (1UL << HB_FAULT_CURRENT) | (1UL << HB_FAULT_SPEED) |
                      (1UL << HB_FAULT_POSITION) | (1UL << HB_PLANAR_FAULT_LIFT),
#endif
    .sense = hb_planar_sense,
    .supervise = hb_planar_supervise,
    .control = hb_planar_control,
    .drive = hb_planar_drive,
    .enter_mode = hb_planar_enter_mode,
    .check = hb_planar_check,
    .written = hb_planar_written,
    .stop_reference = hb_planar_stop_reference,
    .advance = hb_planar_advance,
};
