# kyvadlo-bench: its tables, its options, and that `kyvadlo` has no such command.
. "$2/test/driver/expect.sh"

run --help
expect_status 0
expect_in_out 'Usage: kyvadlo-bench'
run 3
expect_status 2
grep -q -F "kyvadlo-bench: unknown option '3'" err || complain 'a message names the unknown option'
run --functions --quick
expect_status 0
expect_match '^R_F .*GeographicLib .*[0-9]'
expect_match '^sn cn dn .*[0-9]'
run --scenes --quick
expect_status 0
expect_match '^positions and velocities: scene .*[0-9]'
expect_match '^rows of CSV .*[0-9] times that$'
run --motion --quick
expect_status 0
expect_match 'x86-64  *> 1/2  *azimuth, turns counted .*[0-9]'
expect_match 'x86-64  *> 1/2  *position and velocity .*[0-9]'
expect_match '^T alone .*[0-9]'
expect_match '^separatrix  *1000 periods.*[0-9]'
run --threads --quick
expect_status 0
expect_match '^nothing else to do   *[0-9.]*  *[0-9.]*  *[0-9.]*  *[0-9.]*$'
expect_match '^beside two busy loops  *[0-9.]*  *[0-9.]*  *[0-9.]*  *[0-9.]*$'
run --accuracy --quick
expect_status 0
expect_match '^ *1.E-06 .*[0-9]'
finish
