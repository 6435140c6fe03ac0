#!/usr/bin/env bash
# install_test.sh BUILD: installs a build into a folder of its own; the program there finds its scenes,
# and a program of somebody else links the installed library.
set -euo pipefail
build=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A library with sanitizers asks its users for the same options.
if grep -q '^QUICKSAND_SANITIZE:BOOL=ON' "$build/CMakeCache.txt"; then
  echo "skipped: this build has sanitizers"
  exit 77
fi

echo "one target builds all that is installed"
installed=$(ninja -C "$build" -t inputs quicksand_installed)
for file in quicksand quicksand_window.so; do
  [ ! -f "$build/$file" ] || grep -qxF "$file" <<<"$installed" || { echo "but $file"; exit 1; }
done

cmake --install "$build" --prefix "$work/prefix" >"$work/install.log"
cd "$work"

echo "the program finds its scenes beside itself"
unset QUICKSAND_ASSETS
prefix/bin/quicksand list scenes >scenes  # a file, not head, which may close the pipe before all is written
found=$(head -1 scenes)
echo "  $found"
[ "$(realpath "$found")" = "$(realpath prefix/share/quicksand/assets/scenes/cantilever.json)" ]
prefix/bin/quicksand check prefix/share/quicksand/assets/scenes/chain.json >/dev/null
if grep -q '^help2man:FILEPATH=/' "$build/CMakeCache.txt"; then
  grep -qF 'Exit status' prefix/share/man/man1/quicksand.1
  grep -qF 'checkpoint\-every' prefix/share/man/man1/quicksand-run.1
fi
test -s prefix/share/bash-completion/completions/quicksand

if [ -x /usr/bin/python3 ]; then
  echo "the Python module finds the program beside itself"
  found=$(env -u QUICKSAND PATH=/usr/bin:/bin PYTHONPATH=prefix/share/quicksand/assets/python /usr/bin/python3 -B -c \
    'import quicksand; print(quicksand.run("chain", no_frames=True, out="chain") and quicksand.find_program())')
  echo "  $found"
  [ "$(realpath "$found")" = "$(realpath prefix/bin/quicksand)" ]
fi

echo "a program links the installed library"
cmake -S "$here/example" -B example -G Ninja -DCMAKE_PREFIX_PATH="$work/prefix" >configure.log ||
  { cat configure.log; exit 1; }
# Nothing of the source or build tree may be needed.
if grep -rqF "$build" prefix/lib*/cmake prefix/lib/*/cmake 2>/dev/null; then
  echo "the exported targets name the build tree"
  exit 1
fi
cmake --build example >build.log || { cat build.log; exit 1; }
height=$(example/falling_grain)
echo "  a grain comes to rest at $height d"
[ "$height" = 0.500 ]
test -s grain.png
