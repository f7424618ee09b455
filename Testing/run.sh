#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Sets everything up and runs all tests: first with the sanitizers, where these apply, then all without.
#   Testing/run.sh [--quick] [arguments of ctest]     --quick leaves the sanitizers out
# The arguments go to every ctest. Those with a sanitizer may then find no test, as with -L python.
set -euo pipefail

root="$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")"
[[ "${1:-}" != -h && "${1:-}" != --help ]] || exec "$root/Plugin/usage.sh" "$0"
failed=()
# GCC 12's thread sanitizer cannot start where the kernel spreads memory at random over too wide a range.
fixed_layout=()
! setarch -R true 2>/dev/null || fixed_layout=(setarch -R)

quick=no
arguments=()
for argument in "$@"; do
  if [[ "$argument" == --quick ]]; then
    quick=yes
  else
    arguments+=("$argument")
  fi
done

run_ctest() {
  local build="$1" no_tests="$2"
  shift 2
  "${fixed_layout[@]}" /usr/bin/ctest --test-dir "$build" --no-tests="$no_tests" --schedule-random \
    --output-on-failure -j2 "$@" "${arguments[@]}"
}

run_sanitized() {
  local no_tests=error
  ((${#arguments[@]} == 0)) || no_tests=ignore
  "$root/Plugin/setup.sh" --sanitize "$1"
  echo "Testing with the $1 sanitizer"
  run_ctest "$root/build/$2" "$no_tests" --label-regex 'core|vtk' || failed+=("$1 sanitizer")
}

"$root/Plugin/setup.sh" --tests
if [[ $quick == no ]]; then
  run_sanitized address asan
  run_sanitized thread tsan
fi
run_ctest "$root/build" error || failed+=(ctest)
if ((${#failed[@]})); then
  printf 'error: failed: %s\n' "${failed[*]}" >&2
  exit 1
fi
