# shellcheck shell=bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# What contrib/quickstart and contrib/check share; to be sourced by bash.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

packages=(g++ cmake ninja-build libdeal.ii-dev libopenblas0-serial openmpi-bin
          libcli11-dev catch2 libbenchmark-dev python3-matplotlib python3-h5py)

# Ranks are the only parallelism, and root may start them.
export OPENBLAS_NUM_THREADS=1
if [ "$(id -u)" = 0 ]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi

say()
{
  printf '\n== %s\n' "$*"
}

# Installs those of the packages that are missing.
install_packages()
{
  if ! command -v apt-get > /dev/null; then
    say "No apt-get here. Riedel needs what Debian 12 has in these packages:"
    echo "${packages[*]}"
    echo "Going on; CMake says what it does not find."
    return
  fi

  local missing=() package
  for package in "${packages[@]}"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2> /dev/null)" = installed ] ||
      missing+=("$package")
  done
  if [ ${#missing[@]} = 0 ]; then
    say "All Debian packages are there"
    return
  fi

  say "Installing with apt-get: ${missing[*]}"
  local as_root=()
  [ "$(id -u)" = 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get update
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --no-install-recommends "${missing[@]}"
}

is_configured()
{
  [ -e "$root/build/$1/build.ninja" ] || [ -e "$root/build/$1/Makefile" ]
}

# configure release|debug [-DOPTION=VALUE...]: once; later the build itself
# notices when the CMake files change.
configure()
{
  local folder=$root/build/$1 type=${1^}
  shift
  if is_configured "${folder##*/}"; then
    say "$type is configured in $folder"
    return
  fi
  say "Configuring $type in $folder"
  local generator=()
  if [ ! -e "$folder/CMakeCache.txt" ] && command -v ninja > /dev/null; then
    generator=(-G Ninja)
  fi
  mkdir -p "$folder"
  if ! cmake -S "$root" -B "$folder" "${generator[@]}" -DCMAKE_BUILD_TYPE="$type" "$@" \
    > "$folder/configure.log" 2>&1; then
    cat "$folder/configure.log"
    return 1
  fi
}

# build release|debug TARGET: compiles what is new.
build()
{
  # a compiler needs up to 1.5 GB
  local memory jobs
  memory=$(awk '/MemAvailable/ { print int($2 / 1.5e6) }' /proc/meminfo)
  jobs=$(nproc)
  [ "$jobs" -le "$memory" ] || jobs=$((memory > 0 ? memory : 1))
  say "Compiling what is new in build/$1, $jobs at a time"
  cmake --build "$root/build/$1" --target "$2" --parallel "$jobs"
}
