// SPDX-License-Identifier: BSD-3-Clause
// The snapshots of a run as one time series that ParaView and VTK open: an XDMF file beside them that names them all.
#pragma once

#include <map>
#include <string>

#include "storage/snapshot.hpp"

namespace rouleau {

/// `fields.xdmf` or `cells.xdmf`. For rank 0.
class SnapshotSeries {
 public:
  explicit SnapshotSeries(SnapshotKind kind) : kind_(kind) {}

  /// Replaces the series by what is on the disk now, in the order of steps. Files that are known from the time before
  /// are not read again, but for `changed`. A file that is no sound snapshot is left out, with a word on stderr.
  /// throws Error(superseded) by the fence, Error(io); then the older series is there
  void write(const SnapshotPlace& place, const std::string& changed);

 private:
  SnapshotKind kind_;
  std::map<std::string, std::string> grids_;  ///< by file name, which sorts by step; empty for one that is left out
};

}  // namespace rouleau
