#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs a command with a virtual display of its own.
#   Plugin/with_display.sh COMMAND [ARGUMENT ...]
# Not xvfb-run: its Xvfb starts anew whenever the last window closes, and refuses the next one
# meanwhile; and two of them at a time may take the same display. Neither Ctrl-C nor SIGTERM takes the
# display from a command that still has to tidy up: Xvfb has a session of its own, and is ended last.
set -euo pipefail

exec {numbers}< <(exec setsid Xvfb -displayfd 1 -noreset -nolisten tcp -screen 0 1920x1200x24 2>/dev/null)
server=$!
trap 'kill "$server" 2>/dev/null || true' EXIT # it may have ended by itself
trap 'exit 143' TERM                           # which is when the command has ended
read -r -u "$numbers" number || {
  echo "error: Xvfb did not start; is the package xvfb installed?" >&2
  exit 1
}
DISPLAY=":$number" "$@"
