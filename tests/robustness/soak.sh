#!/usr/bin/env bash
# One live session that loads, computes, draws, saves and restores for so many minutes, and whose memory must
# stay flat: `tests/robustness/soak.sh 10`. Fails if the second half needs a tenth more than the first.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/app/setup.sh"
answer_help "$@"
expect_at_most 1 "$@"
expect_number MINUTES "${1:-10}"
program=${QUICKSAND_PROGRAM:-$root/build/quicksand}
seconds=$((${1:-10} * 60))
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

coproc live { exec "$program" session - --out out; }
process=$live_PID
memory() { awk '/^VmRSS/ { print $2 }' "/proc/$process/status"; }  # [KiB]

commands=0
# ask COMMAND: sends it and waits for its answer, which must be fine.
ask() {
  echo "$1" >&"${live[1]}"
  read -r answer <&"${live[0]}"
  case $answer in *'"ok":true'*) commands=$((commands + 1)) ;; *) echo "$1: $answer" && exit 1 ;; esac
}

first=0 second=0
while [ "$SECONDS" -lt "$seconds" ]; do
  ask '{"command": "load", "scene": "collapse", "set": {"phases[0].height": 6, "box.width": 12, "box.height": 10}}'
  ask '{"command": "run", "steps": 300}'
  ask '{"command": "save", "file": "state.cbor"}'
  for _ in 1 2 3; do
    ask '{"command": "run", "steps": 30}'
    ask '{"command": "snapshot", "file": "view.png", "width": 320, "height": 240}'
    ask '{"command": "snapshot", "file": "panel.png", "what": "panel", "width": 960, "height": 600}'
    ask '{"command": "measure"}'
    ask '{"command": "restore", "file": "state.cbor"}'
  done
  ask '{"command": "reset"}'
  now=$(memory)
  if [ $((2 * SECONDS)) -lt "$seconds" ]; then
    first=$((now > first ? now : first))
  else
    second=$((now > second ? now : second))
  fi
done
echo "$commands commands in $SECONDS s; most memory: first half $first KiB, second half $second KiB"
[ "$second" -le $((first * 11 / 10)) ] || { echo "memory grows"; exit 1; }
