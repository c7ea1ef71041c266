"""Renders the independent board's tables as A2L (protocol.md 3.13)."""
from board import SEGMENT_BASE, WORDS

TYPES_IN_ORDER = ["UBYTE", "SBYTE", "UWORD", "ULONG", "FLOAT32_IEEE"]


def render(board, variant):
    parts = ["ASAP2_VERSION 1 61\n/begin PROJECT peer \"independent slave\"\n/begin MODULE peer \"\"\n",
             f"/begin MOD_COMMON \"\" BYTE_ORDER {'MSB_LAST' if variant.byte_order == '<' else 'MSB_FIRST'} "
             "/end MOD_COMMON\n",
             mod_par(board, variant)]
    parts += [f"/begin RECORD_LAYOUT L_{t} FNC_VALUES 1 {t} ROW_DIR DIRECT /end RECORD_LAYOUT\n"
              for t in TYPES_IN_ORDER]
    parts += [measurement(signal) for signal in board.signals]
    parts += [characteristic(p) for p in board.pages[0].parameters + board.live.parameters]
    parts += [conversions(board), interface(variant), "/end MODULE\n/end PROJECT\n"]
    return "".join(parts)


def mod_par(board, variant):
    if variant.pages == "none":
        return "/begin MOD_PAR \"\" EPK \"peer 1\" /end MOD_PAR\n"
    write = "XCP_WRITE_ACCESS_WITH_ECU_DONT_CARE"
    second = "XCP_WRITE_ACCESS_NOT_ALLOWED" if variant.pages == "readonly" else write
    pages = "".join(f"/begin PAGE {n} ECU_ACCESS_DONT_CARE XCP_READ_ACCESS_DONT_CARE {w} /end PAGE\n"
                    for n, w in ((0, write), (1, second)))
    return (f"/begin MOD_PAR \"\" EPK \"peer 1\" ADDR_EPK 0x0\n/begin MEMORY_SEGMENT calibration \"\" DATA RAM INTERN "
            f"0x{SEGMENT_BASE:X} {len(board.pages[0].octets)} -1 -1 -1 -1 -1\n/begin IF_DATA XCP\n"
            f"/begin SEGMENT 0 2 0 0 0\n/begin CHECKSUM XCP_CRC_16_CITT /end CHECKSUM\n{pages}"
            "/end SEGMENT\n/end IF_DATA\n/end MEMORY_SEGMENT\n/end MOD_PAR\n")


def conversion_name(thing):
    if thing.name in WORDS:
        return f"CM_{thing.name}"
    return "CM_linear" if getattr(thing, "slope", 1.0) != 1.0 else "NO_COMPU_METHOD"


def measurement(signal):
    name = signal.label or signal.name
    return (f"/begin MEASUREMENT {name} \"signal {name}\" {signal.type} {conversion_name(signal)} 0 0 "
            f"{signal.lower} {signal.upper}\n  ECU_ADDRESS 0x{signal.address:X}\n  ECU_ADDRESS_EXTENSION 0\n"
            f"  PHYS_UNIT \"{signal.unit}\"\n  /begin IF_DATA XCP /begin DAQ_EVENT VARIABLE "
            "/begin AVAILABLE_EVENT_LIST EVENT 0 EVENT 1 /end AVAILABLE_EVENT_LIST /end DAQ_EVENT /end IF_DATA\n"
            "/end MEASUREMENT\n")


def characteristic(parameter):
    kind = "VALUE" if parameter.count == 1 else "VAL_BLK"
    number = "" if parameter.count == 1 else f"  NUMBER {parameter.count}\n"
    return (f"/begin CHARACTERISTIC {parameter.name} \"parameter {parameter.name}\" {kind} 0x{parameter.address:X} "
            f"L_{parameter.type} 0 NO_COMPU_METHOD {parameter.lower} {parameter.upper}\n{number}"
            f"  PHYS_UNIT \"{parameter.unit}\"\n/end CHARACTERISTIC\n")


def conversions(board):
    text = ("/begin COMPU_METHOD CM_linear \"after its use\" LINEAR \"%8.2\" \"V\" COEFFS_LINEAR 0.01 0 "
            "/end COMPU_METHOD\n")
    for name, words in WORDS.items():
        pairs = " ".join(f'{n} "{word}"' for n, word in words.items())
        text += (f"/begin COMPU_METHOD CM_{name} \"\" TAB_VERB \"%4\" \"\" COMPU_TAB_REF VT_{name} /end COMPU_METHOD\n"
                 f"/begin COMPU_VTAB VT_{name} \"\" TAB_VERB {len(words)} {pairs} /end COMPU_VTAB\n")
    return text


def interface(variant):
    unit = {0: "1NS", 3: "1US"}[variant.time_unit]
    order = "BYTE_ORDER_MSB_LAST" if variant.byte_order == "<" else "BYTE_ORDER_MSB_FIRST"
    return (f"/begin IF_DATA XCP\n/begin PROTOCOL_LAYER 0x0100 1000 200 0 0 0 0 0 {variant.max_cto} {variant.max_dto} "
            f"{order} ADDRESS_GRANULARITY_BYTE OPTIONAL_CMD GET_ID /end PROTOCOL_LAYER\n"
            f"/begin DAQ DYNAMIC {variant.max_daq} 2 0 OPTIMISATION_TYPE_DEFAULT ADDRESS_EXTENSION_FREE "
            "IDENTIFICATION_FIELD_TYPE_RELATIVE_BYTE GRANULARITY_ODT_ENTRY_SIZE_DAQ_BYTE 8 OVERLOAD_INDICATION_EVENT\n"
            f"/begin TIMESTAMP_SUPPORTED 1 SIZE_DWORD UNIT_{unit} TIMESTAMP_FIXED /end TIMESTAMP_SUPPORTED\n"
            "/begin EVENT \"fast\" \"fast\" 0 DAQ 255 1 6 0 /end EVENT\n"
            "/begin EVENT \"slow\" \"slow\" 1 DAQ 255 10 6 0 /end EVENT\n/end DAQ\n"
            "/begin XCP_ON_TCP_IP 0x0100 5555 ADDRESS \"127.0.0.1\" /end XCP_ON_TCP_IP\n/end IF_DATA\n")
