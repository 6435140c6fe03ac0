#!/usr/bin/env bash
# A hand in a real window, on a screen of its own: window_by_hand.sh PROGRAM RUN_X RUN_Y STEP_X STEP_Y TIMES
# clicks Run, lets it run, pauses with the space key, clicks Step twice, drags a grain and turns the wheel,
# waiting between these TIMES as long as a quick hand would.
# The window opens without a scene's name. Leaves by_hand.json in the present folder. Exit code 77: Xvfb or xdotool is not installed.
set -uo pipefail
program=$1 run_x=$2 run_y=$3 step_x=$4 step_y=$5 times=$6
pause() { sleep "$(awk "BEGIN { print $1 * $times }")"; }
command -v Xvfb >/dev/null && command -v xdotool >/dev/null || exit 77

rm -f display
exec 3> >(cat >display)
Xvfb -displayfd 3 -screen 0 1100x800x24 >/dev/null 2>&1 &
screen=$!
trap 'kill $screen 2>/dev/null' EXIT
for _ in $(seq 100); do [ -s display ] && break; sleep 0.1; done
[ -s display ] || { echo "Xvfb gave no display" >&2; exit 1; }
DISPLAY=:$(cat display)
export DISPLAY
unset WAYLAND_DISPLAY
# Files that were opened before are a row of the panel.
export XDG_STATE_HOME=$PWD/state
# The desktop's libraries (D-Bus, X11, drivers) leave memory behind when a process ends, each machine's
# others. What is ours, the session and the panel, other tests check for leaks.
export ASAN_OPTIONS="${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0"

"$program" window --record by_hand.json --out window --size 1000x700 2>window.log &
window=$!
id=
for _ in $(seq 100); do
  id=$(xdotool search --name quicksand 2>/dev/null | head -1) && [ -n "$id" ] && break
  kill -0 $window 2>/dev/null || break
  sleep 0.1
done
[ -n "$id" ] || { cat window.log >&2; exit 1; }
xdotool windowfocus "$id"
pause 1

click() { xdotool mousemove --window "$id" "$1" "$2"; pause 0.2; xdotool click 1; pause 0.3; }
click "$run_x" "$run_y"
pause 2
xdotool mousemove --window "$id" 800 300 key space
pause 0.5
click "$step_x" "$step_y"
click "$step_x" "$step_y"
xdotool mousemove --window "$id" 600 690 mousedown 1 mousemove --window "$id" 640 600
pause 0.3
xdotool mouseup 1 click 4
pause 0.5
kill -INT $window
wait $window
code=$?
[ $code -eq 130 ] || { echo "the window ended with $code" >&2; cat window.log >&2; exit 1; }
