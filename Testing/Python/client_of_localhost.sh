#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs a client of a server on this machine. The server gives the name of the machine, which may not be known
# here; on a bare Debian without /etc/hosts not even localhost is.
#   client_of_localhost.sh --url=cs://<name>:<port> <client> [<argument>...]     as smTestDriver calls it
set -euo pipefail

port="${1##*:}"
client="$2"
shift 2
exec "$client" "--url=cs://127.0.0.1:$port" "$@"
