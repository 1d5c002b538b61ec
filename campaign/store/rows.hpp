// SPDX-License-Identifier: BSD-3-Clause
// The rows of campaign.db as plain structs: what each table holds, with its units.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jobs/state.hpp"

namespace rouleau::campaign {

/// The one row that describes the campaign.
struct CampaignRow {
  std::string name;          ///< [study] name
  std::string study_text;    ///< the study file, byte for byte
  std::string study_digest;  ///< digest of study_text
  double created_unix_s = 0;
  std::string version, git;  ///< of the rouleau that made it
};

/// A run parameter of a point: `name` is section.entry of the run file, `text` its canonical value.
struct ParameterRow {
  std::string name;
  std::string text;
  std::optional<double> value;  ///< set where text is a finite number
  bool swept = false;           ///< named by the study's [sweep]

  friend bool operator==(const ParameterRow&, const ParameterRow&) = default;
};

/// A point; its parameters are in their own table (Store::parameters).
struct PointRow {
  std::string key;  ///< 12 or more hex digits: the name of its run directory
  int ordinal = 0;  ///< 1, 2, 3 ... in the order in which points entered the campaign: `#3`
  State state = State::waiting;
  int replica = 0;
  bool in_study = true;        ///< false once the study file does not name it any more
  int retries_used = 0;        ///< crashes without progress since the last progress, start or retry
  double retry_at_unix_s = 0;  ///< not to be started before this (back-off); 0 = at once
  std::int64_t end_step = 0;   ///< steps to the end time
  double end_time_s = 0;       ///< physical time, s

  friend bool operator==(const PointRow&, const PointRow&) = default;
};

enum class AttemptState {
  planned,   ///< intent recorded, nothing started yet
  launched,  ///< a process was started
  ended,     ///< the process is gone
};

/// The engines by name.
inline constexpr std::string_view local_engine = "local", slurm_engine = "slurm";

/// AttemptRow::job_state of a job that nobody has looked for yet.
inline constexpr const char* submitted_word = "submitted";

/// One start of the solver on a point.
struct AttemptRow {
  std::string point;
  int number = 0;  ///< attempts/<number>/
  std::string token;
  AttemptState state = AttemptState::planned;
  std::string host, boot_id;  ///< of the launched process (contract section 7)
  std::int64_t pid = 0, start_ticks = 0;
  int ranks = 0;
  std::string cores;  ///< the cores that it is pinned to, e.g. "0,1"
  std::string engine = std::string(local_engine);
  std::string job_id;     ///< of the scheduler; "" = none, or not known yet
  std::string job_state;  ///< what the scheduler said last, in plain words; submitted_word before it was asked
  double started_unix_s = 0;
  std::optional<double> ended_unix_s;
  std::optional<int> exit_code;  ///< of exit.json, else of the process
  std::string reason;
  std::string resumed_from;
  std::int64_t checkpoint_at_start = -1;         ///< step of the newest checkpoint when it was started; -1 = none
  std::optional<std::int64_t> start_step, step;  ///< first and last step
  std::optional<double> wall_s, core_s, mlups;
  std::string version, git;  ///< of the solver

  friend bool operator==(const AttemptRow&, const AttemptRow&) = default;
};

/// One line of samples.csv (contract section 4). A measure that was not finite is unset, and `finite` false.
struct SampleRow {
  std::int64_t step = 0;
  int cell = 0;
  double time_s = 0;
  std::optional<double> d_um, x_um, y_um, z_um, asphericity, volume_ratio, area_ratio, inclination_deg;
  std::optional<std::int64_t> inside_nodes;
  std::optional<double> inside_ratio;
  std::optional<std::int64_t> flips;
  std::optional<double> mean_velocity_mm_per_s, pressure_gradient_Pa_per_m, velocity_x_mm_per_s;
  // Older logs have none of these.
  std::optional<double> taylor_deformation, angle_xz_deg, angle_xy_deg, extent_x_um, extent_y_um, extent_z_um;
  std::optional<double> marker_y_dx_um, marker_y_dy_um, marker_y_dz_um, marker_z_dx_um, marker_z_dy_um, marker_z_dz_um;
  bool finite = true;

  friend bool operator==(const SampleRow&, const SampleRow&) = default;
};

/// How far samples.csv of a point has been read.
struct SampleMark {
  std::int64_t offset = 0;  ///< bytes read, always behind a newline
  std::string tail_hash;    ///< XXH64 of the last bytes before offset (at most 4096)

  friend bool operator==(const SampleMark&, const SampleMark&) = default;
};

/// A change of state and its evidence. Events are never changed.
struct EventRow {
  std::int64_t id = 0;
  double unix_s = 0;
  std::string point;
  std::optional<int> attempt;
  std::optional<State> from;  ///< unset: the point was created
  State to = State::waiting;
  std::string evidence;
};

/// What the analysis says of one cell of a point (report/analysis.hpp). Unset = cannot be said from the samples.
struct ResultRow {
  std::string point;
  int cell = 0;
  double window_s = 0;                    ///< asked for
  double window_start_s = 0, time_s = 0;  ///< first and last time of the samples averaged over
  std::int64_t samples = 0;               ///< in the window
  std::int64_t step = 0;                  ///< of the last sample
  std::optional<double> d_mean_um, d_error_um, d_change_um;
  std::optional<double> d_amplitude_um, d_period_s;
  std::optional<double> asphericity_mean, asphericity_error;
  std::optional<double> tank_treading_per_s, tank_treading_error_per_s;
  std::string tank_treading_reason;  ///< over what it was taken, or why there is none
  std::string phase;                 ///< croissant, slipper or undecided
  std::string phase_reason;          ///< by which numbers
  std::string note;                  ///< what limits the figures; empty: nothing does

  friend bool operator==(const ResultRow&, const ResultRow&) = default;
};

}  // namespace rouleau::campaign
