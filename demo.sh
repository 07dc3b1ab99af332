#!/usr/bin/env bash
# Installs what is missing, builds the program and shakes the four-storey building once.
#
#   ./demo.sh                                    the building and record below, 40 s of it
#   ./demo.sh --layout column --pga "0.4 g"      further arguments go to `dougong run` and win over those
#   ./demo.sh scenario.toml --pga "0.4 g"        a scenario file of your own, named first
#
# Exit code 0: the run has a verdict on the building, whichever it is (survived, collapsed, undecided).
# 20: the numbers failed, so there is no verdict. 2: the arguments were wrong. Anything else: a step failed,
# and its name is printed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
# shellcheck source=.ci/common.sh
source "$root/.ci/common.sh"

given() {  # is this option among the arguments?
  local option=$1 word
  shift
  for word in "$@"; do
    case $word in "$option" | "$option"=*) return 0 ;; esac
  done
  return 1
}

step "Looking for missing packages" "" bash "$root/.ci/install.sh"
configure_and_build release --target dougong

# What the demo runs where the arguments do not say otherwise. Of two --set the last one wins.
defaults=()
if [ $# -eq 0 ] || [[ $1 == -* ]]; then  # no scenario file
  given --layout "$@" || defaults+=(--layout four-storey)
  given --record "$@" || defaults+=(--record wenchuan)
  given --pga "$@" || defaults+=(--pga "0.4 g")
  defaults+=(--set solve.duration="40 s")
fi
given --out "$@" || defaults+=(--out "$root/build/demo" --force)
arguments=("${defaults[@]}" "$@")

program=$root/build/release/bin/dougong
say "Running: dougong run$(printf ' %q' "${arguments[@]}")"
code=0
"$program" run "${arguments[@]}" || code=$?

case $code in
  0) meaning="0: the building survived" ;;
  10) meaning="10: the building collapsed" ;;
  30) meaning="30: undecided, for what follows the end of the run is open" ;;
  20) meaning="20: the numbers failed, so nothing is said about the building" ;;
  2) meaning="2: the input was wrong, as the message above says; nothing was run" ;;
  *) meaning="$code: it failed, and its message is above" ;;
esac
say "dougong run returned $meaning"
case $code in 0 | 10 | 30) ;; *) exit "$code" ;; esac
