#!/bin/bash
# Two commits timed in turn with the same bench, so that what slows the machine down slows both. Each is built once, in a
# work tree under build/commits.
#   scripts/compare_commits.sh OLD NEW [rounds=5] -- what bench takes: --scene builtin:hall --lights 256 …
set -euo pipefail
cd "$(dirname "$0")/.."
if [ $# -lt 2 ]; then
  sed -n '2,4s/^# *//p' "$0" >&2
  exit 1
fi
old=$1 new=$2 rounds=5
shift 2
if [ "${1:-}" != "" ] && [ "${1:-}" != "--" ]; then rounds=$1; shift; fi
[ "${1:-}" = "--" ] && shift

# Prints the program's path.
built() {
  local commit folder
  commit=$(git rev-parse --short=12 "$1^{commit}")
  folder=$PWD/build/commits/$commit
  [ -d "$folder" ] || git worktree add --detach --quiet "$folder" "$commit" >&2
  (cd "$folder" && cmake --preset ci >/dev/null && cmake --build build/ci --target gbufferlab >/dev/null) >&2
  echo "$folder/build/ci/gbufferlab"
}
old_program=$(built "$old")
new_program=$(built "$new")

# The sum of the passes: older commits have no wall time.
ms_of() {
  "$1" bench --json --no-truth "${@:2}" 2>/dev/null |
    python3 -c 'import json, sys
row = json.load(sys.stdin)
print(row["time_ms_total_median"])'
}
for ((i = 0; i < rounds; i++)); do
  echo "$(ms_of "$old_program" "$@") $(ms_of "$new_program" "$@")"
done | python3 -c '
import statistics, sys
pairs = [tuple(map(float, line.split())) for line in sys.stdin]
ratios = sorted(new / old for old, new in pairs)
print("old %.2f ms, new %.2f ms, new / old %.3f (%.3f to %.3f; %d rounds in turn)" % (
    statistics.median(p[0] for p in pairs), statistics.median(p[1] for p in pairs), statistics.median(ratios),
    ratios[0], ratios[-1], len(ratios)))'
