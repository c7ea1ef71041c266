/* SPDX-License-Identifier: MIT */
#ifndef HB_PLANAR_PIECES_H
#define HB_PLANAR_PIECES_H

/* A motion of all axes in pieces that the master wrote before it starts: each lasts a while, in which every
 * axis follows a cubic polynomial of the time t since the piece began,
 *
 *   value + speed t + acceleration t^2/2 + jerk t^3/6
 *
 * so that splines, trapezoids and S-curves are followed exactly. Values count from where the axis was when
 * the motion began. The board holds the whole motion: nothing of it depends on the line while it runs. */

#include "devices/firmware/control/hb_reference.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef HB_PIECES
#define HB_PIECES 512 /* 52 octets each */
#endif

enum { HB_PIECE_AXES = 3 };

typedef struct {
    float value, speed, acceleration, jerk;
} hb_piece_start;

typedef struct {
    float duration_s;
    hb_piece_start axis[HB_PIECE_AXES];
} hb_piece;

typedef struct {
    hb_piece list[HB_PIECES];
    float from[HB_PIECE_AXES]; /* where the motion began */
    float late_s;              /* of the present piece, when its first tick came */
    uint32_t ticks;            /* since then */
    uint16_t stored;           /* pieces since piece 1 was stored, in their order */
    uint16_t count;            /* pieces of this motion */
    uint16_t piece;            /* 0, 1, ... */
    uint8_t running;
} hb_pieces;

/* Piece `number` from 1; another number is ignored. Piece 1 begins a new motion, each other one follows the
 * last or replaces it. Not while they run: that would change a motion under way. */
void hb_pieces_store(hb_pieces* pieces, uint16_t number, const hb_piece* piece);
/* t = 0 is the next hb_pieces_point(). It does not run unless `count` is the number of pieces that were
 * stored, so that no piece of another motion is among them, and the first begins where the axes are. */
void hb_pieces_start(hb_pieces* pieces, uint16_t count, const float from[HB_PIECE_AXES]);
/* All axes at the present tick; at rest in the end where it ended. */
void hb_pieces_point(const hb_pieces* pieces, hb_reference_point point[HB_PIECE_AXES]);
/* One tick passes; goes to the next piece and ends the motion, also where the next piece begins elsewhere. */
void hb_pieces_advance(hb_pieces* pieces);

#ifdef __cplusplus
}
#endif

#endif
