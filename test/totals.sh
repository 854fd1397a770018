#!/bin/sh
# Prints `N passed, N failed`: the tests of the last run of ctest in each build folder named, added up. A .pf program
# counts the tests it holds, as it reports them itself; any other ctest counts as one.
set -eu
for folder in "$@"; do
   if [ -f "$folder/Testing/Temporary/LastTest.log" ]; then
      cat "$folder/Testing/Temporary/LastTest.log"
   else
      echo "no tests ran in $folder" >&2
      echo "1/1 Testing: everything in $folder"      # counted as one failure
   fi
done | awk '
   function close_test() {
      if (name == "") return
      # A program that died before its totals, or whose totals ctest overruled, is one failure.
      if (reported && (ok || failed_here > 0)) { passed += passed_here; failed += failed_here }
      else if (ok) passed++
      else failed++
      name = ""
   }
   /^[0-9]+\/[0-9]+ Testing: / {
      close_test(); name = $3; ok = 0; reported = 0; failed_here = 0; passed_here = 0
   }
   /^[0-9]+ passed, [0-9]+ failed/ { reported = 1; passed_here = $1; failed_here = $3 }             # the stand-in
   /^ \([0-9]+ tests?\)/ { reported = 1; passed_here = substr($1, 2); failed_here = 0 }              # pFUnit, all well
   /^Tests run: [0-9]+, Failures: / {                                                                # pFUnit, failures
      reported = 1; gsub(/[^0-9 ]/, ""); failed_here = $2 + $3; passed_here = $1 - failed_here
   }
   /^Test (Passed\.|Pass Reason:)/ { ok = 1 }
   END { close_test(); printf "%d passed, %d failed\n", passed, failed }'
