# Puts the output of a program between the lines `<!-- printed -->` and `<!-- end -->` of a page.
#
#   cmake -DPAGE=... -DOUTPUT=... -P insert.cmake
file(READ ${PAGE} page)
file(READ ${OUTPUT} output)
string(FIND "${page}" "<!-- printed -->\n" from)
string(FIND "${page}" "<!-- end -->" to)
if(from EQUAL -1 OR to LESS from)
  message(FATAL_ERROR "${PAGE}: no lines <!-- printed --> and <!-- end -->")
endif()
math(EXPR from "${from} + 17")
string(SUBSTRING "${page}" 0 ${from} head)
string(SUBSTRING "${page}" ${to} -1 tail)
file(WRITE ${PAGE} "${head}${output}${tail}")
