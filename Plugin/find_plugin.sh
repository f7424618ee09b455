#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Prints the path of the plugin that Plugin/setup.sh has built.
#   Plugin/find_plugin.sh
set -euo pipefail
shopt -s nullglob

root="$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")"
found=("$root"/build/lib/paraview-*/plugins/HashedOctree/HashedOctree.so) # one for each version of ParaView
if ((${#found[@]} == 0)); then
  echo "error: no plugin in $root/build/lib; build it with Plugin/setup.sh" >&2
  exit 1
elif ((${#found[@]} > 1)); then
  echo "error: more than one plugin, remove all but one of: ${found[*]}" >&2
  exit 1
fi
printf '%s\n' "${found[0]}"
