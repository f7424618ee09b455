#!/usr/bin/env bash
# SPDX-FileCopyrightText: HashedOctree contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Sets everything up and runs all tests: first with the sanitizers, then all with ctest.
#   Testing/run.sh [--quick] [arguments of ctest]     --quick leaves the sanitizers out
set -euo pipefail

root="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
failed=()
# GCC 12's thread sanitizer cannot start where the kernel spreads memory at random over too wide a range.
fixed_layout=()
! setarch -R true 2>/dev/null || fixed_layout=(setarch -R)

run_ctest() {
  local build="$1"
  shift
  "${fixed_layout[@]}" /usr/bin/ctest --test-dir "$build" --no-tests=error --schedule-random --output-on-failure -j2 "$@"
}

run_sanitized() {
  "$root/Plugin/setup.sh" --sanitize "$1"
  echo "Testing with the $1 sanitizer"
  run_ctest "$root/build/$2" --label-regex 'core|vtk' || failed+=("$1 sanitizer")
}

quick=no
if [[ "${1:-}" == --quick ]]; then
  quick=yes
  shift
fi

"$root/Plugin/setup.sh" --tests
if [[ $quick == no ]]; then
  run_sanitized address asan
  run_sanitized thread tsan
fi
run_ctest "$root/build" "$@" || failed+=(ctest)
if ((${#failed[@]})); then
  printf 'error: failed: %s\n' "${failed[*]}" >&2
  exit 1
fi
