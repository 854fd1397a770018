#!/bin/sh
# Where there is no apt-get ./bootstrap prints the line that doc/portability.md gives for the system, and builds nothing.
#
#   bootstrap_packages.sh SOURCE_FOLDER SCRATCH_FOLDER
set -u
top=$1 work=$2
status=0
rm -rf "$work"
mkdir -p "$work"
fails() { echo "FAILED: $*"; cat "$work/said"; status=1; }

system() {   # system NAME PACKAGE_MANAGER KERNEL
   bin=$work/$2
   mkdir "$bin"
   for tool in sh sed grep sort head mktemp dirname id cat rm; do ln -s "$(command -v $tool)" "$bin/$tool"; done
   printf '#!/bin/sh\nexit 1\n' >"$bin/$2"
   printf '#!/bin/sh\nexit 1\n' >"$bin/sudo"
   printf '#!/bin/sh\necho %s\n' "$3" >"$bin/uname"
   chmod +x "$bin/$2" "$bin/sudo" "$bin/uname"
   PATH=$bin sh "$top/bootstrap" table >"$work/said" 2>&1
   code=$?
   [ $code -eq 2 ] || fails "$1: exit status $code"
   line=$(sed -n "s/^| $1 | \`\(.*\)\` |\$/\1/p" "$top/doc/portability.md")
   [ -n "$line" ] || fails "$1: no line in doc/portability.md"
   [ "$(tail -n 1 "$work/said")" = "$line" ] || fails "$1: want the line '$line'"
}
system Fedora dnf Linux
system Arch pacman Linux
system openSUSE zypper Linux
system macOS brew Darwin
exit "$status"
