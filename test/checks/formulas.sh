#!/bin/sh
# Every equation of doc/formulas.md stands in the docstring of the procedure named beside it.
#
#   formulas.sh TOP
#
# A row reads | (16) | corrected form | `procedure` in `src/...` |; the first cell may name several equations: (16), (17).
# More than one `procedure` may precede the file; the equation must then stand in one of their docstrings at least.
set -u
cd "$1" || exit 1
awk '
   # The comment block right above `function name` or `subroutine name` (in a template: name_kind), in file.
   function docstring(file, name,    line, block, found) {
      block = ""; found = ""
      while ((getline line < file) > 0) {
         if (line ~ /^[ \t]*!/) block = block line "\n"
         else {
            if (tolower(line) ~ ("(function|subroutine)[ \t]+" tolower(name) "(_kind)?[ \t]*(\\(|$)")) {
               found = (found == "" ? " " : found) block
            }
            if (line !~ /^[ \t]*$/) block = ""
         }
      }
      close(file)
      return found
   }
   # The docstring of a procedure of an orbit: its body says `module procedure name`, its interface is in orbit_bindings.inc.
   function interface_of(file, name,    line, is_body) {
      while ((getline line < file) > 0) if (line ~ ("^ *module procedure " name "(_kind)?$")) is_body = 1
      close(file)
      return is_body ? docstring("src/pendulum/orbit_bindings.inc", name) : ""
   }
   function complain(text) { print FILENAME ":" FNR ": " text; bad++ }

   /^\| *\([0-9]+[a-z]?\)/ {
      cells = split($0, cell, / *\| */)
      rows++
      last = cell[cells - 1]
      if (!match(last, /`src\/[^`]+`/)) { complain("no source file in the last cell: " last); next }
      file = substr(last, RSTART + 1, RLENGTH - 2)
      names = substr(last, 1, RSTART - 1)
      if ((getline line < file) < 0) { complain("no file " file); next }
      close(file)
      text = ""; named = 0
      while (match(names, /`[A-Za-z_0-9]+`/)) {
         name = substr(names, RSTART + 1, RLENGTH - 2)
         names = substr(names, RSTART + RLENGTH)
         doc = docstring(file, name)
         # The interface of a `module procedure` stands with the type it is bound to.
         if (doc == "") doc = interface_of(file, name)
         if (doc == "") complain("no procedure " name " in " file)
         text = text doc
         named++
      }
      if (!named) { complain("no procedure in the last cell: " last); next }
      tags = cell[2]
      while (match(tags, /\([0-9]+[a-z]?\)/)) {
         tag = substr(tags, RSTART, RLENGTH)
         tags = substr(tags, RSTART + RLENGTH)
         equations++
         seen[tag] = 1
         if (!index(text, tag)) complain("equation " tag " does not stand in the docstring named: " last)
      }
   }
   END {
      if (rows < 10) { print "only " rows + 0 " rows found: this check reads doc/formulas.md wrongly"; exit 1 }
      # The paper counts its equations from 1 to 36.
      for (n = 1; n <= 36; n++) if (!(("(" n ")") in seen)) { print "no row for equation (" n ")"; bad++ }
      if (bad) exit 1
      print equations " equations in " rows " rows, each in the docstring named"
   }' doc/formulas.md
