#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# The phase diagram of an exported campaign, averaged anew from its time series: phase_diagram.py FILE [WINDOW_S]
import sqlite3
import sys

database = sqlite3.connect(f"file:{sys.argv[1]}?mode=ro", uri=True)
print("  lambda  class      d_mean_um  0 um                1 um")
for ordinal, cell, contrast, shape, end_s, window_s in database.execute(
        "SELECT ordinal, cell, lambda, class, time_s, window_s FROM v_phase WHERE d_mean_um NOT NULL ORDER BY lambda"):
    begin_s = end_s - float(sys.argv[2] if len(sys.argv) > 2 else window_s) + 1e-9  # the window's first edge is out
    average = "SELECT avg(d_um) FROM v_samples WHERE ordinal = ? AND cell = ? AND time_s > ?"
    d_um = database.execute(average, (ordinal, cell, begin_s)).fetchone()[0]
    print(f"{contrast:8g}  {shape:9} {d_um:10.6f}  |{' ' * round(20 * d_um)}{shape[0]}")
