#!/bin/bash
# Builds the unit tests for aarch64 with Debian's cross compiler and runs them under QEMU. They compare the bits of the engine with
# the bits on x86-64 (tests/unit/bits_test.cpp).
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: [ROOT=FOLDER] [JOBS=N] [GTEST_FILTER=PATTERN] tests/processors.sh
# ROOT: build/aarch64/root, kept for the next time. The libraries for aarch64 are unpacked there, so that this machine's own packages
# stay as they are.
set -euo pipefail
cd "$(dirname "$0")/.."

stop() {
  echo "make other-processor: $1" >&2
  exit 1
}

compiler=aarch64-linux-gnu-g++ emulator=qemu-aarch64-static
for need in $compiler:g++-aarch64-linux-gnu $emulator:qemu-user-static pkg-config:pkg-config parallel:parallel dpkg-deb:dpkg; do
  command -v "${need%:*}" > /dev/null || stop "${need%:*} is missing; run: apt-get install ${need#*:}"
done
root=$(realpath -m "${ROOT:-build/aarch64/root}")
libraries=(libc6-dev libstdc++6 libgomp1 libeigen3-dev libcgal-dev libhdf5-dev libcli11-dev libtomlplusplus-dev libfmt-dev libboost-math-dev
  libgsl-dev libssl-dev libgtest-dev)

# apt with lists and a status of its own sees a machine of aarch64 on which nothing is installed.
foreign_apt() {
  APT_CONFIG=$root.apt/config apt-get -qq "$@"
}

if [[ ! -e $root/made ]]; then
  echo "== aarch64: libraries into $root"
  rm -rf --one-file-system "$root" "$root.apt"
  mkdir -p "$root"/usr/{bin,lib,sbin} "$root.apt"/lists/partial "$root.apt"/cache/archives/partial
  for folder in bin lib sbin; do ln -s usr/$folder "$root/$folder"; done
  : > "$root.apt/status"
  cat > "$root.apt/config" << CONFIG
#clear APT::Architectures;
APT::Architecture "arm64";
APT::Architectures { "arm64"; };
APT::Sandbox::User "root";
Dir::State::Lists "$root.apt/lists";
Dir::State::Status "$root.apt/status";
Dir::Cache "$root.apt/cache";
Debug::NoLocking "true";
CONFIG
  foreign_apt update
  foreign_apt install -y --no-install-recommends --download-only "${libraries[@]}"
  for package in "$root.apt"/cache/archives/*.deb; do
    dpkg-deb --fsys-tarfile "$package" | tar -x --keep-directory-symlink -C "$root"
  done
  # Packages link to /lib/..., which would be this machine's folder.
  find "$root" -type l -lname '/*' -printf '%l\t%p\n' | while IFS=$'\t' read -r target link; do ln -sfn "$root$target" "$link"; done
  touch "$root/made"
fi

export PKG_CONFIG_SYSROOT_DIR=$root PKG_CONFIG_LIBDIR=$root/usr/lib/aarch64-linux-gnu/pkgconfig:$root/usr/share/pkgconfig
export CPPFLAGS="--sysroot=$root" LDFLAGS="--sysroot=$root"
make -j"${JOBS:-$(nproc)}" CXX=$compiler NO_VTK=1 EMULATOR="$emulator -L $root" test-unit
