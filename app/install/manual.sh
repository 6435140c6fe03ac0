#!/bin/sh
# manual.sh PROGRAM FOLDER (both absolute): the manual pages quicksand.1 and quicksand-COMMAND.1, which help2man makes of `--help`.
set -eu
folder=$2
mkdir -p "$folder"
cd "$(dirname "$1")"
program=./$(basename "$1")
version=$("$program" --version)

# page NAME PURPOSE COMMAND...
page() {
  name=$1 purpose=$2
  shift 2
  help2man --no-info --name="$purpose" --version-string="$name ${version#* }" "$*" |
    sed '/^\.SH EXAMPLES/,$ s/^quicksand/.br\n&/' >"$folder/$name.1"
}

"$program" --help | sed -n '/^Subcommands:/,/^$/ s/^  *//p' | while read -r command purpose; do
  page "quicksand-$command" "${purpose%.}" "$program" "$command"
done
page quicksand 'contact dynamics of cohesive granular packings' "$program"
