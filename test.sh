#!/usr/bin/env bash
# Installs what is missing, builds everything and runs the tests; ctest's summary comes last.
#
#   ./test.sh                     optimised build
#   ./test.sh --debug             with assertions, AddressSanitizer and UndefinedBehaviorSanitizer
#   ./test.sh -R ResultsFile      further arguments go to ctest
#   ./test.sh --again             runs them even if they passed and nothing has changed since
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
# shellcheck source=.ci/common.sh
source "$root/.ci/common.sh"

preset=release
again=
while [[ ${1:-} == --debug || ${1:-} == --again ]]; do
  [ "$1" = --debug ] && preset=debug || again=yes
  shift
done

step "Looking for missing packages" "" bash "$root/.ci/install.sh"
configure_and_build "$preset"

# All tests passed, and no file of the project, program or test is newer than that.
passed=$root/build/$preset/tests_passed.txt
nothing_changed() {
  [ -f "$passed" ] &&
    [ -z "$(find "$root" -mindepth 1 \( -path "$root/build" -o -path "$root/.git" \) -prune -o \
      -newer "$passed" -print -quit)" ] &&
    [ -z "$(find "$root/build/$preset/bin" -newer "$passed" -print -quit)" ]
}

if [ $# -eq 0 ] && [ -z "$again" ] && nothing_changed; then
  say "Nothing has changed since all tests passed ($preset); ./test.sh --again runs them again"
  cat "$passed"
  exit 0
fi

say "Testing ($preset)"
cd "$root"
if [ $# -gt 0 ]; then exec ctest --preset "$preset" --parallel 2 "$@"; fi
rm -f "$passed"
log=$root/build/$preset/ctest.log
touch "$log.start"
ctest --preset "$preset" --parallel 2 2>&1 | tee "$log"
grep -A2 'tests passed' "$log" >"$passed"
touch -r "$log.start" "$passed"  # what changed while the tests ran is newer
