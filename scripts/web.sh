#!/usr/bin/env bash
# Builds the lab as one HTML file: scripts/web.sh [FILE]   (default out/gbufferlab.html; ./run web installs first and calls this)
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

page=${1:-$root/out/gbufferlab.html}
folder=$root/build/web
parts=$folder/parts
export NODE_PATH=/usr/share/nodejs  # Debian's acorn is there, and other builds of node do not look

"$root/scripts/web_sources.sh" "$parts"
font=$(find /usr/share/fonts -name DejaVuSans.ttf | head -n 1)
say "building the page"
quietly "configuring the page" emcmake cmake -S "$root/web" -B "$folder" -G Ninja -DGBL_PARTS="$parts" -DGBL_FONT="$font"
cmake --build "$folder" 2>&1 </dev/null | progress
mkdir -p "$(dirname "$page")"
cp "$folder/gbufferlab.html" "$page"
say "$page: $(stat -c %s "$page") bytes, $(gzip -c "$page" | wc -c) gzipped"
