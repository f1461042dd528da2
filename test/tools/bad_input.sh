#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# bad_input.sh <case> <tool> <number option> <arguments>...
# Runs a tool on one kind of bad input and demands: exit status 1, exactly one line on stderr that names the problem,
# nothing on stdout, no file left. INPUT and OUTPUT in the arguments are replaced by paths; an absent OUTPUT means
# that the tool writes no file. FOLDER is replaced by a folder of two classes, one of which holds the bad input.
set -u
case=$1 tool=$2 number=$3
shift 3

folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
input=$folder/input.pcd output=$folder/output.pcd
extra=() expected=

# pcd_header <points> <encoding> [fields]
pcd_header() {
  printf 'VERSION .7\nFIELDS %s\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH %s\nHEIGHT 1\n' "${3:-x y z}" "$1"
  printf 'VIEWPOINT 0 0 0 1 0 0 0\nPOINTS %s\nDATA %s\n' "$1" "$2"
}

# rows <number of points>
rows() {
  awk -v count="$1" 'BEGIN { for (i = 0; i < count; ++i) print i % 10 / 10, int(i / 10) % 10 / 10, int(i / 100) / 10 }'
}

good_cloud() { pcd_header 300 ascii && rows 300; }

if [[ " $* " == *" FOLDER "* ]]; then
  mkdir -p objects/bed objects/cup
  input=$folder/objects/cup/input.pcd
  for name in bed/1 bed/2 cup/1 cup/2; do good_cloud > "objects/$name.pcd"; done
fi

case $case in
  missing_file) expected='input.pcd: (no such (file|folder)|cannot be read)' ;;
  not_a_plan) echo '{"storeys": [{"rooms": 7}]}' > "$input"; expected='input.pcd: ' ;;
  not_a_cloud) echo 'Dear reader,' > "$input"; expected='input.pcd: not a PCD, .* file' ;;
  cut_header) pcd_header 300 ascii | head -n 4 > "$input"; expected='input.pcd: .*header' ;;
  truncated_ascii) { pcd_header 300 ascii; rows 200; } > "$input"; expected='input.pcd: .*truncated.* 300 .* 200' ;;
  truncated_binary)
    { pcd_header 300 binary; head -c 2000 /dev/zero; } > "$input"; expected='input.pcd: .*truncated.* 3600 .* 2000' ;;
  truncated_compressed) # 1000 compressed bytes are announced, 3600 when unpacked; 100 are there
    { pcd_header 300 binary_compressed; printf '\350\003\000\000\020\016\000\000'; head -c 100 /dev/zero; } > "$input"
    expected='input.pcd: .*truncated' ;;
  damaged_compressed) # as long as it should be, but not compressed data
    { pcd_header 300 binary_compressed; printf '\350\003\000\000\020\016\000\000'; head -c 1000 /dev/zero | tr '\0' '\377'; } > "$input"
    expected='input.pcd: .*damaged' ;;
  truncated_ply)
    input=${input%.pcd}.ply
    { printf 'ply\nformat binary_little_endian 1.0\nelement vertex 300\nproperty float x\nproperty float y\nproperty float z\nend_header\n'
      head -c 2000 /dev/zero; } > "$input"
    expected='input.ply: .*truncated.* 3600 .* 2000' ;;
  table_bad_word) input=${input%.pcd}.csv; { echo x,y,z; echo 1,2,3; echo 4,abc,6; } > "$input"; expected="input.csv: line 3: 'abc' is not a number" ;;
  table_short_row) input=${input%.pcd}.xyz; { rows 30; echo 1 2; } > "$input"; expected='input.xyz: line 31 has 2 values, the rows before have 3' ;;
  table_decimal_comma) input=${input%.pcd}.txt; printf '1,50,2,25,3,05\n' > "$input"; expected='input.txt: line 1: commas part the values and the decimals' ;;
  table_without_z) input=${input%.pcd}.csv; printf 'x,y,when\n1,2,3\n' > "$input"; expected="input.csv: line 1 names no column 'z'; .* -columns x,y,z" ;;
  table_too_few_points) input=${input%.pcd}.pts; { echo 400; rows 300; } > "$input"; expected='input.pts: .*truncated.* 400 .* 300' ;;
  table_of_names) input=${input%.pcd}.csv; echo x,y,z > "$input"; expected='input.csv: .*empty' ;;
  word_for_number) { pcd_header 300 ascii; rows 299; echo '1 2 abc'; } > "$input"; expected="input.pcd: .*'abc'" ;;
  no_xyz) { pcd_header 300 ascii 'x y intensity'; rows 300; } > "$input"; expected="input.pcd: .*'z'" ;;
  empty_cloud) pcd_header 0 ascii > "$input"; expected='input.pcd: .*empty' ;;
  empty_file) : > "$input"; expected='input.pcd: ' ;;
  one_point) { pcd_header 1 ascii; rows 1; } > "$input"; expected='input.pcd: .*1 finite point' ;;
  all_nan) { pcd_header 30 ascii; yes 'nan nan nan' | head -n 30; } > "$input"; expected='input.pcd: none .* finite' ;;
  unknown_option) extra=(-no_such_option 1); expected='-no_such_option: unknown option' ;;
  not_a_number) extra=("$number" abc); expected="$number: 'abc' is not a number" ;;
  nan_value) extra=("$number" nan); expected="$number: 'nan' is not a number" ;;
  negative_value) extra=("$number" -1); expected="$number: '-1' is out of range" ;;
  missing_value) extra=("$number"); expected="$number: the value is missing" ;;
  missing_argument) set --; expected='is missing|are needed' ;;
  unwritable_output) output=$input/output.pcd; expected='output.pcd(_rooms.png|.ifc)?: cannot be ' ;;
  wrong_extension) output=$folder/output.las; expected='output.las: cannot be written, .las is ' ;;
  folder_in_folder) # one of the results cannot be replaced
    mkdir -p "$output/classes.png"; expected='output.pcd/classes.png: cannot be written, it is a folder' ;;
  *) echo "unknown case $case"; exit 1 ;;
esac
[ "$case" = missing_file ] || [ -e "$input" ] || good_cloud > "$input"

arguments=()
for argument in "$@"; do
  argument=${argument//FOLDER/$folder\/objects}
  argument=${argument//INPUT/$input}
  arguments+=("${argument//OUTPUT/$output}")
done
before=$(find . | sort)
said=$("$tool" "${arguments[@]}" "${extra[@]}" 2> "$folder.stderr")
status=$?
complaint=$(cat "$folder.stderr")
rm -f "$folder.stderr"
after=$(find . | sort)

problems=()
[ $status -eq 1 ] || problems+=("its exit status is $status, not 1")
[ -z "$said" ] || problems+=("it says on stdout: $said")
[ "$(grep -c . <<< "$complaint")" -eq 1 ] || problems+=("stderr does not hold one line")
grep -qE -e "$expected" <<< "$complaint" || problems+=("stderr does not match '$expected'")
[ "$before" = "$after" ] || problems+=("files have changed: $(diff <(echo "$before") <(echo "$after"))")
[ ${#problems[@]} -gt 0 ] || exit 0
echo "$(basename "$tool") ${arguments[*]} ${extra[*]}:"
printf '  %s\n' "${problems[@]}" "stderr: $complaint"
exit 1
