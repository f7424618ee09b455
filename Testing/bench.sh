#!/usr/bin/env bash
# SPDX-FileCopyrightText: HashedOctree contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Sets everything up and runs one benchmark.
#   Testing/bench.sh NAME [arguments of Google Benchmark]
set -euo pipefail

root="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
declare -A benchmarks=([build]=BenchmarkOctreeBuild)

name="${1:-}"
if [[ -z "$name" || -z "${benchmarks[$name]:-}" ]]; then
  printf 'error: no benchmark "%s"; there is: %s\n' "$name" "${!benchmarks[*]}" >&2
  exit 1
fi
shift
"$root/Plugin/setup.sh" --benchmarks
exec "$root/build/bin/${benchmarks[$name]}" "$@"
