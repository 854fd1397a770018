// How far a pendulum of 1 m strays from the plane of its first swing: many times of one orbit at once, from C++.
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <vector>

#include <kyvadlo.h>

namespace {

// An orbit is a plain struct, so a value will do; a broken rule becomes an exception with the library's message.
kyvadlo_orbit orbit_from_heights(double length, double gravity, double upper, double lower)
{
  char message[300];
  kyvadlo_orbit orbit;
  if (kyvadlo_orbit_from_heights(length, gravity, upper, lower, &orbit, message, sizeof message) != KYVADLO_OK)
    throw std::domain_error(message);
  return orbit;
}

}  // namespace

int main()
{
  try {
    const kyvadlo_orbit orbit = orbit_from_heights(1.0, 9.80665, -0.5, -0.999);
    const double period = kyvadlo_height_period(&orbit);
    const std::size_t count = 10001;
    std::vector<double> times(count), positions(3*count), velocities(3*count);
    for (std::size_t i = 0; i < count; ++i) times[i] = 10*period*static_cast<double>(i)/static_cast<double>(count - 1);
    kyvadlo_locate_many(&orbit, count, times.data(), positions.data(), velocities.data());

    double farthest = 0, worst = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double *p = &positions[3*i], *v = &velocities[3*i];
      farthest = std::fmax(farthest, std::fabs(p[1]));
      const double energy = (v[0]*v[0] + v[1]*v[1] + v[2]*v[2])/2 + 9.80665*p[2];
      const double error = std::fabs(energy - kyvadlo_orbit_energy(&orbit));
      if (!(error <= worst)) worst = error;  // also when it is NaN
    }
    std::printf("ten periods of %.6f s: up to %.4f m from the first plane\n", period, farthest);
    std::printf("energy kept to 1e-13 m2/s2: %s\n", worst <= 1e-13 ? "yes" : "no");

    try {
      orbit_from_heights(1.0, 9.80665, 0.8, 0.3);
    } catch (const std::domain_error &error) {
      std::printf("refused: %s\n", error.what());
    }
    return worst <= 1e-13 ? 0 : 1;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
