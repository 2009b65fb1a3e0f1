#!/usr/bin/env bash
# Draws twelve small pictures with every driver that this machine has, and judges them by the reference:
# scripts/drivers.sh [FOLDER]   (default build/drivers; ./test drivers builds first and calls this)
# One report a driver, and table.md of them all. Exit 0: whatever was drawn holds.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
program=$root/build/ci/gbufferlab
folder=${1:-$root/build/drivers}
mkdir -p "$folder"
failed=0
files=()

# draw NAME DEVICE [VARIABLE=VALUE...] [-- OPTION...]: DEVICE is part of what the driver calls itself. Where Mesa cannot load
# a driver it takes another one, which is not what was asked for.
draw() {
  local name=$1 device=$2 variables=()
  shift 2
  while (($# > 0)) && [[ $1 != -- ]]; do
    variables+=("$1")
    shift
  done
  if (($# > 0)); then shift; fi
  echo "== $name"
  local said status=0
  said=$(env "${variables[@]}" "$program" info 2>&1) || status=$?
  if ((status == 3)) || { ((status == 0)) && ! grep -q "^device .*$device" <<<"$said"; }; then  # 3: no usable GL
    echo "skipped: it cannot be loaded here"
    return
  fi
  env "${variables[@]}" "$program" info --report "$folder/$name.json" "$@" || failed=1
  if [[ -e $folder/$name.json ]]; then
    files+=("$folder/$name.json")
  else
    echo "$name wrote no report"
    failed=1
  fi
}

rm -f "$folder"/*.json
software=(LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe)
draw llvmpipe llvmpipe "${software[@]}"
for feature in debug-labels timer-query depth-clamp clip-control compute tessellation; do
  draw "llvmpipe-without-$feature" llvmpipe "${software[@]}" -- --without "$feature"
done
draw llvmpipe-gl-3.3 llvmpipe "${software[@]}" MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330
draw llvmpipe-gles-3 llvmpipe "${software[@]}" -- --gl es3
draw softpipe softpipe LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=softpipe
lavapipe=$(find /usr/share/vulkan/icd.d -name 'lvp_icd*.json' 2>/dev/null | head -n 1 || true)
if [[ -n $lavapipe ]]; then
  draw zink-on-lavapipe zink LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=zink VK_ICD_FILENAMES="$lavapipe"
else
  echo "== zink-on-lavapipe: skipped, there is no lavapipe here (mesa-vulkan-drivers)"
fi
if ! "$program" info | grep "^device .*llvmpipe" >/dev/null; then draw this-machine .; fi
"$program" info --table "${files[@]}" | tee "$folder/table.md"
exit "$failed"
