#!/bin/sh
# The example project against the installed package: it is built and its tests pass; a change in a scene makes
# those tests fail that show it, with evidence; the goldens change where that is asked for, and only then.
# Arguments: the prefix, the example's sources, a folder to work in, then options of CMake.
set -e
prefix=$1 sources=$2 work=$3
shift 3
rm -rf "$work"
mkdir -p "$work"
cp -R "$sources" "$work/example"
rushlight=$prefix/bin/rushlight
export RUSHLIGHT_EVIDENCE="$work/evidence" CTEST_PARALLEL_LEVEL=2
cd "$work"

fail() {
    echo "example_test: $*" >&2
    exit 1
}
# Prints the tests that fail, of those whose names have the second argument in them.
failing() {
    ctest --test-dir build -R "${2:-.}" >ctest.txt 2>&1 || true
    sed -n 's/.*Test *#[0-9]*: \([^ ]*\) .*\*\*\*.*/\1/p' ctest.txt | sort
}
expect_failing() {
    found=$(failing "$@" | xargs)
    [ "$found" = "$1" ] || { cat ctest.txt; fail "these fail: \"$found\"; expected: \"$1\"."; }
}
goldens() { (cd example/goldens && md5sum ./*); }

cmake -S example -B build -G Ninja -DCMAKE_PREFIX_PATH="$prefix" "$@"
cmake --build build -j2
expect_failing ""
[ ! -e evidence ] || fail "tests that pass leave evidence."

# A scene of another colour.
goldens >before.txt
sed -i 's/0\.8, 0\.1, 0\.1, 1/0.1, 0.1, 0.8, 1/' example/scenes/wall.gltf
expect_failing "frames scenes.wall"
for left in actual.png golden.png error.png heat.png evidence.json breakdown/index.html; do
    for test in scenes.wall Frames.OfAFile.wide; do
        [ -s "evidence/$test/$left" ] || fail "$test left no $left."
    done
done
[ "$(ls evidence)" = "$(printf 'Frames.OfAFile.wide\nscenes.wall')" ] || fail "tests that pass leave evidence."
cmp -s evidence/scenes.wall/golden.png example/goldens/wall.png || fail "evidence has another golden."

# What would change is said, and done when it is asked for.
"$rushlight" goldens evidence >dry.txt
[ "$(grep -c ': flip 0\.[0-9]*, psnr' dry.txt)" = 2 ] || { cat dry.txt; fail "two goldens would change."; }
grep -q 'actual.png' evidence/index.html || fail "the page has no picture."
cmake --build build --target scenes_goldens >all.txt
[ "$(grep -c -e '^lamp ' -e '^wall *changed: flip' all.txt)" = 2 ] || { cat all.txt; fail "the scenes are not listed."; }
goldens | cmp -s - before.txt || fail "goldens change unasked."
"$rushlight" goldens evidence --accept --only scenes.wall >accepted.txt
goldens | diff - before.txt >changed.txt && fail "no golden changes when it is accepted."
[ "$(grep -c '^<' changed.txt)" = 1 ] || fail "another golden changes than the one that was accepted."
"$rushlight" goldens evidence --accept >>accepted.txt
expect_failing ""
[ "$(ls evidence)" = index.html ] || fail "evidence stays when tests pass."

# A golden that is not there.
rm example/goldens/lamp.png
expect_failing "scenes.lamp" scenes.lamp
"$rushlight" goldens evidence | grep -q '^scenes.lamp *new' || fail "the golden would not be new."
[ ! -e example/goldens/lamp.png ] || fail "a golden is made unasked."
"$rushlight" goldens evidence --accept >>accepted.txt
expect_failing "" scenes.lamp
