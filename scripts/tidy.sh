#!/usr/bin/env bash
# scripts/tidy.sh [FILE...]: clang-tidy over these source files, or over all; exit code 1 if it has anything to say.
# It takes the commands of the ci build without GCC's precompiled header, so that a forgotten #include shows, too.
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"
set -euo pipefail

install build run test ci
configure ci
cd "$root"
database=build/ci/tidy
mkdir -p "$database"
sed -E 's/ -include [^ ]*cmake_pch\.hxx//; s/ -Winvalid-pch//; s/ -Wno-restrict//' build/ci/compile_commands.json >"$database/compile_commands.json"

files=("$@")
if ((${#files[@]} == 0)); then mapfile -t files < <(git ls-files '*.cpp'); fi
# web/ is compiled for a browser alone, by a compiler that clang-tidy does not know.
mapfile -t files < <(printf '%s\n' "${files[@]}" | grep -v '^web/')
if ((${#files[@]} == 0)); then exit 0; fi
printf '%s\0' "${files[@]}" |
  xargs -0 -P "$(nproc)" -n 1 clang-tidy -p "$database" --quiet --warnings-as-errors='*' 2> >(grep -v ' warnings\? generated' >&2) ||
  exit 1
