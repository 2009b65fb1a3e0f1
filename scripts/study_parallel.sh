#!/usr/bin/env bash
# scripts/study_parallel.sh N FOLDER [ARGUMENT...]: a study in N processes at once, by GNU parallel, and then as one.
# The arguments are those of `gbufferlab study`, e.g.: scripts/study_parallel.sh 4 out/tradeoff tradeoff --size 320x180
# Each process has its shard in FOLDER/shard-I; FOLDER gets what one run would have written. Run it again and it goes on
# where it was stopped. GBUFFERLAB names the program (default: build/release/gbufferlab).
# Times of processes that share a machine are longer than those of one alone: take errors and bytes from such a study.
# Exit code: 0 done, 1 rows have failed, 4 a process did not finish.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)

stop() {
  echo "study_parallel: $2" >&2
  exit "$1"
}

(($# >= 2)) && [[ $1 =~ ^[1-9][0-9]*$ ]] || stop 2 "write: scripts/study_parallel.sh N FOLDER [ARGUMENT of gbufferlab study...]"
shards=$1 folder=$2
shift 2
program=${GBUFFERLAB:-$root/build/release/gbufferlab}
command -v parallel >/dev/null || stop 4 "GNU parallel is not installed; install the package parallel"
command -v "$program" >/dev/null || stop 4 "there is no $program; build it with ./run, or set GBUFFERLAB"

mkdir -p "$folder"
# Exit codes of the processes, by shard: a row that fails (1) is a row, and no reason to stop the others.
# shellcheck disable=SC2016  # parallel's own placeholders
parallel --jobs "$shards" --joblog "$folder/jobs.txt" --quote \
  "$program" study "$@" --shard "{}/$shards" -o "$folder/shard-{}" ::: $(seq "$shards") >&2 || true
codes=$(awk 'NR > 1 { print ($8 > 0 ? 128 + $8 : $7) }' "$folder/jobs.txt" | sort --unique --numeric-sort)
if grep --quiet --line-regexp 2 <<<"$codes"; then stop 2 "the study was refused, see above"; fi

merged=()
for i in $(seq "$shards"); do
  if [[ -e $folder/shard-$i/spec.json ]]; then merged+=("$folder/shard-$i"); fi
done
((${#merged[@]} > 0)) || stop 4 "no process has measured anything"
"$program" study --merge "${merged[@]}" -o "$folder"
worst=$(tail --lines=1 <<<"$codes")
if ((worst > 1)); then stop 4 "a process did not finish (see $folder/jobs.txt); run this again and it goes on"; fi
exit "$worst"
