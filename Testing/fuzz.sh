#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Sets everything up and looks for inputs on which searches go wrong: for leaves, then for points.
#   Testing/fuzz.sh [SECONDS] [arguments of libFuzzer]     60 seconds for each by default
# Inputs of interest are kept in build/fuzz/corpus, those that fail in build/fuzz.
set -euo pipefail

root="$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")"
[[ "${1:-}" != -h && "${1:-}" != --help ]] || exec "$root/Plugin/usage.sh" "$0"
build="$root/build/fuzz"

seconds=60
if [[ "${1:-}" =~ ^[1-9][0-9]*$ ]]; then
  seconds="$1"
  shift
fi

"$root/Plugin/setup.sh" --fuzz
start="$(mktemp)"
trap 'rm -f "$start"' EXIT
for search in LeafSearch PointSearch; do
  program="$build/bin/Fuzz$search"
  mkdir -p "$build/corpus/$search"
  status=0
  "$program" -max_total_time="$seconds" -max_len=512 -timeout=20 -artifact_prefix="$build/" \
    "$@" "$build/corpus/$search" "$root/Testing/Fuzz/Corpus/$search" || status=$?
  find "$build" -maxdepth 1 -newer "$start" \
    \( -name 'crash-*' -o -name 'leak-*' -o -name 'oom-*' -o -name 'timeout-*' \) \
    -exec printf 'To replay: %q %q\n' "$program" {} \; >&2
  [[ "$status" == 0 ]] || exit "$status"
done
