#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# describe_tool.sh <tool> <version> <man page> <completion>
# Turns what a tool says with -h into a man page and a completion for bash.
set -euo pipefail
tool=$1 version=$2 man=$3 completion=$4
name=$(basename "$tool")
help=$("$tool" -h)

awk -v name="$name" -v version="$version" '
  function plain(text) {
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    return text ~ /^[.'\'']/ ? "\\&" text : text
  }
  NR == 1 {
    summary = $0
    first = summary
    sub(/[.;:] .*|\.$/, "", first)
    printf ".TH %s 1 \"\" \"pcl_indoor %s\"\n.SH NAME\n%s \\- %s\n", toupper(name), version, plain(name), plain(first)
    next
  }
  /^Syntax is: / {
    sub(/^Syntax is: /, "")
    printf ".SH SYNOPSIS\n%s\n.SH DESCRIPTION\n%s\n.SH ARGUMENTS\n", plain($0), plain(summary)
    next
  }
  /^  where options are:/ { print ".SH OPTIONS"; next }
  /^  and, for experts/ { print ".SH OPTIONS FOR EXPERTS\nTheir defaults suit most scans."; next }
  / = / {
    at = index($0, " = ")
    option = substr($0, 1, at - 1)
    sub(/^ +/, "", option)
    printf ".TP\n\\fB%s\\fR\n%s\n", plain(option), plain(substr($0, at + 3))
  }
  END { print ".SH EXIT STATUS\n0, or 1 after an error, which one line on stderr names; then nothing is left half written." }
' <<< "$help" > "$man.part"

awk -v name="$name" '
  /^    -/ {
    options = options " " $1
    if ($2 != "=" && $2 ~ /\|/) {
      values = $2
      gsub(/\|/, " ", values)
      choices = choices sprintf("    %s) COMPREPLY=($(compgen -W \"%s\" -- \"$word\")); return ;;\n", $1, values)
    } else if ($2 == "X")
      numbers = numbers (numbers == "" ? "" : " | ") $1
  }
  END {
    printf "# bash completion of %s\n_%s()\n{\n  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n  COMPREPLY=()\n", name, name
    print "  # shellcheck disable=SC2207 # words have no blanks"
    print "  case $before in"
    printf "%s", choices
    if (numbers != "")
      printf "    %s) return ;;\n", numbers
    print "  esac"
    printf "  if [[ $word == -* ]]; then\n    COMPREPLY=($(compgen -W \"%s\" -- \"$word\"))\n  fi\n}\n", substr(options, 2)
    printf "complete -o default -F _%s %s\n", name, name
  }
' <<< "$help" > "$completion.part"
mv "$man.part" "$man"
mv "$completion.part" "$completion"
