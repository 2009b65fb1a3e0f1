#!/usr/bin/env bash
# A lab that is left running: scripts/long_run.sh [MINUTES]   (default 30)
# The lab alone goes in seeded cycles through every scene, preset, option and panel; beside it a real window under Xvfb gets
# random keys of the program's own table. Both come back to the same settings again and again, and print what is held then.
# Exit 0: memory grew by at most 2 % after the first third, names of OpenGL not at all, and the last picture is the first. In a
# window of less than twenty minutes memory is not judged: until then the driver still compiles for settings that are new.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

minutes=${1:-30}
if ! [[ $minutes =~ ^[0-9]+$ ]] || ((minutes == 0)); then
  say "not a number of minutes: '$minutes'"
  exit 2
fi
install build run test
configure ci
for program in gbufferlab test_app_slow test_ui_slow; do build ci "$program"; done
export XDG_STATE_HOME=$root/build/ci/tests/state
export GBL_LONG_RUN_S=$((minutes * 60))
failed=0
say "the window's records are in build/ci/long-window.log"
"$root/build/ci/test_ui_slow" --gtest_filter='LongWindow.*' >"$root/build/ci/long-window.log" 2>&1 &
"$root/build/ci/test_app_slow" --gtest_filter='LongRuns.*' || failed=1
wait $! || failed=1
tail -n 12 "$root/build/ci/long-window.log"
exit "$failed"
