# Commands, options, help, version: exit status and messages.
. "$2/test/driver/expect.sh"

fails 2 'no command' 
fails 2 "unknown command 'tabel'; the commands are table, eval" tabel
fails 2 "unknown command ''" ''
fails 2 "unknown option '--frobnicate'" --frobnicate
fails 2 "unknown option '--frobnicate'" eval --frobnicate
fails 2 "unknown option '--divisions'" eval --divisions 3
fails 2 'option --kind needs a value: single|double|quad' eval K 0.5 --kind
fails 2 "option --kind must be one of single|double|quad, got 'half'" eval --kind half K 0.5
fails 2 "option --kind must be one of single|double|quad, got 'single|double'" eval '--kind=single|double' K 0.5
fails 2 "option --kind must be one of single|double|quad, got ''" eval --kind= K 0.5
fails 2 'option --kind given twice' eval --kind quad --kind quad K 0.5
fails 2 'option --list takes no value' eval --list=3

for word in --help -h; do
   run $word
   expect_status 0
   expect_in_out 'Usage: kyvadlo COMMAND'
   expect_in_out 'kyvadlo eval K 0.5'
done
for command in table eval; do
   run $command --help
   expect_status 0
   expect_in_out "Usage: kyvadlo $command"
   expect_in_out 'Examples:'
   expect_in_out '--kind single|double|quad'
done
run --version
expect_status 0
expect_in_out 'kyvadlo '
expect_in_out 'Licence: MIT'

finish
