/* SPDX-License-Identifier: MIT */
#include "devices/firmware/planar/hb_planar_pieces.h"

#include <math.h>
#include <string.h>

#define TICK_S (0.001F * HB_TICK_MS)
/* Of values that meet, m or rad: pieces come in single precision. */
#define JOINT 1e-5F

/* Since the present piece began; ticks are counted, so that no rounding adds up. */
static float elapsed_s(const hb_pieces* pieces) {
    return pieces->late_s + (float)pieces->ticks * TICK_S;
}

void hb_pieces_store(hb_pieces* pieces, uint16_t number, const hb_piece* piece) {
    uint8_t follows = number == 1U || number == pieces->stored || number == pieces->stored + 1U;
    if (pieces->running || number < 1U || number > HB_PIECES) {
        return;
    }
    pieces->list[number - 1U] = *piece;
    pieces->stored = follows ? number : 0U;
}

static hb_reference_point pointOf(const hb_piece_start* start, float time_s) {
    hb_reference_point point;
    point.acceleration = start->acceleration + start->jerk * time_s;
    point.speed = start->speed + time_s * (start->acceleration + 0.5F * start->jerk * time_s);
    point.value =
        start->value +
        time_s * (start->speed + time_s * (0.5F * start->acceleration + start->jerk * time_s / 6.0F));
    return point;
}

static uint8_t joins(const hb_piece* piece, const hb_piece* next) {
    uint8_t meets = 1;
    for (uint8_t i = 0; i < HB_PIECE_AXES; i++) {
        float gap = next->axis[i].value - pointOf(&piece->axis[i], piece->duration_s).value;
        meets &= fabsf(gap) <= JOINT;
    }
    return meets;
}

static uint8_t beginsHere(const hb_piece* piece) {
    uint8_t is_here = 1;
    for (uint8_t i = 0; i < HB_PIECE_AXES; i++) {
        is_here &= fabsf(piece->axis[i].value) <= JOINT;
    }
    return is_here;
}

/* Pieces that are over at the present tick, and those without a duration. */
static void skipEnded(hb_pieces* pieces) {
    while (pieces->running && elapsed_s(pieces) >= pieces->list[pieces->piece].duration_s) {
        const hb_piece* piece = &pieces->list[pieces->piece];
        if (pieces->piece + 1U < pieces->count && joins(piece, piece + 1)) {
            pieces->late_s = elapsed_s(pieces) - pieces->list[pieces->piece].duration_s;
            pieces->ticks = 0;
            pieces->piece++;
        } else {
            pieces->running = 0;
        }
    }
}

void hb_pieces_start(hb_pieces* pieces, uint16_t count, const float from[HB_PIECE_AXES]) {
    memcpy(pieces->from, from, sizeof pieces->from);
    pieces->late_s = 0.0F;
    pieces->ticks = 0;
    pieces->piece = 0;
    pieces->count = count == pieces->stored ? count : 0;
    pieces->running = pieces->count > 0U && beginsHere(&pieces->list[0]);
    skipEnded(pieces);
}

void hb_pieces_point(const hb_pieces* pieces, hb_reference_point point[HB_PIECE_AXES]) {
    const hb_piece* piece = &pieces->list[pieces->piece];
    for (uint8_t i = 0; i < HB_PIECE_AXES; i++) {
        point[i] = pointOf(&piece->axis[i], pieces->running ? elapsed_s(pieces) : piece->duration_s);
        point[i].value += pieces->from[i];
        if (!pieces->running) {
            point[i].speed = 0.0F;
            point[i].acceleration = 0.0F;
        }
    }
}

void hb_pieces_advance(hb_pieces* pieces) {
    if (pieces->running) {
        pieces->ticks++;
        skipEnded(pieces);
    }
}
