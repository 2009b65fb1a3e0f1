#!/usr/bin/env bash
# Fuzzes what reads bytes from outside: scripts/fuzz.sh [SECONDS] [READER...]   (default: 60 s for each of all readers)
# Built in build/fuzz with clang's fuzzer, address and undefined-behaviour sanitizers. The first corpus is made by our own
# code; what the fuzzer finds new is kept in build/fuzz/corpus for the next run, and what broke a promise in build/fuzz/found: copy that to
# tests/fuzz/findings/READER when it is fixed. Two readers at a time; each line ends with the processor time it had, and
# build/fuzz/hours.log keeps all lines of all runs. A file may take five seconds by the clock: on a machine that is busy otherwise
# one can seem to hang that does not; give it to build/fuzz/fuzz again. Exit 0: nothing was found; 1: something was; 77: no clang here.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

if ! command -v clang++ >/dev/null; then
  echo "skipped: no clang++ here; packages.txt names what it needs, under [slow]"
  exit 77
fi
seconds=${1:-60}
shift || true
folder=$root/build/fuzz
configure fuzz
build fuzz fuzz
build fuzz make_seeds
names=$("$folder/make_seeds" "$folder") || die "the first files could not be made"
mapfile -t all <<<"$names"
for reader in "$@"; do
  if [[ " ${all[*]} " != *" $reader "* ]]; then
    say "there is no reader '$reader'; known: ${all[*]}"
    exit 2
  fi
done
if (($# == 0)); then set -- "${all[@]}"; fi

fuzz_one() {
  local reader=$1 log=$folder/$1.log status=0 TIMEFORMAT='%U %S'
  mkdir -p "$folder/found/$reader"
  { time "$folder/fuzz" --reader="$reader" -max_total_time="$seconds" -max_len=65536 -timeout=5 -rss_limit_mb=3000 -print_final_stats=1 \
    -dict="$folder/$reader.dict" -artifact_prefix="$folder/found/$reader/" "$folder/corpus/$reader" >"$log" 2>&1; } 2>"$log.time" || status=1
  awk -v reader="$reader" -v bad="$status" -v time="$(<"$log.time")" '
    /stat::number_of_executed_units/ { runs = $2 } /stat::peak_rss_mb/ { mib = $2 } / cov: / { for (i = 1; i < NF; ++i) if ($i == "cov:") edges = $(i + 1) }
    END { split(time, cpu, " "); printf "%-12s %10d executions %6d s of a processor %6d edges %5d MiB  %s\n", reader, runs, cpu[1] + cpu[2], edges, mib, bad ? "FOUND SOMETHING" : "nothing found" }' \
    "$log" | tee -a "$folder/hours.log"
  if ((status)); then grep -m 3 -E "ERROR|broken promise|SUMMARY|Test unit written" "$log" || true; fi
  return "$status"
}

failed=0
running=0
for reader in "$@"; do
  if ((running == 2)); then
    wait -n || failed=1
    running=1
  fi
  fuzz_one "$reader" &
  running=$((running + 1))
done
while ((running > 0)); do
  wait -n || failed=1
  running=$((running - 1))
done
exit "$failed"
