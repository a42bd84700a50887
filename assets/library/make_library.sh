#!/usr/bin/env bash
# Makes library.tactspace.json anew: about eighty candidates, and of these the forty most distinct.
#     assets/library/make_library.sh build/release/tactspace
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
candidates=$(mktemp --suffix .tactspace.json)
trap 'rm -f "$candidates"' EXIT
python3 "$here/candidates.py" >"$candidates"
"$1" subset "$candidates" -k 40 --time-limit 300 --out "$here/library.tactspace.json"
