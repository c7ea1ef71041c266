"""The slaves we answer as: well-behaved foreign boards, and boards that lie."""
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Variant:
    byte_order: str = "<"
    id_field: int = 0
    max_daq: int = 8            # what GET_DAQ_PROCESSOR_INFO says; 0 must not be believed
    pad: int = 1                # DTOs are filled to a multiple of this
    pages: str = "two"          # two | readonly | none
    short_download: bool = True
    time_unit: int = 3          # 3 = 1 us, 0 = 1 ns (wraps every 4.29 s)
    time_start: int = 0         # of the clock, when a measurement starts
    max_cto: int = 64
    max_dto: int = 128
    mischief: str = ""
    described: dict = field(default_factory=dict)      # signals with another label, unit or slope


FOREIGN = {
    "plain": Variant(),
    "motorola": Variant(byte_order=">"),
    "id_field_1": Variant(id_field=1),
    "id_field_2": Variant(id_field=2),
    "id_field_3": Variant(id_field=3),
    "motorola_id_field_3": Variant(byte_order=">", id_field=3),
    "max_daq_zero": Variant(max_daq=0),
    "padded": Variant(pad=4, id_field=3),
    "read_only_page": Variant(pages="readonly"),
    "no_pages": Variant(pages="none"),
    "no_short_download": Variant(short_download=False),
    "no_short_download_no_pages": Variant(short_download=False, pages="none"),
    "nanosecond_clock": Variant(time_unit=0, time_start=0xFFFFFFFF - 100_000_000),
    "microsecond_clock_wraps": Variant(time_start=0xFFFFFFFF - 100_000),
    "smallest_packets": Variant(max_cto=16, max_dto=16),
}

HOSTILE = {name: Variant(mischief=name) for name in (
    "mute", "silence", "refuses_everything", "lying_len", "zero_len", "endless_len", "short_connect", "tiny_max_cto",
    "short_answers", "wrong_answers", "event_flood", "a2l_garbage", "a2l_binary", "a2l_huge", "a2l_many_blocks",
    "a2l_deep", "a2l_empty", "wrong_checksum", "pid_out_of_range", "short_dto", "time_backwards", "time_stands",
    "hangs_up_in_stream", "no_dto")}

# Slaves that break one rule of a board of ours: they test the checks.
BROKEN = {name: Variant(mischief=name) for name in ("no_watchdog", "accepts_anything", "gaps", "switches_in_pieces")}

# Boards that keep the protocol and yet are a trap: names that meet in a column, clocks that start again.
ODD = {
    "meeting_names": Variant(described={
        "counter": {"label": "a_b"}, "wide": {"label": "a.b", "unit": ""},
        "sine": {"label": "a_b_2", "unit": ""},
        "level": {"label": "time_s", "unit": "", "slope": 1.0, "lower": -1e4, "upper": 1e4}}),
    "clock_restarts": Variant(time_start=5_000_000, mischief="clock_restarts"),
    "clock_restarts_after_a_pause": Variant(time_start=5_000_000, mischief="clock_restarts_after_a_pause"),
}

VARIANTS = FOREIGN | HOSTILE | BROKEN | ODD
