/* SPDX-License-Identifier: MIT */
#ifndef TOY_BOARD_H
#define TOY_BOARD_H

#include "devices/firmware/axes/hb_axes.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The smallest actuator of several axes: two slides x and y, one coil each, 5 N/A. Positions in m. */
extern const hb_actuator toy_actuator;

#ifdef __cplusplus
}
#endif

#endif
