/* SPDX-License-Identifier: MIT */
#ifndef HB_A2L_TEXTS_H
#define HB_A2L_TEXTS_H

#include "devices/firmware/xcp/hb_config.h"
#include "devices/firmware/xcp/hb_sxi.h"

/* What the items of the A2L say (resources/help/protocol.md 3.7, 3.13). Only hb_a2l.c includes this. In a
 * template an octet below ' ' (but '\n') stands for a field of the item, one from 0x80 on for an entry of
 * Dictionary: one interpreter instead of a function for each item keeps a small board's description small. */

enum { FIRST_TEXT = ' ', FIRST_WORD = 0x80 };

#define MODEL "\001"
#define EPK "\002"
#define PAGE_OCTETS "\003"
#define MAX_DTO "\004"
#define EVENT_COUNT "\005"
#define EVENTS "\006"
#define EVENT_LIST "\007"
#define TRANSPORT "\010"
#define LAYOUTS "\011"
#define INDEX "\013"
#define EVENT_NAME "\014"
#define CYCLE "\015"
#define TIME_UNIT "\016"
#define NAME "\017"
#define UNIT "\020"
#define DESCRIPTION "\021"
#define TYPE "\022"
#define SCALE "\023"
#define LOWER "\024"
#define UPPER "\025"
#define ADDRESS "\026"
#define CHOICES "\027"
#define CONVERSION "\030"
#define UNIT_LINE "\031"
#define KIND "\032"
#define COLUMNS "\033"
#define ROWS "\034"
#define BLOCK_LINES "\035"
/* The same, in the same order. */
enum {
    FIELD_MODEL = 1,
    FIELD_EPK,
    FIELD_PAGE_OCTETS,
    FIELD_MAX_DTO,
    FIELD_EVENT_COUNT,
    FIELD_EVENTS,
    FIELD_EVENT_LIST,
    FIELD_TRANSPORT,
    FIELD_LAYOUTS,
    FIELD_INDEX = 11,
    FIELD_EVENT_NAME,
    FIELD_CYCLE,
    FIELD_TIME_UNIT,
    FIELD_NAME,
    FIELD_UNIT,
    FIELD_DESCRIPTION,
    FIELD_TYPE,
    FIELD_SCALE,
    FIELD_LOWER,
    FIELD_UPPER,
    FIELD_ADDRESS,
    FIELD_CHOICES,
    FIELD_CONVERSION,
    FIELD_UNIT_LINE,
    FIELD_KIND,
    FIELD_COLUMNS,
    FIELD_ROWS,
    FIELD_BLOCK_LINES
};

/* What comes often, oftenest first. */
#define BEGIN "\200"
#define END "\201"
#define XCP_DATA "\202"
#define EMPTY "\203"
#define LIMITS "\204"
#define METHOD "\205"
#define METHOD_END "\206"
#define ACCESS "\207"
#define DUPLEX "\210"
/* clang-format off */
static hb_rom_char Dictionary[] =
    "/begin \0"
    "/end \0"
    "IF_DATA XCP\0"
    " \"\"\0"
    LOWER " " UPPER "\n\0"
    BEGIN "COMPU_METHOD CM." NAME EMPTY " \0"
    " " END "COMPU_METHOD\n\0"
    "_ACCESS_DONT_CARE \0"
    "ASYNCH_FULL_DUPLEX_MODE ";

static hb_rom_char Types[] =
    "UBYTE\0" "SBYTE\0" "UWORD\0" "SWORD\0" "ULONG\0" "SLONG\0" "FLOAT32_IEEE\0" "FLOAT64_IEEE";

/* Settings are plain numbers. */
#define DIGITS(setting) DIGITS_OF(setting)
#define DIGITS_OF(setting) #setting
#define PAGE_ACCESS " ECU" ACCESS "XCP_READ" ACCESS "XCP_WRITE" ACCESS END "PAGE\n"

static hb_rom_char Head[] =
    "ASAP2_VERSION 1 61\n"
    BEGIN "PROJECT " MODEL EMPTY "\n"
    BEGIN "MODULE " MODEL EMPTY "\n"
    BEGIN "MOD_COMMON" EMPTY "\nBYTE_ORDER MSB_LAST\n" END "MOD_COMMON\n"
    BEGIN "MOD_PAR" EMPTY "\nEPK \"" EPK "\"\n"
    BEGIN "MEMORY_SEGMENT Calibration" EMPTY " DATA RAM INTERN 0x10000 0x" PAGE_OCTETS " -1 -1 -1 -1 -1\n"
    BEGIN XCP_DATA "\n"
    BEGIN "SEGMENT 0 2 0 0 0\n"
    BEGIN "PAGE 0" PAGE_ACCESS
    BEGIN "PAGE 1" PAGE_ACCESS
    END "SEGMENT\n"
    END "IF_DATA\n"
    END "MEMORY_SEGMENT\n"
    END "MOD_PAR\n";

static hb_rom_char Interface[] =
    BEGIN XCP_DATA "\n"
    BEGIN "PROTOCOL_LAYER 0x0100 1000 200 0 0 0 0 0 " DIGITS(HB_MAX_CTO) " " MAX_DTO
    " BYTE_ORDER_MSB_LAST ADDRESS_GRANULARITY_BYTE\n" END "PROTOCOL_LAYER\n"
    BEGIN "DAQ DYNAMIC " DIGITS(HB_DAQ_LISTS) " " EVENT_COUNT
    " 0 OPTIMISATION_TYPE_DEFAULT ADDRESS_EXTENSION_FREE IDENTIFICATION_FIELD_TYPE_ABSOLUTE "
    "GRANULARITY_ODT_ENTRY_SIZE_DAQ_BYTE 8 OVERLOAD_INDICATION_EVENT\n"
    BEGIN "TIMESTAMP_SUPPORTED 1 SIZE_DWORD UNIT_1US " END "TIMESTAMP_SUPPORTED\n";

static hb_rom_char InterfaceEnd[] = EVENTS END "DAQ\n" TRANSPORT END "IF_DATA\n" LAYOUTS;

static hb_rom_char Event[] =
    BEGIN "EVENT \"" EVENT_NAME "\" \"" EVENT_NAME "\" " INDEX " DAQ " DIGITS(HB_DAQ_LISTS)
    " " CYCLE " " TIME_UNIT " 0 " END "EVENT\n";

static hb_rom_char EventNumber[] = " EVENT " INDEX;

#if HB_SXI_FRAMED
#define SXI_FRAMING BEGIN "FRAMING 0x9A 0x9B " END "FRAMING "
#else
#define SXI_FRAMING
#endif
#ifdef HB_SXI_BAUD /* the profile of hb_sxi.h */
static hb_rom_char Transport[] =
    BEGIN "XCP_ON_SxI 0x0100 " DIGITS(HB_SXI_BAUD) " "
    BEGIN DUPLEX "PARITY_NONE ONE_STOP_BIT "
    SXI_FRAMING
    END DUPLEX "HEADER_LEN_CTR_BYTE CHECKSUM_WORD "
    END "XCP_ON_SxI\n";
#else
static hb_rom_char Transport[] = HB_A2L_TRANSPORT;
#endif

static hb_rom_char Layout[] =
    BEGIN "RECORD_LAYOUT RL." TYPE " FNC_VALUES 1 " TYPE " ROW_DIR DIRECT " END "RECORD_LAYOUT\n";

static hb_rom_char VerbalMethod[] =
    BEGIN "COMPU_VTAB VT." NAME EMPTY " TAB_VERB " CHOICES " " END "COMPU_VTAB\n"
    METHOD "TAB_VERB \"%.0f\" \"" UNIT "\" COMPU_TAB_REF VT." NAME METHOD_END;

static hb_rom_char LinearMethod[] =
    METHOD "LINEAR \"%.6g\" \"" UNIT "\" COEFFS_LINEAR " SCALE " 0" METHOD_END;

static hb_rom_char NamedMethod[] = " CM." NAME;
static hb_rom_char NoMethod[] = " NO_COMPU_METHOD";
static hb_rom_char PhysicalUnit[] = "PHYS_UNIT \"" UNIT "\"\n";
static hb_rom_char LargestUlong[] = "4294967295";

static hb_rom_char Measurement[] =
    BEGIN "MEASUREMENT " NAME " \"" DESCRIPTION "\" " TYPE CONVERSION " 0 0 " LIMITS
    "ECU_ADDRESS 0x" ADDRESS "\n" UNIT_LINE
    BEGIN XCP_DATA " " BEGIN "DAQ_EVENT VARIABLE " BEGIN "AVAILABLE_EVENT_LIST" EVENT_LIST
    " " END "AVAILABLE_EVENT_LIST " END "DAQ_EVENT " END "IF_DATA\n"
    END "MEASUREMENT\n";

#if HB_FEATURE_CAPTURE
#define VALUE_KIND "VAL" KIND
static hb_rom_char ValueKind[] = "UE";
static hb_rom_char BlockKind[] = "_BLK";
static hb_rom_char Block[] = "ECU_ADDRESS_EXTENSION 2\nREAD_ONLY\nMATRIX_DIM " COLUMNS " " ROWS " 1\n";
#else
#define VALUE_KIND "VALUE"
#endif

static hb_rom_char Value[] =
    BEGIN "CHARACTERISTIC " NAME " \"" DESCRIPTION "\" " VALUE_KIND " 0x" ADDRESS " RL." TYPE
    " 0" CONVERSION " " LIMITS UNIT_LINE BLOCK_LINES
    END "CHARACTERISTIC\n";

static hb_rom_char Tail[] = END "MODULE\n" END "PROJECT\n";
/* clang-format on */

#endif
