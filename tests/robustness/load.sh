#!/usr/bin/env bash
# What is large is done, or refused with the memory that it needs: a million disks are listed, stepped, drawn and
# saved; a session has 100 000 commands, a film 10 000 frames. `tests/robustness/load.sh [BODIES]` needs 3 GB.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/app/setup.sh"
answer_help "$@"
expect_at_most 1 "$@"
expect_number BODIES "${1:-1000000}"
program=${QUICKSAND_PROGRAM:-$root/build/quicksand}
width=$((${1:-1000000} / 250))
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# scene NAME SPACING: rows of bonded columns, 250 disks high. At a spacing of 1 they touch.
scene() {
  cat <<SCENE
{"name": "$1", "gravity": {}, "box": {"width": $(awk "BEGIN { print $width * $2 }"), "height": 260},
 "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 1000}, "initial_bonds": "touching",
 "phases": [{"type": "settle", "max_time": 0.02, "until_rest": false}],
 "bodies": [$(for row in $(seq 0 249); do
   printf '{"position": [0.5, %d.5], "repeat": {"count": %d, "offset": [%s, 0]}},' "$row" "$width" "$2"
 done | sed 's/,$//')]}
SCENE
}
scene loose 1.5 >loose.json
scene dense 1 >dense.json

# watched ARGUMENTS...: runs the program, says its last line, and keeps its most memory in `most` [KiB].
watched() {
  local process now
  "$program" "$@" >log 2>&1 &
  process=$!
  most=0
  while sleep 0.2 && now=$(awk '/^VmHWM/ { print $2 }' "/proc/$process/status" 2>/dev/null) && [ -n "$now" ]; do
    most=$now
  done
  wait "$process" || { cat log && exit 1; }
  tail -n 1 log
}

watched run loose.json --out loose
echo "  $(ls loose/frames | wc -l) frames, state of $(stat -c %s loose/state.cbor) bytes"
echo "  memory: $most KiB, $((most * 1024 / (width * 250))) bytes a disk"

# refused GIBIBYTES SCENE CODE: in so much address space, with a message that says what is needed.
refused() {
  local code=0
  (ulimit -v $(($1 << 20)) && exec "$program" run "$2" --no-frames --quiet --out refused) >log 2>&1 || code=$?
  cat log
  [ "$code" -eq "$3" ] && grep -q "takes at least .* GB of memory" log || { echo "exit code $code"; exit 1; }
}
refused 2 loose.json 2
refused 8 dense.json 1

awk 'BEGIN {
  print "{\"commands\": [{\"command\": \"load\", \"scene\": \"chain\", \"set\": {\"phases[0].max_time\": 1e6}}"
  for (k = 1; k < 100000; ++k)
    print k % 2 ? ", {\"command\": \"run\", \"steps\": 1}" : ", {\"command\": \"print\", \"text\": \"still here\"}"
  print "]}"
}' >many.json
watched session many.json --out many
echo "  $(wc -l <many/transcript.jsonl) commands, memory: $most KiB"

cat >film.json <<'SCENE'
{"name": "film", "gravity": {}, "box": {"width": 6, "height": 6},
 "bodies": [{"position": [3, 2]}], "phases": [{"type": "settle", "max_time": 100, "until_rest": false}]}
SCENE
watched run film.json --every 0.01 --size 160x120 --out film
echo "  $(ls film/frames | wc -l) frames, memory: $most KiB"
