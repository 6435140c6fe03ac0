#!/usr/bin/env bash
# package_test.sh BUILD: packs a build as Debian packages; what they contain and need is right, and the
# program works from where they unpack it.
set -euo pipefail
build=$1
for tool in dpkg-deb dpkg-shlibdeps cpack; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is missing (dpkg-dev)"; exit 77; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cpack --config "$build/CPackConfig.cmake" -B "$work" >cpack.log || { cat cpack.log; exit 1; }

# expect WHAT FILE: a line of the file contains it.
expect() {
  grep -qF -- "$1" "$2" || { echo "no \"$1\" in:"; cat "$2"; exit 1; }
}

program=$(echo quicksand_*.deb)
development=$(echo quicksand-dev_*.deb)
dpkg-deb -c "$program" >contents
for file in bin/quicksand share/quicksand/assets/scenes/collapse.json \
            share/quicksand/assets/schemas/scene.schema.json share/bash-completion/completions/quicksand; do
  expect " ./usr/$file" contents
done
! grep -q '^help2man:FILEPATH=/' "$build/CMakeCache.txt" || expect share/man/man1/quicksand-run.1 contents
dpkg-deb -c "$development" >contents
for file in include/quicksand/core/world/world.h lib/libquicksand_core.a \
            lib/cmake/quicksand/quicksand-config.cmake; do
  expect " ./usr/$file" contents
done

dpkg-deb -f "$program" Depends >depends
for package in libc6 libosmesa6 libdeflate0 fonts-roboto-unhinted; do expect "$package" depends; done
dpkg-deb -f "$development" Depends >depends
expect libeigen3-dev depends

dpkg-deb -x "$program" root
root/usr/bin/quicksand list scenes >scenes  # a file, not head, which may close the pipe before all is written
found=$(head -1 scenes)
[ "$(realpath "$found")" = "$(realpath root/usr/share/quicksand/assets/scenes/cantilever.json)" ]
ls -l ./*.deb | awk '{ print $9, $5, "bytes" }'
