// SPDX-License-Identifier: BSD-3-Clause
// From the samples of a run to its result: averages over the window, oscillation, class.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "store/rows.hpp"
#include "study/settings.hpp"

namespace rouleau::campaign {

/// The results of all cells of a point, in the order of the cells; no samples, no results. A pure function of its
/// arguments: the same samples give the same bits, whenever and in however many parts they were read.
///
/// Window. With t the time of the cell's last sample, the window holds the samples in (t - window_s, t]; the window
/// before it those in (t - 2 window_s, t - window_s]. A mean weighs samples, not time; `note` says so when they are not
/// equally spaced.
///
/// Errors. Standard errors from block averages (block_average.hpp).
///
/// Oscillation. d in the last oscillation_window_s, at most the second half of the run, at least the window.
///
/// Tank-treading (tank_treading.hpp), over the same span as the oscillation.
///
/// Class, of the mean displacement d in the window and its change c from the window before:
///     croissant   d <= croissant_d_um  and   c <= drift_um    (centred, and not on its way out)
///     slipper     d >= slipper_d_um    and  -c <= drift_um    (off-centre, and not on its way in)
///     undecided   all else: between the thresholds, still drifting, a series that does not cover both windows, or a
///     measure
///                 in them that is not finite. `phase_reason` gives the numbers.
/// For c, both windows are lengthened to whole periods when d oscillates: the phase of a wave is no drift.
/// point     goes into the rows
/// samples   in the order of (step, cell)
std::vector<ResultRow> analyse(std::string_view point, std::span<const SampleRow> samples, const Analysis& settings);

}  // namespace rouleau::campaign
