#!/usr/bin/env bash
# scripts/setup where the mirror gives no CGAL: it says so and leaves nothing that passes for one, so that the next run tries again.
#
#   setup_fails.sh SCRIPTS FOLDER
set -euo pipefail

rm -rf "$2"
mkdir -p "$2"/{scripts,bin}
cp "$1"/{setup,common.sh} "$2/scripts/"
cat >"$2/bin/apt-get" <<'END'
#!/usr/bin/env bash
for argument; do
  [ "$argument" != download ] || exit 100
done
[ "$1" != indextargets ] || echo http://mirror.invalid
END
printf '#!/bin/sh\nexit 0\n' >"$2/bin/apt-cache"
printf '#!/bin/sh\nshift 3\nprintf "installed %%s\\n" "$@"\n' >"$2/bin/dpkg-query" # all that is asked for
chmod +x "$2"/bin/*
unset CGAL_DIR CGAL_DATA_DIR
for run in first second; do
  ! PATH=$2/bin:$PATH "$2/scripts/setup" build 2>"$2/messages" || { echo "the $run run did not fail"; exit 1; }
  grep -q 'not fetch CGAL' "$2/messages" || { echo "no word of it in the $run run:"; cat "$2/messages"; exit 1; }
done
