#!/usr/bin/env bash
# Installs what is missing, builds everything and runs the tests; ctest's summary comes last.
#
#   ./test.sh                     optimised build
#   ./test.sh --debug             with assertions, AddressSanitizer and UndefinedBehaviorSanitizer
#   ./test.sh -R ResultsFile      further arguments go to ctest
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
# shellcheck source=.ci/common.sh
source "$root/.ci/common.sh"

preset=release
if [ "${1:-}" = --debug ]; then
  preset=debug
  shift
fi

step "Looking for missing packages" "" bash "$root/.ci/install.sh"
configure_and_build "$preset"
say "Testing ($preset)"
cd "$root"
exec ctest --preset "$preset" --parallel 2 "$@"
