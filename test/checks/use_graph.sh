#!/bin/sh
# The graph of `use` in src and bench: prints how many modules and arrows there are and the longest chain; fails on a circle, and
# on an arrow from a folder to one that comes later in the list of doc/contributing.md.
#
#   use_graph.sh TOP [MOST]      MOST: the longest chain that is let through
set -u
cd "$1" || exit 1
find src bench -name '*.f90' -o -name '*.F90' | grep -v '/unit_' | LC_ALL=C sort | awk -v most="${2-0}" '
   function level_of(file) {
      if (file ~ /^src\/(kinds|status)\./) return 0
      if (file ~ /^src\/kyvadlo\./) return 3.5
      split(file, part, "/")
      return file ~ /^bench/ ? 9 : order[part[2]]
   }
   # Lines of a source and of what it includes, for the module that begins in it.
   function read_file(file,    line, word, folder) {
      folder = file; sub(/[^\/]*$/, "", folder)
      while ((getline line < file) > 0) {
         if (line ~ /^#include "/) {
            split(line, word, "\"")
            read_file(folder word[2])
         } else if (tolower(line) ~ /^ *(module|program) +[a-z][a-z_0-9]* *$/) {
            split(line, word, " "); current = tolower(word[2])
            home[current] = top_file
         } else if (tolower(line) ~ /^ *submodule *\(/) {
            # A submodule is a part of its module.
            split(tolower(line), word, /[(:) ]+/); current = word[2]
         } else if (line ~ /^ *use +kyvadlo/) {
            gsub(/[,:]/, " ", line); split(line, word, " ")
            if (current != word[2]) arrow[current, word[2]] = top_file
         }
      }
      close(file)
   }
   BEGIN { split("arithmetic elliptic pendulum interfaces numeric scene fit study sweep driver", name, " ")
           for (i in name) order[name[i]] = i + (i > 3) * 0 }
   { top_file = $0; current = ""; read_file($0) }
   END {
      for (module in home) { modules++; depth[module] = 1 }
      for (pair in arrow) {
         arrows++
         split(pair, end, SUBSEP)
         if (!(end[2] in home)) continue
         if (level_of(home[end[1]]) < level_of(home[end[2]])) {
            print "back arrow: " end[1] " (" home[end[1]] ") uses " end[2] " (" home[end[2]] ")"; bad++
         }
         from[++n] = end[1]; to[n] = end[2]
      }
      if (modules < 100) { print "only " modules + 0 " modules found: this check reads the sources wrongly"; exit 1 }
      # The longest chain below each module; without a circle it is found in as many rounds as it is long.
      do {
         changed = ""
         for (i = 1; i <= n; i++) if (depth[from[i]] <= depth[to[i]]) {
            depth[from[i]] = depth[to[i]] + 1; below[from[i]] = to[i]; changed = from[i]
         }
      } while (changed != "" && ++rounds <= modules)
      if (changed != "") {
         text = changed
         for (i = 0; i < 30; i++) { changed = below[changed]; text = text " -> " changed }
         print "circle: " text; exit 1
      }
      for (module in depth) if (depth[module] > longest) { longest = depth[module]; deepest = module }
      printf "%d modules, %d arrows, longest chain %d:", modules, arrows, longest
      for (module = deepest; module in depth; module = below[module]) printf " %s", substr(module, 9)
      print ""
      if (most > 0 && longest > most) { print "the longest chain may have " most; bad++ }
      exit bad > 0
   }'
