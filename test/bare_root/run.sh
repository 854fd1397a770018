#!/bin/sh
# What the README and bootstrap's help say to type, on a machine that has nothing: a Debian of debootstrap's smallest variant with certificates added.
#
#   run.sh [--suite bookworm] [--quick]
#
# Needs root (debootstrap, chroot, mount) and the network. What is committed in this repository is cloned afresh, and then
#   1. a user without rights calls ./bootstrap in the untouched root: one message with a line to copy, status 2, nothing built;
#   2. root, in the C locale: ./bootstrap table, ./bootstrap install, the README's first lines, ./bootstrap test;
#   3. in the same root, from another fresh clone, a user without rights in an English locale: table and test again.
# With --quick no tests are run. BARE_ROOT_CACHE=FOLDER keeps the bare system there for the next root of the same run.
set -eu

suite=bookworm
quick=
while [ $# -gt 0 ]; do
   case $1 in
      --suite) suite=$2; shift 2 ;;
      --quick) quick=yes; shift ;;
      *) sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
   esac
done
say() { printf 'bare root: %s\n' "$*"; }
top=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
[ "$(id -u)" -eq 0 ] || { say 'this test needs root: it makes a system by debootstrap and runs in it by chroot'; exit 77; }
for tool in debootstrap git chroot tar; do
   command -v "$tool" >/dev/null || { say "this test needs $tool"; exit 77; }
done
place=$(mktemp -d "${TMPDIR:-/tmp}/bare_root.XXXXXX")
root=$place/root
clean_up() {
   for mount in proc dev; do umount -l "$root/$mount" 2>/dev/null || true; done
   rm -rf --one-file-system "$place"
}
trap clean_up EXIT
trap 'exit 130' INT TERM

# --- The system ---
cache=${BARE_ROOT_CACHE:-$place}
base=$cache/$suite.tar
if [ ! -f "$base" ]; then
   say "making a bare $suite"
   debootstrap --variant=minbase --include=ca-certificates "$suite" "$place/base" >"$place/log" 2>&1 ||
      { tail -n 20 "$place/log"; say 'debootstrap failed'; exit 1; }
   tar -C "$place/base" -cf "$base.part" . && mv "$base.part" "$base"
   rm -rf --one-file-system "$place/base"
fi
mkdir "$root"
tar -C "$root" -xf "$base"
# The network as this machine reaches it: how apt and TLS go through a proxy, if through one.
cp /etc/resolv.conf "$root/etc/resolv.conf" 2>/dev/null || true
cp /etc/ssl/certs/ca-certificates.crt "$root/etc/ssl/certs/ca-certificates.crt" 2>/dev/null || true
for file in $(grep -l -i -E 'proxy|acquire::https' /etc/apt/apt.conf.d/* 2>/dev/null); do
   cp "$file" "$root/etc/apt/apt.conf.d/"
done
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev" && mount --make-rslave "$root/dev"
chroot "$root" useradd --create-home --home-dir /srv/user user
# A clone as of someone who has just made it: of what is committed.
clone() { git -c safe.directory='*' clone --quiet --no-hardlinks "$top" "$root$1"; }
in_root() {   # in_root USER COMMAND: with no more environment than a login gives
   # shellcheck disable=SC2086
   case $1 in
      root) chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/srv LC_ALL=C ${proxies-} sh -c "$2" ;;
      *) chroot --userspec=user "$root" env -i PATH=/usr/bin:/bin HOME=/srv/user LANG=en_US.UTF-8 sh -c "$2" ;;
   esac
}
proxies=$(env | grep -E -i '^(http|https|no)_proxy=' | tr '\n' ' ') || true

# --- 1. A user without rights, nothing installed ---
clone /srv/user/kyvadlo
chroot "$root" chown -R user:user /srv/user/kyvadlo
status=0
in_root user 'cd ~/kyvadlo && ./bootstrap table' >"$place/out" 2>"$place/err" || status=$?
cat "$place/err"
[ "$status" -eq 2 ] || { say "a user without rights: status $status instead of 2"; exit 1; }
[ ! -s "$place/out" ] || { say 'a user without rights: something was printed on standard output'; exit 1; }
[ "$(grep -c 'apt-get install' "$place/err")" -eq 1 ] || { say 'no line to copy'; exit 1; }
[ ! -e "$root/srv/user/kyvadlo/build" ] || { say 'something was built'; exit 1; }
say 'a user without rights is told what to type, and nothing is built'

# --- 2. root, C locale ---
clone /srv/kyvadlo
begin=$(date +%s)
in_root root 'cd /srv/kyvadlo && ./bootstrap table >/tmp/table' || { say './bootstrap table fails as root'; exit 1; }
[ "$(wc -l <"$root/tmp/table")" -gt 50 ] || { say './bootstrap table prints too little'; exit 1; }
say "./bootstrap table as root: $(($(date +%s) - begin)) s, $(wc -l <"$root/tmp/table") lines"
in_root root 'cd /srv/kyvadlo && ./bootstrap install /tmp/prefix 2>&1 | tail -n 1 >/tmp/last_line &&
   cd /tmp/prefix && ls lib/libkyvadlo_slatec.a share/man/man1/kyvadlo.1 >/dev/null' ||
   { say './bootstrap install fails as root'; exit 1; }
grep -q 'the program is /tmp/prefix/bin/kyvadlo; to call it by its name, type: export PATH=/tmp/prefix/bin:' "$root/tmp/last_line" ||
   { say "the last line of ./bootstrap install is: $(cat "$root/tmp/last_line")"; exit 1; }
say './bootstrap install installs, and its last line says where the program is'
in_root root 'cd /srv/kyvadlo && sh test/checks/commands.sh /srv/kyvadlo /tmp/prefix/bin README.md' ||
   { say 'the lines of the README do not print what it shows'; exit 1; }
[ -z "$quick" ] || exit 0
in_root root 'cd /srv/kyvadlo && ./bootstrap test' || { say './bootstrap test fails as root'; exit 1; }

# --- 3. A user without rights, English locale, a fresh clone ---
rm -rf "$root/srv/user/kyvadlo" "$root/srv/kyvadlo"
clone /srv/user/kyvadlo
chroot "$root" chown -R user:user /srv/user/kyvadlo
in_root user 'cd ~/kyvadlo && ./bootstrap table >/tmp/table_of_user' || { say './bootstrap table fails as a user'; exit 1; }
cmp "$root/tmp/table" "$root/tmp/table_of_user" || { say 'the tables of root and user differ'; exit 1; }
in_root user 'cd ~/kyvadlo && ./bootstrap test' || { say './bootstrap test fails as a user'; exit 1; }
# For .ci/run: the counts of the last run.
if [ -n "${BARE_ROOT_LOG-}" ]; then cp "$root/srv/user/kyvadlo/build/release/Testing/Temporary/LastTest.log" "$BARE_ROOT_LOG"; fi
say 'what the README says to type runs in a bare root'
