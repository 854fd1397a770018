# Puts the study's summary and pictures into the page of the tables of accuracy, and its files beside it.
#
#   cmake -DPAGE=page of ulp_table -DSUMMARY=output of kyvadlo study -DFOLDER=its folder -DDOC=doc -P accuracy_page.cmake
file(READ ${PAGE} page)
file(READ ${SUMMARY} summary)
set(place "## Beside other libraries\n")
string(FIND "${page}" "${place}" at)
string(FIND "${summary}" "\n\n" head)
if(at EQUAL -1 OR head EQUAL -1)
  message(FATAL_ERROR "${PAGE}: no heading ${place}, or ${SUMMARY} without a blank line")
endif()
# The machine is named at the head of the page.
math(EXPR head "${head} + 2")
string(SUBSTRING "${summary}" ${head} -1 summary)
file(GLOB files ${FOLDER}/study.csv ${FOLDER}/study_*.svg ${FOLDER}/study_*.png ${FOLDER}/study_*.gp)
file(COPY ${files} DESTINATION ${DOC}/study)
set(section "## What accuracy costs in time

Printed by `kyvadlo study --output doc/study`, which the command above runs. It puts each question to every method at hand, about a
typical orbit, one near the conical, near the plane and near the upright, a small oscillation, an energetic one and a plane one
([commands.md](commands.md) says what the methods are); every figure is a line of
[study.csv](study/study.csv). References are values of mpmath at 36 digits or more. An entry such as `closed_form x3.1` names
the cheapest method that reaches the error at the head of its column, at its cheapest setting and in its cheapest kind, and says
how many times as long the next one takes; `alone`: no other method gets there. The part above each table looks for methods that
reach the error on every orbit, and gives the geometric mean of their times. At the end stand orbits to a stated accuracy: the worst
error of all, and the time beside that of double precision without one.

```text
${summary}```

In the pictures a point is a setting; the lower and the farther to the left, the better.

![Position within the first period](study/study_position.svg)

![Position within the 1000th period](study/study_position_1000.svg)

![Period](study/study_period.svg)

![Turning heights](study/study_roots.svg)

![Gaps](study/study_gaps.svg)

![Elliptic functions](study/study_functions.svg)

")
string(REPLACE "${place}" "${section}${place}" page "${page}")
file(WRITE ${DOC}/accuracy_tables.md "${page}")
