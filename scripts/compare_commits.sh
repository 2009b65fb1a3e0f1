#!/bin/bash
# Two commits timed in turn with the same bench, so that what slows the machine down slows both. Each is built once, in a
# work tree under build/commits (git worktree remove takes it away).
#   scripts/compare_commits.sh OLD NEW [ROUNDS=5] -- what bench takes: --scene builtin:hall --lights 256 …
set -euo pipefail
shopt -s inherit_errexit
cd "$(dirname "$0")/.."
usage() {
  sed -n '4s/^# *//p' "$0" >&2
  exit 1
}
[ $# -ge 2 ] || usage
old=$1 new=$2 rounds=5
shift 2
if [ $# -gt 0 ] && [ "$1" != "--" ]; then
  [[ $1 =~ ^[1-9][0-9]*$ ]] || usage
  rounds=$1
  shift
fi
[ "${1:-}" = "--" ] && shift

# Prints the program's path.
built() {
  local commit folder
  commit=$(git rev-parse --short=12 "$1^{commit}")
  folder=$PWD/build/commits/$commit
  [ -d "$folder" ] || git worktree add --detach --quiet "$folder" "$commit" >&2
  cmake -S "$folder" --preset ci >&2
  cmake --build "$folder/build/ci" --target gbufferlab >&2
  echo "$folder/build/ci/gbufferlab"
}
old_program=$(built "$old")
new_program=$(built "$new")

# The sum of the passes: older commits have no wall time.
ms_of() {
  local row
  row=$("$1" bench --json --no-truth "${@:2}")
  python3 -c 'import json, sys
print(json.loads(sys.argv[1])["time_ms_total_median"])' "$row"
}
pairs=""
for ((i = 0; i < rounds; i++)); do
  before=$(ms_of "$old_program" "$@")
  after=$(ms_of "$new_program" "$@")
  pairs+="$before $after"$'\n'
done
python3 -c '
import statistics, sys
pairs = [tuple(map(float, line.split())) for line in sys.argv[1].splitlines()]
ratios = sorted(new / old for old, new in pairs)
print("old %.2f ms, new %.2f ms, new / old %.3f (%.3f to %.3f; %d rounds in turn)" % (
    statistics.median(p[0] for p in pairs), statistics.median(p[1] for p in pairs), statistics.median(ratios),
    ratios[0], ratios[-1], len(ratios)))' "$pairs"
