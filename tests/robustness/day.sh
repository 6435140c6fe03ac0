#!/usr/bin/env bash
# Twenty-four hours of a small cohesive heap at rest, of grains 0.344 mm wide: 14.6 million steps of
# sqrt(d/g) = 5.92 ms, the longest step that a scene may ask for. At rest a step is as good as a short one;
# shorter ones would take weeks to compute. Neither memory may grow nor grains creep: `tests/robustness/day.sh`.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/app/setup.sh"
answer_help "$@"
expect_at_most 0 "$@"
program=${QUICKSAND_PROGRAM:-$root/build/quicksand}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

cat >day.json <<'SCENE'
{"name": "day", "seed": 1, "physical": {"grain_diameter": 344e-6, "grain_density": 2650}, "gravity": {},
 "box": {"width": 6, "height": 10},
 "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 100},
 "phases": [{"type": "deposit", "grains": 20, "interval": 0.02},
            {"type": "settle", "max_time": 50},
            {"type": "settle", "dt": 1, "max_time": 14590000, "until_rest": false, "sample_every": 100000}]}
SCENE
"$program" run day.json --no-frames --quiet --strict --out day >log 2>&1 &
process=$!
resident() { awk '/^VmRSS/ { print $2 }' "/proc/$process/status" 2>/dev/null; }  # [KiB]
first= last=
while sleep 2 && now=$(resident) && [ -n "$now" ]; do
  # The first rows of the long phase are there: what the run needs is allocated.
  if [ -z "$first" ] && [ "$(wc -l <day/series.csv)" -gt 110 ]; then first=$now; fi
  last=$now
done
wait "$process" || { cat log && exit 1; }
tail -n 1 log
awk -F, -v first="$first" -v last="$last" '
  $3 == "settle" && $1 > 1000 && !from { from = $1; top = $9; energy = $7 }
  { time = $1; steps = $2; end_top = $9; end_energy = $7; if ($8 > fastest && from) fastest = $8 }
  END {
    printf "%.1f hours, %d steps; memory %d KiB at first, %d KiB at last\n", time * 5.9217e-3 / 3600, steps, first, last
    printf "top of the heap moved by %.1e d, energy by %.1e F_g d; fastest grain %.1e sqrt(g d)\n", end_top - top, end_energy - energy, fastest
    if (last > first * 1.02 || (end_top - top)^2 > 1e-12) { print "not flat"; exit 1 }
  }' day/series.csv
