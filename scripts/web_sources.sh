#!/usr/bin/env bash
# Sources of the libraries that the page is made of: scripts/web_sources.sh FOLDER   (scripts/web.sh calls this)
# They come as Debian's own, read from where this machine's packages come from; nothing of this machine's apt is changed.
# Exit 4: they cannot be had here.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

parts=$1

# fetch_sources NAME...: the upstream archives of these source packages, into $parts/archives.
fetch_sources() {
  local apt=$parts/apt file
  mkdir -p "$apt/parts" "$apt/lists/partial" "$parts/archives"
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    if [[ -e $file ]]; then sed -n 's/^deb /deb-src /p' "$file" >"$apt/parts/$(basename "$file" .list).list"; fi
  done
  for file in /etc/apt/sources.list.d/*.sources; do
    if [[ -e $file ]]; then sed 's/^Types:.*/Types: deb-src/' "$file" >"$apt/parts/$(basename "$file")"; fi
  done
  local options=(-o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$apt/parts" -o "Dir::State::lists=$apt/lists"
    -o APT::Sandbox::User=root)
  quietly "reading the lists of sources" apt-get "${options[@]}" update
  # A package's own changes may have moved on; the upstream archive is what is wanted.
  (cd "$parts/archives" && apt-get "${options[@]}" source --download-only "$@" >/dev/null 2>&1) || true
}

# unpack NAME PATTERN: the one archive of this name, as $parts/NAME.
unpack() {
  local archive
  archive=$(find "$parts/archives" -name "$2" | sort | tail -n 1)
  [[ -n $archive ]] || die "the source of $1 could not be had; the program itself does not need it: ./run"
  rm -rf "${parts:?}/$1"
  mkdir -p "$parts/$1"
  tar -xf "$archive" -C "$parts/$1" --strip-components=1
}

if [[ ! -e $parts/complete ]]; then
  say "fetching the sources of libraries"
  fetch_sources imgui meshoptimizer libpng1.6 zlib
  unpack imgui 'imgui_*.orig.tar.*z'
  unpack meshoptimizer 'meshoptimizer_*.orig.tar.*z'
  unpack png 'libpng1.6_*.orig.tar.*z'
  unpack zlib 'zlib_*.orig.tar.*z*'
  cp "$parts/png/scripts/pnglibconf.h.prebuilt" "$parts/png/pnglibconf.h"
  # Headers alone, by links: the folder of all headers would bring this machine's C library.
  mkdir -p "$parts/include"
  for header in glm nlohmann fmt CLI stb tiny_gltf.h stb/stb_image.h stb/stb_image_write.h; do
    ln -sfn "/usr/include/$header" "$parts/include/$(basename "$header")"
  done
  touch "$parts/complete"
fi
