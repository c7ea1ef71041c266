/* SPDX-License-Identifier: MIT */
#ifndef HB_PLANAR_PATH_H
#define HB_PLANAR_PATH_H

/* Paths of two axes, x and y, from rest to rest, each piece with the profile of hb_planar_profile along it.
 *
 *   circle   counter-clockwise, `turns` times; begins where the platen is, with the centre a radius away in
 *            the direction of +x (of -x for a negative radius)
 *   arc      of a positive radius through `angle`, counter-clockwise where that is positive; begins in the
 *            direction `heading`, counted from +x towards +y
 *   line     of `length` in the direction `heading`
 *   raster   `lines` lines of `width` along x, forth and back, `pitch` along y between them; rests at every
 *            corner
 *
 * The limits are those of the vectors of speed, acceleration and jerk. A circle at speed v has v^2/R across
 * its direction already: the acceleration along it may be 1/sqrt(2) of the limit, the speed sqrt(A
 * R/sqrt(2)), and with a limit J of the jerk v^3 <= J R^2/4, 3 v a <= J R/2, and the jerk along it J/2 at
 * most, which together is at most 0.91 J. */

#include "devices/firmware/planar/hb_planar_profile.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { HB_PATH_AXES = 2 };
/* The last one is no path of this file: the pieces of hb_planar_pieces.h, which move every axis. */
enum hb_path_shape { HB_PATH_NONE, HB_PATH_CIRCLE, HB_PATH_RASTER, HB_PATH_ARC, HB_PATH_LINE, HB_PATH_TABLE };

/* Part of the live parameters; start() copies it. */
typedef struct {
    float radius, width, pitch;
    float angle, heading, length;
    float speed, acceleration, jerk;
    uint16_t turns, lines;
    uint8_t shape;
    uint8_t is_s_curve; /* else the jerk has no limit */
} hb_path_config;

typedef struct {
    hb_path_config config;
    hb_profile profile;         /* along the present piece */
    float corner[HB_PATH_AXES]; /* where the present piece began */
    float along[HB_PATH_AXES];  /* direction at the start, of length one */
    uint16_t piece;             /* 0, 1, ... */
    uint8_t running;
} hb_path;

/* t = 0 is the next hb_path_point(). A path without length or with limits that are not positive does not
 * run. */
void hb_path_start(hb_path* path, const hb_path_config* config, const float from[HB_PATH_AXES]);
/* Both axes at the present tick; where it ended behind its end. */
void hb_path_point(const hb_path* path, hb_reference_point point[HB_PATH_AXES]);
/* One tick passes; goes to the next piece and ends the path. */
void hb_path_advance(hb_path* path);

#ifdef __cplusplus
}
#endif

#endif
