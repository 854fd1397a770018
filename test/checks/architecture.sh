#!/bin/sh
# Draws the house: the folders of src, the modules in them that one should know, and who uses whom, read from the sources.
#
#   architecture.sh TOP            doc/pictures/architecture.dot must be what the sources say, and doc/architecture.md show it
#   architecture.sh TOP --write    writes it anew, and its picture where graphviz (dot) is installed
set -u
cd "$1" || exit 1
write=${2-}
picture=doc/pictures/architecture
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The main modules, folder by folder in the order in which they may use each other.
cat >"$scratch/main" <<'END'
elliptic kyvadlo_carlson integrals of Carlson
elliptic kyvadlo_jacobi sn, cn, dn
pendulum kyvadlo_orbit an orbit and its motion
pendulum kyvadlo_accuracy an orbit to an accuracy
pendulum kyvadlo_string a bob on a string
. kyvadlo the Fortran interface
numeric kyvadlo_effects what else acts
numeric kyvadlo_integrator motion by integration
scene kyvadlo_simulate the samples of a scene
fit kyvadlo_fit a pendulum from measurements
driver kyvadlo_main the program
END
folders='arithmetic elliptic pendulum . interfaces numeric scene fit study sweep driver'

find src -name '*.f90' -o -name '*.F90' | grep -v '/unit_' | LC_ALL=C sort >"$scratch/sources"
awk -v folders="$folders" '
   function folder_of(file) { sub(/^src\//, "", file); return file ~ /\// ? substr(file, 1, index(file, "/") - 1) : file == "kyvadlo.F90" ? "." : "" }
   function plain(name) { sub(/_real(32|64|128)$/, "", name); return name }   # one node for the three kinds
   function read_source(file, own,   line, word, n, status) {
      while ((status = (getline line < file)) > 0) {
         if (line ~ /^#include "/) {
            n = split(line, word, "\"")
            read_source(substr(own, 1, match(own, /[^\/]*$/) - 1) word[2], own)
            continue
         }
         sub(/^ +/, "", line); sub(/,.*$/, "", line); n = split(line, word, /[ ()]+/)
         if (n == 2 && (word[1] == "module" || word[1] == "program")) { module = plain(word[2]); folder[module] = folder_of(own) }
         else if (word[1] == "submodule") { module = plain(word[3]); folder[module] = folder_of(own); uses[plain(word[2]), module] = 1 }
         else if (word[1] == "use" && word[2] ~ /^kyvadlo/ && module != plain(word[2])) uses[module, plain(word[2])] = 1
      }
      close(file)
      if (status < 0) { print "cannot read " file >"/dev/stderr"; exit 1 }
   }
   # Main modules that a module reaches by others that are none.
   function reach(from, module,   pair, part) {
      for (pair in uses) {
         split(pair, part, SUBSEP)
         if (part[1] != module || (from, part[2]) in seen) continue
         seen[from, part[2]] = 1
         if (part[2] in meaning) arrow[from, part[2]] = 1; else reach(from, part[2])
      }
   }
   FILENAME ~ /main$/ { main[++count] = $2; home[$2] = $1; name = $2; sub(/^[^ ]+ [^ ]+ /, ""); meaning[name] = $0; next }
   { read_source($0, $0) }
   END {
      n = split(folders, order, " ")
      for (i = 1; i <= n; i++) rank[order[i]] = i
      for (i = 1; i <= count; i++)
         if (folder[main[i]] != home[main[i]]) { print "no module " main[i] " in " home[main[i]] >"/dev/stderr"; exit 1 }
      for (pair in uses) {
         split(pair, part, SUBSEP)
         a = folder[part[1]]; b = folder[part[2]]
         if (a != b && a in rank && b in rank) between[rank[a], rank[b]] = 1
      }
      print "digraph house {"
      print "   rankdir=BT; compound=true; nodesep=0.15; ranksep=0.35; fontname=\"sans\""
      print "   node [shape=box, style=filled, fillcolor=white, fontname=\"sans\", fontsize=10, height=0.3]"
      print "   edge [color=\"#606060\", arrowsize=0.6]"
      for (i = 1; i <= n; i++) {
         label = order[i] == "." ? "src" : "src/" order[i]
         printf "   subgraph cluster_%d {\n      label=\"%s\"; style=filled; color=\"#dbe7f3\"\n", i, label
         printf "      folder_%d [label=\"\", style=invis, width=0, height=0]\n", i
         for (k = 1; k <= count; k++)
            if (home[main[k]] == order[i]) printf "      %s [label=\"%s\\n%s\"]\n", main[k], main[k], meaning[main[k]]
         print "   }"
      }
      for (k = 1; k <= count; k++) reach(main[k], main[k])
      for (k = 1; k <= count; k++) for (l = 1; l <= count; l++) {
         if (!((main[k], main[l]) in arrow)) continue
         needed = 1
         for (m = 1; m <= count; m++) if (m != l && (main[k], main[m]) in arrow && (main[m], main[l]) in arrow) needed = 0
         if (needed) printf "   %s -> %s\n", main[k], main[l]
      }
      for (i = 1; i <= n; i++) for (j = 1; j <= n; j++) {
         if (!((i, j) in between)) continue
         needed = 1
         for (k = 1; k <= n; k++) if (k != i && k != j && (i, k) in between && (k, j) in between) needed = 0
         if (needed) printf "   folder_%d -> folder_%d [ltail=cluster_%d, lhead=cluster_%d, style=bold]\n", i, j, i, j
      }
      print "}"
   }' "$scratch/main" "$scratch/sources" >"$scratch/dot" || exit 1

if [ "$write" = --write ]; then
   cp "$scratch/dot" $picture.dot
   if command -v dot >/dev/null 2>&1; then dot -Tsvg $picture.dot >$picture.svg; else echo 'no graphviz: the picture is as it was'; fi
   exit
fi
if ! diff $picture.dot "$scratch/dot"; then
   echo "the picture of doc/architecture.md is not of these sources: sh test/checks/architecture.sh . --write"
   exit 1
fi
grep -q 'pictures/architecture.svg' doc/architecture.md || { echo 'doc/architecture.md does not show the picture'; exit 1; }
# shellcheck disable=SC2016  # backquotes of Markdown
for file in $(grep -o '`src/[^` ]*`' doc/architecture.md | tr -d '`' | sort -u); do
   [ -e "$file" ] || { echo "doc/architecture.md names $file, which is not there"; exit 1; }
done
echo "$(wc -l <"$scratch/sources") sources are drawn in doc/architecture.md"
