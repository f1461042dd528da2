#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# thesis_items.sh <folder of the sources> <tools folder>
# docs/method/thesis.md must list every numbered algorithm, equation, figure and table of chapters 2 to 5, each with
# files, tests and commands that exist, or with a reason. The commands of docs/guide/reproduce.md must exist.
set -u
cd "$1" || exit 1
tools=$2 page=docs/method/thesis.md status=0
helps=$(mktemp -d) || exit 1
trap 'rm -rf "$helps"' EXIT
has_option() { # <tool> <option>
  local help=$helps/${1##*/}
  [ -e "$help" ] || "$1" -h > "$help"
  grep -qE "^ +$2 " "$help"
}
complain() { echo "$page: $1"; status=1; }

rows=$(sed -n '/^## Chapter 2/,$p' $page | grep '^| ' | grep -vE '^\| (item|---) ')

# What is listed: "Eq. 2.3 to 2.5, 2.8; Fig. 2.5" in the first column becomes one line for each of them
listed=$(awk -F' *[|] *' '{
  count = split($2, words, /[ ,;()]+/)
  kind = ""; last = ""; range = 0
  for (i = 1; i <= count; ++i)
    if (words[i] ~ /^(Eq\.|Fig\.|Table|Algorithm|Sec\.)$/) { kind = words[i]; range = 0 }
    else if (words[i] == "to") range = 1
    else if (words[i] ~ /^[0-9]+(\.[0-9]+)?$/) {
      if (range) {
        split(last, from, "."); split(words[i], until, ".")
        for (n = from[2] + 1; n < until[2]; ++n) print kind, from[1] "." n
      }
      print kind, words[i]
      last = words[i]; range = 0
    }
    else range = 0
}' <<< "$rows" | sort -u)
expect() { # kind chapter last_number
  for number in $(seq 1 "$3"); do
    grep -qxF "$1 $2.$number" <<< "$listed" || complain "$1 $2.$number is not listed"
  done
}
expect Eq. 2 30; expect Eq. 3 5; expect Eq. 4 8; expect Eq. 5 13
expect Fig. 2 19; expect Fig. 3 8; expect Fig. 4 14; expect Fig. 5 17
expect Table 2 2; expect Table 3 1; expect Table 4 3; expect Table 5 3
for number in 1 2; do
  grep -qxF "Algorithm $number" <<< "$listed" || complain "Algorithm $number is not listed"
done

sources=$(find common experiments features filters io ml scene segmentation simulation test tools -type f)
headers=$(grep '\.h$' <<< "$sources" | xargs cat)
names() { grep -oE '`[^`]+`' <<< "$1" | tr -d '`'; }
while IFS='|' read -r _ item files tests commands _; do
  if ! grep -q '`' <<< "$commands"; then
    [ "$(tr -d ' ' <<< "$tests$commands")" = "" ] && [ "$(tr -d ' ' <<< "$files")" != "" ] ||
      complain "$item has neither a command nor a reason"
    continue
  fi
  for name in $(names "$files"); do
    [ -d "$name" ] || grep -qE "/$name\.(h|cpp|hpp)$" <<< "$sources" ||
      grep -qwF -- "$name" <<< "$headers" ||
      complain "$item names the file $name, which is not there"
  done
  for name in $(names "$tests"); do
    grep -qE "/test_$name\.cpp$" <<< "$sources" || complain "$item names the test $name, which is not there"
  done
  tool=
  for name in $(names "$commands"); do
    case $name in
      pcl_*) tool=$tools/$name && [ -x "$tool" ] || complain "$item names $name, which is not there" ;;
      -*) has_option "$tool" "$name" || complain "$item: ${tool##*/} has no option $name" ;;
      *.py | bench_*)
        grep -qE "^test/benchmark/$name(\.cpp)?$" <<< "$sources" || complain "$item names $name, which is not there" ;;
      *) complain "$item has the command $name" ;;
    esac
  done
done <<< "$rows"

page=docs/guide/reproduce.md
while read -r tool rest; do
  for option in $(grep -oE ' -[a-z_]+' <<< " ${rest%%#*}"); do
    has_option "$tools/$tool" "$option" || complain "$tool has no option $option"
  done
done < <(grep '^    pcl_' $page)
exit $status
