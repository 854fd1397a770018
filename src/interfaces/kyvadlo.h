/* kyvadlo: the spherical pendulum in closed form, and the elliptic functions it needs. C99 and C++.

   All in double precision and SI units. Every function is thread-safe: an orbit is a plain struct that the caller owns,
   set up once and read afterwards; nothing is allocated, nothing need be freed. Conventions: parameter m = k*k,
   complementary parameter mc = 1 - m (names ending in c), characteristic n in 1 - n sin^2. Outside its domain a
   function returns NaN, at a pole an infinity. See doc/elliptic.md and doc/c_interface.md. */
#ifndef KYVADLO_H
#define KYVADLO_H

#include <stddef.h>

/* The version of this file; kyvadlo_version() tells that of the library that is linked. */
#define KYVADLO_VERSION "0.2.0"
#define KYVADLO_VERSION_MAJOR 0
#define KYVADLO_VERSION_MINOR 2
#define KYVADLO_VERSION_PATCH 0

#ifdef __cplusplus
extern "C" {
#endif

const char *kyvadlo_version(void); /* "0.2.0", of the library */

/* ---- Elliptic functions ------------------------------------------------------------------------------------------ */

double kyvadlo_elliptic_k(double m); /* K(m), m <= 1 */
double kyvadlo_elliptic_kc(double mc); /* K from mc = 1 - m >= 0 */
double kyvadlo_elliptic_e(double m); /* E(m) */
double kyvadlo_elliptic_ec(double mc); /* E from mc */
double kyvadlo_elliptic_d(double m); /* D(m) = (K - E)/m */
double kyvadlo_elliptic_dc(double mc); /* D from mc */
double kyvadlo_elliptic_b(double m); /* B(m) = K - D */
double kyvadlo_elliptic_bc(double mc); /* B from mc */
double kyvadlo_elliptic_nome(double m); /* q(m) = exp(-pi K'/K) */
double kyvadlo_elliptic_nomec(double mc); /* q from mc */

double kyvadlo_carlson_rc(double x, double y); /* R_C(x, y); y < 0: principal value */
double kyvadlo_elliptic_pi(double n, double m); /* complete Pi(n, m); n > 1: principal value */
double kyvadlo_elliptic_pic(double n, double mc); /* the same from mc */
double kyvadlo_elliptic_f(double phi, double m); /* F(phi, m), any real phi */
double kyvadlo_elliptic_fc(double phi, double mc); /* the same from mc */
double kyvadlo_elliptic_einc(double phi, double m); /* E(phi, m) */
double kyvadlo_elliptic_eincc(double phi, double mc); /* the same from mc */
double kyvadlo_elliptic_dinc(double phi, double m); /* D(phi, m) */
double kyvadlo_elliptic_dincc(double phi, double mc); /* the same from mc */
double kyvadlo_elliptic_binc(double phi, double m); /* B(phi, m) */
double kyvadlo_elliptic_bincc(double phi, double mc); /* the same from mc */
double kyvadlo_jacobi_zeta(double u, double m); /* Z(u, m) = E(am u) - u E/K */
double kyvadlo_jacobi_zetac(double u, double mc); /* the same from mc */
double kyvadlo_heuman_lambda(double phi, double m); /* Heuman's lambda0(phi, m) */
double kyvadlo_heuman_lambdac(double phi, double mc); /* the same from mc */

double kyvadlo_carlson_rf(double x, double y, double z); /* R_F(x, y, z) */
double kyvadlo_carlson_rd(double x, double y, double z); /* R_D(x, y, z) */
double kyvadlo_carlson_rg(double x, double y, double z); /* R_G(x, y, z) */
double kyvadlo_elliptic_piinc(double n, double phi, double m); /* Pi(n; phi, m) */
double kyvadlo_elliptic_piincc(double n, double phi, double mc); /* the same from mc */
double kyvadlo_carlson_rj(double x, double y, double z, double p); /* R_J(x, y, z, p); p < 0: principal value */

/* Bulirsch's: kc is the complementary modulus of either sign, kc**2 = 1 - m; x = tan(phi); p = 1 - n. */
double kyvadlo_bulirsch_cel(double kc, double p, double a, double b); /* complete */
double kyvadlo_bulirsch_el1(double x, double kc); /* F */
double kyvadlo_bulirsch_el2(double x, double kc, double a, double b); /* E at a = 1, b = kc**2 */
double kyvadlo_bulirsch_el3(double x, double kc, double p); /* Pi */

/* sn, cn, dn and the amplitude am of u, for the parameter m or its complement. */
void kyvadlo_sncndn(double u, double m, double *sn, double *cn, double *dn, double *am);
void kyvadlo_sncndnc(double u, double mc, double *sn, double *cn, double *dn, double *am);

/* The same of arrays: `count` values, the arguments and results of index i belong together. No array of results may
   overlap another array. */
void kyvadlo_elliptic_k_many(size_t count, const double *m, double *values);
void kyvadlo_elliptic_kc_many(size_t count, const double *mc, double *values);
void kyvadlo_elliptic_e_many(size_t count, const double *m, double *values);
void kyvadlo_elliptic_ec_many(size_t count, const double *mc, double *values);
void kyvadlo_elliptic_d_many(size_t count, const double *m, double *values);
void kyvadlo_elliptic_dc_many(size_t count, const double *mc, double *values);
void kyvadlo_elliptic_b_many(size_t count, const double *m, double *values);
void kyvadlo_elliptic_bc_many(size_t count, const double *mc, double *values);
void kyvadlo_elliptic_nome_many(size_t count, const double *m, double *values);
void kyvadlo_elliptic_nomec_many(size_t count, const double *mc, double *values);
void kyvadlo_carlson_rc_many(size_t count, const double *x, const double *y, double *values);
void kyvadlo_elliptic_pi_many(size_t count, const double *n, const double *m, double *values);
void kyvadlo_elliptic_pic_many(size_t count, const double *n, const double *mc, double *values);
void kyvadlo_elliptic_f_many(size_t count, const double *phi, const double *m, double *values);
void kyvadlo_elliptic_fc_many(size_t count, const double *phi, const double *mc, double *values);
void kyvadlo_elliptic_einc_many(size_t count, const double *phi, const double *m, double *values);
void kyvadlo_elliptic_eincc_many(size_t count, const double *phi, const double *mc, double *values);
void kyvadlo_elliptic_dinc_many(size_t count, const double *phi, const double *m, double *values);
void kyvadlo_elliptic_dincc_many(size_t count, const double *phi, const double *mc, double *values);
void kyvadlo_elliptic_binc_many(size_t count, const double *phi, const double *m, double *values);
void kyvadlo_elliptic_bincc_many(size_t count, const double *phi, const double *mc, double *values);
void kyvadlo_jacobi_zeta_many(size_t count, const double *u, const double *m, double *values);
void kyvadlo_jacobi_zetac_many(size_t count, const double *u, const double *mc, double *values);
void kyvadlo_heuman_lambda_many(size_t count, const double *phi, const double *m, double *values);
void kyvadlo_heuman_lambdac_many(size_t count, const double *phi, const double *mc, double *values);
void kyvadlo_carlson_rf_many(size_t count, const double *x, const double *y, const double *z, double *values);
void kyvadlo_carlson_rd_many(size_t count, const double *x, const double *y, const double *z, double *values);
void kyvadlo_carlson_rg_many(size_t count, const double *x, const double *y, const double *z, double *values);
void kyvadlo_elliptic_piinc_many(size_t count, const double *n, const double *phi, const double *m, double *values);
void kyvadlo_elliptic_piincc_many(size_t count, const double *n, const double *phi, const double *mc, double *values);
void kyvadlo_carlson_rj_many(size_t count, const double *x, const double *y, const double *z, const double *p,
   double *values);
void kyvadlo_bulirsch_cel_many(size_t count, const double *kc, const double *p, const double *a, const double *b,
   double *values);
void kyvadlo_bulirsch_el1_many(size_t count, const double *x, const double *kc, double *values);
void kyvadlo_bulirsch_el2_many(size_t count, const double *x, const double *kc, const double *a, const double *b,
   double *values);
void kyvadlo_bulirsch_el3_many(size_t count, const double *x, const double *kc, const double *p, double *values);
void kyvadlo_sncndn_many(size_t count, const double *u, const double *m, double *sn, double *cn, double *dn,
   double *am);
void kyvadlo_sncndnc_many(size_t count, const double *u, const double *mc, double *sn, double *cn, double *dn,
   double *am);

/* Jacobi's theta_i(v, q), i = 1 to 4, and its derivative along v, DLMF 20.2; of real v, and of complex v by its parts. */
void kyvadlo_theta_many(size_t count, const int *i, const double *v, const double *q, double *values);
void kyvadlo_theta_derivative_many(size_t count, const int *i, const double *v, const double *q, double *values);
void kyvadlo_complex_theta_many(size_t count, const int *i, const double *v_re, const double *v_im, const double *q,
   double *re, double *im);
void kyvadlo_complex_theta_derivative_many(size_t count, const int *i, const double *v_re, const double *v_im,
   const double *q, double *re, double *im);

/* The distinct real roots of a x^3 + b x^2 + c x + d, ascending: roots[3*i], ... of the i-th, NaN behind them; found[i]
   of them, -1 where there is no answer. */
void kyvadlo_cubic_roots_many(size_t count, const double *a, const double *b, const double *c, const double *d,
   double *roots, int *found);

/* ---- Orbits ------------------------------------------------------------------------------------------------ */

#define KYVADLO_ORBIT_SIZE 225

/* An orbit. Its contents belong to the version of the library that made it: a checksum guards them, and of a struct
   that was never set up, or changed, every function answers NaN or a code. It may be copied as a whole. */
typedef struct { double hidden[KYVADLO_ORBIT_SIZE]; } kyvadlo_orbit;

/* 1 if the struct holds an orbit as a set-up left it, else 0, also of a null pointer. */
int kyvadlo_is_set_up(const kyvadlo_orbit *orbit);

/* sizeof(kyvadlo_orbit), for languages that do not read this file. */
size_t kyvadlo_orbit_bytes(void);

/* Codes of the functions that set up an orbit. */
enum {
  KYVADLO_OK = 0,     /* the orbit is set up */
  KYVADLO_DOMAIN = 1  /* a value breaks a rule; the message names it */
};

/* What a code means, in a few words; never null, and not to be freed. A set-up's own message says more. */
const char *kyvadlo_message(int code);

/* Set-up from length l and gravity g > 0 and two numbers. Returns a code; on failure `message` (of `capacity` bytes,
   may be 0) says which rule is broken by which values, and every result from the orbit is NaN. */
/* The turning heights z1 >= z2 above the pivot [m]; z1 + z2 < 0. */
int kyvadlo_orbit_from_heights(double length, double gravity, double upper, double lower,
   kyvadlo_orbit *orbit, char *message, size_t capacity);
/* The distances l - z1 and l + z2 to the highest and the lowest point [m]; lower_rise < upper_gap. */
int kyvadlo_orbit_from_gaps(double length, double gravity, double upper_gap, double lower_rise,
   kyvadlo_orbit *orbit, char *message, size_t capacity);
/* The rises l + z1 >= l + z2 above the lowest point [m]: the input for small swings. */
int kyvadlo_orbit_from_rises(double length, double gravity, double upper_rise, double lower_rise,
   kyvadlo_orbit *orbit, char *message, size_t capacity);
/* Energy c1 (0 at rest at the height of the pivot) [m2/s2] and angular momentum c2 [m2/s] per mass. */
int kyvadlo_orbit_from_energy(double length, double gravity, double energy, double momentum,
   kyvadlo_orbit *orbit, char *message, size_t capacity);
/* c1 - g l [m2/s2] and c2 [m2/s]. */
int kyvadlo_orbit_from_energy_above_top(double length, double gravity, double energy, double momentum,
   kyvadlo_orbit *orbit, char *message, size_t capacity);
/* c1 + g l [m2/s2] and c2 [m2/s]. */
int kyvadlo_orbit_from_energy_above_bottom(double length, double gravity, double energy, double momentum,
   kyvadlo_orbit *orbit, char *message, size_t capacity);
/* Angle from the downward vertical [degrees], horizontal speed across [m/s]. */
int kyvadlo_orbit_from_release(double length, double gravity, double angle, double speed,
   kyvadlo_orbit *orbit, char *message, size_t capacity);
/* From a position on the sphere and a tangential velocity (x, y, z; z upwards) at t = 0. */
int kyvadlo_orbit_from_state(double length, double gravity, const double position[3], const double velocity[3],
   kyvadlo_orbit *orbit, char *message, size_t capacity);

/* The motion and its exact derivatives at `count` times [s]. `states` takes x y z vx vy vz for each time; `matrices` their
   derivatives, six rows for each time; `periods` the derivatives of T, then of lambda T. NaN stands where there is no
   derivative; after a failed set-up, which the code and the message tell, everywhere. From a state the columns are
   x y z vx vy vz l g t (matrices[count][6][9], periods[2][8]: no t), */
int kyvadlo_derivatives_from_state(double length, double gravity, const double position[3], const double velocity[3],
   size_t count, const double *times, double *states, double *matrices, double *periods,
   char *message, size_t capacity);
/* and from the turning heights, gaps or rises, t counted from an upper turning point, l g, the two given values, t
   (matrices[count][6][5], periods[2][4]). */
int kyvadlo_derivatives_from_heights(double length, double gravity, double upper, double lower,
   size_t count, const double *times, double *states, double *matrices, double *periods,
   char *message, size_t capacity);
int kyvadlo_derivatives_from_gaps(double length, double gravity, double upper_gap, double lower_rise,
   size_t count, const double *times, double *states, double *matrices, double *periods,
   char *message, size_t capacity);
int kyvadlo_derivatives_from_rises(double length, double gravity, double upper_rise, double lower_rise,
   size_t count, const double *times, double *states, double *matrices, double *periods,
   char *message, size_t capacity);
/* The same from energy c1, or c1 - g l or c1 + g l, and momentum c2, and, t counted from the release, from an angle [degrees]
   and a speed. */
int kyvadlo_derivatives_from_energy(double length, double gravity, double energy, double momentum,
   size_t count, const double *times, double *states, double *matrices, double *periods,
   char *message, size_t capacity);
int kyvadlo_derivatives_from_energy_above_top(double length, double gravity, double energy_above_top, double momentum,
   size_t count, const double *times, double *states, double *matrices, double *periods,
   char *message, size_t capacity);
int kyvadlo_derivatives_from_energy_above_bottom(double length, double gravity, double energy_above_bottom, double momentum,
   size_t count, const double *times, double *states, double *matrices, double *periods,
   char *message, size_t capacity);
int kyvadlo_derivatives_from_release(double length, double gravity, double angle, double speed,
   size_t count, const double *times, double *states, double *matrices, double *periods,
   char *message, size_t capacity);
/* The first time later than `time` at which the bob is at a turning height [s], and its derivatives along the same columns
   but t; NaN for circles, rest and the separatrix. From the other starts it is a number of half periods. */
int kyvadlo_turning_time_derivatives_from_state(double length, double gravity, const double position[3],
   const double velocity[3], double time, double *turning, double slopes[8], char *message, size_t capacity);
int kyvadlo_turning_time_derivatives_from_release(double length, double gravity, double angle, double speed, double time,
   double *turning, double slopes[4], char *message, size_t capacity);

/* Lets kyvadlo_locate_many compute the positions of an orbit in single precision or with fewer terms, whichever keeps
   the accuracy at the least cost: off by at most accuracy * l while |t| <= span [s], velocities by at most twice the
   accuracy of the greatest speed. From 3.6e-15 to 0.1, and once for an orbit; where that fails the orbit stays as it
   was. */
int kyvadlo_orbit_to_accuracy(kyvadlo_orbit *orbit, double accuracy, double span, char *message, size_t capacity);

/* What does not change along an orbit. */
double kyvadlo_height_period(const kyvadlo_orbit *orbit); /* T, from one highest point to the next [s] */
double kyvadlo_modulus(const kyvadlo_orbit *orbit); /* k */
double kyvadlo_complementary_modulus(const kyvadlo_orbit *orbit); /* k' */
double kyvadlo_quarter_period(const kyvadlo_orbit *orbit); /* K(k) */
double kyvadlo_nome(const kyvadlo_orbit *orbit); /* q */
double kyvadlo_phase_rate(const kyvadlo_orbit *orbit); /* dw/dt = 2K/T [1/s] */
double kyvadlo_azimuth_rate(const kyvadlo_orbit *orbit); /* A [1/s] */
double kyvadlo_azimuth_per_period(const kyvadlo_orbit *orbit); /* phi(T) [rad] */
double kyvadlo_apsidal_advance(const kyvadlo_orbit *orbit); /* lambda T = phi(T) - pi [rad] */
double kyvadlo_apsidal_angle(const kyvadlo_orbit *orbit); /* phi(T)/2 [rad] */
double kyvadlo_orbit_energy(const kyvadlo_orbit *orbit); /* c1 [m2/s2] */
double kyvadlo_orbit_momentum(const kyvadlo_orbit *orbit); /* c2 [m2/s] */
/* z2, z1, z3, l+z2, l-z1, z1-z2, z3-z1, z3-l [m]. */
void kyvadlo_turning(const kyvadlo_orbit *orbit, double values[8]);

/* The motion at a time t [s], counted from an upper turning point, or from the start of a state or a release. */
double kyvadlo_height(const kyvadlo_orbit *orbit, double t); /* z [m] */
double kyvadlo_rise(const kyvadlo_orbit *orbit, double t); /* l + z [m] */
double kyvadlo_top_clearance(const kyvadlo_orbit *orbit, double t); /* l - z [m] */
double kyvadlo_azimuth(const kyvadlo_orbit *orbit, double t); /* phi, continuous [rad] */
double kyvadlo_vertical_speed(const kyvadlo_orbit *orbit, double t); /* dz/dt [m/s] */
double kyvadlo_azimuthal_speed(const kyvadlo_orbit *orbit, double t); /* dphi/dt [1/s] */
double kyvadlo_speed(const kyvadlo_orbit *orbit, double t); /* [m/s] */
double kyvadlo_rod_force(const kyvadlo_orbit *orbit, double t); /* tension over mass [m/s2] */
double kyvadlo_time_to_height(const kyvadlo_orbit *orbit, double z); /* first t >= 0 at the height z [s] */
double kyvadlo_time_to_rise(const kyvadlo_orbit *orbit, double rise); /* first t >= 0 at the rise l + z [s] */
double kyvadlo_time_to_azimuth(const kyvadlo_orbit *orbit, double phi); /* first t >= 0 at the azimuth phi [s] */
double kyvadlo_next_turning_time(const kyvadlo_orbit *orbit, double t); /* first turning point later than t [s] */
/* Position x, y, z [m] and velocity [m/s] at one time, and at `count` times (positions[3*i], ... belong to times[i])
   by vector kernels. The last one shares long arrays among `threads` threads, 0: as many as OpenMP offers; the others
   stay on the caller's. */
void kyvadlo_locate(const kyvadlo_orbit *orbit, double t, double position[3], double velocity[3]);
void kyvadlo_locate_many(const kyvadlo_orbit *orbit, size_t count, const double *times, double *positions,
   double *velocities);
void kyvadlo_locate_many_threads(const kyvadlo_orbit *orbit, size_t count, const double *times, double *positions,
   double *velocities, int threads);
/* phi at `count` times [rad], by vector kernels too, for a little more than the positions. */
void kyvadlo_azimuths(const kyvadlo_orbit *orbit, size_t count, const double *times, double *azimuths, int threads);

/* Many orbits of one pendulum, each evaluated once, without setting them up: from their gaps l - z1 and l + z2 [m],
   `count` of each. T [s]; the advance of the apsides in a period, phi(T) - pi [rad]; eight constants each: T, k, k', K, q,
   A, phi(T) and that advance; positions [m] and velocities [m/s] (three each) at one time t [s] since the upper turning
   height at azimuth 0, whose period has the digits of a double only. NaN where there is no such orbit. By `threads`
   threads, 0: as many as OpenMP offers. */
void kyvadlo_orbits_period_from_gaps(double length, double gravity, size_t count, const double *upper_gaps,
   const double *lower_rises, double *periods, int threads);
void kyvadlo_orbits_advance_from_gaps(double length, size_t count, const double *upper_gaps,
   const double *lower_rises, double *advances, int threads);
void kyvadlo_orbits_constants_from_gaps(double length, double gravity, size_t count, const double *upper_gaps,
   const double *lower_rises, double *constants, int threads);
void kyvadlo_orbits_locate_from_gaps(double length, double gravity, size_t count, const double *upper_gaps,
   const double *lower_rises, double t, double *positions, double *velocities, int threads);

#ifdef __cplusplus
}
#endif

#endif
