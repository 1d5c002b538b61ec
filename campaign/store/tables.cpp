// SPDX-License-Identifier: BSD-3-Clause
// The tables. CHECK (typeof ...) instead of STRICT, so that SQLite tools older than 3.37 can read the file too.
#include "store/tables.hpp"

namespace rouleau::campaign {

const char* const table_statements = R"sql(
CREATE TABLE campaign (
  id              INTEGER PRIMARY KEY CHECK (id = 1),
  name            TEXT NOT NULL,
  study_text      TEXT NOT NULL,
  study_digest    TEXT NOT NULL,
  created_unix_s  REAL NOT NULL CHECK (typeof(created_unix_s) = 'real'),
  version         TEXT NOT NULL,
  git             TEXT NOT NULL
);

CREATE TABLE setting (
  name   TEXT PRIMARY KEY,
  value  TEXT NOT NULL
) WITHOUT ROWID;

CREATE TABLE point (
  ordinal          INTEGER PRIMARY KEY CHECK (ordinal >= 1),
  key              TEXT NOT NULL UNIQUE CHECK (length(key) >= 12),
  state            TEXT NOT NULL CHECK (state IN ('waiting', 'running', 'stopped', 'done', 'failed', 'refused',
                                                  'crashed', 'exhausted', 'cancelled')),
  replica          INTEGER NOT NULL CHECK (typeof(replica) = 'integer' AND replica >= 0),
  in_study         INTEGER NOT NULL CHECK (in_study IN (0, 1)),
  retries_used     INTEGER NOT NULL CHECK (typeof(retries_used) = 'integer' AND retries_used >= 0),
  retry_at_unix_s  REAL NOT NULL CHECK (typeof(retry_at_unix_s) = 'real'),
  end_step         INTEGER NOT NULL CHECK (typeof(end_step) = 'integer'),
  end_time_s       REAL NOT NULL CHECK (typeof(end_time_s) = 'real'),
  log_offset       INTEGER NOT NULL DEFAULT 0 CHECK (typeof(log_offset) = 'integer' AND log_offset >= 0),
  log_tail_hash    TEXT NOT NULL DEFAULT ''
);

CREATE TABLE parameter (
  point    INTEGER NOT NULL REFERENCES point (ordinal),
  name     TEXT NOT NULL,
  text     TEXT NOT NULL,
  value    REAL CHECK (typeof(value) IN ('real', 'null')),
  swept    INTEGER NOT NULL CHECK (swept IN (0, 1)),
  position INTEGER NOT NULL,
  PRIMARY KEY (point, name)
) WITHOUT ROWID;

CREATE TABLE attempt (
  point           INTEGER NOT NULL REFERENCES point (ordinal),
  number          INTEGER NOT NULL CHECK (number >= 1),
  token           TEXT NOT NULL,
  state           TEXT NOT NULL CHECK (state IN ('planned', 'launched', 'ended')),
  host            TEXT NOT NULL,
  boot_id         TEXT NOT NULL,
  pid             INTEGER NOT NULL CHECK (typeof(pid) = 'integer'),
  start_ticks     INTEGER NOT NULL CHECK (typeof(start_ticks) = 'integer'),
  ranks           INTEGER NOT NULL CHECK (typeof(ranks) = 'integer'),
  cores           TEXT NOT NULL,
  started_unix_s  REAL NOT NULL CHECK (typeof(started_unix_s) = 'real'),
  ended_unix_s    REAL CHECK (typeof(ended_unix_s) IN ('real', 'null')),
  exit_code       INTEGER CHECK (typeof(exit_code) IN ('integer', 'null')),
  reason          TEXT NOT NULL,
  resumed_from    TEXT NOT NULL,
  checkpoint_at_start INTEGER NOT NULL CHECK (typeof(checkpoint_at_start) = 'integer'),
  start_step      INTEGER CHECK (typeof(start_step) IN ('integer', 'null')),
  step            INTEGER CHECK (typeof(step) IN ('integer', 'null')),
  wall_s          REAL CHECK (typeof(wall_s) IN ('real', 'null')),
  core_s          REAL CHECK (typeof(core_s) IN ('real', 'null')),
  mlups           REAL CHECK (typeof(mlups) IN ('real', 'null')),
  version         TEXT NOT NULL,
  git             TEXT NOT NULL,
  engine          TEXT NOT NULL DEFAULT 'local',
  job_id          TEXT NOT NULL DEFAULT '',
  job_state       TEXT NOT NULL DEFAULT '',
  PRIMARY KEY (point, number)
) WITHOUT ROWID;

CREATE TABLE sample (
  point                       INTEGER NOT NULL REFERENCES point (ordinal),
  step                        INTEGER NOT NULL CHECK (typeof(step) = 'integer' AND step >= 0),
  cell                        INTEGER NOT NULL CHECK (typeof(cell) = 'integer' AND cell >= 0),
  time_s                      REAL NOT NULL CHECK (typeof(time_s) = 'real'),
  d_um                        REAL CHECK (typeof(d_um) IN ('real', 'null')),
  x_um                        REAL CHECK (typeof(x_um) IN ('real', 'null')),
  y_um                        REAL CHECK (typeof(y_um) IN ('real', 'null')),
  z_um                        REAL CHECK (typeof(z_um) IN ('real', 'null')),
  asphericity                 REAL CHECK (typeof(asphericity) IN ('real', 'null')),
  volume_ratio                REAL CHECK (typeof(volume_ratio) IN ('real', 'null')),
  area_ratio                  REAL CHECK (typeof(area_ratio) IN ('real', 'null')),
  inclination_deg             REAL CHECK (typeof(inclination_deg) IN ('real', 'null')),
  inside_nodes                INTEGER CHECK (typeof(inside_nodes) IN ('integer', 'null')),
  inside_ratio                REAL CHECK (typeof(inside_ratio) IN ('real', 'null')),
  flips                       INTEGER CHECK (typeof(flips) IN ('integer', 'null')),
  mean_velocity_mm_per_s      REAL CHECK (typeof(mean_velocity_mm_per_s) IN ('real', 'null')),
  pressure_gradient_Pa_per_m  REAL CHECK (typeof(pressure_gradient_Pa_per_m) IN ('real', 'null')),
  velocity_x_mm_per_s         REAL CHECK (typeof(velocity_x_mm_per_s) IN ('real', 'null')),
  finite                      INTEGER NOT NULL CHECK (finite IN (0, 1)),
  taylor_deformation          REAL CHECK (typeof(taylor_deformation) IN ('real', 'null')),
  angle_xz_deg                REAL CHECK (typeof(angle_xz_deg) IN ('real', 'null')),
  angle_xy_deg                REAL CHECK (typeof(angle_xy_deg) IN ('real', 'null')),
  extent_x_um                 REAL CHECK (typeof(extent_x_um) IN ('real', 'null')),
  extent_y_um                 REAL CHECK (typeof(extent_y_um) IN ('real', 'null')),
  extent_z_um                 REAL CHECK (typeof(extent_z_um) IN ('real', 'null')),
  marker_y_dx_um              REAL CHECK (typeof(marker_y_dx_um) IN ('real', 'null')),
  marker_y_dy_um              REAL CHECK (typeof(marker_y_dy_um) IN ('real', 'null')),
  marker_y_dz_um              REAL CHECK (typeof(marker_y_dz_um) IN ('real', 'null')),
  marker_z_dx_um              REAL CHECK (typeof(marker_z_dx_um) IN ('real', 'null')),
  marker_z_dy_um              REAL CHECK (typeof(marker_z_dy_um) IN ('real', 'null')),
  marker_z_dz_um              REAL CHECK (typeof(marker_z_dz_um) IN ('real', 'null')),
  PRIMARY KEY (point, step, cell)
) WITHOUT ROWID;

CREATE TABLE result (
  point              INTEGER NOT NULL REFERENCES point (ordinal),
  cell               INTEGER NOT NULL CHECK (typeof(cell) = 'integer'),
  window_s           REAL NOT NULL CHECK (typeof(window_s) = 'real'),
  window_start_s     REAL NOT NULL CHECK (typeof(window_start_s) = 'real'),
  time_s             REAL NOT NULL CHECK (typeof(time_s) = 'real'),
  samples            INTEGER NOT NULL CHECK (typeof(samples) = 'integer'),
  step               INTEGER NOT NULL CHECK (typeof(step) = 'integer'),
  d_mean_um          REAL CHECK (typeof(d_mean_um) IN ('real', 'null')),
  d_error_um         REAL CHECK (typeof(d_error_um) IN ('real', 'null')),
  d_change_um      REAL CHECK (typeof(d_change_um) IN ('real', 'null')),
  d_amplitude_um     REAL CHECK (typeof(d_amplitude_um) IN ('real', 'null')),
  d_period_s         REAL CHECK (typeof(d_period_s) IN ('real', 'null')),
  asphericity_mean   REAL CHECK (typeof(asphericity_mean) IN ('real', 'null')),
  asphericity_error  REAL CHECK (typeof(asphericity_error) IN ('real', 'null')),
  class              TEXT NOT NULL CHECK (class IN ('croissant', 'slipper', 'undecided')),
  class_reason       TEXT NOT NULL,
  note               TEXT NOT NULL,
  tank_treading_per_s        REAL CHECK (typeof(tank_treading_per_s) IN ('real', 'null')),
  tank_treading_error_per_s  REAL CHECK (typeof(tank_treading_error_per_s) IN ('real', 'null')),
  tank_treading_reason       TEXT NOT NULL DEFAULT '',
  PRIMARY KEY (point, cell)
) WITHOUT ROWID;

CREATE TABLE event (
  id          INTEGER PRIMARY KEY AUTOINCREMENT,
  unix_s      REAL NOT NULL CHECK (typeof(unix_s) = 'real'),
  point       INTEGER NOT NULL REFERENCES point (ordinal),
  attempt     INTEGER CHECK (typeof(attempt) IN ('integer', 'null')),
  from_state  TEXT,
  to_state    TEXT NOT NULL,
  evidence    TEXT NOT NULL CHECK (length(evidence) > 0)
);
CREATE INDEX event_of_point ON event (point, id);
CREATE TRIGGER event_is_never_changed BEFORE UPDATE ON event
  BEGIN SELECT raise(ABORT, 'events are append-only'); END;
CREATE TRIGGER event_is_never_deleted BEFORE DELETE ON event
  BEGIN SELECT raise(ABORT, 'events are append-only'); END;
)sql";

const char* const drop_view_statements = R"sql(
DROP VIEW IF EXISTS v_phase;
DROP VIEW IF EXISTS v_samples;
DROP VIEW IF EXISTS v_points;
DROP VIEW IF EXISTS v_attempts;
)sql";

const char* const view_statements = R"sql(
CREATE VIEW v_attempts AS
  SELECT p.ordinal, p.key, a.number AS attempt, a.state, a.host, a.pid, a.ranks, a.cores,
         strftime('%Y-%m-%dT%H:%M:%SZ', a.started_unix_s, 'unixepoch') AS started_utc,
         strftime('%Y-%m-%dT%H:%M:%SZ', a.ended_unix_s, 'unixepoch') AS ended_utc,
         a.exit_code, a.reason, a.start_step, a.step, a.resumed_from, a.wall_s, a.core_s / 3600.0 AS core_h, a.mlups,
         a.version, a.git, a.engine, a.job_id, a.job_state
    FROM attempt a JOIN point p ON p.ordinal = a.point;

CREATE VIEW v_points AS
  SELECT p.ordinal, p.key, p.state, l.value AS lambda, v.value AS mean_velocity_mm_per_s, p.replica,
         (SELECT group_concat(name || ' = ' || text, ', ')
            FROM (SELECT name, text FROM parameter WHERE point = p.ordinal AND swept ORDER BY position)) AS swept,
         p.in_study, p.end_time_s, p.end_step, p.retries_used,
         (SELECT max(step) FROM sample WHERE point = p.ordinal) AS sampled_step,
         (SELECT count(*) FROM attempt WHERE point = p.ordinal) AS attempts,
         (SELECT sum(wall_s) FROM attempt WHERE point = p.ordinal) AS wall_s,
         (SELECT sum(core_s) / 3600.0 FROM attempt WHERE point = p.ordinal) AS core_h,
         (SELECT sum(mlups * wall_s) / sum(wall_s) FROM attempt
           WHERE point = p.ordinal AND mlups IS NOT NULL AND wall_s > 0) AS mlups,
         (SELECT host FROM attempt WHERE point = p.ordinal ORDER BY number DESC LIMIT 1) AS host,
         (SELECT version FROM attempt WHERE point = p.ordinal ORDER BY number DESC LIMIT 1) AS version,
         (SELECT git FROM attempt WHERE point = p.ordinal ORDER BY number DESC LIMIT 1) AS git
    FROM point p
    LEFT JOIN parameter l ON l.point = p.ordinal AND l.name = 'fluid.lambda'
    LEFT JOIN parameter v ON v.point = p.ordinal AND v.name = 'flow.mean_velocity_mm_per_s';

CREATE VIEW v_phase AS
  SELECT p.ordinal, p.key, p.state, p.lambda, p.mean_velocity_mm_per_s, p.replica, p.swept, r.cell, r.class,
         r.d_mean_um, r.d_error_um, r.d_amplitude_um, r.d_period_s, r.asphericity_mean, r.asphericity_error,
         r.tank_treading_per_s, r.tank_treading_error_per_s, r.tank_treading_reason,
         r.time_s, r.step, r.window_s, r.window_start_s, r.samples, r.class_reason, r.note,
         p.wall_s, p.core_h, p.mlups, p.attempts, p.host, p.version, p.git
    FROM v_points p LEFT JOIN result r ON r.point = p.ordinal;

CREATE VIEW v_samples AS
  SELECT p.ordinal, p.key, l.value AS lambda, p.replica, s.step, s.cell, s.time_s, s.d_um, s.x_um, s.y_um, s.z_um,
         s.asphericity, s.volume_ratio, s.area_ratio, s.inclination_deg, s.inside_nodes, s.inside_ratio, s.flips,
         s.mean_velocity_mm_per_s, s.pressure_gradient_Pa_per_m, s.velocity_x_mm_per_s,
         s.taylor_deformation, s.angle_xz_deg, s.angle_xy_deg, s.extent_x_um, s.extent_y_um, s.extent_z_um,
         s.marker_y_dx_um, s.marker_y_dy_um, s.marker_y_dz_um, s.marker_z_dx_um, s.marker_z_dy_um, s.marker_z_dz_um,
         s.finite
    FROM sample s
    JOIN point p ON p.ordinal = s.point
    LEFT JOIN parameter l ON l.point = p.ordinal AND l.name = 'fluid.lambda';
)sql";

}  // namespace rouleau::campaign
