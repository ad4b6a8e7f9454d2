#!/bin/sh
# verilate.sh CLASS VERILATOR WORD...
#
# Verilates in the current folder, which then has CLASS.h, with the headers behind it, and CLASS.cpp,
# all of the model as one file. Files that come out as they were keep their time, so that a change of
# RTL that a model does not see compiles nothing. CLASS.d says which files were read.
#
# Verilator ends at a blank in a path: it sees the checkout and the build through two links in this folder.
# SPDX-License-Identifier: Apache-2.0
set -eu
class=$1
shift

root=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd ../.. && pwd)
ln -sfn "$root" checkout
ln -sfn "$build" build

# Each word with `build` or `checkout` in place of their paths, behind -I or at its begin.
for word; do
  shift
  case $word in
    "$build"/*) word=build/${word#"$build"/} ;;
    "-I$build"/*) word=-Ibuild/${word#"-I$build"/} ;;
    "$root"/*) word=checkout/${word#"$root"/} ;;
    "-I$root"/*) word=-Icheckout/${word#"-I$root"/} ;;
  esac
  set -- "$@" "$word"
done

rm -rf new
if ! "$@" --Mdir new 2>verilator.log; then
  cat verilator.log >&2
  exit 1
fi

if grep -q __Vcoverage "new/${class}__Syms.h"; then
  python3 -B "$(dirname "$0")/compact_counters.py" "$class" new
fi

keep() {
  if cmp -s "$1" "$2"; then rm "$1"; else mv "$1" "$2"; fi
}

# Headers that no build step knows of: their sum changes those files that it does know.
sum=$(cat new/*.h | cksum)
{ echo "// headers: $sum"; cat "new/$class.h"; } >new/class.h
{ echo "// headers: $sum"; cat new/*.cpp; } >new/model.cc
rm new/*.cpp "new/$class.h"
for header in new/"$class"*.h; do keep "$header" "${header#new/}"; done
keep new/class.h "$class.h"
keep new/model.cc "$class.cpp"
escaped() { printf '%s' "$1" | sed 's/ /\\\\ /g; s/[&|]/\\&/g'; }
sed "s|^.*: |$(escaped "$PWD")/$class.cpp: |; s| checkout/| $(escaped "$root")/|g; s| build/| $(escaped "$build")/|g" \
  "new/${class}__ver.d" >"$class.d"
rm -r new
