#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Prints the comment at the head of a script.
#   Plugin/usage.sh SCRIPT
set -euo pipefail
sed -n '4,/^[^#]/s/^# \{0,1\}//p' "$1"
