// SPDX-License-Identifier: BSD-3-Clause
// The part of job.sh that all jobs share: bash 4.2 and later, as compute nodes have it.
#pragma once

#include <string_view>

namespace rouleau::campaign {

/// Expects campaign, solver, name, launcher, at_end, limit_s, margin_s, keys, attempts, tokens to be set.
inline constexpr std::string_view job_script_body = R"BASH(
set +e +u  # whatever the setup lines have set
say() { printf '%s %s: %s\n' "$(date '+%Y-%m-%dT%H:%M:%S')" "$name" "$*"; }

if [ -z "$SLURM_JOB_ID" ]; then
  say 'this is no Slurm job; submit the script with sbatch'
  exit 1
fi

# Writes a file of one line that exists whole or not at all.
write() {
  printf '%s\n' "$2" >"$1.tmp" && mv -f "$1.tmp" "$1"
}

# The number of the newest attempt of the point in this directory; 0 = none.
newest_attempt() {
  local newest=0 folder
  for folder in attempts/*/; do
    folder=${folder#attempts/}
    folder=${folder%/}
    [[ $folder =~ ^[1-9][0-9]{0,8}$ ]] && ((folder > newest)) && newest=$folder
  done
  echo "$newest"
}

# Takes the attempt, and notes which start of the job it belongs to; fails if it has begun before.
begin() {
  mkdir "attempts/$attempt/begun" 2>/dev/null && write "attempts/$attempt/start" "${SLURM_RESTART_COUNT:-0}"
}

# Makes an attempt ours: the one that the script was written for if nobody has begun it yet, else a new one. Whoever
# makes a directory first has it, so that two copies of this job (Slurm may start the second while the first still runs
# on a node out of its sight) never share an attempt, and the newer one fences the older. Sets attempt and token.
claim() {
  attempt=$2 token=$3
  cd "$campaign/points/$1" || return 1
  if [ ! -d "attempts/$attempt" ]; then
    say "point $1: there is no attempt $attempt; it is left alone"
    return 1
  fi
  begin && return 0
  if [ ! -d "attempts/$attempt/begun" ]; then
    say "point $1: cannot write in attempts/$attempt; it is left alone"
    return 1
  fi
  local newest owner='' ended=''
  newest=$(newest_attempt)
  if [ "$newest" != "$attempt" ]; then
    [ -f "attempts/$newest/job" ] && read -r _ _ owner <"attempts/$newest/job"
    if [ "$owner" != "$name" ]; then
      say "point $1: attempt $newest has taken it over; it is left alone"
      return 1
    fi
  fi
  # Slurm starts all points of a job again, also those that have come to their end.
  if [ "${SLURM_RESTART_COUNT:-0}" != 0 ] && [ -f "attempts/$newest/exit.json" ]; then
    ended=$(grep -o '"code": *[0-9]*' "attempts/$newest/exit.json" | head -n 1)
    case ${ended##*[: ]} in
      0 | 65 | 70 | 76)
        say "point $1: attempt $newest ended with code ${ended##*[: ]}; it is left alone"
        return 1
        ;;
    esac
  fi
  attempt=$((newest + 1))
  if ! mkdir "attempts/$attempt"; then
    say "point $1: somebody else makes attempt $attempt; it is left alone"
    return 1
  fi
  token=$(</proc/sys/kernel/random/uuid)
  token=${token//-/}
  write "attempts/$attempt/owner" "$token" &&
    write "attempts/$attempt/job" "slurm $SLURM_JOB_ID $name" &&
    begin || return 1
  say "point $1: attempt $2 has begun before; this start is attempt $attempt"
}

# Whether what the point in this directory reads is what `rouleau init` wrote: days may lie between the submission, when
# the manager looked, and this start. If it is not, the attempt ends here, with the reason as its last words.
has_sound_inputs() {
  local crc size file
  [ -f inputs ] || return 0  # by an earlier version of `rouleau init`
  if ! command -v cksum >/dev/null; then
    say "point $1: there is no program cksum here; its input files are not compared"
    return 0
  fi
  while read -r crc size file; do
    [ "$(cksum <"$file")" = "$crc $size" ] && continue
    echo "job.sh: $PWD/$file is not the file that \`rouleau init\` wrote; the solver was not started" \
      >>"attempts/$attempt/stderr"
    write "attempts/$attempt/status" 65
    say "point $1: $file is not the file that \`rouleau init\` wrote; it is left alone"
    return 1
  done <inputs
}

# Seconds in what squeue calls the time left: [D-]H:M:S or M:S; fails for anything else.
seconds_of() {
  [[ $1 =~ ^((([0-9]+)-)?([0-9]+):)?([0-9]+):([0-9]+)$ ]] || return 1
  local days=${BASH_REMATCH[3]:-0} hours=${BASH_REMATCH[4]:-0}
  echo $((((10#$days * 24 + 10#$hours) * 60 + 10#${BASH_REMATCH[5]}) * 60 + 10#${BASH_REMATCH[6]}))
}

# Sets end_s to the time limit on the clock of SECONDS: as Slurm says, else as was asked for; empty = there is no limit.
find_end() {
  local words left
  words=$(timeout 60 squeue -h -j "$SLURM_JOB_ID" -o %L 2>/dev/null | tail -n 1)
  words=${words//[[:space:]]/}
  if [ "$words" = UNLIMITED ]; then
    end_s=
  elif left=$(seconds_of "$words"); then
    end_s=$((SECONDS + left))
  else
    end_s=$limit_s
  fi
}

# Sets deadline_s to the seconds that a solver has from now on; empty = no limit.
find_deadline() {
  deadline_s=
  [ -n "$end_s" ] || return 0
  deadline_s=$((end_s - SECONDS - margin_s))
  ((deadline_s >= 1)) || deadline_s=1
}

# Runs the solver on the point in this directory. On SIGUSR2 it is told to write a checkpoint and end.
run_point() {
  local status pid signalled
  trap 'kill -USR2 "$pid"; signalled=1' USR2
  trap '' TERM
  (
    trap - TERM USR2
    exec "${launcher[@]}" "$solver" run.ini --attempt "$attempt" --token "$token" \
      ${deadline_s:+--deadline-s "$deadline_s"} >>"attempts/$attempt/stdout" 2>>"attempts/$attempt/stderr" </dev/null
  ) &
  pid=$!
  # A trap ends `wait`, with a status that is not the solver's even if that has ended meanwhile.
  while :; do
    signalled=
    wait "$pid"
    status=$?
    [ -n "$signalled" ] || break
  done
  write "attempts/$attempt/status" "$status"
}

# Passes the signal on to the solvers that can take it: one that has not written started.json yet would be killed by it.
# Fails as long as some are left to be told.
tell_all_to_stop() {
  local i all_told=0
  for i in "${!pids[@]}"; do
    [ -n "${told[i]}" ] && continue
    if ! kill -0 "${pids[i]}" 2>/dev/null; then
      told[i]=ended
    elif [ -f "${folders[i]}/started.json" ]; then
      kill -USR2 "${pids[i]}" 2>/dev/null
      told[i]=told
    else
      all_told=1
    fi
  done
  return $all_told
}

some_run() {
  local pid
  for pid in "${pids[@]}"; do
    kill -0 "$pid" 2>/dev/null && return 0
  done
  return 1
}

worst=0 stop='' terminated='' pids=() folders=() told=()
trap 'stop=1' USR2
trap 'stop=1 terminated=1' TERM
find_end
for i in "${!keys[@]}"; do
  claim "${keys[i]}" "${attempts[i]}" "${tokens[i]}" || continue
  has_sound_inputs "${keys[i]}" || {
    worst=65
    continue
  }
  find_deadline
  run_point &
  pids[i]=$!
  folders[i]=$PWD/attempts/$attempt
  say "point ${keys[i]}: attempt $attempt runs on ${SLURM_JOB_NODELIST:-$HOSTNAME}, ${deadline_s:-no limit of} s left"
done

while some_run; do
  # bash runs a trap only between commands: the signal ends `wait`.
  if [ -z "$stop" ] || tell_all_to_stop; then
    wait "${pids[@]}"
  else
    sleep 1
  fi
done

for i in "${!pids[@]}"; do
  status=
  [ -f "${folders[i]}/status" ] && read -r status <"${folders[i]}/status"
  say "point ${keys[i]}: ended with status ${status:-unknown}"
  case $status in
    0 | 75 | 76) ;;
    *) worst=${status:-1} ;;
  esac
done

cd "$campaign" || exit 1
if [ -n "$terminated" ]; then
  say 'the job was told to end'
elif [ "${#at_end[@]}" != 0 ]; then
  "${at_end[@]}" || say "${at_end[0]} ended with status $?"
fi
exit "$worst"
)BASH";

}  // namespace rouleau::campaign
