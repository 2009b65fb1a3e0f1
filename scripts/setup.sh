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

# progress: from ninja's lines, one line every ten seconds; what is no such line (a warning, an error) passes at once.
progress() {
  local line done=0 all=? said=$SECONDS
  while true; do
    if IFS= read -r -t 1 line; then
      if [[ $line =~ ^\[([0-9]+)/([0-9]+)\]\  ]]; then
        done=${BASH_REMATCH[1]} all=${BASH_REMATCH[2]}
      else
        printf '%s\n' "$line" >&2
      fi
    elif (($? <= 128)); then  # the end; above it is a second without a line
      return
    fi
    if ((SECONDS - said >= 10)); then
      said=$SECONDS
      say "built $done of $all files"
    fi
  done
}

# build PRESET [TARGET]: says so if there is anything to do. A terminal gets ninja's one moving line, others a line
# every ten seconds.
build() {
  local folder=$root/build/$1 target=${2:-all} status=0
  if ! work_to_do "$folder" "$target"; then return; fi
  say "building ${2:-everything} (build/$1)"
  export NINJA_STATUS='[%f/%t] '
  if [[ -t 2 ]]; then
    cmake --build "$folder" --target "$target" >&2 || status=$?
  else
    cmake --build "$folder" --target "$target" 2>&1 </dev/null | progress || status=$?
  fi
  ((status == 0)) || die "the build failed"
}
