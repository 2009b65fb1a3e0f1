#!/bin/sh
# Fuzzes the glTF loader: scripts/fuzz_gltf.sh [SECONDS]   (default 60; needs clang and its sanitizers)
# Built in build/fuzz with clang's fuzzer, address and undefined-behaviour sanitizers. The first corpus is made by
# our own code; what the fuzzer finds new is kept in build/fuzz/corpus for the next run. Exit 0: no crash in that time.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
seconds=${1:-60}
command -v clang++ >/dev/null || { echo "skipped: no clang++ here; install clang and libclang-rt-dev"; exit 77; }
build=$root/build/fuzz
mkdir -p "$build/corpus" "$build/crashes"
cd "$build"

# Errors that the loader throws are caught by type across files: one set of flags for all of them.
flags="-std=c++20 -g -O1 -ffp-contract=off -I$root -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined"
sources="$root/renderer/gltf/*.cpp $root/renderer/scene/*.cpp $root/renderer/base/error.cpp
  $root/tests/gltf/gltf_fixture.cpp $root/tests/gltf/gltf_seeds.cpp
  $root/tests/gltf/fuzz/gltf_fuzz.cpp $root/tests/gltf/fuzz/make_seeds.cpp"
objects=
for source in $sources; do
  object=$(basename "$source" .cpp).o
  # Headers are not tracked; they are few, and a stale object would fuzz yesterday's code.
  if [ ! -e "$object" ] || [ -n "$(find "$source" "$root"/renderer/base/*.h "$root"/renderer/scene/*.h "$root"/renderer/gltf/*.h "$root"/tests/gltf/*.h -newer "$object" | head -n 1)" ]; then
    # shellcheck disable=SC2086
    clang++ $flags -c "$source" -o "$object"
  fi
  case $object in gltf_fuzz.o | make_seeds.o) ;; *) objects="$objects $object" ;; esac
done
# shellcheck disable=SC2086
clang++ -fsanitize=address,undefined make_seeds.o $objects -o make_seeds -lfmt -lpthread
# shellcheck disable=SC2086
clang++ -fsanitize=fuzzer,address,undefined gltf_fuzz.o $objects -o gltf_fuzz -lfmt -lpthread

./make_seeds "$build/corpus"
./gltf_fuzz -max_total_time="$seconds" -max_len=16384 -timeout=10 -rss_limit_mb=3000 -print_final_stats=1 \
  -dict="$root/tests/gltf/fuzz/gltf.dict" -artifact_prefix="$build/crashes/" "$build/corpus"
