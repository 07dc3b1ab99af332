# shellcheck shell=bash disable=SC2154
# Shared by demo.sh, test.sh and .ci/: steps that say what they do and, when they fail, which one it was.
# To be sourced, after `set -euo pipefail`, by a script that has set `root` to the project's folder.

say() { printf '\n== %s\n' "$*"; }

fail() {
  printf '\n%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# step "Doing this" "what to look at when it fails" command arguments ...
step() {
  local name=$1 hint=$2
  shift 2
  say "$name"
  "$@" || fail "this step failed: $name.${hint:+ $hint}"
}

# configure_and_build PRESET [further arguments of cmake --build]
configure_and_build() {
  local preset=$1 cache="$root/build/$1/CMakeCache.txt" fresh=()
  shift
  # A build folder that was moved or copied along with the project holds paths of the old place.
  if [ -f "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then fresh=(--fresh); fi
  step "Configuring ($preset)" "CMake's message above says what it missed." \
    cmake -S "$root" --preset "$preset" "${fresh[@]}" --log-level=WARNING
  step "Building ($preset) in $root/build/$preset" "The compiler's first error is the one to read." \
    cmake --build "$root/build/$preset" --parallel "$(nproc)" "$@"
}
