#!/bin/sh
# Every installed header compiles by itself, against what is installed and nothing else.
# Arguments: the prefix, the compiler, a folder to work in.
set -e
prefix=$1 compiler=$2 work=$3
rm -rf "$work"
mkdir -p "$work"
cd "$prefix/include"
# GLM and tl::expected take most of the time; compiled once for the headers that have them anyway. The others must not
# live on what these include.
third='glm/ext/matrix_transform.hpp glm/glm.hpp glm/gtc/quaternion.hpp tl/expected.hpp'
for header in $third; do echo "#include <$header>"; done >"$work/third.h"
flags='-std=c++20 -DGLM_FORCE_DEPTH_ZERO_TO_ONE -Wall -Wextra -Werror'
# shellcheck disable=SC2086  # words on purpose
$compiler $flags -x c++-header "$work/third.h" -o "$work/third.h.gch"
find . -name '*.h' | sed 's#^\./##' | sort >"$work/headers"
grep -r '#include ' --include='*.h' . | sed 's#^\./##' >"$work/includes"
awk -F: '{ split($2, part, /[<>"]/); from[NR] = $1; to[NR] = part[2] }
    END { while (!done) { done = 1
              for (i = 1; i <= NR; ++i)
                  if (!(from[i] in has) && (to[i] ~ /^(glm|tl)\// || to[i] in has)) { has[from[i]] = 1; done = 0 } }
          for (header in has) print header }' "$work/includes" | sort >"$work/with_third"
[ "$(wc -l <"$work/headers")" -ge 50 ] || { echo "There are only $(wc -l <"$work/headers") headers." >&2; exit 1; }
cat >"$work/compile.sh" <<'END'
first=
grep -qxF "$4" "$3/with_third" && first="-include $3/third.h"
printf '#include "%s"\n#include "%s"\n' "$4" "$4" | $1 $2 $first -I . -fsyntax-only -x c++ - && exit
echo "$4 does not compile by itself." >&2
exit 1
END
# What a header includes first is compiled with nothing before it when that header is.
while read -r header; do
    grep -m1 '#include' "$header" | sed -n 's/.*"\(.*\)".*/\1/p'
done <"$work/headers" | sort -u >"$work/first"
comm -23 "$work/headers" "$work/first" >"$work/compiled"
xargs -P 2 -I {} sh "$work/compile.sh" "$compiler" "$flags" "$work" {} <"$work/compiled"
echo "$(wc -l <"$work/headers") headers compile."
