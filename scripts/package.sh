#!/usr/bin/env bash
# A .deb of the program: scripts/package.sh [FOLDER]   (default out; ./run package installs first and calls this)
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

folder=${1:-$root/out}
configure package
build package all
rm -f "$root"/build/package/gbufferlab_*.deb
(cd "$root/build/package" && quietly "packing" cpack -G DEB)
mkdir -p "$folder"
for package in "$root"/build/package/gbufferlab_*.deb; do
  cp "$package" "$folder/"
  say "$folder/$(basename "$package"): install it with apt install ./$(basename "$package")"
done
