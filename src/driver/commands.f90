!> The commands of the program, their options and examples: the one source of the help pages, and of what
!> `kyvadlo_command_line` accepts.
module kyvadlo_commands
   implicit none
   private
   public :: command_type, option_type, example_type, commands, options, examples, explanations, explanation_type

   type :: command_type
      character(len=8) :: name
      character(len=24) :: operands    !! What follows the name, for the usage line; blank: nothing
      character(len=72) :: summary     !! One line
   end type command_type

   type :: option_type
      character(len=8) :: command      !! Blank: every command; `-`: the program itself, without a command
      character(len=16) :: name        !! With its dashes
      character(len=24) :: value       !! Name of its value; blank: a switch. `a|b|c`: one of these words
      character(len=88) :: meaning
   end type option_type

   type :: example_type
      character(len=8) :: command
      character(len=80) :: line
      character(len=72) :: meaning
   end type example_type

   type :: explanation_type
      character(len=8) :: command
      character(len=100) :: line
   end type explanation_type

   type(command_type), parameter :: commands(*) = [ &
      command_type('table', '[SCENE]...', 'the motion of pendulums in tables: constants, quarter periods, speeds'), &
      command_type('simulate', 'SCENE', 'the samples of a scene: positions, velocities, energy, tension over time'), &
      command_type('eval', '[NAME ARGUMENT...]', 'values of elliptic functions and of orbits: a calculator'), &
      command_type('sweep', 'PLAN [PART]...', &
      'quantities over grids and clouds of scenes, by all cores and machines'), &
      command_type('fit', 'SCENE DATA', 'a pendulum with error bars from measurements of it'), &
      command_type('study', '[SCENE]...', 'what accuracy costs in time: error and time of every method, per orbit'), &
      command_type('help', '[TOPIC]', 'what a scene may say: its form, effects and output; help of a command'), &
      command_type('examples', '[NAME [FILE]]', 'the names of the example scenes; with NAME copies one into FILE')]

   type(option_type), parameter :: options(*) = [ &
      option_type('table', '--divisions', 'N', 'every quantity at the N+1 times that divide the period'), &
      option_type('table', '--data', '', 'only the constants of the motion, one line for each pendulum in csv'), &
      option_type('table', '--digits', 'N', &
         'significant digits; without it 6, 14 or 32 by kind, in csv all that count'), &
      option_type('table', '--format', 'text|csv|markdown', 'layout of the output (default text)'), &
      option_type('table', '--output', 'FILE', 'write FILE instead of standard output; it appears when it is whole'), &
      option_type('table', '--kind', 'single|double|quad', 'kind of the numbers, read and computed (default double)'), &
      option_type('table', '--accuracy', 'A', &
         'kind and digits for a relative error A, 1.3e-32 to 0.1: double down to 1e-13, then quad'), &
      option_type('table', '--pendulum', 'NAME', 'only the pendulum of this name or number'), &
      option_type('table', '--upper', 'A:B:N', 'a grid instead of scenes: N upper turning heights from A to B'), &
      option_type('table', '--lower', 'A:B:N', 'N lower turning heights from A to B'), &
      option_type('table', '--release-angle', 'A', &
         'a pendulum instead of scenes: let go A degrees from straight down, -180 to 180'), &
      option_type('table', '--release-speed', 'V', 'with this horizontal speed, across (default 0)'), &
      option_type('table', '--length', 'L', 'length of that pendulum, or of the grid (default 1)'), &
      option_type('table', '--gravity', 'G', 'gravity likewise (default 9.80665)'), &
      option_type('simulate', '--output', 'FILE', &
         'write FILE, NetCDF if it ends in .nc, instead of standard output; it appears when whole'), &
      option_type('simulate', '--events', 'FILE', &
         'of &event and of the string (slack, taut), as CSV; else comment lines between samples'), &
      option_type('simulate', '--plot', 'FILE', &
         'draw FILE, .svg or .png, by gnuplot; its script and data stand beside, .gp and .dat'), &
      option_type('simulate', '--summary', '[text|json]', &
         'print what the motion is like in ten lines, instead of the samples; these go to --output'), &
      option_type('simulate', '--pendulum', 'NAME', 'the pendulum of this name or number, of a scene with several'), &
      option_type('simulate', '--explain', '', &
         'first say which path was chosen, why, and what it will cost (standard error)'), &
      option_type('simulate', '--most-steps', 'N', &
         'steps that an integration may take (default 1e7); more are refused'), &
      option_type('simulate', '--accuracy', 'A', &
         'of the positions, in lengths (default all digits); integrated: of a step (1e-12)'), &
      option_type('simulate', '--check', '', &
         'run an integrated scene at a tenth of its accuracy beside, and say how far it differs'), &
      option_type('simulate', '--list', '', &
         'print every group and name of a scene with its meaning, unit and default'), &
      option_type('simulate', '--threads', 'N', &
         'that share the work: they gain where cores are idle (default 1; 0: all there are)'), &
      option_type('fit', '--output', 'FILE', 'write FILE instead of standard output; it appears when it is whole'), &
      option_type('fit', '--format', 'text|csv|json', 'layout of the output (default text)'), &
      option_type('fit', '--residuals', 'FILE', 'measured, model and residual of every number, as CSV'), &
      option_type('fit', '--plot', 'FILE', &
         'draw FILE, .svg or .png, by gnuplot: data, model, residuals; beside it script and data'), &
      option_type('fit', '--explain', '', &
         'first say what is fitted, where the search begins and what it costs (standard error)'), &
      option_type('fit', '--pendulum', 'NAME', 'the pendulum of this name or number, of a scene with several'), &
      option_type('fit', '--profile', '', 'intervals by profile likelihood: chi2 grows by 1 at their ends'), &
      option_type('fit', '--bootstrap', 'N', 'intervals by N fits of rows drawn anew, 20 to 1000000'), &
      option_type('fit', '--seed', 'N', 'of --bootstrap (default 1): the same seed draws the same rows'), &
      option_type('fit', '--threads', 'N', 'that share --profile or --bootstrap (default 1; 0: all there are)'), &
      option_type('eval', '--kind', 'single|double|quad', 'kind of the numbers, read and computed (default double)'), &
      option_type('eval', '--modulus', '', 'arguments m and mc are given as their roots, the moduli k and k'''), &
      option_type('eval', '--list', '', 'print every NAME with its arguments, results and domain'), &
      option_type('sweep', '--output', 'FILE', &
         'write FILE, NetCDF if it ends in .nc, else CSV (default: CSV on standard output)'), &
      option_type('sweep', '--resume', '', 'go on with FILE.nc; start it where it is not there'), &
      option_type('sweep', '--force', '', 'replace FILE if it is there'), &
      option_type('sweep', '--part', 'I/N', 'compute part I of N of the chunks only'), &
      option_type('sweep', '--merge', '', 'make FILE.nc of the files of the parts, which are named behind PLAN'), &
      option_type('sweep', '--pendulum', 'NAME', 'the pendulum of this name or number, of a plan with several'), &
      option_type('sweep', '--threads', 'N', &
         'of every rank (default all there are, under mpirun 1; 0: all there are)'), &
      option_type('sweep', '--explain', '', 'first say how many points there are and what they cost'), &
      option_type('study', '--quick', '', 'fewer settings, shorter measurements: under 20 seconds'), &
      option_type('study', '--output', 'DIR', 'write study.csv, scripts of gnuplot and pictures into DIR'), &
      option_type('study', '--pendulum', 'NAME', 'only the pendulum of this name or number, of each scene'), &
      option_type('study', '--seconds', 'S', 'measure every point for S seconds (default 0.02, with --quick 0.002)'), &
      option_type('', '--help', '', 'print this help'), &
      option_type('-', '--version', '', 'print version, compiler and licence'), &
      option_type('-', '--manual-page', '', 'print the manual page, for man'), &
      option_type('-', '--scene-page', '', 'print the manual page of scenes, kyvadlo-scene(5)'), &
      option_type('-', '--completion', '', 'print the completion of commands and options for bash')]

   type(example_type), parameter :: examples(*) = [ &
      example_type('table', 'kyvadlo table', 'five built-in pendulums'), &
      example_type('table', 'kyvadlo table examples/scenes/laboratory.nml', 'the pendulums of a scene file'), &
      example_type('table', 'kyvadlo table examples/scenes/laboratory.nml --divisions 360 --format csv', &
         'one period for another program'), &
      example_type('table', 'kyvadlo table examples/scenes/laboratory.nml --kind quad', 'with 32 digits'), &
      example_type('table', 'kyvadlo table --upper -0.9:0.9:19 --lower -1:0:11', &
         'T, k, phi(T), lambda T over a grid'), &
      example_type('table', 'kyvadlo table --release-angle 40 --release-speed 0.8 --length 1.2', &
         'a pendulum by options'), &
      example_type('simulate', 'kyvadlo simulate examples/scenes/foucault.nml', 'one period as CSV'), &
      example_type('simulate', 'kyvadlo simulate examples/scenes/slack_string.nml --output -', &
         'a string that goes slack'), &
      example_type('eval', 'kyvadlo eval K 0.5', 'one value: the complete integral K at m = 1/2'), &
      example_type('eval', 'kyvadlo eval --kind quad orbit 1 9.80665 0.3 -0.8', 'the constants of an orbit'), &
      example_type('eval', 'kyvadlo eval <requests.txt >answers.txt', 'one request a line, one answer a line'), &
      example_type('sweep', 'kyvadlo sweep examples/sweeps/periods.nml', &
         'periods and advances over a grid of orbits'), &
      example_type('sweep', 'mpirun -n 16 kyvadlo sweep PLAN --output FILE.nc --resume', &
         'the same bytes, by 16 processes; what is done is kept'), &
      example_type('fit', 'kyvadlo fit examples/fits/foucault.nml examples/fits/foucault.csv', &
         'what the &fit group of the scene calls free'), &
      example_type('fit', 'kyvadlo fit examples/fits/laboratory.nml examples/fits/laboratory.csv --profile', &
         'and an interval for each number that need not be symmetric'), &
      example_type('fit', &
         'kyvadlo fit examples/fits/laboratory.nml examples/fits/laboratory.csv --explain', &
         'what is fitted, and what it costs, said before'), &
      example_type('study', 'kyvadlo study --quick', 'which method is the cheapest at 1e-3, 1e-6 ...'), &
      example_type('study', 'kyvadlo study --output study', 'the whole record, with pictures'), &
      example_type('study', 'kyvadlo study examples/scenes/laboratory.nml --output laboratory', &
         'for pendulums of your own'), &
      example_type('help', 'kyvadlo help effects', 'what may act on a pendulum, and what it takes'), &
      example_type('examples', 'kyvadlo examples', 'their names, and what they are about'), &
      example_type('examples', 'kyvadlo examples foucault.nml -', 'one of them, on standard output')]

   type(explanation_type), parameter :: explanations(*) = [ &
      explanation_type('table', &
         'SCENE is a file of &pendulum groups (doc/scene_format.md); - is standard input. Without'), &
      explanation_type('table', &
         'SCENE: Foucault''s pendulum, a wide swing, a conical and a plane one, one near the upright.'), &
      explanation_type('table', &
         'Lengths are in metres, z upward from the centre; t = 0 at the upper turning height.'), &
      explanation_type('simulate', &
         'SCENE is a file with one &pendulum group, an &output group (duration, samples, quantities)'), &
      explanation_type('simulate', &
         'and at most one group for each effect (doc/scene_format.md); - is standard input. Numbers'), &
      explanation_type('simulate', &
         'are in SI units, in the shortest form that reads back exactly, under a line of names.'), &
      explanation_type('sweep', &
         'PLAN is a scene with &axis groups (name, from, to, count ...), one &measure (quantities) and'), &
      explanation_type('sweep', &
         'perhaps &histogram groups (doc/sweeps.md). The file depends on the plan alone: by any number'), &
      explanation_type('sweep', &
         'of ranks and threads, interrupted or not, it has the same bytes.'), &
      explanation_type('eval', &
         'Answers are separated by a blank, in the shortest form that reads back exactly. Without'), &
      explanation_type('eval', &
         'NAME, requests are read from standard input, one a line, and each is answered by one'), &
      explanation_type('eval', 'line: the results, or `error: MESSAGE`. Exit status 1 if any request failed.'), &
      explanation_type('help', 'TOPIC is scenes, effects, output or a command. The manual pages kyvadlo(1) and'), &
      explanation_type('help', 'kyvadlo-scene(5) say the same.'), &
      explanation_type('examples', &
         'FILE is NAME in the current folder if it is not given, - is standard output. A file that is'), &
      explanation_type('examples', 'there is not overwritten.'), &
      explanation_type('fit', &
         'SCENE has a &fit group that names what is free, DATA is a table with one line of names'), &
      explanation_type('fit', &
         '(doc/fitting.md). No first guess is needed. Exit status 1: there is no minimum.'), &
      explanation_type('study', &
         'Positions, periods, turning heights and elliptic functions by our closed form and by what else'), &
      explanation_type('study', &
         'there is, of built-in orbits against stored values, or of SCENE against our real128 path.'), &
      explanation_type('study', &
         'study.csv: question, orbit, method, setting, kind, error, nanoseconds a result, evaluations.')]

end module kyvadlo_commands
