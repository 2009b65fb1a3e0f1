#!/usr/bin/env bash
# study_parallel_test.sh PROGRAM: four shards through GNU parallel, one of them killed, run again, merged: the rows of a
# single run. Then the same by the script for Slurm, with its variables set by hand. Exit code 77: something is missing here.
set -euo pipefail
program=$(readlink -f "$1")
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd)
for tool in parallel python3; do
  command -v "$tool" >/dev/null || { echo "skipped: there is no $tool here; install the package $tool"; exit 77; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

fail() {
  echo "FAILED: $*"
  exit 1
}

cat >spec.json <<'SPEC'
{"name": "shared", "base": {"scene": "builtin:layers", "size": "64x36"},
 "permute": {"lights": [1, 2, 3, 4, 5, 6], "layout": ["exact", "compact"]}, "x": "bytes_per_pixel", "y": "rmse_linear", "family": "layout"}
SPEC

# Its second shard is killed after its first row, once.
cat >killed_once.sh <<SH
#!/usr/bin/env bash
if [[ " \$* " != *" 2/4 "* || -e "$folder/killed" ]]; then exec "$program" "\$@"; fi
touch "$folder/killed"
"$program" "\$@" &
until [[ -s "$folder/shared/shard-2/rows.jsonl" ]]; do sleep 0.01; done
kill -KILL \$!
wait \$!
SH
chmod +x killed_once.sh

# compare FOLDER FOLDER: the same rows in the same order, but for times, and all have their pictures.
compare() {
  python3 - "$1" "$2" <<'PY'
import json, pathlib, sys
def rows(folder):
    out = []
    for row in json.loads((pathlib.Path(folder) / "study.json").read_text())["rows"]:
        assert all((pathlib.Path(folder) / "thumbs" / (row["key"] + e)).exists() for e in (".jpg", ".png")), row["case"]
        out.append({k: v for k, v in row.items() if not k.startswith("time_ms_") and k != "frames"})
    return out
a, b = rows(sys.argv[1]), rows(sys.argv[2])
assert len(a) == 12, len(a)
assert [r["case"] for r in a] == [r["case"] for r in b], "another order"
assert a == b, "other rows"
PY
}

"$program" study spec.json -o single >/dev/null 2>&1 || fail "the single run"

status=0
GBUFFERLAB=$folder/killed_once.sh "$root/scripts/study_parallel.sh" 4 shared spec.json >first.txt 2>&1 || status=$?
cat first.txt
[[ -e killed ]] || fail "no shard was killed"
((status == 4)) || fail "a killed shard must be said: exit code $status"
(($(wc -l <shared/rows.jsonl) < 12)) || fail "the killed shard has all its rows: it was not killed in time"
GBUFFERLAB=$folder/killed_once.sh "$root/scripts/study_parallel.sh" 4 shared spec.json >second.txt 2>&1 || fail "the second run: $(cat second.txt)"
compare single shared || fail "four shards are not the single run"

for task in 0 1 2; do
  SLURM_ARRAY_TASK_ID=$task SLURM_ARRAY_TASK_MIN=0 SLURM_ARRAY_TASK_COUNT=3 GBUFFERLAB=$program \
    "$root/scripts/study_slurm.sh" slurm spec.json >/dev/null 2>&1 || fail "task $task"
done
GBUFFERLAB=$program "$root/scripts/study_slurm.sh" --merge slurm >/dev/null 2>&1 || fail "merging the tasks"
compare single slurm || fail "three tasks are not the single run"
if GBUFFERLAB=$program "$root/scripts/study_slurm.sh" slurm spec.json 2>alone.txt; then fail "without Slurm's variables it must stop"; fi
grep --quiet SLURM_ARRAY_TASK_ID alone.txt || fail "and say which: $(cat alone.txt)"
echo "four shards, one of them killed, and three tasks give the rows of a single run"
