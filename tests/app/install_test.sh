#!/usr/bin/env bash
# The program where it is installed: install_test.sh BUILD_FOLDER. Every file in its place under any prefix, and the program runs
# from another working folder.
set -euo pipefail

build=$1
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
cmake --install "$build" --prefix "$prefix" >/dev/null
for file in bin/gbufferlab share/man/man1/gbufferlab.1 share/bash-completion/completions/gbufferlab \
  share/applications/gbufferlab.desktop share/icons/hicolor/scalable/apps/gbufferlab.svg share/doc/gbufferlab/copyright; do
  [[ -s $prefix/$file ]] || { echo "not installed: $file"; exit 1; }
done
cd /
presets=$("$prefix/bin/gbufferlab" list presets)
[[ $presets == *exact* ]] || { echo "the installed program lists no presets: $presets"; exit 1; }
run=$(sed -n 's/^Exec=\([^ ]*\).*/\1/p' "$prefix/share/applications/gbufferlab.desktop")
[[ -x $prefix/bin/$run ]] || { echo "the desktop entry starts '$run'"; exit 1; }
