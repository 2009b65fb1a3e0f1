#!/usr/bin/env bash
# scripts/prove_fresh_debian.sh [--package] [FOLDER]: proves by hand that packages.txt, ./run and ./test are enough on a minimal
# Debian 12: no display, no sudo, no git, no compiler. It lays such a system into FOLDER (new or empty, and kept;
# else a temporary one, removed) from the Debian mirror that this machine's apt uses, copies a clean clone of HEAD
# into it and runs there: ./run render --sheet -o out, the same again offline, ./test, ./run package. The package is then installed
# in a second such system, and draws there as another user, without a source folder. --package: that alone. Fails loudly at the
# first step that does. Needs root, debootstrap and git here; about 2 GB of disk.
set -euo pipefail

release=bookworm
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { echo "prove_fresh_debian: $*"; }

die() {
  say "FAILED: $*" >&2
  exit 1
}

# timed WHAT COMMAND...
timed() {
  local what=$1 start=$SECONDS
  shift
  say "$what ..."
  "$@" || die "$what (after $((SECONDS - start)) s, exit code $?)"
  times+=("$(printf '%5d s  %s' $((SECONDS - start)) "$what")")
}

# Lines "SITE SUITE" of the Debian archives apt is configured with, the main one first.
apt_suites() {
  # shellcheck disable=SC2016  # apt's own placeholders
  apt-get indextargets --format '$(SITE) $(RELEASE) $(COMPONENT) $(ORIGIN)' 'Created-By: Packages' |
    awk -v r="$release" '$3 == "main" && $4 == "Debian" && ($2 == r || $2 ~ "^" r "-(updates|security)$") { print $1, $2 }' |
    sort --unique --key=2,2
}

# How apt here reaches its mirror: proxies, dates, retries, certificates; nothing of what is installed or pinned.
copy_apt_settings() {
  local suite site file
  apt-config dump | grep '^Acquire::' | grep --invert-match '^Acquire::IndexTargets' >"$system/etc/apt/apt.conf.d/00host"
  while read -r site suite; do echo "deb $site $suite main"; done <<<"$suites" >"$system/etc/apt/sources.list"
  for file in /etc/resolv.conf /etc/hosts; do cp --dereference "$file" "$system$file"; done
  cp --no-clobber /etc/apt/trusted.gpg.d/* "$system/etc/apt/trusted.gpg.d/" 2>/dev/null || true
  while read -r file; do
    if [[ -f $file ]]; then install -D --mode=644 "$file" "$system$file"; fi
  done < <(apt-config dump | sed -n 's/^Acquire::http.*"\(\/.*\)";$/\1/p')
  if [[ $suites == *https:* ]]; then
    mkdir -p "$system/etc/ssl/certs"
    cp --dereference /etc/ssl/certs/ca-certificates.crt "$system/etc/ssl/certs/"
  fi
}

# A package's daemon must not start in there, and apt's own user must be able to enter.
settle_system() {
  copy_apt_settings
  printf '#!/bin/sh\nexit 101\n' >"$system/usr/sbin/policy-rc.d"
  chmod 755 "$system" "$system/usr/sbin/policy-rc.d"
  mount -t proc proc "$system/proc"
  mount --rbind /dev "$system/dev"
}

lay_system() {
  local proxy='' mirror
  read -r mirror _ <<<"$suites"
  eval "$(apt-config shell proxy Acquire::http::Proxy)"
  if [[ -n $proxy && $proxy != DIRECT ]]; then export http_proxy=$proxy; fi
  debootstrap --variant=minbase "$release" "$system" "$mirror" >"$log" 2>&1 || {
    tail -n 20 "$log" >&2
    return 1
  }
}

inside() {
  "${network[@]}" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 ${http_proxy:+http_proxy="$http_proxy"} \
    chroot "$system" /bin/bash -c 'cd /home/gbufferlab && exec "$@"' bash "$@" </dev/null
}

package_only=
if [[ ${1:-} == --package ]]; then
  package_only=--package
  shift
fi
# Everything from here on sees mounts and processes of its own: they are gone with the script, however it ends.
if [[ ${1:-} != --inside-namespace ]]; then
  ((EUID == 0)) || die "needs root: it mounts and changes root"
  for tool in debootstrap git unshare; do command -v "$tool" >/dev/null || die "needs $tool: apt-get install $tool"; done
  if [[ -n ${1:-} && -n $(ls -A "$1" 2>/dev/null) ]]; then die "$1 is not empty: a fresh system needs a fresh folder"; fi
  if [[ -n ${1:-} ]]; then
    mkdir -p "$1"
    system=$(cd "$1" && pwd)
  else
    system=$(mktemp -d -t gbufferlab-debian.XXXXXX)
    trap 'rm -rf --one-file-system "$system" "$system.bare"' EXIT
  fi
  unshare --mount --propagation private --pid --fork --mount-proc --kill-child "${BASH_SOURCE[0]}" --inside-namespace "$system" $package_only
  exit
fi

system=$2
package_only=${3:-}
times=()
network=()
log=$system.log
trap 'rm -f "$log"' EXIT
suites=$(apt_suites)
[[ $suites == *" $release"* ]] || die "apt here has no Debian $release source, or apt-get update has not been run"
if [[ -n $(git -C "$root" status --porcelain) ]]; then say "note: HEAD is proved; changes that are not committed are not in it"; fi

timed "debootstrap $release, minbase" lay_system
cp -a "$system" "$system.bare"
settle_system
git clone --quiet --depth 1 "file://$root" "$system/home/gbufferlab"

if [[ -z $package_only ]]; then
  timed "./run render --sheet -o out: packages, build, picture" inside ./run render --sheet -o out
  sheet=$system/home/gbufferlab/out/sheet.png
  [[ $(head -c 4 "$sheet" | tail -c 3) == PNG ]] || die "out/sheet.png is missing or no PNG"
  rm "$sheet"
  network=(unshare --net)
  timed "the same again, without a network" inside ./run render --sheet -o out
  network=()
  timed "./test" inside ./test
fi
timed "./run package" inside ./run package

built=$(echo "$system"/home/gbufferlab/out/gbufferlab_*.deb)
system=$system.bare
settle_system
mkdir "$system/home/gbufferlab"
cp "$built" "$system/home/gbufferlab/"
name=./$(basename "$built")
timed "apt-get update in a bare system" inside apt-get -qq update
timed "apt-get install $name there" inside apt-get -qq --no-install-recommends install --yes "$name"
inside useradd --create-home student
timed "a picture drawn by another user" inside su student -c 'cd && gbufferlab render --only final -o pictures && gbufferlab list presets >/dev/null'
picture=$system/home/student/pictures/final.png
[[ $(head -c 4 "$picture" | tail -c 3) == PNG ]] || die "pictures/final.png is missing or no PNG"
left=$(cd "$system/home/student" && find . -newer "$system/home/gbufferlab/$name" -type f | sort)
say "that user's files now: $left"

say "a minimal Debian $release runs the lab; packages.txt is complete, and so is what the package depends on"
printf '%s\n' "${times[@]}"
