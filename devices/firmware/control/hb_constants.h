/* SPDX-License-Identifier: MIT */
#ifndef HB_CONSTANTS_H
#define HB_CONSTANTS_H

#define HB_PI 3.14159265F
#define HB_TWO_PI 6.28318531F
#define HB_SQRT_HALF 0.70710678F

#endif
