# shellcheck shell=bash
# Set-up shared by ./run and ./test, which source it: packages, configure, build.
# It speaks on stderr only, so that stdout belongs to the program; it fails with 4, "could not finish".

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { echo "gbufferlab: $*" >&2; }

die() {
  say "$@"
  exit 4
}

# quietly WHAT COMMAND...: its output is shown only if it fails.
quietly() {
  local what=$1 output
  shift
  if ! output=$("$@" 2>&1 </dev/null); then
    printf '%s\n' "$output" >&2
    die "$what failed: $*"
  fi
}

# packages SECTION...: the names in these sections of packages.txt.
packages() {
  awk -v wanted=" $* " '{ sub(/#.*/, "") } /^\[/ { on = index(wanted, " " substr($1, 2, length($1) - 2) " ") } !/^\[/ && on && NF { print $1 }' \
    "$root/packages.txt"
}

# missing NAME...: those of the packages that are not installed.
missing() {
  local name status
  declare -A installed=()
  while read -r name status; do
    if [[ $status == installed ]]; then installed[$name]=yes; fi
  done < <(dpkg-query --show --showformat '${Package} ${db:Status-Status}\n' "$@" 2>/dev/null)
  for name in "$@"; do
    if [[ -z ${installed[$name]:-} ]]; then echo "$name"; fi
  done
}

# install SECTION...: everything in these sections of packages.txt. Asks nothing of the network when all is there.
install() {
  local wanted needed as_root=()
  mapfile -t wanted < <(packages "$@")
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    die "there is no apt here; install what packages.txt names, then: cmake --preset release && cmake --build --preset release"
  fi
  mapfile -t needed < <(missing "${wanted[@]}")
  if ((${#needed[@]} == 0)); then return; fi

  if ((EUID != 0)); then
    command -v sudo >/dev/null || die "packages are missing and there is no sudo; as root: apt-get install --no-install-recommends ${needed[*]}"
    as_root=(sudo)
  fi
  as_root+=(env DEBIAN_FRONTEND=noninteractive)
  say "installing ${needed[*]}"
  quietly "reading the package lists" "${as_root[@]}" apt-get -o DPkg::Lock::Timeout=120 update
  quietly "installing packages" "${as_root[@]}" apt-get -o DPkg::Lock::Timeout=120 install --yes --no-install-recommends "${needed[@]}"
}

# configure PRESET: anew where that has not been done, the presets have changed since, or the folder was moved;
# else ninja looks whether a CMakeLists.txt or the list of sources has changed.
configure() {
  local folder=$root/build/$1 stamp=$root/build/$1/.configured
  if [[ -e $folder/build.ninja && $stamp -nt $root/CMakePresets.json && $(<"$stamp") == "$root" ]]; then
    quietly "configuring" ninja -C "$folder" build.ninja
    return
  fi
  say "configuring build/$1"
  quietly "configuring" cmake -S "$root" --preset "$1" --fresh
  echo "$root" >"$stamp"
}

# work_to_do FOLDER TARGET: a dry run. It goes through a manifest that only includes the real one, because a dry run
# of the real one pretends to configure again and then stops.
work_to_do() {
  local planned
  planned=$(ninja -C "$1" -f /dev/stdin -n "$2" <<<"include build.ninja" 2>&1) || true
  [[ $planned != *"no work to do"* ]]
}

# build PRESET [TARGET]: one line says so if there is anything to do; a terminal also gets ninja's one moving line.
build() {
  local folder=$root/build/$1 target=${2:-all} quiet=(--quiet)
  if ! work_to_do "$folder" "$target"; then return; fi
  say "building ${2:-everything} (build/$1)"
  if [[ -t 2 ]]; then quiet=(); fi
  NINJA_STATUS='[%f/%t] ' cmake --build "$folder" --target "$target" -- "${quiet[@]}" >&2 || die "the build failed"
}
