# SPDX-License-Identifier: BSD-3-Clause
# What the fake Slurm's commands share: a table of jobs below $FAKE_SLURM_DIR, behind a lock, and the scheduler's step.
#   jobs      id|name|state|reason|node|user|visible|may start|ended|limit s|restarts|requeue|signal|tasks|began
#   nodes     name|slots          free places are slots less the tasks of running jobs; 0 slots: a node that is down
#   control/  one file a thing that goes wrong, made by `fake-slurm`; calls: one line a client call
#   job.ID/   script, directory, output, mode, session.N (of the N-th restart)
set -u
: "${FAKE_SLURM_DIR:?names the directory that \`fake-slurm start\` made}"
state_dir=$FAKE_SLURM_DIR control=$FAKE_SLURM_DIR/control
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
client=${0##*/}

exec 9<> <(:)
pause() { read -r -t "$1" -u 9; }  # SECONDS; unlike sleep it dies with the client
now() { echo "$EPOCHREALTIME"; }
setting() { cat "$control/$1" 2>/dev/null || echo "$2"; }

lock() { exec 8>"$state_dir/lock" && flock 8; }
unlock() { exec 8>&-; }

# Replaces the table by what the awk program makes of it. [-v NAME=VALUE ...] PROGRAM; the lock must be held.
edit_jobs() {
  awk -F'|' -v OFS='|' -v now="$(now)" "$@" "$state_dir/jobs" >"$state_dir/jobs.new" &&
    mv "$state_dir/jobs.new" "$state_dir/jobs"
}
row_of() { awk -F'|' -v id="$1" '$1 == id' "$state_dir/jobs"; }  # ID
is_known() { [ -n "$(row_of "$1")" ]; }

# The scheduler's step: forgets what ended long ago, starts what may start and has room, in the order of submission.
tick() {
  local id node restarts
  [ -e "$state_dir/jobs" ] || return 0
  : >"$state_dir/starts"
  edit_jobs -v age="$(setting min_job_age 300)" -v nodes="$state_dir/nodes" -v starts="$state_dir/starts" '
    BEGIN {
      while ((getline line < nodes) > 0) {
        split(line, part, "|")
        names[++count] = part[1]
        free[part[1]] = part[2]
      }
    }
    $9 > 0 && $9 + age < now { next }
    { row[NR] = $0 }
    $3 == "RUNNING" || $3 == "COMPLETING" { free[$5] -= $14 }
    END {
      for (i = 1; i <= NR; ++i) {
        if (!(i in row)) continue
        $0 = row[i]
        if ($3 == "PENDING" && $4 ~ /^(None|Priority|Resources|BeginTime)$/ && $8 <= now) {
          $4 = is_full ? "Priority" : "Resources"
          for (n = 1; n <= count && !is_full; ++n) if (free[names[n]] >= $14) {
            $3 = "RUNNING"; $4 = "None"; $5 = names[n]; $15 = now; free[$5] -= $14
            print $1, $5, $11 >starts
            break
          }
          if ($3 == "PENDING") is_full = 1
        }
        print
      }
    }'
  while IFS='|' read -r id node restarts; do
    setsid "$here/run-job" "$id" "$node" "$restarts" 8>&- </dev/null >/dev/null 2>>"$state_dir/trouble" &
  done <"$state_dir/starts"
}

# The living processes of a session. SESSION
session() {
  cat /proc/[0-9]*/stat 2>/dev/null | awk -v session="$1" '
    { pid = $1; sub(/^.*\) /, ""); if ($4 == session && $1 != "Z") print pid }'
}
signal_session() {  # SESSION SIGNAL
  local pids
  pids=$(session "$1")
  [ -z "$pids" ] || kill -s "$2" $pids 2>/dev/null
}

# Each client calls this first: writes the call down; then nothing, or what a lost controller or munge does to it.
begin_call() {
  local words
  if [ "${1:-}" = --version ]; then  # asks nobody
    echo "slurm-wlm 22.05.8"
    exit 0
  fi
  printf -v words ' %q' "$@"
  echo "$EPOCHREALTIME $client$words" >>"$state_dir/calls"
  kill_caller before
  if [ -e "$control/munge_down" ]; then
    pause "$(cat "$control/munge_down")"
    echo "$client: error: If munge is up, restart with --num-threads=10" >&2
    echo "$client: error: Munge encode failed: Failed to connect to \"/run/munge/socket\": Connection refused" >&2
    echo "$client: error: slurm_send_node_msg: auth_g_create: ${request:-REQUEST_JOB_INFO} has authentication error" >&2
    fail_call "Protocol authentication error" "$@"
  elif [ -e "$control/down" ]; then
    pause "$(cat "$control/down")"
    fail_call "Unable to contact slurm controller (connect failure)" "$@"
  elif [ -e "$control/timed_out" ]; then
    pause "$(cat "$control/timed_out")"
    fail_call "Socket timed out on send/recv operation" "$@"
  fi
}

# How each client words an error of the controller. TEXT ARGUMENTS...
fail_call() {
  local text=$1
  shift
  case $client in
    sbatch) [[ " $* " == *" --test-only "* ]] && echo "allocation failure: $text" >&2 ||
      echo "sbatch: error: Batch job submission failed: $text" >&2 ;;
    squeue) echo "slurm_load_jobs error: $text" >&2 ;;
    sinfo) echo "slurm_load_partitions: $text" >&2 ;;
    srun) echo "srun: error: Unable to allocate resources: $text" >&2 ;;
    scancel) echo "scancel: error: Kill job error on job id ${*: -1}: $text" >&2; exit 8 ;;
    scontrol)  # measured: it does not say which of the two it was
      echo "Unexpected message received for job ${*: -1}" >&2
      echo "slurm_suspend error: Unexpected message received" >&2 ;;
  esac
  exit 1
}

# Kills the program that called the client, once, if asked to; the client goes on. before|after
kill_caller() {
  rm "$control/kill_caller.$client.$1" 2>/dev/null && kill -KILL "$PPID"
}
