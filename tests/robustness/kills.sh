#!/usr/bin/env bash
# Kills runs at random moments, resumes them until they end, and compares every file of their folders with
# an unbroken run. `tests/robustness/kills.sh 200 [SEED]`: until there were 200 kills.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/app/setup.sh"
answer_help "$@"
expect_at_most 2 "$@"
expect_number KILLS "${1:-200}"
expect_number SEED "${2:-1}"
program=${QUICKSAND_PROGRAM:-$root/build/quicksand}
kills=${1:-200}
RANDOM=${2:-1}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

cat >scene.json <<'SCENE'
{"name": "killed", "seed": 7, "gravity": {},
 "box": {"width": 12, "height": 14},
 "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 100},
 "step": {"dt": 0.01},
 "phases": [
   {"type": "deposit", "grains": 60, "interval": 0.02, "sample_every": 0.06},
   {"type": "settle", "max_time": 0.4, "until_rest": false},
   {"type": "push", "diameter": 2, "force": 300, "max_time": 0.4, "sample_every": 0.03}]}
SCENE
options=(--size 160x120 --bonds --theme dark --checkpoint-every 0.05 --quiet)

# The object "work" ends where its own brace is closed.
without_times() { sed '/^  "work": {/,/^  }/d; /"wall_seconds"\|"steps_per_second"/d' "$1"; }

# same A B: whether two folders hold the same bytes, but for the time that computing took.
same() {
  diff -rq --exclude=summary.json "$1" "$2" &&
    diff <(without_times "$1/summary.json") <(without_times "$2/summary.json")
}

begin=$(date +%s%N)
"$program" run scene.json "${options[@]}" --out whole >log 2>&1
milliseconds=$((($(date +%s%N) - begin) / 1000000))
echo "unbroken: $milliseconds ms, $(find whole -name '*.png' | wc -l) frames, $(wc -l <whole/series.csv) lines of series.csv"

done_kills=0 runs=0 again=0
while [ "$done_kills" -lt "$kills" ]; do
  rm -rf broken
  command=("$program" run scene.json "${options[@]}" --out broken)
  while true; do
    "${command[@]}" >log 2>&1 &
    process=$!
    # Most of a run, or little of it: some kills hit its first moments.
    limit=$((RANDOM % 3 == 0 ? milliseconds / 10 : milliseconds))
    moment=$((limit * (RANDOM % 1000) / 1000))
    sleep "$(printf '%d.%03d' $((moment / 1000)) $((moment % 1000)))"
    if kill -KILL "$process" 2>/dev/null; then
      wait "$process" 2>/dev/null && ended=0 || ended=$?
    else
      wait "$process" && ended=0 || ended=$?
    fi
    if grep -q "starts again" log; then again=$((again + 1)); fi
    if [ "$ended" -eq 0 ]; then break; fi
    if [ "$ended" -ne 137 ]; then echo "exit code $ended:" && cat log && exit 1; fi
    done_kills=$((done_kills + 1))
    # Before its options and scene are written, there is no run to resume.
    if [ -e broken/scene.json ]; then command=("$program" resume broken); fi
  done
  same whole broken || { echo "run $((runs + 1)) differs, after $done_kills kills"; exit 1; }
  runs=$((runs + 1))
done
echo "$done_kills kills in $runs runs: every file as in the unbroken run ($again resumed from the beginning)"
