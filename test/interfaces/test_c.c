/* The C interface against values of kyvadlo's own driver-independent laws: energy, Legendre's relation, codes, messages. */
#include <kyvadlo.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0, passes = 0;

static void check(int condition, const char *what)
{
  if (condition) {
    ++passes;
  } else {
    ++failures;
    printf("FAIL %s\n", what);
  }
}

static int near(double a, double b, double tolerance)
{
  return fabs(a - b) <= tolerance;
}

/* Every answer of an orbit; how many are not NaN. */
static int answers(const kyvadlo_orbit *orbit)
{
  static double (*const constants[])(const kyvadlo_orbit *) = {kyvadlo_height_period, kyvadlo_modulus,
    kyvadlo_complementary_modulus, kyvadlo_quarter_period, kyvadlo_nome, kyvadlo_phase_rate, kyvadlo_azimuth_rate,
    kyvadlo_azimuth_per_period, kyvadlo_apsidal_advance, kyvadlo_apsidal_angle, kyvadlo_orbit_energy, kyvadlo_orbit_momentum};
  static double (*const functions[])(const kyvadlo_orbit *, double) = {kyvadlo_height, kyvadlo_rise, kyvadlo_top_clearance,
    kyvadlo_azimuth, kyvadlo_vertical_speed, kyvadlo_azimuthal_speed, kyvadlo_speed, kyvadlo_rod_force, kyvadlo_time_to_height,
    kyvadlo_time_to_rise, kyvadlo_time_to_azimuth, kyvadlo_next_turning_time};
  double values[8], p[3], v[3], t[2] = {0.3, 50}, many[6], rates[6];
  int i, numbers = 0;

  for (i = 0; i < 12; i++) numbers += !isnan(constants[i](orbit));
  for (i = 0; i < 12; i++) numbers += !isnan(functions[i](orbit, 0.2));
  kyvadlo_turning(orbit, values);
  for (i = 0; i < 8; i++) numbers += !isnan(values[i]);
  kyvadlo_locate(orbit, 0.3, p, v);
  for (i = 0; i < 3; i++) numbers += !isnan(p[i]) + !isnan(v[i]);
  kyvadlo_locate_many(orbit, 2, t, many, rates);
  for (i = 0; i < 6; i++) numbers += !isnan(many[i]) + !isnan(rates[i]);
  return numbers;
}

/* The matrix of a small swing is that of an oscillator; its columns of time are the velocity; a start off the sphere gives a code. */
static void try_derivatives(void)
{
  double p[3] = {1e-9, 0, -2}, v[3] = {0, 0, 0}, t[2] = {0.7, 1.4}, states[12], matrices[108], periods[16], five[30];
  char message[300];

  check(kyvadlo_derivatives_from_state(2, 8, p, v, 2, t, states, matrices, periods, message, sizeof message) == KYVADLO_OK
    && near(matrices[0], cos(1.4), 1e-12) && near(matrices[54 + 0], cos(2.8), 1e-12) && near(matrices[9 + 4], sin(1.4)/2, 1e-12)
    && near(matrices[8], states[3], 1e-20) && near(periods[6], acos(-1.0)/8, 1e-9), "derivatives of a small swing");
  check(kyvadlo_derivatives_from_heights(2, 8, 0.1, -1, 1, t, states, five, periods, message, sizeof message) == KYVADLO_OK
    && near(five[4], states[3], 1e-12) && !isnan(periods[7]), "derivatives from heights");
  check(kyvadlo_derivatives_from_gaps(2, 8, 0.1, 3, 1, t, states, five, periods, message, sizeof message) == KYVADLO_DOMAIN
    && isnan(five[0]) && isnan(periods[0]) && strlen(message) > 20, "derivatives of no orbit");
  check(kyvadlo_derivatives_from_rises(2, 8, 0.5, 0, 1, t, states, five, periods, NULL, 0) == KYVADLO_OK
    && isnan(five[3]) && !isnan(five[2]), "a column without a derivative");
  /* A small swing in a plane: x = l angle cos(w t), T = pi/w. */
  check(kyvadlo_derivatives_from_release(2, 8, 1e-6, 0, 1, t, states, five, periods, NULL, 0) == KYVADLO_OK
    && near(five[2], acos(-1.0)/90*cos(1.4), 1e-12) && near(periods[0], acos(-1.0)/8, 1e-9), "derivatives from a release");
  check(kyvadlo_derivatives_from_energy(2, 8, -15, 0.3, 1, t, states, five, periods, NULL, 0) == KYVADLO_OK
    && near(five[4], states[3], 1e-12) && !isnan(five[2]) && !isnan(five[3]), "derivatives from energy and momentum");
  /* The energy along these columns is counted from a point that moves with l and g. */
  {
    double above[30], same[6];
    int row, good = 1;
    const double g_l[2] = {16, -16};
    for (int pole = 0; pole < 2; pole++) {
      good = good && (pole == 0 ? kyvadlo_derivatives_from_energy_above_top : kyvadlo_derivatives_from_energy_above_bottom)
        (2, 8, -15 - g_l[pole], 0.3, 1, t, same, above, periods, message, sizeof message) == KYVADLO_OK;
      for (row = 0; row < 6; row++) {
        const double *x = above + 5*row, *y = five + 5*row, sign = pole == 0 ? 1 : -1;
        good = good && near(x[2], y[2], 1e-10) && near(x[3], y[3], 1e-10) && near(x[4], y[4], 1e-10)
          && near(x[0], y[0] + sign*8*y[2], 1e-9) && near(x[1], y[1] + sign*2*y[2], 1e-9);
      }
    }
    check(good, "derivatives from an energy above a pole");
  }
  /* The lowest point, T/2 = pi sqrt(l/g)/2 after the release; no such times at rest. */
  check(kyvadlo_turning_time_derivatives_from_release(2, 8, 1e-6, 0, 0.1, periods, five, message, sizeof message) == KYVADLO_OK
    && near(periods[0], acos(-1.0)/4, 1e-12) && near(five[0], acos(-1.0)/16, 1e-9) && near(five[1], -acos(-1.0)/64, 1e-9),
    "derivatives of a turning time from a release");
  check(kyvadlo_turning_time_derivatives_from_state(2, 8, p, v, 0.1, periods, five, message, sizeof message) == KYVADLO_OK
    && near(periods[0], acos(-1.0)/4, 1e-12) && near(five[6], acos(-1.0)/16, 1e-9) && near(five[7], -acos(-1.0)/64, 1e-9),
    "derivatives of a turning time from a state");
  p[0] = 0;
  check(kyvadlo_turning_time_derivatives_from_state(2, 8, p, v, 0.1, periods, five, NULL, 0) == KYVADLO_OK
    && isnan(periods[0]) && isnan(five[6]), "no turning times at rest");
}

/* Every function of arrays against the function of one value, bit for bit, NaN and infinity among the arguments. */
#define COUNT 9
#define SAME(what, at_index) do { \
    int same = 1; \
    what; \
    for (i = 0; i < COUNT; i++) { \
      double one = at_index; \
      same = same && (memcmp(&one, &f[i], sizeof one) == 0 || (isnan(one) && isnan(f[i]))); \
    } \
    check(same, #at_index); \
  } while (0)
#define ONE(name) SAME(kyvadlo_##name##_many(COUNT, a, f), kyvadlo_##name(a[i]))
#define TWO(name) SAME(kyvadlo_##name##_many(COUNT, a, b, f), kyvadlo_##name(a[i], b[i]))
#define THREE(name) SAME(kyvadlo_##name##_many(COUNT, a, b, c, f), kyvadlo_##name(a[i], b[i], c[i]))
#define FOUR(name) SAME(kyvadlo_##name##_many(COUNT, a, b, c, d, f), kyvadlo_##name(a[i], b[i], c[i], d[i]))

static void try_arrays(void)
{
  const double a[COUNT] = {0.3, 0, 1, -2, 0.7, INFINITY, NAN, 1.5, 0.1}, b[COUNT] = {0.4, 0.5, 1, 0.9, -3, 0.2, 0.1, 0.6, 0},
    c[COUNT] = {0.6, 0.2, 2, 0.8, 0.5, 1, 0.3, 0.9, 0.5}, d[COUNT] = {1, -1, 0.5, 2, 3, 0, 1, 0.1, 0.2};
  const int index[COUNT] = {1, 2, 3, 4, 0, 1, 2, 3, 4};
  double f[COUNT], cn[COUNT], dn[COUNT], am[COUNT], roots[3 * COUNT];
  int found[COUNT], i, good = 1;

  ONE(elliptic_k); ONE(elliptic_kc); ONE(elliptic_e); ONE(elliptic_ec); ONE(elliptic_d); ONE(elliptic_dc); ONE(elliptic_b);
  ONE(elliptic_bc); ONE(elliptic_nome); ONE(elliptic_nomec);
  TWO(carlson_rc); TWO(elliptic_pi); TWO(elliptic_pic); TWO(elliptic_f); TWO(elliptic_fc); TWO(elliptic_einc);
  TWO(elliptic_eincc); TWO(elliptic_dinc); TWO(elliptic_dincc); TWO(elliptic_binc); TWO(elliptic_bincc); TWO(jacobi_zeta);
  TWO(jacobi_zetac); TWO(heuman_lambda); TWO(heuman_lambdac); TWO(bulirsch_el1);
  THREE(carlson_rf); THREE(carlson_rd); THREE(carlson_rg); THREE(elliptic_piinc); THREE(elliptic_piincc); THREE(bulirsch_el3);
  FOUR(carlson_rj); FOUR(bulirsch_cel); FOUR(bulirsch_el2);
  kyvadlo_sncndn_many(COUNT, a, b, f, cn, dn, am);
  for (i = 0; i < COUNT; i++) good = good && (isnan(a[i]) || isinf(a[i]) || near(f[i]*f[i] + cn[i]*cn[i], 1, 1e-15));
  kyvadlo_sncndnc_many(COUNT, a, c, f, cn, dn, am);
  for (i = 0; i < COUNT; i++) good = good && (isnan(a[i]) || isinf(a[i]) || near(f[i], sin(am[i]), 1e-15));
  check(good && isnan(f[6]), "Jacobi's functions of arrays");
  /* theta_3(1, 0.1) = 1 + 2 (0.1 cos 2 + 0.1**4 cos 4 + ...); complex arguments on the real line; cubics. */
  kyvadlo_theta_many(1, index + 2, c + 5, a + 8, f);
  check(near(f[0], 1 + 2*(0.1*cos(2) + 1e-4*cos(4) + 1e-9*cos(6)), 1e-15), "a theta function");
  kyvadlo_theta_derivative_many(1, index + 2, c + 5, a + 8, cn);
  check(near(cn[0], -4*(0.1*sin(2) + 2e-4*sin(4) + 3e-9*sin(6)), 5e-15), "its derivative");
  kyvadlo_complex_theta_many(1, index + 2, c + 5, d + 5, a + 8, dn, am);
  check(near(dn[0], f[0], 1e-15) && near(am[0], 0, 1e-15), "the same, complex");
  kyvadlo_complex_theta_derivative_many(1, index + 2, c + 5, d + 5, a + 8, dn, am);
  check(near(dn[0], cn[0], 1e-15) && near(am[0], 0, 1e-15), "its derivative, complex");
  f[0] = 1; cn[0] = 0; dn[0] = -7; am[0] = 6;
  kyvadlo_cubic_roots_many(1, f, cn, dn, am, roots, found);
  check(found[0] == 3 && near(roots[0], -3, 1e-15) && near(roots[1], 1, 1e-15) && near(roots[2], 2, 1e-15), "a cubic");
}

/* A struct that was never set up, or of which bytes have changed, answers NaN, and a code: 1b/10 item 10. */
/* Many orbits at once, beside each set up; what is no orbit is NaN. */
static void try_many_orbits(void)
{
  double gaps[100], rises[100], periods[100], advances[100], constants[800], positions[300], velocities[300], p[3], v[3];
  kyvadlo_orbit orbit;
  int i;

  for (i = 0; i < 100; i++) {
    gaps[i] = 0.06 + 0.015*i;
    rises[i] = 0.05 - 0.0004*i;
  }
  kyvadlo_orbits_period_from_gaps(1, 9.8, 100, gaps, rises, periods, 1);
  kyvadlo_orbits_advance_from_gaps(1, 100, gaps, rises, advances, 2);
  kyvadlo_orbits_constants_from_gaps(1, 9.8, 100, gaps, rises, constants, 2);
  kyvadlo_orbits_locate_from_gaps(1, 9.8, 100, gaps, rises, 1.3, positions, velocities, 0);
  for (i = 0; i < 100; i++) {
    kyvadlo_orbit_from_gaps(1, 9.8, gaps[i], rises[i], &orbit, NULL, 0);
    check(fabs(periods[i]/kyvadlo_height_period(&orbit) - 1) <= 4*DBL_EPSILON, "T of many orbits");
    check(fabs(advances[i]/kyvadlo_apsidal_advance(&orbit) - 1) <= 8*DBL_EPSILON, "advance of many orbits");
    check(fabs(constants[8*i]/periods[i] - 1) <= 8*DBL_EPSILON && fabs(constants[8*i + 7]/advances[i] - 1) <= 8*DBL_EPSILON
      && fabs(constants[8*i + 4]/kyvadlo_nome(&orbit) - 1) <= 8*DBL_EPSILON, "constants of many orbits");
    kyvadlo_locate(&orbit, 1.3, p, v);
    /* 3 eps (l + t v), 3 eps (v + t (g + v*v/l)) with speeds to 7 m/s. */
    check(fabs(positions[3*i] - p[0]) <= 30*DBL_EPSILON && fabs(positions[3*i + 2] - p[2]) <= 30*DBL_EPSILON, "positions");
    check(fabs(velocities[3*i + 1] - v[1]) <= 250*DBL_EPSILON, "velocities of many orbits");
  }
  rises[3] = 2;
  kyvadlo_orbits_period_from_gaps(1, 9.8, 5, gaps, rises, periods, 1);
  kyvadlo_orbits_advance_from_gaps(1, 5, gaps, rises, advances, 1);
  kyvadlo_orbits_constants_from_gaps(1, 9.8, 5, gaps, rises, constants, 1);
  check(isnan(constants[24]) && isnan(constants[31]) && !isnan(constants[32]), "no constants among many");
  check(isnan(periods[3]) && isnan(advances[3]) && !isnan(periods[4]), "no orbit among many");
}

static void try_broken_orbits(void)
{
  kyvadlo_orbit good, orbit, before;
  unsigned char *bytes = (unsigned char *)&orbit;
  char message[300];
  int i, k, wrong = 0, codes = 0;

  check(kyvadlo_orbit_from_heights(1, 9.8, 0.3, -0.8, &good, message, SIZE_MAX) == KYVADLO_OK && message[0] == 0, "SIZE_MAX");
  check(kyvadlo_is_set_up(&good) == 1 && answers(&good) == 50, "an orbit that is set up");
  check(kyvadlo_orbit_from_heights(1, 9.8, -0.8, 0.3, &orbit, message, SIZE_MAX) == KYVADLO_DOMAIN && strlen(message) > 20,
        "a message in a buffer said to be of SIZE_MAX");
  check(kyvadlo_is_set_up(&orbit) == 0 && answers(&orbit) == 0, "an orbit that failed");
  check(kyvadlo_orbit_to_accuracy(&orbit, 1e-6, 10, message, sizeof message) == KYVADLO_DOMAIN
        && strstr(message, "kyvadlo_orbit_to_accuracy: orbit is not set up") != NULL, "the accuracy of an orbit that failed");
  memset(&orbit, 0, sizeof orbit);
  check(kyvadlo_is_set_up(&orbit) == 0 && answers(&orbit) == 0, "a zeroed orbit");
  check(kyvadlo_is_set_up(NULL) == 0, "no orbit at all");
  srand(1);
  for (i = 0; i < 1500; i++) {
    for (k = 0; k < (int)sizeof orbit; k++) bytes[k] = (unsigned char)(rand() >> 7);
    wrong += answers(&orbit);
    codes += kyvadlo_orbit_to_accuracy(&orbit, 1e-6, 10, message, sizeof message) == KYVADLO_DOMAIN;
  }
  check(wrong == 0 && codes == 1500, "random bytes");
  codes = 0;
  for (i = 0; i < 10000; i++) {
    orbit = good;
    for (k = 0; k < 3; k++) {
      unsigned at = (unsigned)rand() % sizeof orbit;
      bytes[at] ^= (unsigned char)(1 + (rand() >> 7) % 255);
    }
    if (memcmp(&orbit, &good, sizeof orbit) == 0) {
      codes++;  /* Twice the same byte and back. */
      continue;
    }
    before = orbit;
    wrong += answers(&orbit) + kyvadlo_is_set_up(&orbit);
    codes += kyvadlo_orbit_to_accuracy(&orbit, 1e-6, 10, message, sizeof message) == KYVADLO_DOMAIN;
    wrong += memcmp(&orbit, &before, sizeof orbit) != 0;
  }
  check(wrong == 0 && codes == 10000, "three flipped bytes");
}

int main(void)
{
  const double pi = 3.14159265358979323846, g = 9.80665;
  char message[200] = "x", tiny[4];
  kyvadlo_orbit orbit;
  double sn, cn, dn, am, values[8], p[3], v[3], many[6], rates[6], times[2] = {0.3, 1.7};
  int i;

  /* DLMF 19.7.1, Legendre's relation, and sn**2 + cn**2 = 1: they miss no factor together with K(0). */
  check(near(kyvadlo_elliptic_k(0), pi/2, 1e-15), "K(0)");
  check(near(kyvadlo_elliptic_e(0.3)*kyvadlo_elliptic_kc(0.3) + kyvadlo_elliptic_ec(0.3)*kyvadlo_elliptic_k(0.3)
             - kyvadlo_elliptic_k(0.3)*kyvadlo_elliptic_kc(0.3), pi/2, 1e-14), "Legendre's relation");
  kyvadlo_sncndn(0.7, 0.4, &sn, &cn, &dn, &am);
  check(near(sn*sn + cn*cn, 1, 1e-15) && near(dn*dn + 0.4*sn*sn, 1, 1e-15), "sn, cn, dn");
  check(near(kyvadlo_elliptic_f(am, 0.4), 0.7, 1e-15), "F inverts am");
  check(near(kyvadlo_carlson_rf(1, 1, 1), 1, 1e-15) && near(kyvadlo_carlson_rj(1, 1, 1, 1), 1, 1e-15)
        && near(kyvadlo_carlson_rd(4, 4, 4), 0.125, 1e-15) && near(kyvadlo_carlson_rc(4, 4), 0.5, 1e-15)
        && near(kyvadlo_carlson_rg(4, 4, 4), 2, 1e-15), "Carlson at equal arguments");
  /* test/reference/make_f77_functions.py */
  check(near(kyvadlo_bulirsch_cel(0.625, 3, 1.5, 0.25), 1.036482718796511786, 1e-15)
        && near(kyvadlo_bulirsch_el1(1.75, 0.625), 1.176431858130082575, 1e-15)
        && near(kyvadlo_bulirsch_el2(1.75, 0.625, 1.5, 0.25), 1.2969441775304251096, 1e-15)
        && near(kyvadlo_bulirsch_el3(1.75, 0.625, 3), 0.78728492170397107298, 1e-15), "Bulirsch's functions");
  check(isnan(kyvadlo_elliptic_k(2)) && isinf(kyvadlo_elliptic_k(1)), "K beyond and at its pole");
  check(near(kyvadlo_elliptic_piinc(0, 0.5, 0.2), kyvadlo_elliptic_f(0.5, 0.2), 1e-15), "Pi at n = 0");

  check(sizeof(kyvadlo_orbit) == KYVADLO_ORBIT_SIZE*sizeof(double), "size of an orbit");
  check(kyvadlo_orbit_from_heights(1, g, 0.3, -0.8, &orbit, message, sizeof message) == KYVADLO_OK, "set-up");
  check(message[0] == 0, "no message");
  kyvadlo_turning(&orbit, values);
  check(near(values[0], -0.8, 0) && near(values[1], 0.3, 0) && near(values[2], 1.52, 1e-15), "turning heights");
  kyvadlo_locate(&orbit, 1.7, p, v);
  check(near(p[0]*p[0] + p[1]*p[1] + p[2]*p[2], 1, 1e-14), "on the sphere");
  check(near((v[0]*v[0] + v[1]*v[1] + v[2]*v[2])/2 + g*p[2], kyvadlo_orbit_energy(&orbit), 1e-13), "energy");
  check(near(p[0]*v[1] - p[1]*v[0], kyvadlo_orbit_momentum(&orbit), 1e-13), "momentum");
  check(near(kyvadlo_height(&orbit, kyvadlo_height_period(&orbit)/2), -0.8, 1e-14), "half a period");
  check(near(kyvadlo_height(&orbit, kyvadlo_time_to_height(&orbit, 0.1)), 0.1, 1e-14), "passage");
  kyvadlo_locate_many(&orbit, 2, times, many, rates);
  /* The vector kernels: 5 eps of the length and of the greatest speed (6 m/s) at worst for each of the two. */
  for (i = 0; i < 3; ++i)
    check(fabs(many[3 + i] - p[i]) <= 10*DBL_EPSILON && fabs(rates[3 + i] - v[i]) <= 60*DBL_EPSILON, "many times");
  {
    /* Threads that are asked for change no value. */
    static double at[20000], here[60000], there[60000], moving[60000];
    int n, threads;
    for (n = 0; n < 20000; n++) at[n] = 0.01*n;
    kyvadlo_locate_many(&orbit, 20000, at, here, moving);
    for (threads = 0; threads < 4; threads++) {
      kyvadlo_locate_many_threads(&orbit, 20000, at, there, moving, threads);
      check(memcmp(here, there, sizeof here) == 0, "many threads");
    }
    for (threads = 0; threads < 4; threads++) {
      kyvadlo_azimuths(&orbit, 20000, at, there, threads);
      for (n = 0; n < 20000; n += 7)
        check(fabs(there[n] - kyvadlo_azimuth(&orbit, at[n])) <= 8*DBL_EPSILON*(1 + there[n]), "azimuths of many times");
    }
  }
  check(kyvadlo_orbit_bytes() == sizeof orbit, "the size of an orbit");

  {
    /* To 1e-6 of l = 1 the same places, not to the last digit; not finer than double precision, nor twice. */
    kyvadlo_orbit rough = orbit;
    double moved[6], unused[6], far = 0;
    int k;
    check(kyvadlo_orbit_to_accuracy(&rough, 1e-6, 100, message, sizeof message) == KYVADLO_OK, "accuracy 1e-6");
    kyvadlo_locate_many(&rough, 2, times, moved, unused);
    for (k = 0; k < 6; k++) far = fmax(far, fabs(moved[k] - many[k]));
    check(far <= 1e-6 && far > 1e-14, "places to 1e-6");
    check(kyvadlo_orbit_to_accuracy(&rough, 1e-3, 100, message, sizeof message) == KYVADLO_DOMAIN, "accuracy twice");
    check(kyvadlo_orbit_to_accuracy(&orbit, 1e-20, 100, message, sizeof message) == KYVADLO_DOMAIN, "accuracy 1e-20");
    check(strstr(message, "1.00E-20") != NULL, message);
    kyvadlo_locate_many(&orbit, 2, times, moved, unused);
    check(memcmp(moved, many, sizeof moved) == 0, "an orbit that could not be had stays as it was");
  }
  check(kyvadlo_orbit_from_state(1, g, p, v, &orbit, message, sizeof message) == KYVADLO_OK, "state");
  kyvadlo_locate(&orbit, 0, many, rates);
  check(near(many[0], p[0], 4e-16) && near(many[2], p[2], 4e-16) && near(rates[1], v[1], 4e-15), "the start comes back");

  check(kyvadlo_orbit_from_heights(1, g, -0.8, 0.3, &orbit, message, sizeof message) == KYVADLO_DOMAIN, "refusal");
  check(strstr(message, "upper = -0.8") != NULL
        && strstr(message, "z_upper") == NULL && isnan(kyvadlo_height_period(&orbit)), "message and NaN");
  check(kyvadlo_orbit_from_heights(-1, g, -0.8, 0.3, &orbit, tiny, sizeof tiny) == KYVADLO_DOMAIN && strlen(tiny) == 3,
        "a message that is too long for its buffer");
  check(kyvadlo_orbit_from_heights(-1, g, -0.8, 0.3, &orbit, NULL, 0) == KYVADLO_DOMAIN, "no buffer at all");

  check(strcmp(kyvadlo_message(KYVADLO_OK), "no error") == 0 && strstr(kyvadlo_message(KYVADLO_DOMAIN), "rule") != NULL
        && strstr(kyvadlo_message(-1), "unknown") != NULL, "what codes mean");

  try_broken_orbits();
  try_arrays();
  try_many_orbits();
  try_derivatives();
  printf("%d passed, %d failed\n", passes, failures);
  return failures != 0;
}
