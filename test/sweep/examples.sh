# The plans of examples/sweeps against laws. $3: mpirun, or empty (not used).
. "$2/test/driver/expect.sh"
holds() {
   checks=$((checks + 1))
   command_line="kyvadlo sweep $1"
   awk -F, "$2" out >found 2>&1
   [ ! -s found ] || complain "$(head -n 3 found)"
}

# Periods: 2 K/(the rate of the phase), by the arithmetic-geometric mean: T = pi sqrt(2 l/g)/agm(sqrt(z3 - z2), sqrt(z3 - z1)) with
# l = 1; z3 from 1 + z1 z2 = -(z1 + z2) z3.
run sweep "$top/examples/sweeps/periods.nml"
expect_status 0
holds periods.nml 'NR > 1 && $6 == "computed" { u = $1; w = $2; s = -(u + w); if (s <= 0) next
      z = (1 + u*w)/s; a = sqrt(z - w); b = sqrt(z - u)
      for (i = 0; i < 8; i++) { c = (a + b)/2; b = sqrt(a*b); a = c }
      t = atan2(0, -1)*sqrt(2/9.80665)/a; n++
      if (($3 - t)^2 > (1e-13*t)^2) print $0, t }
   END { if (n < 400) print n, "periods" }'

# Foucault: the Earth turns the line of the swing by -omega sin(latitude) t, and an ellipse a, b by 3/8 sqrt(g/l) a b/l**2 t (Airy).
run sweep "$top/examples/sweeps/foucault.nml"
expect_status 0
holds foucault.nml 'NR > 1 { pi = atan2(0, -1); w = sqrt(0.980665); a = $1*pi/180; t = 19*pi/w
      law = (3/8*w*a*($2/w/10) - 7.292115e-5*sin(48.85*pi/180))*t; n++
      if ($5 != "computed" || ($3 - law)^2 > (0.01*law)^2 + 1e-8 || ($4 - a)^2 > (1e-5*a)^2) print $0, law }
   END { if (n < 30) print n, "swings" }'

# A throw from below: the string goes slack if the ball passes the height of the pivot but not the top.
run sweep "$top/examples/sweeps/thrown.nml"
expect_status 0
holds thrown.nml 'NR > 1 { v = $1*$1 + $2*$2; n++; slack = v > 2*9.80665 && v < 5*9.80665
      if (slack != ($3 != "") || $4 != "computed") print; thrown[$1]++; freed[$1] += slack
      # The normal distribution of the speed across, by its integral.
      if (!($1 in law)) { p = 0; for (x = -6 + 0.0005; x < 6; x += 0.001) if ($1*$1 + x*x > 2*9.80665 && $1*$1 + x*x < 5*9.80665) {
         p += exp(-x*x/2)*0.001/sqrt(8*atan2(1, 1)) } law[$1] = p } }
   END { for (v in law) if ((freed[v]/thrown[v] - law[v])^2 > 16*law[v]*(1 - law[v])/thrown[v] + 1e-4) print v, freed[v]/thrown[v], law[v]
      if (n < 1000) print n, "throws" }'
finish
