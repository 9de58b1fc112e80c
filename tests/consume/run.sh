#!/usr/bin/env bash
# Installs the build tree given, takes the README's C++ example, builds it against the installed package and runs it.
# usage: run.sh SOURCE_DIR BUILD_DIR
set -eu
source=$1
build=$2
work=$build/consume
rm -rf "$work"
mkdir -p "$work/app"
cmake --install "$build" --prefix "$work/installed" >/dev/null
# The first C++ block after the mark in the README.
awk '/<!-- compiled -->/ {marked = 1} marked && /^```cpp/ {inside = 1; next} inside && /^```/ {exit} inside' "$source/README.md" >"$work/app/consumer.cpp"
[ -s "$work/app/consumer.cpp" ] || { echo "the README has no marked C++ example"; exit 1; }
cp "$source/tests/consume/CMakeLists.txt" "$work/app/"
cmake -S "$work/app" -B "$work/app/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/installed" >"$work/configure.log" 2>&1 || { cat "$work/configure.log"; exit 1; }
ninja -C "$work/app/build" >"$work/build.log" 2>&1 || { cat "$work/build.log"; exit 1; }
cd "$work" && ./app/build/consumer installed/share/waywright/examples/dock_middle.json
# What a vehicle's program starts from, and the C header: with the docking part alone, which links nothing but the standard library.
mkdir -p "$work/docking"
cp "$source/tests/consume/docking/CMakeLists.txt" "$source/examples/embed/dock.cpp" "$source/tests/consume/dock.c" "$work/docking/"
cmake -S "$work/docking" -B "$work/docking/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/installed" >"$work/configure.log" 2>&1 || { cat "$work/configure.log"; exit 1; }
ninja -C "$work/docking/build" >"$work/build.log" 2>&1 || { cat "$work/build.log"; exit 1; }
./docking/build/dock
./docking/build/dock_c
if ldd docking/build/dock docking/build/dock_c | grep -vE 'linux-vdso|ld-linux|libstdc\+\+|libm\.|libgcc_s|libc\.|:$'; then
  echo "the docking part links more than the standard library"
  exit 1
fi
# The installed program finds its own examples.
./installed/bin/waywright list vehicles | grep -q forklift
