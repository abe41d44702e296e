# Sourced by the other scripts: where things are, and how a build folder is made.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
downloads=$root/build/downloads # everything that scripts/setup fetches; git ignores build/
jobs=${GEODESIC_REMESHING_JOBS:-2}

die()
{
  echo "$(basename "$0"): $*" >&2
  exit 1
}

# find_cgal stable|newer: sets cgal_dir, the folder of CGALConfig.cmake, and cgal_data, that of CGAL's example meshes. The caller's
# CGAL_DIR and CGAL_DATA_DIR win, then what scripts/setup unpacked, then (both empty) what CMake finds by itself.
find_cgal()
{
  local unpacked
  unpacked=$(echo "$downloads/cgal-$1/root/usr/lib/"*/cmake/CGAL)
  cgal_dir=${CGAL_DIR:-}
  cgal_data=${CGAL_DATA_DIR:-}
  if [ -z "$cgal_dir" ] && [ -f "$unpacked/CGALConfig.cmake" ]; then
    cgal_dir=$unpacked
    cgal_data=${cgal_data:-$downloads/cgal-$1/data}
  fi
}

# build stable|newer FOLDER TARGET [CMake options]: configures with that CGAL and builds; quiet unless something fails
build()
{
  local cgal=$1 folder=$2 target=$3 log
  shift 3
  find_cgal "$cgal"
  mkdir -p "$folder"
  log=$folder/build.log
  {
    cmake -G Ninja -S "$root" -B "$folder" ${cgal_dir:+-DCGAL_DIR="$cgal_dir"} ${cgal_data:+-DCGAL_DATA_DIR="$cgal_data"} \
      -DGEODESIC_REMESHING_JOBS="$jobs" "$@" && cmake --build "$folder" --target "$target"
  } >"$log" 2>&1 || {
    grep -E -A6 'error|Error|FAILED' "$log" | head -60 >&2 || true
    die "building $target failed; everything is in ${log#"$root"/}"
  }
}

# Sets folders, the options by which a compiler finds our headers and CGAL's, from which no warnings are wanted. The latter are beside
# lib/cmake/CGAL or lib/ARCHITECTURE/cmake/CGAL; those of the system the compiler finds by itself.
find_include_folders()
{
  local above
  find_cgal stable
  folders=(-I"$root/include" -isystem /usr/include/eigen3)
  above=$cgal_dir
  while [ -n "$above" ] && [ ! -f "$above/include/CGAL/version.h" ]; do above=${above%/*}; done
  [ "${above:-/usr}" = /usr ] || folders+=(-isystem "$above/include")
}

# Sets public and internal, the headers as programs include them; the lists of names, included with a macro defined, are none.
find_headers()
{
  mapfile -t public < <(cd "$root/include" && ls CGAL/geodesic_remeshing.h CGAL/Geodesic_remeshing/*.h)
  mapfile -t internal < <(cd "$root/include" && ls CGAL/Geodesic_remeshing/internal/*.h | grep -v parameters_interface)
}
