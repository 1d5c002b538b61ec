// SPDX-License-Identifier: BSD-3-Clause
// How often the membrane goes around the cell: from the paths of its markers.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "store/rows.hpp"

namespace rouleau::campaign {

struct TankTreading {
  std::optional<double> per_s;        ///< turns of the membrane about the cell in a second, without a sign
  std::optional<double> error_per_s;  ///< standard error of its mean, from the single turns; unset below two
  std::string reason;                 ///< over what it was taken, or why there is none
};

/// The angle of a marker about the centre, minus that of the cell's longer axis: what is left when the cell tumbles as
/// a whole is taken off. Looked at in the x-z plane with the marker of z and in the x-y plane with that of y; the plane
/// with more turns counts. Whole turns are counted back from the last sample, since within a turn the membrane does not
/// go evenly: the frequency is their number over the time that they took.
/// Unset below one turn, and where no plane can be followed: without markers (logs of older solvers), with a value that
/// is not finite, or where a marker goes more than 120 degrees between two samples or the axis more than 60, as it does
/// in a plane in which the cell is round.
/// samples  of one cell, oldest first; those with time_s > after_s are looked at
TankTreading tank_treading(std::span<const SampleRow> samples, double after_s);

}  // namespace rouleau::campaign
