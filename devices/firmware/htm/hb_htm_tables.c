/* SPDX-License-Identifier: MIT */
#include "devices/firmware/board/hb_board_tables.h"
#include "devices/firmware/htm/hb_htm_internal.h"

/* Names, units and limits of the board. A name is what a user sees on the command line; units are those of
 * the host's table. Defaults are the preset "published" of resources/help/htm-theory.md 8.1 with stray
 * compensation on. */

#define ANGLE_LIMIT 51471.0F /* 8192 turns */

static hb_rom_char StatusChoices[] = HB_STATUS_CHOICES;
static hb_rom_char FaultChoices[] =
    "none|coil temperature above its limit|current above its limit|speed above its window|position left its "
    "window|"
    "angle jumped (ambiguous decode)|sensor out of range|value not finite|output converter does not answer";
static hb_rom_char OffOn[] = HB_SWITCH_CHOICES;
static hb_rom_char LawChoices[] = "positional|literal difference equation|literal with clamped memory";
static hb_rom_char DecodeChoices[] = "arctangent|linear";
static hb_rom_char DelayChoices[] = "none|one sample|two samples";
static hb_rom_char ModeChoices[] = "idle|current|position|d-axis";
static hb_rom_char ShapeChoices[] = HB_SHAPE_CHOICES;

#define SIGNAL(name, unit, type, member, scale, limit, choices, text)                                        \
    HB_SIGNAL(name, unit, type, hb_htm_signals, member, scale, -(limit), limit, choices, text)

static const hb_signal Signals[] HB_ROM = {
    HB_SIGNAL_EXACT("position", "rad", HB_SLONG, hb_htm_signals, position,
                    2.3968449810713143e-05 /* 2 pi/2^18 */, -(ANGLE_LIMIT), ANGLE_LIMIT,
                    "Rotor angle, unwrapped"),
    SIGNAL("speed", "rad/s", HB_FLOAT32, speed_rad_s, 1.0F, 1000.0F, NULL, "Rotor speed, slope over 32 ms"),
    SIGNAL("reference", "rad", HB_FLOAT32, reference, 1.0F, ANGLE_LIMIT, NULL,
           "Reference: rad in mode position, else A"),
    SIGNAL("current_command", "A", HB_FLOAT32, current_command_A, 1.0F, 5.0F, NULL,
           "Current amplitude commanded"),
    SIGNAL("current.a", "A", HB_FLOAT32, current_A[0], 1.0F, 5.0F, NULL, "Current commanded into phase A"),
    SIGNAL("current.b", "A", HB_FLOAT32, current_A[1], 1.0F, 5.0F, NULL, "Current commanded into phase B"),
    SIGNAL("hall.a", "T", HB_FLOAT32, hall_T[0], 1.0F, 0.25F, NULL, "Field at Hall sensor A, not corrected"),
    SIGNAL("hall.b", "T", HB_FLOAT32, hall_T[1], 1.0F, 0.25F, NULL, "Field at Hall sensor B, not corrected"),
    SIGNAL("coil_temperature.a", "degC", HB_FLOAT32, temperature_degC[0], 1.0F, 500.0F, NULL, "Coil A"),
    SIGNAL("coil_temperature.b", "degC", HB_FLOAT32, temperature_degC[1], 1.0F, 500.0F, NULL, "Coil B"),
    HB_BOARD_SIGNALS(hb_htm_signals, board, StatusChoices, FaultChoices, HB_FAULT_COUNT - 1.0F),
    HB_BOARD_REFERENCE_SIGNALS(hb_htm_signals, board),
#if HB_FEATURE_CAPTURE
    HB_BOARD_CAPTURE_SIGNALS(hb_htm_signals, board),
#endif
};

#define PAGED(name, unit, member, initial, lower, upper, choices, text)                                      \
    HB_PAGED_PARAM(name, unit, hb_htm_calibration, member, initial, lower, upper, choices, text)
#define LIVE(name, unit, type, member, initial, lower, upper, choices, text)                                 \
    HB_LIVE_PARAM(name, unit, hb_htm_live, type, member, initial, lower, upper, choices, text)
#define MAP(order)                                                                                           \
    PAGED("errormap.cos" #order, "rad", errormap_cosine[order - 1], 0.0F, -0.2F, 0.2F, NULL,                 \
          "Angle error map, cosine of order " #order),                                                       \
        PAGED("errormap.sin" #order, "rad", errormap_sine[order - 1], 0.0F, -0.2F, 0.2F, NULL,               \
              "Angle error map, sine of order " #order)
#define COEFFICIENT(n, name, member, initial, lower, upper, text)                                            \
    PAGED(name, "", sections[n - 1].member, initial, lower, upper, NULL, text)
#define SECTION(n, b0_name, b1_name, b2_name, a1_name, a2_name)                                              \
    COEFFICIENT(n, b0_name, b0, 1.0F, -1000.0F, 1000.0F,                                                     \
                "Filter section (b0 d^2 + b1 d + b2)/(d^2 + a1 d + a2), d = z - 1"),                         \
        COEFFICIENT(n, b1_name, b1, 0.0F, -1000.0F, 1000.0F, "Coefficient b1 of the filter section"),        \
        COEFFICIENT(n, b2_name, b2, 0.0F, -1000.0F, 1000.0F, "Coefficient b2 of the filter section"),        \
        COEFFICIENT(n, a1_name, a1, 0.0F, 0.0F, 4.0F,                                                        \
                    "Coefficient a1 of the filter section; 0 switches it off"),                              \
        COEFFICIENT(n, a2_name, a2, 0.0F, 0.0F, 4.0F, "Coefficient a2 of the filter section")

static const hb_parameter Parameters[] HB_ROM = {
    HB_SET_FIRST(hb_htm_calibration, set_first),
    PAGED("gain.kp", "A/rad", kp, 10.0F, 0.0F, 2000.0F, NULL, "Proportional gain"),
    PAGED("gain.ki", "A/(rad*s)", ki, 0.1F, 0.0F, 20000.0F, NULL, "Integral gain"),
    PAGED("gain.kd", "A*s/rad", kd, 0.0F, 0.0F, 100.0F, NULL, "Derivative gain on the measured angle"),
#if HB_LAW_WEIGHTS
    PAGED("gain.reference_weight", "", reference_weight, 1.0F, 0.0F, 1.0F, NULL,
          "Set-point weight b of the proportional part"),
    PAGED("gain.derivative_reference_weight", "", derivative_reference_weight, 0.0F, 0.0F, 1.0F, NULL,
          "Set-point weight c of the derivative part"),
    PAGED("gain.derivative_filter", "s", derivative_filter, 0.0F, 0.0F, 10.0F, NULL,
          "Time constant of the derivative's filter"),
#endif
#if HB_LAW_SECTIONS > 0
    SECTION(1, "filter.1.b0", "filter.1.b1", "filter.1.b2", "filter.1.a1", "filter.1.a2"),
    SECTION(2, "filter.2.b0", "filter.2.b1", "filter.2.b2", "filter.2.a1", "filter.2.a2"),
    SECTION(3, "filter.3.b0", "filter.3.b1", "filter.3.b2", "filter.3.a1", "filter.3.a2"),
    SECTION(4, "filter.4.b0", "filter.4.b1", "filter.4.b2", "filter.4.a1", "filter.4.a2"),
#endif
    PAGED("feedforward.inertia", "A*s^2/rad", ff_inertia, 0.0F, 0.0F, 10.0F, NULL, "J/phi"),
    PAGED("feedforward.viscous", "A*s/rad", ff_viscous, 0.0F, 0.0F, 10.0F, NULL, "c/phi"),
    PAGED("feedforward.coulomb", "A", ff_coulomb, 0.0F, 0.0F, 4.0F, NULL,
          "0.9 K_f/phi, with the reference speed"),
    PAGED("feedforward.coulomb_speed", "rad/s", ff_coulomb_speed, 0.02F, 0.001F, 10.0F, NULL,
          "Reference speed of full Coulomb feed-forward"),
    PAGED("stiction.current", "A", stiction_current, 0.0F, 0.0F, 4.0F, NULL,
          "Friction help at rest, 0.9 K_f/phi"),
    PAGED("stiction.threshold", "rad", stiction_threshold, 2.7925268e-3F, 0.0F, 1.0F, NULL,
          "Error above which the friction help acts (0.16 degrees)"),
    PAGED("stiction.speed", "rad/s", stiction_speed, 0.02F, 0.0F, 10.0F, NULL,
          "Reference speed below which the friction help acts"),
    PAGED("control.law", "", law, 0.0F, 0.0F, 2.0F, LawChoices, "Form of the control law"),
    PAGED("limit.current", "A", limit_current, 4.0F, 0.0F, 4.0F, NULL, "Largest current amplitude"),
    PAGED("limit.temperature", "degC", limit_temperature, 80.0F, -40.0F, 80.0F, NULL,
          "Coil temperature that trips"),
    PAGED("window.position", "rad", window_position, 6.2831853F, 0.0F, 10000.0F, NULL,
          "Largest excursion from the position at arming"),
    PAGED("window.position_enabled", "", window_position_enabled, 0.0F, 0.0F, 1.0F, OffOn, "Position window"),
    PAGED("window.speed", "rad/s", window_speed, 40.0F, 0.0F, 1000.0F, NULL, "Largest speed while armed"),
    PAGED("window.speed_enabled", "", window_speed_enabled, 1.0F, 0.0F, 1.0F, OffOn, "Speed window"),
    PAGED("stray.enabled", "", stray_enabled, 1.0F, 0.0F, 1.0F, OffOn,
          "Subtract the field of the phase currents"),
    PAGED("stray.coefficient", "T/A", stray_coefficient, 2.5e-3F, -0.05F, 0.05F, NULL,
          "Field of a phase current at its own sensor"),
    PAGED("decode.method", "", decode_method, 0.0F, 0.0F, 1.0F, DecodeChoices, "Angle from the two fields"),
    PAGED("delay.samples", "", delay_samples, 0.0F, 0.0F, 2.0F, DelayChoices,
          "Delay of the position loop in its samples"),
    PAGED("commutation.divider", "", commutation_divider, 1.0F, 1.0F, 100.0F, NULL,
          "Commutate every n-th millisecond"),
    PAGED("commutation.advance", "s", commutation_advance, 0.0F, -0.01F, 0.01F, NULL,
          "Commutation angle ahead by speed times this"),
    PAGED("hall.offset_a", "T", hall_offset_a, 0.0F, -0.05F, 0.05F, NULL, "Offset of channel A"),
    PAGED("hall.offset_b", "T", hall_offset_b, 0.0F, -0.05F, 0.05F, NULL, "Offset of channel B"),
    PAGED("hall.gain_ratio", "", hall_gain_ratio, 1.0F, 0.5F, 2.0F, NULL,
          "Amplitude of channel B over channel A"),
    PAGED("hall.quadrature", "rad", hall_quadrature, 0.0F, -0.5F, 0.5F, NULL,
          "Channel B sees sin(angle + quadrature)"),
    PAGED("hall.amplitude", "T", hall_amplitude, 0.157F, 0.01F, 0.2F, NULL, "Field amplitude at the sensors"),
#if HB_FEATURE_ERROR_MAP
    PAGED("errormap.enabled", "", errormap_enabled, 0.0F, 0.0F, 1.0F, OffOn, "Angle error map"),
    MAP(1),
    MAP(2),
    MAP(3),
    MAP(4),
    MAP(5),
    MAP(6),
#endif
    HB_SET_LAST(hb_htm_calibration, set_last),

    HB_BOARD_ARM(hb_htm_live, board, ModeChoices, 3.0F),
    LIVE("hb.setpoint", "", HB_FLOAT32, setpoint, 0.0F, -10000.0F, 10000.0F, NULL,
         "A, or rad from the position at arming"),
    HB_BOARD_WATCHDOG(hb_htm_live, board),
    LIVE("reference.shape", "", HB_UBYTE, reference.shape, 0.0F, 0.0F, HB_SHAPE_COUNT - 1.0F, ShapeChoices,
         "Shape of the reference"),
    LIVE("reference.amplitude", "", HB_FLOAT32, reference.amplitude, 0.0F, -10000.0F, 10000.0F, NULL,
         "rad or A; height of one step of the staircase, end of the ramp"),
    LIVE("reference.rate", "", HB_FLOAT32, reference.rate, 0.0F, -1000.0F, 1000.0F, NULL,
         "Slope of the ramp, rad/s or A/s"),
    LIVE("reference.frequency", "Hz", HB_FLOAT32, reference.frequency_Hz, 1.0F, 0.0F, 200.0F, NULL,
         "Frequency of sine; first of chirp and multisine"),
#if HB_FEATURE_GENERATOR
    LIVE("reference.frequency_end", "Hz", HB_FLOAT32, reference.frequency_end_Hz, 10.0F, 0.0F, 200.0F, NULL,
         "Last frequency of chirp and multisine"),
#endif
    LIVE("reference.period", "s", HB_FLOAT32, reference.period_s, 1.0F, 0.001F, 3600.0F, NULL,
         "Time of one step of the staircase"),
    LIVE("reference.count", "", HB_UWORD, reference.count, 10.0F, 1.0F, 1000.0F, NULL,
         "Steps of the staircase, lines of the multisine"),
    LIVE("reference.duration", "s", HB_FLOAT32, reference.duration_s, 10.0F, 0.001F, 100000.0F, NULL,
         "Time until the generator ends"),
    LIVE("reference.base", "", HB_FLOAT32, reference.base, 0.0F, -1000.0F, 1000.0F, NULL,
         "Constant motion added: rad/s in mode position, else A"),
#if HB_FEATURE_GENERATOR
    LIVE("reference.seed", "", HB_ULONG, reference.seed, 0.0F, 0.0F, HB_LARGEST_ULONG, NULL,
         "Phases of the multisine; 0 = Schroeder"),
#endif
    HB_BOARD_START(hb_htm_live, board),
    LIVE("plateau.count", "", HB_UWORD, plateaus.count, 1.0F, 1.0F, HB_PLATEAUS, NULL, "Number of plateaus"),
    LIVE("plateau.dwell", "s", HB_FLOAT32, plateaus.dwell_s, 1.0F, 0.001F, 3600.0F, NULL,
         "Time of one plateau"),
    HB_PARAM_LIST(HB_LIVE, "plateau.current", "A", HB_FLOAT32, hb_htm_live, plateaus.current_A, HB_PLATEAUS,
                  0.0F, -4.0F, 4.0F, "Current of one plateau"),
#if HB_FEATURE_CAPTURE
    HB_BOARD_CAPTURE(hb_htm_live, capture),
#endif
};

static const hb_event Events[] HB_ROM = {{"fast", HB_TICK_MS, 6}, {"position", 10, 6}};

const HB_FLASH hb_actuator hb_htm_actuator = {
    .model = "htm",
    .signals = Signals,
    .parameters = Parameters,
    .events = Events,
    .signal_count = sizeof Signals / sizeof Signals[0],
    .parameter_count = sizeof Parameters / sizeof Parameters[0],
    .faults = FaultChoices,
    .page_octets = sizeof(hb_htm_calibration),
    .live_octets = sizeof(hb_htm_live),
    .live_offset = offsetof(hb_htm_live, board),
    .signal_offset = offsetof(hb_htm_signals, board),
    .output_offset = offsetof(hb_htm_signals, current_A),
#if HB_FEATURE_CAPTURE
    .capture_offset = offsetof(hb_htm_live, capture),
#endif
    .output_count = 2,
    .event_count = HB_HTM_EVENT_COUNT,
    .loop_ticks = HB_HTM_LOOP_TICKS,
    .axis_count = 1,
    .sense = hb_htm_sense,
    .supervise = hb_htm_supervise,
    .control = hb_htm_control,
    .drive = hb_htm_drive,
    .enter_mode = hb_htm_enter_mode,
    .check = hb_htm_check,
    .stop_reference = hb_htm_stop_reference,
    .advance = hb_htm_advance,
};
