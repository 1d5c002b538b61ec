#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing from Debian's packages and configures build/. Sourced by quickstart.sh and test.sh.
set -euo pipefail  # for the sourcing script, too
cd "$(dirname "${BASH_SOURCE[0]}")/.."

packages=(g++ cmake make git pkg-config ca-certificates
  libopenmpi-dev openmpi-bin libhdf5-openmpi-dev libeigen3-dev libboost-program-options-dev libsqlite3-dev
  libgtest-dev libgmock-dev libfmt-dev nlohmann-json3-dev libxxhash-dev "${more_packages[@]}")

missing=()
for package in "${packages[@]}"; do
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ]; then
  if [ "$(id -u)" -ne 0 ]; then
    echo "These Debian packages are missing. Install them, then run this script again:" >&2
    echo "  sudo apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  echo "== installing ${missing[*]}"
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -qq
  apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
fi

# build TARGET ...: configures build/ (Release, this machine's instructions) and builds the targets.
build() {
  cmake -S . -B build -DCMAKE_BUILD_TYPE=Release >build.log.tmp 2>&1 || { cat build.log.tmp >&2; exit 1; }
  mv build.log.tmp build/configure.log
  cmake --build build --parallel "$(nproc)" --target "$@"
}
