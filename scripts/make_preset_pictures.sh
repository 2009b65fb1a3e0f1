#!/usr/bin/env bash
# The pictures of docs/presets.md: one sheet per preset of a source, and the packing of its G-buffer. Run by hand after
# a change that shows: scripts/make_preset_pictures.sh
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

configure release
build release gbufferlab
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
for preset in nclgl stereo learnopengl-a learnopengl-b learnopengl objectid viewspace; do
  "$root/build/release/gbufferlab" render --preset "$preset" --size 480x270 --sheet -o "$out" > /dev/null
  # 256 colours are enough for a page, and a fifth of the bytes.
  convert "$out/sheet.png" -strip -colors 256 "PNG8:$root/docs/images/preset_$preset.png"
  cp "$out/packing.svg" "$root/docs/images/packing_$preset.svg"
done
rm -f "$root"/docs/images/packing_learnopengl-[ab].svg  # the same as stage c's
