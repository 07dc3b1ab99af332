#!/usr/bin/env bash
# Installs those Debian packages of packages.txt that are missing. Does nothing when none is.
# DOUGONG_SKIP_INSTALL=1 leaves the packages to you.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
list=$here/packages.txt

fail() {
  printf '\nInstalling what is needed failed: %s\n' "$*" >&2
  exit 1
}

is_installed() { [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

# The first of the alternatives when none is installed, else nothing.
missing_of() {
  local package
  for package in "$@"; do
    if is_installed "$package"; then return; fi
  done
  echo "$1"
}

missing_packages() {
  local line words
  while read -r line; do
    read -ra words <<<"${line//|/ }"
    missing_of "${words[@]}"
  done < <(grep -vE '^[[:space:]]*(#|$)' "$list")
}

if [ "${DOUGONG_SKIP_INSTALL:-}" = 1 ]; then
  echo "Packages are left to you (DOUGONG_SKIP_INSTALL=1)."
  exit 0
fi
for tool in dpkg-query apt-get; do
  command -v "$tool" >/dev/null || fail "$tool is not here, so this is not Debian or a relative of it.
Install the equivalents of the packages in $list, then start again with DOUGONG_SKIP_INSTALL=1."
done

mapfile -t missing < <(missing_packages)
if [ ${#missing[@]} -eq 0 ]; then
  echo "Every package in .ci/packages.txt is installed."
  exit 0
fi
echo "Missing: ${missing[*]}"

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || fail "you are not root and sudo is not here. Let an administrator run:
  apt-get install --no-install-recommends ${missing[*]}"
  as_root=(sudo)
  # Without a terminal nobody can type a password.
  [ -t 0 ] || as_root+=(-n)
fi
apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 "$@"; }

echo "Installing with: ${as_root[*]:+${as_root[*]} }apt-get install ${missing[*]}"
apt update -o APT::Update::Error-Mode=any ||
  echo "The package lists could not be refreshed (no network?); going on with the ones that are here." >&2
apt install -y --no-install-recommends "${missing[@]}" ||
  fail "apt-get could not install: ${missing[*]}
Its messages above say why: no network, no right to install, or a release that lacks a package (Debian 12 has all)."
