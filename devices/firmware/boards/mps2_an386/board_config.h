/* SPDX-License-Identifier: MIT */
#ifndef HB_BOARD_MPS2_AN386_CONFIG_H
#define HB_BOARD_MPS2_AN386_CONFIG_H

/* The full library on a Cortex-M4F with an HB-SxI line. build.sh names the actuator (HB_ACTUATOR). */
#define HB_SXI_BAUD 115200
#define HB_FEATURE_FUSED_TRIG 1
#define HB_PIECES 192 /* of a table of poses: 10 kB */

#endif
