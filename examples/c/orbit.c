/* One period of a pendulum of 1 m between 0.3 m above and 0.8 m below its pivot, as CSV. */
#include <stdio.h>
#include <kyvadlo.h>

int main(void)
{
  char message[300];
  kyvadlo_orbit orbit;
  if (kyvadlo_orbit_from_heights(1.0, 9.80665, 0.3, -0.8, &orbit, message, sizeof message) != KYVADLO_OK) {
    fprintf(stderr, "%s\n", message);
    return 1;
  }
  const double period = kyvadlo_height_period(&orbit);
  printf("# T = %.17g s, lambda T = %.17g, K(1/2) = %.17g\n", period, kyvadlo_apsidal_advance(&orbit),
         kyvadlo_elliptic_k(0.5));
  puts("t,x,y,z,vx,vy,vz");
  for (int i = 0; i <= 8; ++i) {
    double position[3], velocity[3];
    kyvadlo_locate(&orbit, i*period/8, position, velocity);
    printf("%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", i*period/8, position[0], position[1], position[2],
           velocity[0], velocity[1], velocity[2]);
  }
  return 0;
}
