/* SPDX-License-Identifier: MIT */
#include "devices/firmware/planar/hb_planar_path.h"

#include "devices/firmware/control/hb_constants.h"

#include <math.h>
#include <string.h>

static float least(float a, float b) {
    return a < b ? a : b;
}

/* Along the circle, so that the vectors keep the limits of the path. */
static hb_profile_limits circleLimits(const hb_path_config* config) {
    const float half_root = 0.70710678F; /* 1/sqrt(2) */
    float radius = fabsf(config->radius);
    hb_profile_limits limits;
    limits.acceleration = half_root * config->acceleration;
    limits.speed = least(config->speed, sqrtf(limits.acceleration * radius));
    limits.jerk = INFINITY;
    if (config->is_s_curve) {
        limits.jerk = 0.5F * config->jerk;
        limits.speed = least(limits.speed, cbrtf(0.25F * config->jerk * radius * radius));
        limits.acceleration = least(limits.acceleration, config->jerk * radius / (6.0F * limits.speed));
    }
    return limits;
}

static hb_profile_limits lineLimits(const hb_path_config* config) {
    hb_profile_limits limits;
    limits.speed = config->speed;
    limits.acceleration = config->acceleration;
    limits.jerk = config->is_s_curve ? config->jerk : INFINITY;
    return limits;
}

/* Lines and the steps between them take turns. */
static uint8_t isLine(uint16_t piece) {
    return piece % 2U == 0U;
}

static uint8_t isBent(const hb_path* path) {
    return path->config.shape == HB_PATH_CIRCLE || path->config.shape == HB_PATH_ARC;
}

static float pieceLength(const hb_path* path) {
    const hb_path_config* config = &path->config;
    switch (config->shape) {
    case HB_PATH_CIRCLE:
        return HB_TWO_PI * fabsf(config->radius) * (float)config->turns;
    case HB_PATH_ARC:
        /* The angle says to which side it bends. */
        return config->radius > 0.0F ? config->radius * fabsf(config->angle) : 0.0F;
    case HB_PATH_LINE:
        return config->length;
    default:
        break;
    }
    if (!isLine(path->piece)) {
        return config->pitch;
    }
    return path->piece % 4U == 0U ? config->width : -config->width;
}

static void startPiece(hb_path* path) {
    hb_profile_limits limits = isBent(path) ? circleLimits(&path->config) : lineLimits(&path->config);
    hb_profile_start(&path->profile, 0.0F, pieceLength(path), &limits);
    path->running = path->profile.running;
}

/* A circle whose centre lies in +x begins in the direction of -y. */
static void setDirection(hb_path* path) {
    if (path->config.shape == HB_PATH_CIRCLE) {
        path->along[0] = 0.0F;
        path->along[1] = path->config.radius > 0.0F ? -1.0F : 1.0F;
    } else {
        path->along[0] = cosf(path->config.heading);
        path->along[1] = sinf(path->config.heading);
    }
}

void hb_path_start(hb_path* path, const hb_path_config* config, const float from[HB_PATH_AXES]) {
    memset(path, 0, sizeof *path);
    path->config = *config;
    memcpy(path->corner, from, sizeof path->corner);
    setDirection(path);
    if (config->shape != HB_PATH_NONE) {
        startPiece(path);
    }
}

/* Turned into the direction at the start; `across` points to the left of it. */
static void turnInto(const hb_path* path, const hb_reference_point* ahead, const hb_reference_point* across,
                     hb_reference_point point[HB_PATH_AXES]) {
    const float c = path->along[0];
    const float s = path->along[1];
    point[0].value = path->corner[0] + c * ahead->value - s * across->value;
    point[0].speed = c * ahead->speed - s * across->speed;
    point[0].acceleration = c * ahead->acceleration - s * across->acceleration;
    point[1].value = path->corner[1] + s * ahead->value + c * across->value;
    point[1].speed = s * ahead->speed + c * across->speed;
    point[1].acceleration = s * ahead->acceleration + c * across->acceleration;
}

static void bentPoint(const hb_path* path, const hb_reference_point* along,
                      hb_reference_point point[HB_PATH_AXES]) {
    float radius = fabsf(path->config.radius);
    float side = path->config.shape == HB_PATH_ARC && path->config.angle < 0.0F ? -radius : radius;
    float per_m = 1.0F / radius;
    float c = cosf(along->value * per_m);
    float s = sinf(along->value * per_m);
    float rate = along->speed * per_m;
    float change = along->acceleration * per_m;
    hb_reference_point ahead;
    hb_reference_point across;
    ahead.value = radius * s;
    ahead.speed = radius * c * rate;
    ahead.acceleration = radius * (c * change - s * rate * rate);
    across.value = side * (1.0F - c);
    across.speed = side * s * rate;
    across.acceleration = side * (c * rate * rate + s * change);
    turnInto(path, &ahead, &across, point);
}

void hb_path_point(const hb_path* path, hb_reference_point point[HB_PATH_AXES]) {
    hb_reference_point along = hb_profile_point(&path->profile);
    memset(point, 0, HB_PATH_AXES * sizeof *point);
    if (isBent(path) && path->profile.distance > 0.0F) {
        bentPoint(path, &along, point);
        return;
    }
    point[0].value = path->corner[0];
    point[1].value = path->corner[1];
    if (path->config.shape == HB_PATH_LINE) {
        const hb_reference_point across = {0.0F, 0.0F, 0.0F};
        turnInto(path, &along, &across, point);
    } else if (path->config.shape == HB_PATH_RASTER) {
        uint8_t axis = (uint8_t)(path->piece % 2U); /* lines along x */
        along.value += path->corner[axis];
        point[axis] = along;
    }
}

void hb_path_advance(hb_path* path) {
    if (!path->running) {
        return;
    }
    hb_profile_advance(&path->profile);
    if (path->profile.running) {
        return;
    }
    if (path->config.shape == HB_PATH_RASTER && path->piece + 2U < 2U * path->config.lines) {
        path->corner[isLine(path->piece) ? 0 : 1] += path->profile.distance;
        path->piece = (uint16_t)(path->piece + 1U);
        startPiece(path);
    } else {
        path->running = 0;
    }
}
