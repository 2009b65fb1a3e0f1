#!/usr/bin/env bash
# A lab that is left running: scripts/long_run.sh [MINUTES]   (default 45: 15 of them without a window, 30 in one)
# First the lab alone goes in seeded cycles through every scene, preset, option and panel; then a real window under Xvfb gets
# random keys of the program's own table. Both come back to the same settings again and again, and print what is held then.
# Exit 0: memory grew by at most 2 % after the first third, names of OpenGL not at all, and the last picture is the first. In a
# window memory is judged from its twentieth minute on: until then the driver still compiles for settings that are new.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

minutes=${1:-45}
if ! [[ $minutes =~ ^[0-9]+$ ]] || ((minutes == 0)); then
  say "not a number of minutes: '$minutes'"
  exit 2
fi
install build run test
configure ci
for program in gbufferlab test_app_slow test_ui_slow; do build ci "$program"; done
export XDG_STATE_HOME=$root/build/ci/tests/state
failed=0
GBL_LONG_RUN_S=$((minutes * 20)) "$root/build/ci/test_app_slow" --gtest_filter='LongRuns.*' || failed=1
GBL_LONG_RUN_S=$((minutes * 40)) "$root/build/ci/test_ui_slow" --gtest_filter='LongWindow.*' || failed=1
exit "$failed"
