/* SPDX-License-Identifier: MIT */
#include "devices/firmware/xcp/hb_crc.h"
#include "devices/firmware/xcp/hb_xcp_internal.h"

#include <string.h>

/* The commands that move octets between the master and the memory at the MTA. */

enum { CHECKSUM_CRC16_CCITT = 8 };

uint8_t hb_cmd_set_mta(hb_xcp* slave, const uint8_t* packet, uint16_t length) {
    (void)length;
    slave->mta_extension = packet[3];
    slave->mta_address = hb_get32(&packet[4]);
    return HB_OK;
}

/* One response with the next octets at the MTA. */
static uint8_t uploadPart(hb_xcp* slave, uint8_t count) {
    uint8_t result =
        hb_memory_read(slave, slave->mta_extension, slave->mta_address, &slave->response[1], count);
    if (result == HB_OK) {
        slave->mta_address += count;
        slave->response[0] = 0xFF;
        slave->response_length = (uint16_t)(count + 1);
    }
    return result;
}

uint8_t hb_cmd_upload(hb_xcp* slave, const uint8_t* packet, uint16_t length) {
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

void hb_memory_continue_block(hb_xcp* slave) {
    while (slave->block_left > 0 && hb_queue_free(&slave->queue) >= HB_MAX_CTO + HB_PACKET_OVERHEAD) {
        uint8_t part = slave->block_left < HB_MAX_CTO - 1 ? slave->block_left : HB_MAX_CTO - 1;
        if (uploadPart(slave, part) != HB_OK) {
            uint8_t error[2];
            error[0] = 0xFE;
            error[1] = HB_ERR_OUT_OF_RANGE;
            slave->block_left = 0;
            hb_xcp_send(slave, error, 2);
            return;
        }
        slave->block_left = (uint8_t)(slave->block_left - part);
        hb_xcp_send(slave, slave->response, slave->response_length);
    }
}

uint8_t hb_cmd_short_upload(hb_xcp* slave, const uint8_t* packet, uint16_t length) {
    if (packet[1] == 0 || packet[1] > HB_MAX_CTO - 1) {
        return HB_ERR_OUT_OF_RANGE;
    }
    hb_cmd_set_mta(slave, packet, length);
    return uploadPart(slave, packet[1]);
}

uint8_t hb_cmd_build_checksum(hb_xcp* slave, const uint8_t* packet, uint16_t length) {
    uint32_t left = hb_get32(&packet[4]);
    uint16_t crc = HB_CRC_START;
    (void)length;
    if (left == 0 || left > 0x10000UL) {
        return HB_ERR_OUT_OF_RANGE;
    }
    while (left > 0) {
        uint8_t octets[16];
        uint8_t part = left < sizeof octets ? (uint8_t)left : (uint8_t)sizeof octets;
        uint8_t result = hb_memory_read(slave, slave->mta_extension, slave->mta_address, octets, part);
        if (result != HB_OK) {
            return result;
        }
        crc = hb_crc16(crc, octets, part);
        slave->mta_address += part;
        left -= part;
    }
    memset(&slave->response[1], 0, 7);
    slave->response[1] = CHECKSUM_CRC16_CCITT;
    hb_put16(&slave->response[4], crc);
    slave->response_length = 8;
    return HB_OK;
}

/* Takes `count` octets at the MTA, which moves behind them. */
static uint8_t downloadPart(hb_xcp* slave, const uint8_t* source, uint8_t count) {
    uint8_t result = hb_memory_write(slave, slave->mta_extension, slave->mta_address, source, count);
    if (result == HB_OK) {
        slave->mta_address += count;
    }
    return result;
}

uint8_t hb_cmd_download(hb_xcp* slave, const uint8_t* packet, uint16_t length) {
    if (packet[1] == 0 || packet[1] > HB_MAX_CTO - 2) {
        return HB_ERR_OUT_OF_RANGE;
    }
    if (length < packet[1] + 2U) {
        return HB_ERR_CMD_SYNTAX;
    }
    return downloadPart(slave, &packet[2], packet[1]);
}

uint8_t hb_cmd_short_download(hb_xcp* slave, const uint8_t* packet, uint16_t length) {
    if (packet[1] == 0 || packet[1] > HB_MAX_CTO - 8) {
        return HB_ERR_OUT_OF_RANGE;
    }
    if (length < packet[1] + 8U) {
        return HB_ERR_CMD_SYNTAX;
    }
    hb_cmd_set_mta(slave, packet, length);
    return downloadPart(slave, &packet[8], packet[1]);
}
