#!/usr/bin/env bash
# Draws the pictures of the README and of the pages anew: draw.sh
#
# All but those of long runs, whose commands are in assets/doc/pictures.md; it takes about a minute. Those of the
# page in a browser need Chromium with its driver (package chromium-driver), and stay as they are without it.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/app/setup.sh"
answer_help "$@"
expect_at_most 0 "$@"
build_in release quicksand
quicksand="$build/quicksand"
pictures="$root/assets/pictures"
work=$(mktemp -d "${TMPDIR:-/tmp}/quicksand-pictures-XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"

# The demo: before the push, on its way, and at the end.
"$quicksand" run collapse --no-frames --quiet --out collapse
"$quicksand" render collapse --time 5.96,6.54,13.16 --size 1400x1000 --text-size 31 --out "$pictures/collapse.png"

# The scene of first_scene.md, whose second version is the last but one block of JSON there.
awk '/^```json/ { text = ""; inside = 1; next }
     /^```/ { if (inside && text ~ /"push"/ && !done) { printf "%s", text; done = 1 } inside = 0 }
     inside { text = text $0 "\n" }' "$root/assets/doc/first_scene.md" >heap.json
"$quicksand" run heap.json --no-frames --quiet --out heap
"$quicksand" render heap --time 3.06 --bonds --size 900x740 --text-size 20 --out "$pictures/first_scene.png"

# The shear cell: pressed, and sheared.
"$quicksand" run shear_cell --no-frames --quiet --out shear_cell
"$quicksand" render shear_cell --time 6,12.5 --window=-1,-1,21,22 --colour speed --colour-high 5 --forces --size 1400x860 \
  --text-size 28 --titles "pressed by the piston" "sheared by the sliding piston" --out "$pictures/shear_cell.png"

# The panel, by the session that uses all of it.
"$quicksand" session "$root/assets/sessions/tour.json" --quiet --out tour
cp tour/04_push.png "$pictures/panel.png"
cp tour/05_bonds_near_the_intruder.png "$pictures/panel_bonds.png"
cp tour/06_forces_in_the_dark.png "$pictures/panel_dark.png"

if command -v chromedriver >/dev/null; then
  python3 "$pictures/draw_browser.py" "$quicksand" "$work/collapse" "$pictures"
else
  echo "draw.sh: there is no chromedriver, so the pictures of the page stay as they are" >&2
fi
