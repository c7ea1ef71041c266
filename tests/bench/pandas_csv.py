"""Seconds of processor time that pandas takes to write and to read the table of csv_bench.cpp."""

import os
import tempfile
import time

import numpy
import pandas

ROWS = 200000
COLUMNS = 15
ROUNDS = 3


def table():
    random = numpy.random.default_rng(7)
    rows = numpy.arange(ROWS)
    frame = {"time_s": rows / 1000.0}
    for column in range(COLUMNS):
        frame[f"s{column}_A"] = numpy.sin(0.01 * rows * (column + 1)) + 0.01 * random.standard_normal(ROWS)
    return pandas.DataFrame(frame)


def least_s(work):
    times = []
    for _ in range(ROUNDS):
        before = time.process_time()
        work()
        times.append(time.process_time() - before)
    return min(times)


def main():
    frame = table()
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "table.csv")
        write_s = least_s(lambda: frame.to_csv(path, index=False))
        read_s = least_s(lambda: pandas.read_csv(path))
    print(write_s, read_s)


main()
