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

static float pieceLength(const hb_path* path) {
    if (path->config.shape == HB_PATH_CIRCLE) {
        return HB_TWO_PI * fabsf(path->config.radius) * (float)path->config.turns;
    }
    if (!isLine(path->piece)) {
        return path->config.pitch;
    }
    return path->piece % 4U == 0U ? path->config.width : -path->config.width;
}

static void startPiece(hb_path* path) {
    hb_profile_limits limits =
        path->config.shape == HB_PATH_CIRCLE ? circleLimits(&path->config) : lineLimits(&path->config);
    hb_profile_start(&path->profile, 0.0F, pieceLength(path), &limits);
    path->running = path->profile.running;
}

void hb_path_start(hb_path* path, const hb_path_config* config, const float from[HB_PATH_AXES]) {
    memset(path, 0, sizeof *path);
    path->config = *config;
    memcpy(path->corner, from, sizeof path->corner);
    if (config->shape != HB_PATH_NONE) {
        startPiece(path);
    }
}

static void circlePoint(const hb_path* path, const hb_reference_point* along,
                        hb_reference_point point[HB_PATH_AXES]) {
    float radius = path->config.radius;
    float per_m = 1.0F / fabsf(radius);
    float c = cosf(along->value * per_m);
    float s = sinf(along->value * per_m);
    float rate = along->speed * per_m;
    float change = along->acceleration * per_m;
    point[0].value = path->corner[0] + radius * (1.0F - c);
    point[0].speed = radius * s * rate;
    point[0].acceleration = radius * (c * rate * rate + s * change);
    point[1].value = path->corner[1] - radius * s;
    point[1].speed = -radius * c * rate;
    point[1].acceleration = radius * (s * rate * rate - c * change);
}

void hb_path_point(const hb_path* path, hb_reference_point point[HB_PATH_AXES]) {
    hb_reference_point along = hb_profile_point(&path->profile);
    memset(point, 0, HB_PATH_AXES * sizeof *point);
    if (path->config.shape == HB_PATH_CIRCLE && path->profile.distance > 0.0F) {
        circlePoint(path, &along, point);
        return;
    }
    point[0].value = path->corner[0];
    point[1].value = path->corner[1];
    if (path->config.shape == HB_PATH_RASTER) {
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
