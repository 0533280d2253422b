#!/bin/bash
# Builds and checks this commit on the other Debian release, in a chroot that debootstrap makes, and compares the bytes of the
# files that the quickstart and chapter 5 write there and here.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage, as root: [RELEASE=trixie|bookworm] [ROOT=FOLDER] [MIRROR=URL] [WHOLE=1] [CHECK=no] tests/releases.sh
# RELEASE: the one of the two that this machine does not have. ROOT: build/releases/RELEASE, kept for the next time. MIRROR: where
# this machine's apt takes Debian from. WHOLE=1: every study (`make reproduce PROFILE=quick`). CHECK=no: without `make check`.
set -euo pipefail
cd "$(dirname "$0")/.."
unset MAKEFLAGS MFLAGS MAKELEVEL

stop() {
  echo "make other-release: $1" >&2
  exit 1
}

[[ $(id -u) -eq 0 ]] || stop "debootstrap and chroot need root; run: sudo make other-release"
for need in debootstrap:debootstrap unshare:util-linux git:git; do
  command -v "${need%:*}" > /dev/null || stop "${need%:*} is missing; run: apt-get install ${need#*:}"
done
[[ -z $(git status --porcelain) ]] || stop "a commit is what is compared, and there are changes beside it; commit or stash them"

# Mounts and processes belong to namespaces of their own, so that none stays behind, however the script ends.
if [[ -z ${SOILWEAVE_UNSHARED:-} ]]; then
  unshare --mount --pid --fork true 2> /dev/null || stop "this machine permits no namespaces (unshare --mount --pid); run it outside of the container"
  SOILWEAVE_UNSHARED=1 exec unshare --mount --propagation private --pid --fork --kill-child "$PWD/tests/releases.sh"
fi
mount -t proc proc /proc

# shellcheck disable=SC2016  # apt-get's dollars, not the shell's
mirror=${MIRROR:-$(apt-get indextargets --format '$(ORIGIN) $(LABEL) $(COMPONENT) $(REPO_URI)' 'Created-By: Packages' 2> /dev/null |
  awk '$1 == "Debian" && $2 == "Debian" && $3 == "main" && !n++ { print $4 }')}
[[ -n $mirror ]] || stop "apt takes no Debian from anywhere here; give an address: make other-release MIRROR=URL"
here=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
release=${RELEASE:-$([[ $here == trixie ]] && echo bookworm || echo trixie)}
[[ $release == bookworm || $release == trixie ]] || stop "RELEASE=$release: choose bookworm or trixie"
root=$(realpath -m "${ROOT:-build/releases/$release}")
jobs=${JOBS:-$(nproc)}
out=build/releases/out

# owner COMMAND: runs it here as the user who called sudo, so that built files belong to that user.
owner() {
  if [[ -n ${SUDO_USER:-} ]]; then runuser -u "$SUDO_USER" -- "$@"; else "$@"; fi
}
owner mkdir -p $out

# An incomplete root is made anew.
if [[ ! -e $root/made ]]; then
  echo "== $release: debootstrap from $mirror into $root"
  rm -rf --one-file-system "$root"
  mkdir -p "$root"
  debootstrap --variant=minbase "$release" "$root" "$mirror" > "$root.log" 2>&1 || stop "debootstrap failed: $(tail -n 1 "$root.log"); see $root.log"
  touch "$root/made"
fi
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"

# there COMMAND: runs it on the other release, in its clone, with nothing of this machine but the network.
there() {
  local -a proxies
  mapfile -t proxies < <(env | grep -iE '^(http|https|no)_proxy=')
  chroot "$root" /usr/bin/env -i "${proxies[@]}" PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive JOBS="$jobs" /bin/bash -c "cd /soilweave 2> /dev/null; $1" < /dev/null
}

there 'apt-get update -qq && apt-get install -qq -y --no-install-recommends make git ca-certificates' > "$root.log" 2>&1 ||
  stop "apt-get failed on $release: $(tail -n 1 "$root.log"); see $root.log"
# Makes a clone of this commit. Earlier builds in it are kept; results of studies are not.
clone=$root/soilweave
[[ -d $clone/.git ]] || git clone -q --no-hardlinks . "$clone"
git -C "$clone" fetch -q "$PWD" HEAD
git -C "$clone" reset -q --hard FETCH_HEAD
rm -rf "${clone:?}/$out"

echo "== $release: $(git log -1 --format='%h %s')"
SECONDS=0
if [[ -n ${WHOLE:-} ]]; then
  there "make reproduce PROFILE=quick OUT=$out"
else
  there "make deps && make -j$jobs all && make -j$jobs PROFILE=quick OUT=$out quickstart ch5-solution"
fi
echo "== $release: studies done after $SECONDS s"
echo "== $here: the same"
owner make -j"$jobs" all
owner make -j"$jobs" PROFILE=quick OUT=$out quickstart ch5-solution

# Packings, runs and tables are compared; figures and pages depend on the release's Matplotlib.
kept() {
  (cd "$1/$out" && find quickstart ch5 -type f \( -name '*.h5' -o -name '*.tsv' -o -name '*.txt' \) | LC_ALL=C sort)
}
both=$(LC_ALL=C comm -12 <(kept .) <(kept "$clone"))
differences=$(
  while IFS= read -r file; do cmp "$out/$file" "$clone/$out/$file" 2>&1 || true; done <<< "$both"
  LC_ALL=C comm -23 <(kept .) <(kept "$clone") | sed "s/\$/: on $here alone/"
  LC_ALL=C comm -13 <(kept .) <(kept "$clone") | sed "s/\$/: on $release alone/"
)
count() {
  grep -cE "$1" <<< "$both" || true
}
packings=$(count '^quickstart/packing_.*\.h5$') runs=$(count '^quickstart/triaxial_.*\.h5$') tables=$(count '^quickstart/.*\.(tsv|txt)$')
((packings > 0 && runs > 0 && tables > 0)) || stop "quickstart wrote $packings packings, $runs runs and $tables tables: nothing to compare"
compared="$packings packings, $runs runs and $tables tables of quickstart, $(count '^ch5/') files of ch5"
[[ -z $differences ]] || printf '%s\n' "$differences"

checked="; make check left out"
if [[ ${CHECK:-} != no ]]; then
  SECONDS=0
  there "make check" || stop "make check fails on $release${differences:+, and there are differences (above)}"
  checked="; make check passed there in $SECONDS s"
fi
[[ -z $differences ]] || stop "$here and $release differ in $(wc -l <<< "$differences") files, told above, of $compared$checked"
echo "make other-release: $here and $release write the same bytes: $compared$checked"
