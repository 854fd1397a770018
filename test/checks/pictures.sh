#!/bin/sh
# Draws doc/pictures/*.gp by gnuplot from what the programs print, and compares with the pictures that the pages show. They must be
# equal where the same version of gnuplot drew them; another version's need only be drawn without a word.
#
#   pictures.sh TOP FOLDERS_OF_PROGRAMS [--write]      with --write the pictures are replaced
set -u
cd "$1" || exit 1
pictures=$1/doc/pictures
PATH=$2:$PATH; export PATH
write=${3-}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
ln -s "$1/examples" "$1/doc" "$scratch"
cd "$scratch" || exit 1
foucault_precession >/dev/null || exit 1

bad=0
count=0
for script in "$pictures"/*.gp; do
   name=$(basename "$script" .gp)
   count=$((count + 1))
   if ! gnuplot "$script" >"$name.svg" 2>messages || [ -s messages ] || ! grep -q '</svg>' "$name.svg"; then
      echo "$name.gp draws nothing, or complains:"; cat messages
      bad=$((bad + 1))
   elif [ "$write" = --write ]; then
      cp "$name.svg" "$pictures/$name.svg"
   elif [ "$(grep -s 'Produced by GNUPLOT' "$name.svg")" = "$(grep -s 'Produced by GNUPLOT' "$pictures/$name.svg")" ]; then
      cmp "$name.svg" "$pictures/$name.svg" || bad=$((bad + 1))
   fi
   grep -q "pictures/$name.svg" "$1"/doc/*.md || { echo "no page shows $name.svg"; bad=$((bad + 1)); }
done
[ "$count" -gt 0 ] && [ "$bad" -eq 0 ] || exit 1
echo "$count pictures drawn"
