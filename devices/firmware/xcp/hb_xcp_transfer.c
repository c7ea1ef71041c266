/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_crc.h"
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

/* The commands that move octets between the master and the memory at the MTA. */

enum { CHECKSUM_CRC16_CCITT = 8, SUM_PART = 16, SUM_ANSWER = 8 };
enum { LONG_HEADER = 2, SHORT_HEADER = 8 };
#if HB_FEATURE_FULL
#define LONGEST_CHECKSUM 0x10000UL
#else
#define LONGEST_CHECKSUM 0xFFFFUL
#endif

uint8_t hb_cmd_set_mta(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    (void)length;
    hb_memory_set_mta(slave, packet[3], &packet[4]);
    return HB_OK;
}

/* One response with the next octets at the MTA. */
static uint8_t uploadPart(hb_xcp* slave, uint8_t count) {
    slave->response[0] = 0xFF;
    slave->response_length = (uint8_t)(count + 1U);
    return hb_memory_read(slave, &slave->response[1], count);
}

uint8_t hb_cmd_upload(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    uint8_t part = packet[1] < HB_MAX_CTO - 1 ? packet[1] : HB_MAX_CTO - 1;
    uint8_t result;
    (void)length;
    if (packet[1] == 0) {
        return HB_ERR_OUT_OF_RANGE;
    }
    slave->block_left = 0;
    result = uploadPart(slave, part);
    if (result == HB_OK) {
        slave->block_left = (uint8_t)(packet[1] - part);
    }
    return result;
}

static void continueBlock(hb_xcp* slave) {
    if (hb_queue_free(&slave->queue) >= HB_MAX_CTO + HB_PACKET_OVERHEAD) {
        uint8_t part = slave->block_left < HB_MAX_CTO - 1 ? slave->block_left : HB_MAX_CTO - 1;
        uint8_t result = uploadPart(slave, part);
        slave->block_left = result == HB_OK ? (uint8_t)(slave->block_left - part) : 0U;
        hb_xcp_answer(slave, result);
    }
}

static void continueChecksum(hb_xcp* slave) {
    uint8_t octets[SUM_PART];
    uint8_t part = slave->sum_left < SUM_PART ? (uint8_t)slave->sum_left : (uint8_t)SUM_PART;
    uint8_t result = hb_memory_read(slave, octets, part);
    slave->sum = hb_crc16(slave->sum, octets, part);
    slave->sum_left = result == HB_OK ? (hb_address)(slave->sum_left - part) : 0U;
    if (slave->sum_left == 0) {
        memset(slave->response, 0, SUM_ANSWER);
        slave->response[0] = 0xFF;
        slave->response[1] = CHECKSUM_CRC16_CCITT;
        hb_put16(&slave->response[4], slave->sum);
        slave->response_length = SUM_ANSWER;
        hb_xcp_answer(slave, result);
    }
}

void hb_memory_continue(hb_xcp* slave) {
    if (slave->block_left > 0) {
        continueBlock(slave);
    }
    if (slave->sum_left > 0) {
        continueChecksum(slave);
    }
#if HB_FEATURE_FULL
    while (slave->sum_left > 0) {
        continueChecksum(slave);
    }
#endif
}

uint8_t hb_cmd_short_upload(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    if (packet[1] == 0 || packet[1] > HB_MAX_CTO - 1) {
        return HB_ERR_OUT_OF_RANGE;
    }
    hb_cmd_set_mta(slave, packet, length);
    return uploadPart(slave, packet[1]);
}

uint8_t hb_cmd_build_checksum(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    uint32_t octets = hb_get32(&packet[4]);
    (void)length;
    if (octets == 0 || octets > LONGEST_CHECKSUM) {
        return HB_ERR_OUT_OF_RANGE;
    }
    slave->sum = HB_CRC_START;
    slave->sum_left = (hb_address)octets;
    slave->response_length = 0; /* the answer comes when all is read */
    return HB_OK;
}

/* Both downloads: `count` octets behind a header of so many. */
static uint8_t download(hb_xcp* slave, const uint8_t* packet, hb_length length, uint8_t header) {
    if (packet[1] == 0 || packet[1] > HB_MAX_CTO - header) {
        return HB_ERR_OUT_OF_RANGE;
    }
    if (length < packet[1] + header) {
        return HB_ERR_CMD_SYNTAX;
    }
    if (header == SHORT_HEADER) {
        hb_cmd_set_mta(slave, packet, length);
    }
    return hb_memory_write(slave, &packet[header], packet[1]);
}

uint8_t hb_cmd_download(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    return download(slave, packet, length, LONG_HEADER);
}

uint8_t hb_cmd_short_download(hb_xcp* slave, const uint8_t* packet, hb_length length) {
    return download(slave, packet, length, SHORT_HEADER);
}
