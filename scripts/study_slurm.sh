#!/usr/bin/env bash
#SBATCH --job-name=gbufferlab-study
# A study as a job array of Slurm, a shard for each task:
#   sbatch --array=1-8 scripts/study_slurm.sh FOLDER [ARGUMENT of gbufferlab study...]
# and when all have ended:
#   sbatch --dependency=afterany:JOB scripts/study_slurm.sh --merge FOLDER
# FOLDER is seen by all machines. Each task has its rows in FOLDER/shard-I; a task that is started again goes on.
# GBUFFERLAB names the program (default: build/release/gbufferlab of the folder in which sbatch was called).
set -euo pipefail

stop() {
  echo "study_slurm: $2" >&2
  exit "$1"
}

program=${GBUFFERLAB:-${SLURM_SUBMIT_DIR:-.}/build/release/gbufferlab}
command -v "$program" >/dev/null || stop 4 "there is no $program; build it with ./run, or set GBUFFERLAB"

if [[ ${1:-} == --merge ]]; then
  (($# == 2)) || stop 2 "write: study_slurm.sh --merge FOLDER"
  exec "$program" study --merge "$2"/shard-* -o "$2"
fi

(($# >= 1)) && [[ $1 != -* ]] || stop 2 "write: sbatch --array=1-N study_slurm.sh FOLDER [ARGUMENT of gbufferlab study...]"
folder=$1
shift
[[ -n ${SLURM_ARRAY_TASK_ID:-} && -n ${SLURM_ARRAY_TASK_COUNT:-} ]] ||
  stop 2 "this is no task of a job array: SLURM_ARRAY_TASK_ID and SLURM_ARRAY_TASK_COUNT are not set; use sbatch --array=1-N"
# An array may begin at 0 and may have steps; shards count from 1.
shard=$(((SLURM_ARRAY_TASK_ID - ${SLURM_ARRAY_TASK_MIN:-1}) / ${SLURM_ARRAY_TASK_STEP:-1} + 1))
mkdir -p "$folder"
exec "$program" study "$@" --shard "$shard/$SLURM_ARRAY_TASK_COUNT" -o "$folder/shard-$shard"
